// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Polygon_2_algorithms.h>

#include <limits>

using namespace fixtures;
using Catch::Matchers::Contains;
using Kind = Domain::Location::Kind;

namespace {

Domain square_with_hole() {
  return Domain({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}});
}

} // namespace

TEST_CASE("A domain knows its corners, sides and neighbours") {
  const Domain l(l_shape());
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(l.next(l.prev(i)) == i);
    CHECK(l.corner_type(i) == (i == 3 ? MP::Corner_type::reflex : MP::Corner_type::convex));
  }
  CHECK(l.area() == 3);
  CHECK(l.clearance() == 1);
  CHECK(l.side_length(0) == 2);
  CHECK_FALSE(l.is_strictly_convex());
  CHECK(Domain({{0, 0}, {1, 0}, {0, 1}}).is_strictly_convex());
  CHECK(std::isinf(Domain({{0, 0}, {1, 0}, {0, 1}}).clearance()));
}

TEST_CASE("A hole is part of the domain's boundary") {
  const Domain d = square_with_hole();
  CHECK(d.area() == 15);
  CHECK(d.clearance() == 1);
  CHECK(d.next(7) == 4);
  CHECK(d.prev(4) == 7);
  CHECK(d.corner_type(5) == MP::Corner_type::reflex);
  CHECK(d.locate({1.5, 1.5}).kind == Kind::outside);
  CHECK(d.locate({0.5, 1.5}).kind == Kind::interior);
  CHECK(d.locate({1, 1.25}).kind == Kind::side);
  CHECK(d.locate({1, 1.25}).s == 0.25);
}

TEST_CASE("Every vertex, and samples of every side, are located where they are") {
  for (const Domain& d : {Domain(l_shape()), Domain(u_shape()), square_with_hole()})
    for (std::size_t i = 0; i < d.size(); ++i) {
      const auto at_vertex = d.locate(d.vertex(i));
      CHECK(at_vertex.kind == Kind::vertex);
      CHECK(at_vertex.index == i);
      for (const double s : {0.25, 0.5, 0.875}) {
        const auto on_side = d.locate(d.point_on_side(i, s));
        CHECK(on_side.kind == Kind::side);
        CHECK(on_side.index == i);
        CHECK(on_side.s == s);
      }
    }
}

TEST_CASE("Points are inside or outside as CGAL says") {
  const unsigned seed = 20260101;
  CAPTURE(seed);
  Random random(seed);
  for (int k = 0; k < 200; ++k) {
    const auto polygon = star_shaped_polygon(random, random.integer(3, 20), 0.1);
    const Domain domain(polygon);
    for (int q = 0; q < 20; ++q) {
      // Coordinates of vertices make rays that pass through them.
      const Point_2 p(random.in(-1, 1), polygon[random.integer(0, polygon.size() - 1)].y());
      const auto side = CGAL::bounded_side_2(polygon.begin(), polygon.end(), p, Kernel());
      const Kind expected = side == CGAL::ON_BOUNDED_SIDE ? Kind::interior : Kind::outside;
      if (side != CGAL::ON_BOUNDARY)
        CHECK(domain.locate(p).kind == expected);
    }
  }
}

TEST_CASE("Polygons that are not domains are refused with the reason") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(Domain({{0, 0}, {1, 0}}), Contains("at least 3"));
  CHECK_THROWS_WITH(Domain({{0, 0}, {1, 0}, {nan, 1}}), Contains("vertex 2"));
  CHECK_THROWS_WITH(Domain({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), Contains("side 1"));
  CHECK_THROWS_WITH(Domain({{0, 0}, {0, 1}, {1, 0}}), Contains("counterclockwise"));
  CHECK_THROWS_WITH(Domain({{0, 0}, {2, 0}, {0, 1}, {2, 1}}), Contains("sides 1 and 3"));
  CHECK_THROWS_WITH(Domain({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), Contains("cross or touch"));
  CHECK_THROWS_WITH(Domain({{0, 0}, {1, 0}, {2, 0}}), Contains("cross or touch"));
  // A vertex that touches the middle of another side.
  CHECK_THROWS_AS(Domain({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}), MP::Input_error);

  const std::vector<Point_2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  using Holes = std::vector<std::vector<Point_2>>;
  CHECK_THROWS_WITH(Domain(square, Holes{{{1, 1}, {2, 1}, {2, 2}}}), Contains("clockwise"));
  CHECK_THROWS_WITH(Domain(square, Holes{{{3, 1}, {3, 2}, {5, 2}}}), Contains("two loops"));
  CHECK_THROWS_WITH(Domain(square, Holes{{{7, 1}, {7, 2}, {8, 2}}}), Contains("outside"));
  CHECK_THROWS_WITH(
      Domain(square, Holes{{{1, 1}, {1, 3}, {3, 3}, {3, 1}}, {{2, 2}, {2, 2.5}, {2.5, 2.5}}}),
      Contains("lie in each other"));
}

TEST_CASE("Checks are exact where doubles just tell points apart") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  CHECK_NOTHROW(Domain({{0, 0}, {1, 0}, {1, 1}, {0.5, tiny}, {0, 1}}));
  CHECK_THROWS_AS(Domain({{0, 0}, {1, 0}, {1, 1}, {0.5, 0}, {0, 1}}), MP::Input_error);
  CHECK(Domain({{0, 0}, {1, 0}, {1, 1}, {0.5, tiny}, {0, 1}}).locate({0.5, tiny}).kind ==
        Kind::vertex);
}
