// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangular and tensor product Bézier patches.

#include "catch.h"

#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/internal/integer_power.h>
#include <CGAL/Multisided_patches/patches/Bezier_triangle_3.h>
#include <CGAL/Multisided_patches/patches/Tensor_product_patch_3.h>
#include <CGAL/Multisided_patches/ribbons/Generalized_bezier_net_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace MP = CGAL::Multisided_patches;
using Rational = CGAL::Exact_rational;
using Kernel = CGAL::Simple_cartesian<Rational>;
using Point_2 = Kernel::Point_2;
using Vector_2 = Kernel::Vector_2;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Domain = MP::Polygonal_domain_2<Kernel>;
using Triangle = MP::Bezier_triangle_3<Kernel>;
using Tensor_product = MP::Tensor_product_patch_3<Kernel>;
using Jet = MP::Jet_2<Rational, 2>;
using Surface = std::array<Jet, 3>;

using Double_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Double_triangle = MP::Bezier_triangle_3<Double_kernel>;
using Double_tensor_product = MP::Tensor_product_patch_3<Double_kernel>;
using Double_point = Double_kernel::Point_3;

constexpr unsigned seed = 20261127;

Rational ratio(int a, int b) {
  return Rational(a) / Rational(b);
}

class Random {
public:
  Rational number() { return ratio(integer(-99, 99), integer(1, 9)); }
  std::vector<Point_3> points(std::size_t n) {
    std::vector<Point_3> points;
    for (std::size_t i = 0; i < n; ++i)
      points.emplace_back(number(), number(), number());
    return points;
  }
  std::vector<Double_point> doubles(std::size_t n) {
    std::uniform_real_distribution<double> in(-1, 1);
    std::vector<Double_point> points;
    for (std::size_t i = 0; i < n; ++i)
      points.emplace_back(in(engine_), in(engine_), in(engine_));
    return points;
  }

private:
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  std::mt19937 engine_{seed};
};

const std::vector<Point_2> oblique{{1, -1}, {4, 1}, {2, 5}};

Triangle random_triangle(Random& random, std::size_t degree) {
  return Triangle(degree, random.points(Triangle::number_of_control_points(degree)),
                  Domain(oblique));
}

Tensor_product random_tensor_product(Random& random, std::size_t d, std::size_t e) {
  return Tensor_product(d, e, random.points((d + 1) * (e + 1)));
}

// Three points inside, one on each side, and all vertices.
std::vector<Point_2> samples(const Domain& domain) {
  const std::size_t n = domain.size();
  std::vector<Point_2> points(domain.vertices());
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(domain.point_on_side(i, ratio(2, 7)));
  const Point_2 centre = CGAL::midpoint(domain.vertex(0), domain.point_on_side(1, ratio(3, 7)));
  for (std::size_t i = 0; i < 3; ++i)
    points.push_back(centre + ratio(1, 3) * (domain.vertex(i) - centre));
  return points;
}

bool same(const Surface& a, const Surface& b) {
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < Jet::size; ++k)
      if (a[c][k] != b[c][k])
        return false;
  return true;
}

void add(Surface& sum, const Jet& weight, const Point_3& p) {
  for (int c = 0; c < 3; ++c)
    sum[static_cast<std::size_t>(c)] += weight * p[c];
}

Rational factorial(std::size_t n) {
  Rational f(1);
  for (std::size_t i = 2; i <= n; ++i)
    f *= Rational(static_cast<int>(i));
  return f;
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

Surface polynomial(const Tensor_product& patch, const Point_2& uv) {
  const std::size_t d = patch.degree_u(), e = patch.degree_v();
  const auto bernstein = [](std::size_t n, std::size_t i, const Jet& t) {
    return MP::internal::integer_power(t, i) * MP::internal::integer_power(Jet(Jet(1) - t), n - i) *
           Rational(factorial(n) / (factorial(i) * factorial(n - i)));
  };
  Surface sum;
  for (std::size_t i = 0; i <= d; ++i)
    for (std::size_t j = 0; j <= e; ++j)
      add(sum, bernstein(d, i, Jet::u_variable(uv.x())) * bernstein(e, j, Jet::v_variable(uv.y())),
          patch.control_point(i, j));
  return sum;
}

template <typename Patch>
void check_polynomial(const Patch& patch) {
  for (const Point_2& uv : samples(patch.domain())) {
    CHECK(same(patch.template evaluate<2>(uv), polynomial(patch, uv)));
    const Surface s = polynomial(patch, uv);
    CHECK(patch(uv) == Point_3(s[0].value(), s[1].value(), s[2].value()));
  }
}

template <typename Patch>
void check_same_surface(const Patch& a, const Patch& b) {
  for (const Point_2& uv : samples(a.domain()))
    CHECK(same(a.template evaluate<2>(uv), b.template evaluate<2>(uv)));
}

// The derivative of order 0, 1 or 2 across the side that a ribbon stands for.
Vector_3 across(const MP::Bezier_ribbon_3<Kernel>& ribbon, const Rational& s, std::size_t order) {
  std::vector<Rational> b(ribbon.degree() + 1);
  MP::internal::bernstein_polynomials(ribbon.degree(), s, b.data());
  const int m = static_cast<int>(ribbon.cross_degree());
  Vector_3 sum(0, 0, 0);
  for (std::size_t j = 0; j <= ribbon.degree(); ++j) {
    const auto row = [&](std::size_t k) { return ribbon.control_point(j, k) - CGAL::ORIGIN; };
    sum = sum + b[j] * (order == 0   ? row(0)
                        : order == 1 ? Rational(m) * (row(1) - row(0))
                                     : Rational(m * (m - 1)) * (row(2) - 2 * row(1) + row(0)));
  }
  return sum;
}

// The directional derivative of a surface, of order 0, 1 or 2.
Vector_3 along(const Surface& surface, const Vector_2& w, std::size_t order) {
  const auto coordinate = [&](const Jet& f) -> Rational {
    if (order == 0)
      return f[0];
    if (order == 1)
      return f[1] * w.x() + f[2] * w.y();
    return f[3] * w.x() * w.x() + 2 * f[4] * w.x() * w.y() + f[5] * w.y() * w.y();
  };
  return Vector_3(coordinate(surface[0]), coordinate(surface[1]), coordinate(surface[2]));
}

// The ribbons have the derivatives of the surface in the direction `inwards(i, p)` across side i at
// point p of the domain, all that they have layers for, up to the second.
template <typename Patch, typename Inwards>
void check_ribbons(const Patch& patch, const Inwards& inwards) {
  const Domain& domain = patch.domain();
  for (std::size_t i = 0; i < domain.size(); ++i) {
    const auto& ribbon = patch.loop()[i];
    for (const Rational& s : {Rational(0), ratio(1, 9), ratio(3, 5), Rational(1)}) {
      const Point_2 p = domain.point_on_side(i, s);
      const Surface surface = patch.template evaluate<2>(p);
      CHECK(ribbon.boundary_derivative(s) == along(surface, domain.side(i).to_vector(), 1));
      for (std::size_t order = 0; order < (std::min<std::size_t>)(ribbon.layers(), 3); ++order)
        CHECK(across(ribbon, s, order) == along(surface, inwards(i, p), order));
    }
  }
}

Vector_2 to_opposite_vertex(std::size_t side, const Point_2& p) {
  return oblique[(side + 2) % 3] - p;
}
Vector_2 into_square(std::size_t side, const Point_2&) {
  const std::array<Vector_2, 4> inwards{Vector_2(0, 1), Vector_2(-1, 0), Vector_2(0, -1),
                                        Vector_2(1, 0)};
  return inwards[side];
}

template <typename Patch>
void check_continuity(const Patch& patch) {
  const auto report = MP::continuity_report(patch, 8);
  CHECK(report.largest_position().value < 1e-10);
  CHECK(report.largest_tangent_plane().value < 1e-7);
  CHECK(report.largest_normal_curvature().value < 1e-7);
  for (const MP::Side_continuity& side : report.sides) {
    CHECK(side.tangent_plane.has_value() == (patch.loop()[side.side].layers() >= 2));
    CHECK(side.normal_curvature.has_value() == (patch.loop()[side.side].layers() >= 3));
  }
}

std::vector<Point_3> converted(const std::vector<Double_point>& points) {
  std::vector<Point_3> result;
  for (const Double_point& p : points)
    result.emplace_back(Rational(p.x()), Rational(p.y()), Rational(p.z()));
  return result;
}

} // namespace

TEST_CASE("A Bezier triangle is its polynomial in barycentric coordinates, with derivatives") {
  CAPTURE(seed);
  Random random;
  for (std::size_t degree = 1; degree <= 6; ++degree)
    check_polynomial(random_triangle(random, degree));
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
  Random random;
  const Double_triangle patch(3, random.doubles(10));
  const auto& domain = patch.domain();
  CHECK(domain.size() == 3);
  CHECK(domain.side_length(0) == Approx(domain.side_length(1)).epsilon(1e-14));
  CHECK(domain.side_length(1) == Approx(domain.side_length(2)).epsilon(1e-14));
  // A boundary that turns inwards at its corners changes nothing.
  const Triangle dented(2, {{0, 0, 0}, {9, 9, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 1}, {0, 9, 9}});
  CHECK(dented.domain().is_strictly_convex());
  check_polynomial(dented);
}

TEST_CASE("A Bezier triangle of a higher degree is the same surface") {
  CAPTURE(seed);
  Random random;
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
  Random random;
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
  Random random;
  for (std::size_t degree = 1; degree <= 7; ++degree) {
    const Triangle patch = random_triangle(random, degree);
    CHECK(patch.loop()[0].layers() == (degree < 5 ? 2 : (degree + 1) / 2));
    check_ribbons(patch, to_opposite_vertex);
  }
}

TEST_CASE("A tensor product patch is the product of its Bernstein sums, with derivatives") {
  CAPTURE(seed);
  Random random;
  for (std::size_t d = 1; d <= 4; ++d)
    for (std::size_t e = 1; e <= 4; ++e)
      check_polynomial(random_tensor_product(random, d, e));
}

TEST_CASE("A tensor product patch of higher degrees is the same surface") {
  CAPTURE(seed);
  Random random;
  for (std::size_t d = 1; d <= 3; ++d)
    for (std::size_t e = 1; e <= 3; ++e) {
      const Tensor_product patch = random_tensor_product(random, d, e);
      for (const auto& [du, dv] : {std::pair<std::size_t, std::size_t>(0, 2), {1, 0}, {2, 1}}) {
        const Tensor_product higher = patch.elevated_to(d + du, e + dv);
        CHECK(higher.degree_u() == d + du);
        CHECK(higher.degree_v() == e + dv);
        check_same_surface(higher, patch);
      }
    }
}

TEST_CASE("The ribbons of a tensor product patch have the derivatives of the surface, exactly") {
  CAPTURE(seed);
  Random random;
  for (std::size_t d = 1; d <= 6; ++d)
    for (std::size_t e = 1; e <= 6; ++e) {
      const Tensor_product patch = random_tensor_product(random, d, e);
      CHECK(patch.loop()[0].layers() == (e + 1) / 2);
      CHECK(patch.loop()[1].layers() == (d + 1) / 2);
      check_ribbons(patch, into_square);
    }
}

TEST_CASE("A continuity report finds parametric patches to meet their ribbons") {
  CAPTURE(seed);
  Random random;
  for (const std::size_t degree : {1, 2, 4, 5})
    check_continuity(random_triangle(random, degree));
  for (const std::size_t degree : {1, 3, 5})
    check_continuity(random_tensor_product(random, degree, degree + 1));
}

TEST_CASE("The ribbons of a square patch are those of its net as a generalized Bezier patch") {
  CAPTURE(seed);
  Random random;
  for (const std::size_t d : {3, 4, 5, 6}) {
    const Tensor_product patch = random_tensor_product(random, d, d);
    using Net = MP::Generalized_bezier_net_3<Kernel>;
    const Net layout(4, d,
                     std::vector<Point_3>(Net::number_of_control_points(4, d), Point_3(0, 0, 0)));
    std::vector<Point_3> points = layout.control_points();
    for (std::size_t j = 0; j <= d; ++j)
      for (std::size_t k = 0; k < layout.layers(); ++k) {
        points[layout.index(0, j, k)] = patch.control_point(j, k);
        points[layout.index(1, j, k)] = patch.control_point(d - k, j);
        points[layout.index(2, j, k)] = patch.control_point(d - j, d - k);
        points[layout.index(3, j, k)] = patch.control_point(k, d - j);
      }
    const auto loop = layout.with_control_points(points).loop();
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(patch.loop()[i].control_points() == loop[i].control_points());
  }
}

TEST_CASE("A bilinear patch has its corners in counterclockwise order") {
  const Point_3 corners[4] = {{0, 0, 0}, {2, 0, 1}, {2, 3, 0}, {0, 3, 1}};
  const Tensor_product patch =
      Tensor_product::bilinear(corners[0], corners[1], corners[2], corners[3]);
  CHECK(patch.degree_u() == 1);
  CHECK(patch.degree_v() == 1);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(patch(patch.domain().vertex(i)) == corners[i]);
    CHECK(patch.loop().corner_point(i) == corners[i]);
  }
  const Rational u = ratio(1, 3), v = ratio(3, 4);
  CHECK(patch({u, v}) == Point_3(2 * u, 3 * v, u + v - 2 * u * v));
}

TEST_CASE("Normals point to the side from which the boundary runs counterclockwise") {
  // z = xy over [0,1]², and the same over the triangle below its diagonal.
  const Tensor_product square =
      Tensor_product::bilinear({0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0});
  const Rational half = ratio(1, 2);
  const Triangle triangle(
      2, {{0, 0, 0}, {half, 0, 0}, {1, 0, 0}, {0, half, 0}, {half, half, half}, {0, 1, 0}},
      Domain({Point_2(0, 0), Point_2(1, 0), Point_2(0, 1)}));
  const auto check = [](const auto& patch, const Point_2& uv) {
    const double x = CGAL::to_double(uv.x()), y = CGAL::to_double(uv.y());
    const double length = std::sqrt(x * x + y * y + 1);
    const Vector_3 n = patch.normal(uv);
    CHECK(patch(uv) == Point_3(uv.x(), uv.y(), uv.x() * uv.y()));
    CHECK(CGAL::to_double(n.x()) == Approx(-y / length).epsilon(0).margin(1e-15));
    CHECK(CGAL::to_double(n.y()) == Approx(-x / length).epsilon(0).margin(1e-15));
    CHECK(CGAL::to_double(n.z()) == Approx(1 / length).epsilon(1e-15));
  };
  for (const Point_2& uv : samples(square.domain()))
    check(square, uv);
  for (const Point_2& uv : samples(triangle.domain()))
    check(triangle, uv);
}

TEST_CASE("Patches over doubles are evaluated in rationals at once") {
  CAPTURE(seed);
  Random random;
  const auto in_triangle = random.doubles(15), in_square = random.doubles(20);
  using Double_point_2 = Double_kernel::Point_2;
  const std::vector<Double_point_2> vertices{{0.1, 0.2}, {1.3, 0.3}, {0.4, 0.9}};
  std::vector<Point_2> exact_vertices;
  for (const Double_point_2& p : vertices)
    exact_vertices.emplace_back(Rational(p.x()), Rational(p.y()));
  const Double_triangle triangle(4, in_triangle, Double_triangle::Domain(vertices));
  const Triangle exact_triangle(4, converted(in_triangle), Domain(exact_vertices));
  const Double_tensor_product square(3, 4, in_square);
  const Tensor_product exact_square(3, 4, converted(in_square));

  const auto check = [](const auto& patch, const auto& exact, const Point_2& uv) {
    const auto location = exact.domain().locate_inside(uv);
    const Surface expected = exact.template evaluate<2>(uv, location);
    CHECK(same(patch.template evaluate<2, Rational>(uv.x(), uv.y(), location), expected));
    // In double the point is rounded, and its location, too.
    const typename Double_triangle::Location rounded{
        static_cast<Double_triangle::Location::Kind>(location.kind), location.index,
        CGAL::to_double(location.s)};
    const auto in_double =
        patch.template evaluate<2>({CGAL::to_double(uv.x()), CGAL::to_double(uv.y())}, rounded);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < Jet::size; ++k)
        CHECK(in_double[c][k] ==
              Approx(CGAL::to_double(expected[c][k])).epsilon(0).margin(k == 0 ? 1e-14 : 1e-11));
  };
  for (const Point_2& uv : samples(exact_triangle.domain()))
    check(triangle, exact_triangle, uv);
  for (const Point_2& uv : samples(exact_square.domain()))
    check(square, exact_square, uv);
}

TEST_CASE("Parametric patches refuse sizes and domains that do not fit") {
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

  const auto tensor_product = [](std::size_t d, std::size_t e, std::size_t n) {
    return Tensor_product(d, e, std::vector<Point_3>(n, Point_3(0, 0, 0)));
  };
  CHECK_THROWS_WITH(tensor_product(0, 2, 3), Contains("from 1 to 1000, not 0 by 2"));
  CHECK_THROWS_WITH(tensor_product(2, 1001, 3), Contains("not 2 by 1001"));
  CHECK_THROWS_WITH(tensor_product(2, 3, 11),
                    Contains("degree 2 by 3 has 12 control points, not 11"));
  CHECK_THROWS_WITH(Tensor_product::bilinear(corners[0], corners[1], corners[2], corners[2]),
                    Contains("side 2 is a single point"));

  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(Double_triangle(1, {{0, 0, 0}, {1, 0, 0}, {0, 1, nan}}),
                    Contains("control point 2 of a Bezier triangle is not finite"));
  CHECK_THROWS_WITH(Double_tensor_product::bilinear({0, 0, 0}, {1, 0, 0}, {1, 1, nan}, {0, 1, 0}),
                    Contains("control point 3 of a tensor product patch is not finite"));
}
