// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "parametric_fixtures.h"

#include <CGAL/Multisided_patches/internal/integer_power.h>
#include <CGAL/Multisided_patches/patches/Bezier_triangle_3.h>

#include <cstddef>
#include <limits>
#include <vector>

using namespace parametric_fixtures;

namespace {

using Triangle = MP::Bezier_triangle_3<Kernel>;
using Double_triangle = MP::Bezier_triangle_3<Double_kernel>;

constexpr unsigned seed = 20261127;

const std::vector<Point_2> oblique{{1, -1}, {4, 1}, {2, 5}};

Triangle random_triangle(Random& random, std::size_t degree) {
  return Triangle(degree, random.points(Triangle::number_of_control_points(degree)),
                  Domain(oblique));
}

// The polynomial in the barycentric coordinates, which Cramer's rule gives.
Surface polynomial(const Triangle& patch, const Point_2& uv) {
  const Point_2 &a = patch.domain().vertex(0), &b = patch.domain().vertex(1),
                &c = patch.domain().vertex(2);
  const Jet u = Jet::u_variable(Rational(uv.x() - c.x())),
            v = Jet::v_variable(Rational(uv.y() - c.y()));
  const Vector_2 ca = a - c, cb = b - c;
  const Rational determinant = ca.x() * cb.y() - cb.x() * ca.y();
  const Jet x = (u * cb.y() - v * cb.x()) * Rational(1 / determinant),
            y = (v * ca.x() - u * ca.y()) * Rational(1 / determinant), z = Jet(1) - x - y;
  Surface sum;
  const std::size_t d = patch.degree();
  for (std::size_t i = 0; i <= d; ++i)
    for (std::size_t j = 0; i + j <= d; ++j) {
      const std::size_t k = d - i - j;
      const Rational coefficient = factorial(d) / (factorial(i) * factorial(j) * factorial(k));
      add(sum,
          MP::internal::integer_power(x, i) * MP::internal::integer_power(y, j) *
              MP::internal::integer_power(z, k) * coefficient,
          patch.control_point(i, j, k));
    }
  return sum;
}

Vector_2 to_opposite_vertex(std::size_t side, const Point_2& p) {
  return oblique[(side + 2) % 3] - p;
}

} // namespace

TEST_CASE("A Bezier triangle is its polynomial in barycentric coordinates, with derivatives") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t degree = 1; degree <= 6; ++degree)
    check_polynomial(random_triangle(random, degree), polynomial);
}

TEST_CASE("The control points of a Bezier triangle come row by row, from side 0 to vertex 2") {
  const std::vector<Point_3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0},
                                    {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
  const Triangle patch(2, points, Domain(oblique));
  CHECK(patch.control_point(2, 0, 0) == points[0]);
  CHECK(patch.control_point(1, 1, 0) == points[1]);
  CHECK(patch.control_point(1, 0, 1) == points[3]);
  CHECK(patch.control_point(0, 1, 1) == points[4]);
  CHECK(patch(oblique[0]) == points[0]);
  CHECK(patch(oblique[1]) == points[2]);
  CHECK(patch(oblique[2]) == points[5]);
}

TEST_CASE("By default a Bezier triangle is over an equilateral triangle") {
  CAPTURE(seed);
  const Double_triangle patch(3, doubles(seed, 10));
  const auto& domain = patch.domain();
  CHECK(domain.size() == 3);
  CHECK(domain.side_length(0) == Approx(domain.side_length(1)).epsilon(1e-14));
  CHECK(domain.side_length(1) == Approx(domain.side_length(2)).epsilon(1e-14));
  // A boundary that turns inwards at its corners changes nothing.
  const Triangle dented(2, {{0, 0, 0}, {9, 9, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 1}, {0, 9, 9}});
  CHECK(dented.domain().is_strictly_convex());
  check_polynomial(dented, polynomial);
}

TEST_CASE("A Bezier triangle of a higher degree is the same surface") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t degree = 1; degree <= 4; ++degree) {
    const Triangle patch = random_triangle(random, degree), higher = patch.elevated();
    CHECK(higher.degree() == degree + 1);
    check_same_surface(higher, patch);
    CHECK(patch.elevated_to(degree + 2).control_points() == higher.elevated().control_points());
    CHECK(patch.elevated_to(degree).control_points() == patch.control_points());
  }
}

TEST_CASE("The three parts of a Bezier triangle are the triangle, with its derivatives") {
  CAPTURE(seed);
  Random random(seed);
  const Point_2 uv(ratio(5, 2), ratio(4, 3));
  for (std::size_t degree = 1; degree <= 5; ++degree) {
    const Triangle patch = random_triangle(random, degree);
    const auto parts = patch.subdivided(uv);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(parts[i].domain().vertices() ==
            std::vector<Point_2>{oblique[i], oblique[(i + 1) % 3], uv});
      check_same_surface(parts[i], patch);
    }
  }
}

TEST_CASE("The ribbons of a Bezier triangle have the derivatives of the surface, exactly") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t degree = 1; degree <= 7; ++degree) {
    const Triangle patch = random_triangle(random, degree);
    CHECK(patch.loop()[0].layers() == (degree < 5 ? 2 : (degree + 1) / 2));
    check_ribbons(patch, to_opposite_vertex);
  }
}

TEST_CASE("A continuity report finds a Bezier triangle to meet its ribbons") {
  CAPTURE(seed);
  Random random(seed);
  for (const std::size_t degree : {1, 2, 4, 5})
    check_continuity(random_triangle(random, degree));
}

TEST_CASE("Normals of a Bezier triangle point to where the boundary runs counterclockwise") {
  const Rational half = ratio(1, 2);
  check_normals_of_saddle(
      Triangle(2, {{0, 0, 0}, {half, 0, 0}, {1, 0, 0}, {0, half, 0}, {half, half, half}, {0, 1, 0}},
               Domain({Point_2(0, 0), Point_2(1, 0), Point_2(0, 1)})));
}

TEST_CASE("A Bezier triangle over doubles is evaluated in rationals at once") {
  CAPTURE(seed);
  const std::vector<Double_point> points = doubles(seed, 15);
  using Double_point_2 = Double_kernel::Point_2;
  const std::vector<Double_point_2> vertices{{0.1, 0.2}, {1.3, 0.3}, {0.4, 0.9}};
  std::vector<Point_2> exact_vertices;
  for (const Double_point_2& p : vertices)
    exact_vertices.emplace_back(Rational(p.x()), Rational(p.y()));
  check_evaluation_in_rationals(Double_triangle(4, points, Double_triangle::Domain(vertices)),
                                Triangle(4, converted(points), Domain(exact_vertices)));
}

TEST_CASE("A Bezier triangle refuses sizes and domains that do not fit") {
  using Catch::Matchers::Contains;
  const auto triangle = [](std::size_t degree, std::size_t n) {
    return Triangle(degree, std::vector<Point_3>(n, Point_3(0, 0, 0)));
  };
  CHECK_THROWS_WITH(triangle(0, 1), Contains("degree from 1 to 1000, not 0"));
  CHECK_THROWS_AS(triangle(std::numeric_limits<std::size_t>::max(), 1), MP::Input_error);
  CHECK_THROWS_WITH(triangle(2, 5), Contains("degree 2 has 6 control points, not 5"));
  const std::vector<Point_3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK_NOTHROW(Triangle(1, corners));
  CHECK_THROWS_WITH(
      Triangle(1, corners, Domain({Point_2(0, 0), Point_2(1, 0), Point_2(1, 1), Point_2(0, 1)})),
      Contains("3 vertices, not 4"));
  CHECK_THROWS_WITH(Triangle(1, {corners[0], corners[1], corners[1]}),
                    Contains("side 1 is a single point"));

  const Triangle patch(1, corners, Domain(oblique));
  CHECK_THROWS_AS(patch.subdivided({0, 0}), MP::Outside_domain_error);
  CHECK_THROWS_WITH(patch.subdivided(oblique[1]), Contains("inside its domain"));
  CHECK_THROWS_WITH(patch.subdivided(CGAL::midpoint(oblique[0], oblique[1])),
                    Contains("inside its domain"));

  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(Double_triangle(1, {{0, 0, 0}, {1, 0, 0}, {0, 1, nan}}),
                    Contains("control point 2 of a Bezier triangle is not finite"));
}
