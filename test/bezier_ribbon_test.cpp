// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <limits>

using namespace fixtures;

namespace {

Ribbon random_ribbon(Random& random, std::size_t degree, std::size_t layers) {
  std::vector<Point_3> points;
  for (std::size_t i = 0; i < (degree + 1) * layers; ++i)
    points.emplace_back(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
  return Ribbon(degree, layers, points);
}

} // namespace

TEST_CASE("A boundary curve starts and ends at its end control points and is tangent there") {
  Random random(1);
  for (std::size_t degree = 1; degree <= 9; ++degree) {
    const Ribbon r = random_ribbon(random, degree, 2);
    CHECK(r.boundary_point(0) == r.control_point(0, 0));
    CHECK(r.boundary_point(1) == r.control_point(degree, 0));
    const double d = static_cast<double>(degree);
    const Vector_3 start = d * (r.control_point(1, 0) - r.control_point(0, 0));
    CHECK((r.boundary_derivative(0) - start).squared_length() < 1e-26);
    CHECK((r.cross_derivative(1) - 3 * (r.control_point(degree, 1) - r.control_point(degree, 0)))
              .squared_length() < 1e-26);
  }
}

TEST_CASE("The derivative of a boundary curve is the limit of its differences") {
  Random random(2);
  const Ribbon r = random_ribbon(random, 6, 1);
  for (const double s : {0.1, 0.35, 0.8}) {
    const double step = 1e-5;
    const Vector_3 difference =
        (r.boundary_point(s + step) - r.boundary_point(s - step)) / (2 * step);
    CHECK((difference - r.boundary_derivative(s)).squared_length() < 1e-16);
  }
}

TEST_CASE("A curve and its reverse have bitwise the same points and length") {
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    const Ribbon r = random_ribbon(random, random.integer(1, 9), 2), back = r.reversed();
    CHECK(r.arc_length() == back.arc_length());
    const double s = static_cast<double>(random.integer(0, 1 << 20)) / (1 << 20); // 1 - s is exact
    CHECK(r.boundary_point(s) == back.boundary_point(1 - s));
    CHECK((r.cross_derivative(s) - back.cross_derivative(1 - s)).squared_length() < 1e-26);
  }
}

TEST_CASE("Arc lengths are those of curves whose length is known") {
  const Ribbon line(1, 1, {{1, 2, 3}, {3, 5, 9}});
  CHECK(line.arc_length() == Approx(7).epsilon(1e-14));
  // A parabola: y = x² for x in [0,1].
  const Ribbon parabola(2, 1, {{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}});
  CHECK(parabola.arc_length() == Approx(std::sqrt(5.0) / 2 + std::asinh(2.0) / 4).epsilon(1e-12));
  // A cusp in the middle: x = t³, y = t² for t from -1 to 1, which is 2 (13^1.5 - 8) / 27 long.
  const Ribbon cusp(3, 1, {{-1, 1, 0}, {1, -1.0 / 3, 0}, {-1, -1.0 / 3, 0}, {1, 1, 0}});
  CHECK(cusp.arc_length() == Approx(2 * (13 * std::sqrt(13.0) - 8) / 27).epsilon(1e-9));
  // Sizes at which squares of coordinates over- or underflow.
  for (const double size : {1e-200, 1e200}) {
    const Ribbon scaled(2, 1, {{0, 0, 0}, {0.5 * size, 0, 0}, {size, size, 0}});
    CHECK(scaled.arc_length() / size == Approx(parabola.arc_length()).epsilon(1e-12));
  }
}

TEST_CASE("One control point of a ribbon moves, and no other") {
  Random random(3);
  const Ribbon r = random_ribbon(random, 3, 2);
  const Point_3 p(7, 8, 9);
  const Ribbon moved = r.with_control_point(2, 1, p);
  CHECK(moved.degree() == 3);
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t j = 0; j < 4; ++j)
      CHECK(moved.control_point(j, k) == (j == 2 && k == 1 ? p : r.control_point(j, k)));
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(r.with_control_point(0, 0, Point_3(infinity, 0, 0)), MP::Input_error);
}

TEST_CASE("A ribbon refuses sizes that do not fit and coordinates that are not finite") {
  using Catch::Matchers::Contains;
  const std::vector<Point_3> four(4, Point_3(0, 0, 0));
  CHECK_THROWS_AS(Ribbon(0, 4, four), MP::Input_error);
  CHECK_THROWS_AS(Ribbon(3, 0, four), MP::Input_error);
  CHECK_THROWS_WITH(Ribbon(3, 2, four), Contains("not 4"));
  CHECK_THROWS_AS(Ribbon(std::numeric_limits<std::size_t>::max(), 1, four), MP::Input_error);
  CHECK_THROWS_AS(Ribbon(std::numeric_limits<std::size_t>::max(), 1, {}), MP::Input_error);
  std::vector<Point_3> bad = four;
  bad[3] = Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  CHECK_THROWS_WITH(Ribbon(1, 2, bad), Contains("control point 1 of row 1"));
}
