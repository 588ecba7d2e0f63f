// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>

#include "catch.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Points = std::vector<Point_2>;
using Domain = CGAL::Multisided_patches::Polygonal_domain_2<Kernel>;
using Location = Domain::Location;
using Harmonic_coordinates_2 = CGAL::Multisided_patches::Harmonic_coordinates_2<Kernel>;
template <int Order>
using Jet = CGAL::Multisided_patches::Jet_2<double, Order>;

constexpr double pi = 3.14159265358979323846;

// fixtures

Points square() {
  return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
}
Points L_shape() {
  return {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
}
Points U_shape() {
  return {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
}

Points regular_polygon(int n) {
  Points p;
  for (int i = 0; i < n; ++i)
    p.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n));
  return p;
}

Points star() {
  Points p;
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.4;
    p.emplace_back(r * std::cos(pi * i / 5), r * std::sin(pi * i / 5));
  }
  return p;
}

// a cut of width 0.002 from the outside
Points slotted() {
  return {{0, 0}, {2, 0}, {2, 1}, {1.001, 1}, {1.001, 0.2}, {0.999, 0.2}, {0.999, 1}, {0, 1}};
}

// two rooms that a corridor of the given width joins
Points dumbbell(double width) {
  return {{0, 0}, {2, 0}, {2, 1}, {1.5, 1}, {1.5, width}, {0.5, width}, {0.5, 1}, {0, 1}};
}

// a spike of about 0.2 degrees
Points spiked() {
  return {{0, 0}, {2, 0}, {2, 1}, {1.05, 1}, {1, 30}, {0.95, 1}, {0, 1}};
}

Points with_straight_corners() {
  return {{0, 0}, {0.7, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 1.5}, {1, 2}, {0, 2}, {0, 0.5}};
}

// corners within 1e-3 and 1e-9 radians of straight, on either side
Points with_nearly_straight_corners() {
  return {{0, 0}, {1, 1e-3}, {2, 0}, {2, 1}, {1.5, 1 + 1e-9}, {1, 1}, {0.5, 1.001}, {0, 1}};
}

Domain square_with_holes() {
  return Domain(
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}},
      {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {{2.5, 2.5}, {2.5, 3.5}, {3.5, 3.5}, {3.5, 2.5}}});
}

Domain square_with_triangular_hole() {
  return Domain({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{{1, 1}, {1.4, 2.2}, {2.5, 1.3}}});
}

// domains with all sides parallel to the axes
std::vector<Domain> rectilinear_domains() {
  return {Domain(square()),       Domain(L_shape()),
          Domain(U_shape()),      Domain(slotted()),
          Domain(dumbbell(1e-2)), Domain(dumbbell(1e-6)),
          square_with_holes(),    Domain(with_straight_corners())};
}

std::vector<Domain> all_domains() {
  std::vector<Domain> domains = rectilinear_domains();
  for (const Points& p : {Points{{0, 0}, {1, 0}, {0.3, 0.8}}, regular_polygon(5),
                          regular_polygon(16), star(), spiked(), with_nearly_straight_corners()})
    domains.emplace_back(p);
  domains.push_back(square_with_triangular_hole());
  return domains;
}

// the coordinates on all of them; kept, as most tests want the same accuracies
const std::vector<Harmonic_coordinates_2>& on_all_domains(double target_error) {
  static std::map<double, std::vector<Harmonic_coordinates_2>> coordinates;
  std::vector<Harmonic_coordinates_2>& result = coordinates[target_error];
  if (result.empty())
    for (const Domain& domain : all_domains())
      result.emplace_back(domain, target_error);
  return result;
}

// a simple polygon through random points of the unit square: crossings are undone one by one
Points random_polygon(int n, std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(0, 1);
  Points p;
  for (int i = 0; i < n; ++i) {
    const double x = uniform(generator), y = uniform(generator);
    p.emplace_back(x, y);
  }
  const auto uncross = [&] {
    for (int i = 0; i < n; ++i)
      for (int j = i + 2; j < n; ++j)
        if ((j + 1) % n != i && CGAL::do_intersect(Kernel::Segment_2(p[i], p[i + 1]),
                                                   Kernel::Segment_2(p[j], p[(j + 1) % n]))) {
          std::reverse(p.begin() + i + 1, p.begin() + j + 1);
          return true;
        }
    return false;
  };
  while (uncross()) {
  }
  double area = 0;
  for (int i = 0; i < n; ++i) {
    const Point_2 &a = p[i], &b = p[(i + 1) % n];
    area += a.x() * b.y() - a.y() * b.x();
  }
  if (area < 0)
    std::reverse(p.begin(), p.end());
  return p;
}

Points random_points_inside(const Domain& domain, int count, unsigned seed = 1) {
  std::mt19937 generator(seed);
  const CGAL::Bbox_2 box = domain.bbox();
  std::uniform_real_distribution<double> x(box.xmin(), box.xmax()), y(box.ymin(), box.ymax());
  Points points;
  while (points.size() < static_cast<std::size_t>(count)) {
    const double px = x(generator), py = y(generator);
    if (domain.locate({px, py}).kind == Location::Kind::interior)
      points.emplace_back(px, py);
  }
  return points;
}

// helpers

template <int Order>
std::vector<Jet<Order>> evaluate(const Harmonic_coordinates_2& h, const Point_2& p,
                                 const Location& location = Location::interior()) {
  std::vector<Jet<Order>> lambda(h.domain().size());
  h.evaluate<Order>(p, location, lambda.data());
  return lambda;
}

double largest_difference(const std::vector<Jet<0>>& a, const std::vector<Jet<0>>& b) {
  double max = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    max = (std::max)(max, std::abs(a[i][0] - b[i][0]));
  return max;
}

// the largest difference of the values of two approximations, over random points
double largest_difference(const Harmonic_coordinates_2& a, const Harmonic_coordinates_2& b) {
  double max = 0;
  for (const Point_2& p : random_points_inside(a.domain(), 200))
    max = (std::max)(max, largest_difference(evaluate<0>(a, p), evaluate<0>(b, p)));
  return max;
}

} // namespace

TEST_CASE("Harmonic coordinates sum to one and reproduce linear functions", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-8)) {
    const Domain& domain = h.domain();
    const double size = domain.diameter();
    for (const Point_2& p : random_points_inside(domain, 100)) {
      const auto lambda = evaluate<2>(h, p);
      Jet<2> sum, x, y;
      double scale = 1; // derivatives are large near reflex corners, and cancel
      for (std::size_t i = 0; i < domain.size(); ++i) {
        sum += lambda[i];
        x += lambda[i] * domain.vertex(i).x();
        y += lambda[i] * domain.vertex(i).y();
        for (std::size_t k = 1; k < 6; ++k)
          scale = (std::max)(scale, std::abs(lambda[i][k]));
      }
      CHECK(std::abs(sum[0] - 1) < 1e-13);
      CHECK(std::abs(x[0] - p.x()) < 1e-13 * size);
      CHECK(std::abs(y[0] - p.y()) < 1e-13 * size);
      const Jet<2> u = Jet<2>::u_variable(p.x()), v = Jet<2>::v_variable(p.y());
      for (std::size_t k = 1; k < 6; ++k) {
        CHECK(std::abs(sum[k]) < 1e-13 * scale);
        CHECK(std::abs(x[k] - u[k]) < 1e-13 * scale * size);
        CHECK(std::abs(y[k] - v[k]) < 1e-13 * scale * size);
      }
    }
  }
}

TEST_CASE("Harmonic coordinates are exact at the vertices and on the sides", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-6)) {
    const Domain& domain = h.domain();
    for (std::size_t k = 0; k < domain.size(); ++k) {
      const auto at_vertex = evaluate<1>(h, domain.vertex(k), Location::on_vertex(k));
      const auto on_side =
          evaluate<1>(h, domain.point_on_side(k, 0.25), Location::on_side(k, 0.25));
      for (std::size_t i = 0; i < domain.size(); ++i) {
        CHECK(at_vertex[i][0] == (i == k ? 1 : 0));
        CHECK(on_side[i][0] == (i == k ? 0.75 : i == domain.next(k) ? 0.25 : 0));
      }
    }
  }
}

TEST_CASE("The derivative along a side is that of the boundary values", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-6)) {
    const Domain& domain = h.domain();
    for (std::size_t k = 0; k < domain.size(); ++k)
      for (const double s : {1e-6, 0.01, 0.3, 0.5, 0.9, 1 - 1e-5}) {
        const auto lambda = evaluate<1>(h, domain.point_on_side(k, s), Location::on_side(k, s));
        const auto d = domain.vertex(domain.next(k)) - domain.vertex(k);
        for (std::size_t i = 0; i < domain.size(); ++i) {
          const double slope = lambda[i][1] * d.x() + lambda[i][2] * d.y();
          CHECK(slope == Approx(i == k ? -1 : i == domain.next(k) ? 1 : 0).margin(1e-6));
        }
      }
  }
}

TEST_CASE("Harmonic coordinates approach their boundary values from the inside", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-8)) {
    const Domain& domain = h.domain();
    // Values rise from 0 to 1 across a gap; the point is 1e-12 side lengths away from the side.
    const double tolerance = 1e-10 + 1e-11 * domain.diameter() / domain.clearance();
    for (std::size_t k = 0; k < domain.size(); ++k)
      for (const double s : {0.1, 0.5, 0.8}) {
        const Point_2 p = domain.point_on_side(k, s);
        const auto d = domain.vertex(domain.next(k)) - domain.vertex(k);
        const Point_2 q(p.x() - 1e-12 * d.y(), p.y() + 1e-12 * d.x());
        if (domain.locate(q).kind != Location::Kind::interior)
          continue;
        const auto lambda = evaluate<0>(h, q);
        for (std::size_t i = 0; i < domain.size(); ++i) {
          const double boundary = i == k ? 1 - s : i == domain.next(k) ? s : 0;
          CHECK(std::abs(lambda[i][0] - boundary) < tolerance);
        }
      }
  }
}

TEST_CASE("Harmonic coordinates obey the maximum principle", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-11)) {
    const Domain& domain = h.domain();
    for (const Point_2& p : random_points_inside(domain, 500))
      for (const Jet<0>& lambda : evaluate<0>(h, p)) {
        CHECK(lambda[0] > -1e-12);
        CHECK(lambda[0] < 1 + 1e-12);
      }
  }
}

TEST_CASE("On triangles and rectangles harmonic coordinates are polynomials", "[harmonic]") {
  const Harmonic_coordinates_2 triangle(Domain({{0, 0}, {2, 0}, {0, 1}}));
  const auto t = evaluate<2>(triangle, {0.3, 0.4});
  const double barycentric[6] = {0.15, 0.5, 0, 0, 0, 0};
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(t[1][k] == Approx(barycentric[k]).margin(1e-13));

  const Harmonic_coordinates_2 unit_square{Domain(square())};
  for (const Point_2& p : random_points_inside(unit_square.domain(), 50)) {
    const auto lambda = evaluate<2>(unit_square, p);
    const double bilinear[6] = {p.x() * p.y(), p.y(), p.x(), 0, 1, 0}; // λ_2 = xy
    for (std::size_t k = 0; k < 6; ++k)
      CHECK(lambda[2][k] == Approx(bilinear[k]).margin(1e-11));
  }
}

// xy is harmonic, and linear on every side parallel to an axis.
TEST_CASE("Between sides parallel to the axes, the function xy is reproduced", "[harmonic]") {
  for (const Domain& domain : rectilinear_domains()) {
    const Harmonic_coordinates_2 h(domain);
    for (const Point_2& p : random_points_inside(domain, 100)) {
      const auto lambda = evaluate<2>(h, p);
      Jet<2> sum;
      for (std::size_t i = 0; i < domain.size(); ++i)
        sum += lambda[i] * (domain.vertex(i).x() * domain.vertex(i).y());
      const double exact[6] = {p.x() * p.y(), p.y(), p.x(), 0, 1, 0};
      const double tolerance[6] = {1e-8, 1e-6, 1e-6, 1e-4, 1e-4, 1e-4};
      for (std::size_t k = 0; k < 6; ++k)
        CHECK(sum[k] == Approx(exact[k]).margin(10 * tolerance[k]));
    }
  }
}

// A harmonic function is determined by its boundary values, which are exact, and this property.
TEST_CASE("The value at a point is the mean over circles around it", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-11)) {
    const Domain& domain = h.domain();
    for (const Point_2& c : random_points_inside(domain, 10)) {
      double squared = domain.diameter();
      for (std::size_t k = 0; k < domain.size(); ++k)
        squared = (std::min)(squared, CGAL::squared_distance(c, domain.side(k)));
      const double radius = 0.8 * std::sqrt(squared);
      const int samples = 150; // the trapezoidal rule converges like 0.8^samples
      std::vector<Jet<0>> mean(domain.size());
      for (int j = 0; j < samples; ++j) {
        const double t = 2 * pi * j / samples;
        const auto lambda =
            evaluate<0>(h, {c.x() + radius * std::cos(t), c.y() + radius * std::sin(t)});
        for (std::size_t i = 0; i < domain.size(); ++i)
          mean[i] += lambda[i] * (1. / samples);
      }
      CHECK(largest_difference(mean, evaluate<0>(h, c)) < 1e-9);
    }
  }
}

TEST_CASE("Harmonic coordinates are as symmetric as the domain", "[harmonic]") {
  for (const int n : {3, 4, 5, 8, 13}) {
    const Harmonic_coordinates_2 h(Domain(regular_polygon(n)), 1e-11);
    for (const Jet<0>& lambda : evaluate<0>(h, {0, 0}))
      CHECK(lambda[0] == Approx(1. / n).margin(1e-11));
  }
  const Harmonic_coordinates_2 h(Domain(L_shape()), 1e-11);
  const std::size_t mirrored[6] = {0, 5, 4, 3, 2, 1};
  for (const Point_2& p : random_points_inside(h.domain(), 50)) {
    const auto a = evaluate<0>(h, p), b = evaluate<0>(h, {p.y(), p.x()});
    for (std::size_t i = 0; i < 6; ++i)
      CHECK(a[i][0] == Approx(b[mirrored[i]][0]).margin(1e-10));
  }
}

namespace {

// coordinate of the reflex corner (1,1) of the L-shape at (0.5,0.5), by the five-point stencil on a
// grid of m cells a unit and successive over-relaxation
double five_point_value(int m) {
  const int size = 2 * m;
  std::vector<std::vector<double>> u(size + 1, std::vector<double>(size + 1, 0.));
  for (int i = m; i <= size; ++i)
    u[i][m] = u[m][i] = 2 - double(i) / m; // the hat on its two sides
  const auto inside = [&](int i, int j) {
    return 0 < i && i < size && 0 < j && j < size && (i < m || j < m);
  };
  const double factor = 2 / (1 + std::sin(pi / size));
  for (int sweep = 0; sweep < 12 * m; ++sweep)
    for (int i = 1; i < size; ++i)
      for (int j = 1; j < size; ++j)
        if (inside(i, j))
          u[i][j] +=
              factor * ((u[i - 1][j] + u[i + 1][j] + u[i][j - 1] + u[i][j + 1]) / 4 - u[i][j]);
  return u[m / 2][m / 2];
}

} // namespace

TEST_CASE("Finite differences converge to the harmonic coordinates", "[harmonic]") {
  const Harmonic_coordinates_2 h(Domain(L_shape()), 1e-11);
  const double value = evaluate<0>(h, {0.5, 0.5})[3][0];
  // The order is 4/3, from the corner of 270 degrees. Extrapolation takes off the leading term.
  const double coarse = five_point_value(32), fine = five_point_value(64);
  const double ratio = std::pow(2, 4. / 3);
  CHECK(std::abs(fine - value) < 0.45 * std::abs(coarse - value));
  CHECK(std::abs((ratio * fine - coarse) / (ratio - 1) - value) < 3e-5);
}

TEST_CASE("The error stays below its bound, and the bound below the target", "[harmonic]") {
  for (const Harmonic_coordinates_2& fine : on_all_domains(1e-11)) {
    const Domain& domain = fine.domain();
    CHECK(fine.error_bound() < 1e-10);
    for (const double target : {1e-4, 1e-7}) {
      const Harmonic_coordinates_2 h(domain, target);
      CHECK(h.error_bound() <= target);
      INFO(domain.size() << " sides, the first from " << domain.side(0) << ", target " << target);
      CHECK(largest_difference(h, fine) <= h.error_bound() + fine.error_bound());
    }
  }
}

TEST_CASE("Gradients and Hessians agree with differences", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-11)) {
    const Domain& domain = h.domain();
    for (const Point_2& p : random_points_inside(domain, 20)) {
      double squared = 1;
      for (std::size_t k = 0; k < domain.size(); ++k)
        squared = (std::min)(squared, CGAL::squared_distance(p, domain.side(k)));
      const double radius = std::sqrt(squared), e = 1e-3 * radius;
      const auto at = evaluate<2>(h, p);
      const auto right = evaluate<1>(h, {p.x() + e, p.y()}),
                 left = evaluate<1>(h, {p.x() - e, p.y()}), up = evaluate<1>(h, {p.x(), p.y() + e}),
                 down = evaluate<1>(h, {p.x(), p.y() - e});
      for (std::size_t i = 0; i < domain.size(); ++i) {
        // Harmonic functions between 0 and 1 have derivatives below k! / radius^k.
        const double first = 1e-4 / radius, second = first / radius;
        CHECK(at[i][1] == Approx((right[i][0] - left[i][0]) / (2 * e)).margin(first));
        CHECK(at[i][2] == Approx((up[i][0] - down[i][0]) / (2 * e)).margin(first));
        CHECK(at[i][3] == Approx((right[i][1] - left[i][1]) / (2 * e)).margin(second));
        CHECK(at[i][4] == Approx((right[i][2] - left[i][2]) / (2 * e)).margin(second));
        CHECK(at[i][5] == Approx((up[i][2] - down[i][2]) / (2 * e)).margin(second));
      }
    }
  }
}

TEST_CASE("Derivatives at vertices are finite, and at convex ones the limits", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-8)) {
    const Domain& domain = h.domain();
    for (std::size_t k = 0; k < domain.size(); ++k) {
      const auto lambda = evaluate<2>(h, domain.vertex(k), Location::on_vertex(k));
      for (const Jet<2>& jet : lambda)
        for (std::size_t j = 0; j < Jet<2>::size; ++j)
          CHECK(std::isfinite(jet[j]));
      if (domain.corner_type(k) != CGAL::Multisided_patches::Corner_type::convex)
        continue;
      const auto a = domain.vertex(domain.next(k)) - domain.vertex(k);
      const auto b = domain.vertex(domain.prev(k)) - domain.vertex(k);
      CHECK(lambda[k][1] * a.x() + lambda[k][2] * a.y() == Approx(-1));
      CHECK(lambda[k][1] * b.x() + lambda[k][2] * b.y() == Approx(-1));
    }
  }
}

TEST_CASE("Harmonic coordinates are invariant under similarities", "[harmonic]") {
  const Domain domain(U_shape());
  const Harmonic_coordinates_2 h(domain, 1e-10);
  struct Similarity {
    double scale, angle, x, y;
    Point_2 operator()(const Point_2& p) const {
      const double c = scale * std::cos(angle), s = scale * std::sin(angle);
      return {c * p.x() - s * p.y() + x, s * p.x() + c * p.y() + y};
    }
  };
  for (const Similarity& map :
       {Similarity{1e-9, 0, 0, 0}, Similarity{1e9, 0, 0, 0}, Similarity{1, 1, 0, 0},
        Similarity{3e-5, 2, 7e-4, -1}, Similarity{1, 0.5, 1e6, -2e6}}) {
    Points image;
    for (const Point_2& p : domain.vertices())
      image.push_back(map(p));
    const Harmonic_coordinates_2 g(Domain(image), 1e-10);
    // as many digits as the coordinates have after the translation
    const double tolerance = 1e-9 + 1e-15 * (std::abs(map.x) + std::abs(map.y)) / map.scale;
    for (const Point_2& p : random_points_inside(domain, 30)) {
      const auto a = evaluate<1>(h, p), b = evaluate<1>(g, map(p));
      for (std::size_t i = 0; i < domain.size(); ++i) {
        CHECK(a[i][0] == Approx(b[i][0]).margin(tolerance));
        const double length = std::hypot(a[i][1], a[i][2]);
        CHECK(length ==
              Approx(map.scale * std::hypot(b[i][1], b[i][2])).epsilon(1e-6).margin(1e-6));
      }
    }
  }
}

TEST_CASE("Random polygons give consistent results at different accuracies", "[harmonic]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    std::mt19937 generator(seed);
    const int n = 3 + static_cast<int>(seed * seed) % 28;
    const Domain domain(random_polygon(n, generator));
    const Harmonic_coordinates_2 coarse(domain, 1e-4), fine(domain, 1e-6);
    CHECK(coarse.error_bound() <= 1e-4);
    CHECK(fine.error_bound() <= 1e-6);
    CHECK(largest_difference(coarse, fine) <= coarse.error_bound() + fine.error_bound());
  }
}

TEST_CASE("Slivers and tiny sides are resolved", "[harmonic]") {
  for (const Points& p : {Points{{0, 0}, {1, 0}, {0.4, 1e-6}}, Points{{0, 0}, {1, 0}, {1, 1e-7}},
                          Points{{0, 0}, {1, 0}, {1, 1e-9}, {0, 1e-9}},
                          Points{{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5 - 1e-6, 1}, {0, 1}},
                          Points{{0, 0}, {1, 0}, {1, 1}, {0.6, 1}, {0.5, 1e-6}, {0.4, 1}, {0, 1}}})
    CHECK(Harmonic_coordinates_2(Domain(p), 1e-6).error_bound() <= 1e-6);
}

TEST_CASE("The output iterator gets one value a vertex, and points outside are refused",
          "[harmonic]") {
  const Harmonic_coordinates_2 h(square_with_triangular_hole(), 1e-6);
  std::vector<double> values;
  h({0.5, 0.5}, std::back_inserter(values));
  CHECK(values.size() == 7);
  CHECK_THROWS_AS(h({1.5, 1.5}, std::back_inserter(values)),
                  CGAL::Multisided_patches::Outside_domain_error);
}
