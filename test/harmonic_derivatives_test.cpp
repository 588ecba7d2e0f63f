// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "harmonic_fixtures.h"

using namespace fixtures;

TEST_CASE("The derivative along a side is that of the boundary values", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-6)) {
    const Domain& domain = h.domain();
    for (std::size_t k = 0; k < domain.size(); ++k)
      for (const double s : {1e-6, 0.01, 0.3, 0.5, 0.9, 1 - 1e-5}) {
        const auto lambda = evaluate<1>(h, domain.point_on_side(k, s), Location::on_side(k, s));
        const auto d = domain.vertex(domain.next(k)) - domain.vertex(k);
        for (std::size_t i = 0; i < domain.size(); ++i) {
          const double slope = lambda[i][1] * d.x() + lambda[i][2] * d.y();
          CHECK(slope == Approx(i == k ? -1 : i == domain.next(k) ? 1 : 0).epsilon(0).margin(1e-6));
        }
      }
  }
}

// The formulas of the derivatives against differences of the very same approximation, of which only
// the rounding is different.
TEST_CASE("Gradients and Hessians agree with differences in higher precision", "[harmonic]") {
  using Real = long double;
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-8)) {
    const Domain& domain = h.domain();
    const std::size_t n = domain.size();
    for (const Point_2& p : random_points_inside(domain, 20)) {
      const double radius = distance_to_boundary(domain, p);
      const Real e = 1e-5 * radius, x = p.x(), y = p.y();
      const auto gradients = [&](const Real& u, const Real& v) {
        std::vector<MP::Jet_2<Real, 1>> lambda(n);
        h.evaluate_extended(u, v, lambda.data());
        return lambda;
      };
      // differences of fourth order
      const auto difference = [&](const auto& f, std::size_t i, std::size_t k) {
        return (8 * (f[2][i][k] - f[1][i][k]) - (f[3][i][k] - f[0][i][k])) / (12 * e);
      };
      const std::vector<MP::Jet_2<Real, 1>> u[4] = {gradients(x - 2 * e, y), gradients(x - e, y),
                                                    gradients(x + e, y), gradients(x + 2 * e, y)},
                                            v[4] = {gradients(x, y - 2 * e), gradients(x, y - e),
                                                    gradients(x, y + e), gradients(x, y + 2 * e)};
      const auto at = evaluate<2>(h, p);
      for (std::size_t i = 0; i < n; ++i) {
        // Harmonic functions between 0 and 1 have derivatives below k! / radius^k.
        const double first = 1e-9 / radius, second = 1e-8 / (radius * radius);
        CHECK(std::abs(at[i][1] - difference(u, i, 0)) < first);
        CHECK(std::abs(at[i][2] - difference(v, i, 0)) < first);
        CHECK(std::abs(at[i][3] - difference(u, i, 1)) < second);
        CHECK(std::abs(at[i][4] - difference(u, i, 2)) < second);
        CHECK(std::abs(at[i][4] - difference(v, i, 1)) < second);
        CHECK(std::abs(at[i][5] - difference(v, i, 2)) < second);
      }
    }
  }
}

TEST_CASE("Double precision costs few digits of values", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-8))
    for (const Point_2& p : random_points_inside(h.domain(), 50)) {
      std::vector<MP::Jet_2<long double, 0>> precise(h.domain().size());
      std::vector<Jet<0>> rounded(h.domain().size());
      h.evaluate_extended(static_cast<long double>(p.x()), static_cast<long double>(p.y()),
                          precise.data());
      h.evaluate_extended(p.x(), p.y(), rounded.data());
      for (std::size_t i = 0; i < precise.size(); ++i)
        CHECK(std::abs(precise[i][0] - rounded[i][0]) < 0.1 * h.error_bound() + 1e-13);
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
      if (domain.corner_type(k) != MP::Corner_type::convex)
        continue;
      const auto a = domain.vertex(domain.next(k)) - domain.vertex(k);
      const auto b = domain.vertex(domain.prev(k)) - domain.vertex(k);
      CHECK(lambda[k][1] * a.x() + lambda[k][2] * a.y() == Approx(-1));
      CHECK(lambda[k][1] * b.x() + lambda[k][2] * b.y() == Approx(-1));
    }
  }
}

// They are taken at points so near to the vertices that far from the origin no number lies between.
TEST_CASE("Derivatives at vertices are the same in higher precision, anywhere", "[harmonic]") {
  for (const double offset : {0., 1e3, 1e12}) {
    Points points;
    for (const Point_2& p : Points{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}})
      points.emplace_back(p.x() + offset, p.y() + 3 * offset);
    const Harmonic_coordinates_2 h{Domain(points)};
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto lambda = evaluate<2>(h, points[k], Location::on_vertex(k));
      std::vector<MP::Jet_2<long double, 2>> precise(points.size());
      h.evaluate<2>(static_cast<long double>(points[k].x()),
                    static_cast<long double>(points[k].y()),
                    MP::Domain_location<long double>::on_vertex(k), precise.data());
      for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < Jet<2>::size; ++j)
          CHECK(lambda[i][j] == Approx(static_cast<double>(precise[i][j])).margin(1e-6));
    }
  }
}

namespace {

// points inside, on the sides and at the vertices, in mixed order
struct Queries {
  Points points;
  std::vector<Location> locations;

  explicit Queries(const Domain& domain) {
    for (const Point_2& p : random_points_inside(domain, 300)) {
      const std::size_t k = points.size();
      points.push_back(p);
      locations.push_back(Location::interior());
      if (k % 3 == 0 && k / 3 < domain.size()) {
        const double s = k % 2 == 0 ? 0.3 : 0;
        points.push_back(domain.point_on_side(k / 3, s));
        locations.push_back(domain.location_on_side(k / 3, s));
      }
    }
  }
};

template <int Order>
void check_batch(const Harmonic_coordinates_2& h) {
  const Queries queries(h.domain());
  const auto batch = h.evaluate_batch<Order>(queries.points, queries.locations);
  for (const auto& matrix : batch) {
    REQUIRE(matrix.rows() == static_cast<Eigen::Index>(h.domain().size()));
    REQUIRE(matrix.cols() == static_cast<Eigen::Index>(queries.points.size()));
  }
  for (std::size_t j = 0; j < queries.points.size(); ++j) {
    const auto lambda = evaluate<Order>(h, queries.points[j], queries.locations[j]);
    double scale = 1;
    for (const auto& l : lambda)
      for (std::size_t k = 0; k < batch.size(); ++k)
        scale = (std::max)(scale, std::abs(l[k]));
    for (std::size_t i = 0; i < lambda.size(); ++i)
      for (std::size_t k = 0; k < batch.size(); ++k)
        CHECK(std::abs(batch[k](static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) -
                       lambda[i][k]) < 1e-11 * scale);
  }
}

} // namespace

TEST_CASE("A batch of points gives what the points give one by one", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-6)) {
    check_batch<0>(h);
    check_batch<1>(h);
    check_batch<2>(h);
  }
  const Harmonic_coordinates_2 h(square_with_triangular_hole(), 1e-6);
  CHECK(h.evaluate_batch(Points()).front().cols() == 0);
  CHECK(h.evaluate_batch<1>(Points{{0.5, 0.5}, {0, 1}}).front()(0, 1) == Approx(2. / 3));
  CHECK_THROWS_AS(h.evaluate_batch(Points{{0.5, 0.5}, {1.5, 1.5}}), MP::Outside_domain_error);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("Several threads find the same harmonic coordinates as one", "[harmonic]") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const Domain domain = random_domain(random, 40, 2);
    const Harmonic_coordinates_2 one(domain, 1e-6, 0, CGAL::Sequential_tag()),
        several(domain, 1e-6, 0, CGAL::Parallel_tag());
    CHECK(one.error_bound() == several.error_bound());
    const Queries queries(domain);
    const auto a = one.evaluate_batch<1, CGAL::Sequential_tag>(queries.points, queries.locations),
               b = several.evaluate_batch<1, CGAL::Parallel_tag>(queries.points, queries.locations);
    for (std::size_t k = 0; k < a.size(); ++k)
      CHECK(a[k] == b[k]);
  }
}
#endif
