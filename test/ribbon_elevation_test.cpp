// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Ribbons with other degrees and other numbers of layers. What should stay stays exactly.

#include "catch.h"
#include "exact_fixtures.h"

#include <cstddef>
#include <vector>

using namespace exact_fixtures;

TEST_CASE("More layers keep all derivatives across a side and continue them by zeros") {
  Random random(1);
  for (std::size_t layers = 1; layers <= 3; ++layers)
    for (std::size_t more = layers; more <= 5; ++more) {
      CAPTURE(layers, more);
      const Ribbon r = random_ribbon(random, 4, layers), deeper = r.with_layers(more);
      REQUIRE(deeper.layers() == more);
      for (std::size_t order = 0; order < layers; ++order)
        CHECK(same_derivatives(r, deeper, order));
      for (std::size_t order = layers; order < more; ++order)
        for (const FT& s : parameters(4))
          CHECK(cross_derivative(deeper, s, order) == Vector(0, 0, 0));
      CHECK(deeper.with_layers(layers).control_points() == r.control_points());
    }
}

TEST_CASE("Fewer layers keep the derivatives that they can tell") {
  Random random(2);
  const Ribbon r = random_ribbon(random, 3, 4);
  for (std::size_t layers = 1; layers <= 4; ++layers)
    for (std::size_t order = 0; order < layers; ++order)
      CHECK(same_derivatives(r, r.with_layers(layers), order));
  CHECK_THROWS_AS(r.with_layers(501), MP::Input_error);
}

TEST_CASE("A ribbon with more layers and a higher degree is the same whichever comes first") {
  Random random(3);
  const Ribbon r = random_ribbon(random, 3, 2);
  CHECK(r.with_layers(4).elevated(6).control_points() ==
        r.elevated(6).with_layers(4).control_points());
}

TEST_CASE("Reducing the degree of a ribbon inverts elevation") {
  Random random(4);
  for (std::size_t degree = 1; degree <= 5; ++degree)
    for (std::size_t higher = degree; higher <= 9; ++higher) {
      const Ribbon r = random_ribbon(random, degree, 2);
      CHECK(r.elevated(higher).reduced(degree).control_points() == r.control_points());
    }
}

TEST_CASE("Reducing the degree of any ribbon keeps the ends of its rows and half the derivatives") {
  Random random(5);
  for (std::size_t d = 2; d <= 9; ++d) {
    const Ribbon r = random_ribbon(random, d, 2), reduced = r.reduced(d - 1);
    CAPTURE(d);
    // The reduced ribbon, raised to the degree that it had, has the same points near the ends.
    const Ribbon back = reduced.elevated(d);
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t j = 0; j < d / 2; ++j) {
        CHECK(back.control_point(j, k) == r.control_point(j, k));
        CHECK(back.control_point(d - j, k) == r.control_point(d - j, k));
      }
    CHECK(back.control_points() != r.control_points());
  }
}

TEST_CASE("A ribbon run the other way reduces and deepens to the same rounded points") {
  const unsigned seed = GENERATE(range(10u, 20u));
  CAPTURE(seed);
  Random random(seed);
  const std::size_t degree = random.integer(2, 8);
  std::vector<fixtures::Point_3> points;
  for (std::size_t i = 0; i < 2 * (degree + 1); ++i)
    points.emplace_back(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
  const fixtures::Ribbon r(degree, 2, points);
  const std::size_t lower = random.integer(1, degree);
  CHECK(r.reversed().reduced(lower).control_points() ==
        r.reduced(lower).reversed().control_points());
  CHECK(r.reversed().with_layers(4).control_points() ==
        r.with_layers(4).reversed().control_points());
}

TEST_CASE("An elevated ribbon is the same surface") {
  const unsigned seed = 20260212;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t degree = 1; degree <= 7; ++degree)
    for (std::size_t layers = 1; layers <= 4; ++layers) {
      const Ribbon ribbon = random_ribbon(random, degree, layers);
      const Ribbon elevated = ribbon.elevated(degree + random.integer(1, 4));
      REQUIRE(elevated.degree() > degree);
      REQUIRE(elevated.layers() == layers);
      for (const FT& s :
           std::vector<FT>{FT(0), FT(2) / FT(7), FT(3) / FT(5), FT(1), FT(9) / FT(4)}) {
        for (std::size_t k = 0; k < layers; ++k)
          CHECK(row_point(elevated, k, s) == row_point(ribbon, k, s));
        CHECK(elevated.boundary_point(s) == ribbon.boundary_point(s));
        CHECK(elevated.boundary_derivative(s) == ribbon.boundary_derivative(s));
        if (layers >= 2)
          CHECK(elevated.cross_derivative(s) == ribbon.cross_derivative(s));
      }
      CHECK(elevated.arc_length() == Approx(ribbon.arc_length()).epsilon(1e-12));
      CHECK(ribbon.elevated(degree).control_points() == ribbon.control_points());
    }
}

TEST_CASE("In floating point arithmetic, too, a ribbon and its reverse are elevated alike") {
  Random random(20260213);
  for (int k = 0; k < 50; ++k) {
    const auto loop = fixtures::random_loop(random, 5, 0.3);
    for (const auto& ribbon : loop.ribbons()) {
      const std::size_t degree = ribbon.degree() + 3;
      const auto elevated = ribbon.elevated(degree);
      CHECK(elevated.control_points() ==
            ribbon.reversed().elevated(degree).reversed().control_points());
      CHECK(elevated.control_point(0, 0) == ribbon.control_point(0, 0));
      CHECK(elevated.control_point(degree, 0) == ribbon.control_point(ribbon.degree(), 0));
    }
  }
}
