// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fuzz/random_plans.h"
#include "harmonic_fixtures.h"

using namespace fixtures;

TEST_CASE("The error stays below its bound, and the bound below the target", "[harmonic]") {
  for (const Harmonic_coordinates_2& fine : on_all_domains(1e-11)) {
    const Domain& domain = fine.domain();
    CHECK(fine.error_bound() <= 1e-10);
    for (const double target : {1e-2, 1e-4, 1e-7, 1e-9}) {
      const Harmonic_coordinates_2 h(domain, target);
      CHECK(h.error_bound() <= target);
      INFO(domain.size() << " sides, the first from " << domain.side(0) << ", target " << target);
      CHECK(largest_difference(h, fine) <= h.error_bound() + fine.error_bound());
    }
  }
}

// Next to short sides, and between facing ones, functions vary on very different scales in one
// cell.
TEST_CASE("The bound holds on domains whose sides are 1e7 times as long as others", "[harmonic]") {
  const unsigned seed = 31;
  for (unsigned k = 0; k < 12; ++k) {
    Random random(seed + k);
    const Domain domain(fuzz::random_uneven(random, 6 + 2 * (k % 3)));
    const Harmonic_coordinates_2 fine(domain, 1e-9, 1e-6);
    for (const double target : {1e-3, 1e-5, 1e-7}) {
      const Harmonic_coordinates_2 h(domain, target, 1e-3);
      INFO("seed " << seed + k << ", target " << target << ", bounds " << h.error_bound() << " and "
                   << fine.error_bound());
      CHECK(largest_difference(h, fine) <= h.error_bound() + fine.error_bound());
    }
  }
}

namespace {

// random points near every vertex, down to the last digits
Points points_near_vertices(const Domain& domain) {
  Random random(1);
  Points points;
  for (const Point_2& vertex : domain.vertices())
    for (const double size : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10})
      for (int i = 0; i < 20; ++i) {
        const double x = random.in(-size, size), y = random.in(-size, size);
        const Point_2 p(vertex.x() + x, vertex.y() + y);
        if (domain.locate(p).kind == Location::Kind::interior)
          points.push_back(p);
      }
  return points;
}

// a corridor with two bends
Points zigzag(double width) {
  const double w = width;
  return {{0, 0},           {1, 0}, {2, 1}, {2, 2}, {2 - w, 2}, {2 - w, 1 + w / 2.4},
          {1 - w / 2.4, w}, {0, w}};
}

// a room with corridors of the given width, side by side
Points rake(double width) {
  Points p{{0, 0}, {4, 0}, {4, 1}};
  for (int i = 3; i >= 1; --i)
    for (const Point_2& q : {Point_2(i + width, 1), Point_2(i + width, 2 - 0.1 * i),
                             Point_2(i, 2 - 0.1 * i), Point_2(i, 1)})
      p.push_back(q);
  p.emplace_back(0, 1);
  return p;
}

} // namespace

// Coordinates have sixteen digits, so the width of a slanted gap of 1e-10 is known to six.
TEST_CASE("The bound holds in gaps of any width, also next to their ends", "[harmonic]") {
  for (const double width : {1e-4, 1e-7, 1e-10})
    for (const Domain& domain :
         {Domain(zigzag(width)), Domain(rake(width)), Domain(dumbbell(width)),
          Domain(Points{{0, 0}, {3, 0}, {3, 2}, {0, 2}}, {{{1, width}, {0.5, 1}, {2.5, 1}}})}) {
      const Harmonic_coordinates_2 h(domain, 1e-8, 1e-4), fine(domain, 1e-11, 1e-4);
      INFO("width " << width << ", " << domain.size() << " sides, bounds " << h.error_bound()
                    << " and " << fine.error_bound());
      for (const Point_2& p : points_near_vertices(domain)) {
        const auto lambda = evaluate<0>(h, p);
        CHECK(largest_difference(lambda, evaluate<0>(fine, p)) <=
              h.error_bound() + fine.error_bound());
        // Rounding takes none of the digits that the approximation has.
        std::vector<MP::Jet_2<long double, 0>> extended(domain.size());
        h.evaluate_extended(static_cast<long double>(p.x()), static_cast<long double>(p.y()),
                            extended.data());
        for (std::size_t i = 0; i < domain.size(); ++i)
          CHECK(std::abs(lambda[i][0] - extended[i][0]) <= h.error_bound());
      }
    }
}

TEST_CASE("Slanted corridors down to 1e-11 of their length reach 1e-3", "[harmonic]") {
  Random random(12);
  for (int trial = 0; trial < 20; ++trial) {
    const double width = std::pow(10., -random.in(4, 11));
    INFO("seed 12, trial " << trial << ", width " << width);
    CHECK_NOTHROW(Harmonic_coordinates_2(Domain(zigzag(width)), 1e-4, 1e-3));
  }
}

// A harmonic function is determined by its boundary values, which are exact, and this property.
TEST_CASE("The value at a point is the mean over circles around it", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-11)) {
    const Domain& domain = h.domain();
    for (const Point_2& c : random_points_inside(domain, 10)) {
      const double radius = 0.8 * distance_to_boundary(domain, c);
      const int samples = 150; // the trapezoidal rule converges like 0.8^samples
      std::vector<Jet<0>> mean(domain.size());
      for (int j = 0; j < samples; ++j) {
        const double t = 2 * pi * j / samples;
        const auto lambda =
            evaluate<0>(h, {c.x() + radius * std::cos(t), c.y() + radius * std::sin(t)});
        for (std::size_t i = 0; i < domain.size(); ++i)
          mean[i] += lambda[i] * (1. / samples);
      }
      // once for the point, once for the circle; and the trapezoidal rule
      CHECK(largest_difference(mean, evaluate<0>(h, c)) < 2 * h.error_bound() + 1e-13);
    }
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
  const Harmonic_coordinates_2 h(Domain(l_shape()), 1e-11);
  const double value = evaluate<0>(h, {0.5, 0.5})[3][0];
  // The order is 4/3, from the corner of 270 degrees. Extrapolation takes off the leading term.
  const double coarse = five_point_value(32), fine = five_point_value(64);
  const double ratio = std::pow(2, 4. / 3);
  CHECK(std::abs(fine - value) < 0.45 * std::abs(coarse - value));
  CHECK(std::abs((ratio * fine - coarse) / (ratio - 1) - value) < 3e-5);
}

namespace {

void check_random_domain(unsigned seed, bool with_holes) {
  INFO("seed " << seed);
  Random random(seed);
  const std::size_t n = random.integer(3, 40);
  const Domain domain = random_domain(random, n, with_holes ? random.integer(1, 3) : 0);
  const Harmonic_coordinates_2 h(domain, 1e-8);
  CHECK(h.error_bound() <= 1e-8);
  if (seed % 8 != 0)
    return;
  // against an approximation that shares the method, but neither cells nor coefficients
  const Harmonic_coordinates_2 fine(domain, 1e-10);
  CHECK(fine.error_bound() <= 1e-10);
  CHECK(largest_difference(h, fine, 50) <= h.error_bound() + fine.error_bound());
}

} // namespace

TEST_CASE("Random polygons reach eight digits, and their bounds are honest", "[harmonic]") {
  for (unsigned seed = 1; seed <= 750; ++seed)
    check_random_domain(seed, false);
}

TEST_CASE("Random polygons with holes reach eight digits, and their bounds are honest",
          "[harmonic]") {
  for (unsigned seed = 1; seed <= 250; ++seed)
    check_random_domain(seed, true);
}

TEST_CASE("Slivers and tiny sides are resolved", "[harmonic]") {
  for (const Points& p : {Points{{0, 0}, {1, 0}, {0.4, 1e-6}}, Points{{0, 0}, {1, 0}, {1, 1e-7}},
                          Points{{0, 0}, {1, 0}, {1, 1e-9}, {0, 1e-9}},
                          Points{{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5 - 1e-6, 1}, {0, 1}},
                          Points{{0, 0}, {1, 0}, {1, 1}, {0.6, 1}, {0.5, 1e-6}, {0.4, 1}, {0, 1}}})
    CHECK_NOTHROW(Harmonic_coordinates_2(Domain(p), 1e-6));
}

// Near the tip the domain looks the same at every scale, so the values do, too. A gap of 1e-9 is
// known to seven digits only, as coordinates have sixteen.
TEST_CASE("Sides that nearly touch are resolved as far as their coordinates tell", "[harmonic]") {
  const auto value_below_tip = [](double gap, double target) {
    const Domain domain({{0, 0}, {1, 0}, {1, 1}, {0.6, 1}, {0.5, gap}, {0.4, 1}, {0, 1}});
    const Harmonic_coordinates_2 h(domain, target);
    CHECK(h.error_bound() <= target);
    return evaluate<0>(h, {0.5, gap / 2})[4][0];
  };
  const double limit = value_below_tip(1e-6, 1e-8);
  CHECK(value_below_tip(1e-3, 1e-8) == Approx(limit).epsilon(0).margin(1e-3));
  CHECK(value_below_tip(1e-9, 1e-5) == Approx(limit).epsilon(0).margin(1e-5));
}

TEST_CASE("Polygons with hundreds of vertices are no different", "[harmonic]") {
  Random random(5);
  for (const Points& polygon : {star_shaped_polygon(random, 200, 0.6), comb(64)}) {
    const Harmonic_coordinates_2 h(Domain(polygon), 1e-6);
    CHECK(h.error_bound() <= 1e-6);
    double sum = 0;
    for (const Jet<0>& lambda : evaluate<0>(h, {0.01, 0.02}))
      sum += lambda[0];
    CHECK(sum == Approx(1).epsilon(0).margin(1e-14));
  }
}

// No polygon is known that has fewer equations than unknowns to begin with, so here one point is
// taken where a hundred were needed.
TEST_CASE("Where equations would be too few there are more, and the error bound is honest",
          "[harmonic]") {
  namespace harmonic = MP::internal::harmonic;
  for (const Points& polygon : {l_shape(), unit_u_shape(), star()}) {
    const harmonic::Boundary boundary = boundary_of(Domain(polygon));
    const harmonic::Bisection_mesh mesh = harmonic::triangulate_boundary(boundary);
    const double tau = 1e-5, few = 0.01;

    harmonic::Bisection_mesh refined = mesh;
    const harmonic::Cover cover = harmonic::Cover_builder(boundary, tau, refined).build();
    const std::vector<harmonic::Interface> interfaces =
        harmonic::find_interfaces(refined, cover.cell_of);
    CHECK(harmonic::Interface_assembler(cover.cells, interfaces).oversampling() ==
          harmonic::Interface_assembler::usual_oversampling);
    CHECK(harmonic::Interface_assembler(cover.cells, interfaces, few).oversampling() > 10 * few);

    const harmonic::Solution solution =
        harmonic::solve_laplace<CGAL::Sequential_tag>(boundary, mesh, tau, 1e-8, few);
    CHECK(solution.error < 1e-2);
    const Harmonic_coordinates_2 fine(Domain(polygon), 1e-11);
    std::vector<double> values(solution.basis.stride());
    for (const Point_2& p : random_points_inside(fine.domain(), 300)) {
      const harmonic::Complex z(p.x(), p.y());
      solution.basis.evaluate<0>(solution.basis.locate(z), z, values.data());
      const auto expected = evaluate<0>(fine, p);
      for (std::size_t i = 0; i < polygon.size(); ++i)
        CHECK(std::abs(values[i] - expected[i][0]) <= solution.error + fine.error_bound());
    }
  }
}

TEST_CASE("A cell that touches others almost nowhere is refused", "[harmonic]") {
  namespace harmonic = MP::internal::harmonic;
  const std::vector<harmonic::Cell> cells{harmonic::Interior_cell({0, 0}, 1, 20),
                                          harmonic::Interior_cell({1, 0}, 1, 20)};
  const std::vector<harmonic::Interface> touching{{{0, 1}, {{{0.5, 0}, {0.5, 1e-9}}}}};
  CHECK_THROWS_AS(harmonic::Interface_assembler(cells, touching), MP::Numerical_error);
  const std::vector<harmonic::Interface> common{{{0, 1}, {{{0.5, -0.5}, {0.5, 0.5}}}}};
  CHECK(harmonic::Interface_assembler(cells, common).oversampling() >
        harmonic::Interface_assembler::usual_oversampling);
}

// Without it, a comb's back would be joined to all teeth from its two ends.
TEST_CASE("A long side is cut where vertices are near, unless others are nearer", "[harmonic]") {
  using MP::internal::harmonic::Side_subdivision;
  const auto subdivision = [](const Points& polygon) {
    return Side_subdivision(boundary_of(Domain(polygon))).parameters(0);
  };
  std::vector<double> expected;
  for (int k = 1; k <= 30; ++k)
    expected.push_back(k / 31.);
  CHECK_THAT(subdivision(comb(16)), Catch::Matchers::Approx(expected));
  CHECK(subdivision(comb(2)).empty());
  // The middle vertex hides the one above it, and is nearer than its neighbours.
  const Points dented{{0, 0}, {20, 0}, {20, 3}, {10.2, 2}, {10, 0.5}, {9.9, 2}, {0, 3}};
  CHECK_THAT(subdivision(dented), Catch::Matchers::Approx(std::vector<double>{0.5}));
  // Rounding would show in the place of a foot as near as that.
  const auto pricked = [](double distance) {
    return Points{{0, 0}, {20, 0}, {20, 3}, {10.2, 3}, {10, distance}, {9.9, 3}, {0, 3}};
  };
  CHECK_THAT(subdivision(pricked(1e-9)), Catch::Matchers::Approx(std::vector<double>{0.5}));
  CHECK(subdivision(pricked(1e-11)).empty());
}

TEST_CASE("An accuracy out of reach is refused with what was reached", "[harmonic]") {
  const Domain domain(l_shape());
  try {
    const Harmonic_coordinates_2 h(domain, 1e-30);
    FAIL("an error of 1e-30 is not possible in double precision");
  } catch (const MP::Accuracy_error& error) {
    CHECK(error.reached() < 1e-10);
    CHECK(error.reached() > 1e-30);
    using Catch::Matchers::Contains;
    CHECK_THAT(error.what(), Contains("1e-30") && Contains("reached"));
  }
  const Harmonic_coordinates_2 accepted(domain, 1e-30, 1e-10);
  CHECK(accepted.error_bound() < 1e-10);
}

TEST_CASE("An error is told in two digits, and never as less than it is", "[harmonic]") {
  Random random(14);
  for (int trial = 0; trial < 10000; ++trial) {
    const double exponent = random.in(-300, 307);
    const double x = std::pow(10, trial % 10 == 0 ? std::round(exponent) : exponent);
    const std::string text = MP::internal::to_short_text_above(x);
    INFO("seed 14, trial " << trial << ": " << text << " for " << x);
    CHECK(std::stod(text) > x);
    CHECK(std::stod(text) < 1.101 * x);
    CHECK(text.size() <= 8);
  }
}

TEST_CASE("An accuracy that was reached is acceptable", "[harmonic]") {
  // a slanted gap, in which the rounding of vertices limits what can be reached
  const Domain domain(
      {{0, 0}, {4, 0}, {4, 3}, {2.3 + 1e-8, 3}, {2 + 1e-8, 1}, {2, 1}, {2.3, 3}, {0, 3}});
  double reached = 0, told = 0;
  try {
    const Harmonic_coordinates_2 h(domain, 1e-8);
  } catch (const MP::Accuracy_error& error) {
    reached = error.reached();
    const std::string message = error.what(), before = "asked for, and ";
    told = std::stod(message.substr(message.find(before) + before.size()));
  }
  REQUIRE(reached > 1e-8);
  CHECK(told >= reached);
  CHECK(told < 1.11 * reached);
  CHECK(Harmonic_coordinates_2(domain, 1e-8, told).error_bound() <= told);
}
