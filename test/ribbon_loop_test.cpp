// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

using namespace fixtures;
using Catch::Matchers::Contains;
using MP::Corner_type;

namespace {

double flat(double, double) {
  return 0;
}
double bowl(double x, double y) {
  return 0.2 * (x * x - y * y) + 0.1 * x;
}

std::vector<Ribbon> l_ribbons() {
  return lifted_loop(l_shape(), flat).ribbons();
}

Ribbon with_point(const Ribbon& r, std::size_t index, const Point_3& p) {
  std::vector<Point_3> points = r.control_points();
  points[index] = p;
  return Ribbon(r.degree(), r.layers(), points);
}

} // namespace

TEST_CASE("Corners of a loop are convex and reflex where those of its plan are") {
  for (const auto& polygon : {l_shape(), u_shape()})
    for (const auto& height : {flat, bowl}) {
      const Loop loop = lifted_loop(polygon, height);
      const Domain plan(polygon);
      for (std::size_t i = 0; i < loop.size(); ++i)
        CHECK(loop.corner_type(i) == plan.corner_type(i));
    }
}

TEST_CASE("Corner angles of a flat loop are those of its plan") {
  const Loop loop = lifted_loop(l_shape(), flat);
  const double right = MP::internal::pi / 2;
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(loop.corner_angle(i) == Approx(i == 3 ? 3 * right : right));
    CHECK(loop.corner_normal(i) == Vector_3(0, 0, 1));
    CHECK(loop.corner_normal_mismatch(i) == 0);
  }
  CHECK(loop.number_of_corners(Corner_type::reflex) == 1);
}

TEST_CASE("Corner angles do not change when a loop is moved, turned over and scaled") {
  const Loop loop = lifted_loop(u_shape(), bowl);
  std::vector<Ribbon> moved;
  for (const Ribbon& r : loop.ribbons()) {
    std::vector<Point_3> points;
    for (const Point_3& p : r.control_points())
      points.emplace_back(1e5 + 1e3 * p.y(), 1e3 * p.z(), 1e3 * p.x()); // a rotation
    moved.emplace_back(r.degree(), r.layers(), points);
  }
  const Loop other(moved);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    CHECK(other.corner_type(i) == loop.corner_type(i));
    CHECK(other.corner_angle(i) == Approx(loop.corner_angle(i)).epsilon(1e-9));
  }
}

TEST_CASE("A corner in the middle of a straight side is straight") {
  const Loop loop = lifted_loop({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}, flat);
  CHECK(loop.corner_type(1) == Corner_type::straight);
  CHECK(loop.number_of_corners(Corner_type::straight) == 1);
}

TEST_CASE("Without cross-derivatives the boundary as a whole tells which corners are reflex") {
  std::vector<Ribbon> ribbons;
  const auto plan = l_shape();
  for (std::size_t i = 0; i < 6; ++i) {
    const Point_2 &a = plan[i], &b = plan[(i + 1) % 6];
    ribbons.emplace_back(1, 1, std::vector<Point_3>{{a.x(), a.y(), 0}, {b.x(), b.y(), 0}});
  }
  const Loop loop(ribbons);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(loop.corner_type(i) == (i == 3 ? Corner_type::reflex : Corner_type::convex));
  CHECK(loop.corner_normal(0) == CGAL::NULL_VECTOR);
}

TEST_CASE("A loop that does not close is refused with the side at which it is open") {
  auto ribbons = l_ribbons();
  ribbons[2] = with_point(ribbons[2], 3, Point_3(1, 1, 0.01));
  CHECK_THROWS_WITH(Loop(ribbons), Contains("does not close") && Contains("side 2"));
}

TEST_CASE("The message about a loop that does not close guesses what is wrong") {
  const auto good = l_ribbons();
  auto reversed = good;
  reversed[3] = reversed[3].reversed();
  CHECK_THROWS_WITH(Loop(reversed),
                    Contains("side 2 ends at (1, 1, 0)") && Contains("seems to run the other way"));
  auto clockwise = good;
  std::reverse(clockwise.begin(), clockwise.end());
  CHECK_THROWS_WITH(Loop(clockwise), Contains("clockwise order"));
  auto swapped = good; // that is no clockwise order
  std::swap(swapped[0], swapped[1]);
  CHECK_THROWS_WITH(Loop(swapped), !Contains("clockwise") && Contains("side 0 ends") &&
                                       Contains("as if they were swapped"));
  auto upside_down = good;
  auto points = good[1].control_points();
  std::rotate(points.begin(), points.begin() + 4, points.end());
  upside_down[1] = Ribbon(3, 2, points);
  CHECK_THROWS_WITH(Loop(upside_down), Contains("the boundary is row 0"));
}

TEST_CASE("A control point moves with the neighbours' only where they have it in common") {
  const Loop loop = lifted_loop(l_shape(), bowl);
  // A corner is common to two ribbons, whatever their rows.
  const Point_3 p(2.2, 0.1, 1);
  const Loop pulled = loop.with_control_point(0, 3, 0, p);
  CHECK(pulled[0].control_points() == with_point(loop[0], 3, p).control_points());
  CHECK(pulled[1].control_points() == with_point(loop[1], 0, p).control_points());
  for (std::size_t i = 2; i < 6; ++i)
    CHECK(pulled[i].control_points() == loop[i].control_points());
  CHECK(loop.with_control_point(1, 0, 0, p)[0].control_points() == pulled[0].control_points());
  // The second rows of these ribbons end elsewhere than the curves beside them have points.
  REQUIRE(loop[0].control_point(3, 1) != loop[1].control_point(1, 0));
  const Loop row = loop.with_control_point(0, 3, 1, p);
  CHECK(row[0].control_points() == with_point(loop[0], 7, p).control_points());
  CHECK(row[1].control_points() == loop[1].control_points());
  // Nothing happens, and nothing can.
  CHECK(loop.with_control_point(2, 1, 1, loop[2].control_point(1, 1))[2].control_points() ==
        loop[2].control_points());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(loop.with_control_point(0, 0, 0, Point_3(nan, 0, 0)), MP::Input_error);
}

TEST_CASE("A gap below the tolerance is closed exactly") {
  auto ribbons = l_ribbons();
  ribbons[2] = with_point(ribbons[2], 3, Point_3(1, 1, 1e-10));
  const Loop loop(ribbons);
  CHECK(loop[2].control_point(3, 0) == loop[3].control_point(0, 0));
  CHECK_THROWS_AS(Loop(ribbons, 1e-12), MP::Input_error);
}

TEST_CASE("Loops of two ribbons and sides that are single points are refused") {
  auto ribbons = l_ribbons();
  CHECK_THROWS_WITH(Loop({ribbons[0], ribbons[1]}), Contains("at least 3"));
  const Point_3 p(2, 0, 0);
  ribbons.insert(ribbons.begin() + 1, Ribbon(2, 1, {p, p, p}));
  CHECK_THROWS_WITH(Loop(ribbons), Contains("side 1") && Contains("single point"));
}
