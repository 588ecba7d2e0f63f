// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/domains/make_domain.h>

using namespace fixtures;
using MP::Corner_type;
using MP::Domain_generator;

namespace {

double flat(double, double) {
  return 0;
}

// Ratios of distances are what a domain has regardless of how it is placed.
void check_similar(const Domain& a, const std::vector<Point_2>& b, double tolerance) {
  const auto ratio = [](const auto& points, std::size_t i, std::size_t j) {
    return std::sqrt(CGAL::squared_distance(points[i], points[j]) /
                     CGAL::squared_distance(points[0], points[1]));
  };
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      CHECK(ratio(a.vertices(), i, j) == Approx(ratio(b, i, j)).epsilon(tolerance));
}

bool matches(const Domain& domain, const Loop& loop) {
  bool same = domain.size() == loop.size();
  for (std::size_t i = 0; same && i < loop.size(); ++i)
    same = loop.corner_type(i) == Corner_type::straight ||
           loop.corner_type(i) == domain.corner_type(i);
  return same;
}

MP::Domain_options options(Domain_generator generator, double clearance = 0) {
  MP::Domain_options result;
  result.generator = generator;
  result.clearance = clearance;
  return result;
}

} // namespace

TEST_CASE("Similarity and projected domains of a flat loop with straight sides are the loop") {
  for (const auto& polygon : {l_shape(), u_shape()}) {
    const Loop loop = lifted_loop(polygon, flat);
    check_similar(MP::make_similarity_domain(loop), polygon, 1e-9);
    check_similar(MP::make_similarity_domain(loop, MP::Angle_scaling::smaller_angles), polygon,
                  1e-9);
    check_similar(MP::make_projected_domain(loop), polygon, 1e-9);
  }
}

TEST_CASE("Domains fill the unit square in one direction") {
  const Loop loop = lifted_loop(u_shape(), [](double x, double y) { return 0.3 * x * y; });
  for (const auto generator :
       {Domain_generator::similarity, Domain_generator::projected, Domain_generator::regular}) {
    const CGAL::Bbox_2 box = MP::make_domain(loop, options(generator)).domain.bbox();
    CHECK(box.xmin() == 0);
    CHECK(box.ymin() == 0);
    CHECK((std::max)(box.xmax(), box.ymax()) == 1);
  }
}

TEST_CASE("The regular domain of a convex loop is a regular polygon") {
  Random random(4);
  for (std::size_t n = 3; n <= 12; ++n) {
    const Domain d = MP::make_regular_domain(lifted_loop(convex_polygon(random, n), flat));
    for (std::size_t i = 0; i < n; ++i)
      CHECK(d.side_length(i) == Approx(d.side_length(0)).epsilon(1e-12));
    check_similar(MP::make_circular_domain(lifted_loop(d.vertices(), flat)), d.vertices(), 1e-9);
  }
}

TEST_CASE("The regular domain is reflex exactly where any sequence of corner types asks for it") {
  Random random(5);
  for (int k = 0; k < 500; ++k) {
    const std::size_t n = random.integer(3, 60);
    std::vector<bool> is_reflex(n);
    for (std::size_t i = 0; i < n; ++i)
      is_reflex[i] = random.in(0, 1) < 0.6;
    if (std::count(is_reflex.begin(), is_reflex.end(), false) < 3) {
      CHECK_THROWS_AS(MP::internal::dented_regular_polygon(is_reflex), MP::Input_error);
      continue;
    }
    const Domain domain(
        MP::internal::to_unit_box<Kernel>(MP::internal::dented_regular_polygon(is_reflex)));
    for (std::size_t i = 0; i < n; ++i)
      CHECK((domain.corner_type(i) == Corner_type::reflex) == is_reflex[i]);
  }
}

TEST_CASE("The circular domain keeps its corners on a circle and refuses reflex corners") {
  Random random(6);
  const Domain d = MP::make_circular_domain(lifted_loop(convex_polygon(random, 7), flat));
  const Point_2 center = CGAL::circumcenter(d.vertex(0), d.vertex(2), d.vertex(4));
  for (std::size_t i = 0; i < 7; ++i)
    CHECK(CGAL::squared_distance(center, d.vertex(i)) ==
          Approx(CGAL::squared_distance(center, d.vertex(0))));
  CHECK_THROWS_WITH(MP::make_circular_domain(lifted_loop(l_shape(), flat)),
                    Catch::Matchers::Contains("corner 3 is reflex"));
}

TEST_CASE("Where the loop starts does not change the shape of its domain") {
  const Loop loop =
      lifted_loop(u_shape(), [](double x, double y) { return 0.4 * x * x - 0.2 * y; });
  for (const auto generator : {Domain_generator::similarity, Domain_generator::similarity_outer,
                               Domain_generator::projected, Domain_generator::regular}) {
    const Domain d = MP::make_domain(loop, options(generator)).domain;
    for (std::size_t shift = 1; shift < loop.size(); ++shift) {
      auto ribbons = loop.ribbons();
      std::rotate(ribbons.begin(), ribbons.begin() + shift, ribbons.end());
      auto vertices = d.vertices();
      std::rotate(vertices.begin(), vertices.begin() + shift, vertices.end());
      check_similar(MP::make_domain(Loop(ribbons), options(generator)).domain, vertices, 1e-9);
    }
  }
}

TEST_CASE("A mirror symmetric loop has mirror symmetric domains") {
  const Loop loop = lifted_loop(u_shape(), [](double x, double y) { return 0.2 * x * x + y * y; });
  for (const auto generator : {Domain_generator::similarity, Domain_generator::similarity_outer,
                               Domain_generator::projected, Domain_generator::regular}) {
    const auto vertices = MP::make_domain(loop, options(generator)).domain.vertices();
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < i; ++j)
        CHECK(CGAL::squared_distance(vertices[i], vertices[j]) ==
              Approx(CGAL::squared_distance(vertices[7 - i], vertices[7 - j])).epsilon(1e-9));
  }
}

TEST_CASE("Thousands of random loops get valid domains with the loops' corner types") {
  const unsigned seed = 20260102;
  CAPTURE(seed);
  Random random(seed);
  int repaired = 0, given_up = 0;
  for (int k = 0; k < 3000; ++k) {
    CAPTURE(k);
    const Loop loop = random_loop(random, random.integer(3, 20), random.in(0, 0.6));
    // The constructor of the domain has checked that it is simple.
    const auto generated = MP::make_domain(loop, options(Domain_generator::automatic, 0.02));
    const bool possible = loop.number_of_corners(Corner_type::reflex) + 3 <= loop.size();
    CHECK(matches(generated.domain, loop) == possible);
    CHECK(generated.report.clearance > 0);
    CHECK(generated.report.clearance == generated.domain.clearance());
    if (!possible)
      CHECK_FALSE(generated.report.remarks.empty());
    repaired += generated.report.repair > 0;
    given_up += generated.report.used != Domain_generator::similarity;
  }
  // Otherwise the sample says nothing about repairs and fallbacks.
  CHECK(repaired > 100);
  CHECK(given_up > 10);
}

TEST_CASE("A narrow similarity domain is opened until it has the wanted clearance") {
  // A slot, a tenth as wide as deep.
  const Loop loop = lifted_loop(
      {{0, 0}, {3, 0}, {3, 2}, {1.6, 2}, {1.6, 0.6}, {1.4, 0.6}, {1.4, 2}, {0, 2}}, flat);
  const auto narrow = MP::make_domain(loop, options(Domain_generator::similarity, 0.0));
  const auto open = MP::make_domain(loop, options(Domain_generator::similarity, 0.1));
  CHECK(narrow.report.repair == 0);
  CHECK(narrow.report.clearance < 0.1);
  CHECK(open.report.repair > 0);
  CHECK(open.report.clearance >= 0.1);
  CHECK(matches(open.domain, loop));
  const auto impossible = MP::make_domain(loop, options(Domain_generator::similarity, 0.9));
  CHECK(impossible.report.clearance < 0.9);
  CHECK_FALSE(impossible.report.remarks.empty());
}

TEST_CASE("A curved domain is replaced by a similarity domain, and the report says so") {
  const auto generated =
      MP::make_domain(lifted_loop(l_shape(), flat), options(Domain_generator::curved));
  CHECK(generated.report.used == Domain_generator::similarity);
  REQUIRE_FALSE(generated.report.remarks.empty());
  CHECK(generated.report.remarks[0].generator == Domain_generator::curved);
}
