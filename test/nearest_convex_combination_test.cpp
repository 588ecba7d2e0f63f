// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Affine_correction.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/nearest_convex_combination.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

using CGAL::Multisided_patches::internal::harmonic::Affine_correction;
using CGAL::Multisided_patches::internal::harmonic::Complex;
using CGAL::Multisided_patches::internal::harmonic::make_nonnegative;
using CGAL::Multisided_patches::internal::harmonic::Nearest_convex_combination;
using fixtures::Random;

namespace {

double sum_of(const std::vector<double>& lambda) {
  return std::accumulate(lambda.begin(), lambda.end(), 0.);
}

Complex combination_of(const std::vector<Complex>& points, const std::vector<double>& lambda) {
  Complex z = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    z += lambda[i] * points[i];
  return z;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double squared = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    squared += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(squared);
}

// the corners of a square, and clusters of very different sizes inside
std::vector<Complex> clustered_points(Random& random, std::size_t n) {
  std::vector<Complex> points{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  for (std::size_t i = 0; i < n; ++i) {
    const double size = 0.4 * std::pow(10., -2. * static_cast<double>(i % 3));
    points.emplace_back(random.in(-size, size), random.in(-size, size));
  }
  return points;
}

// a random convex combination; half of the coefficients are zero
std::vector<double> random_combination(Random& random, std::size_t n) {
  std::vector<double> mu{0, 0, 0, 0};
  for (std::size_t i = 0; i < n; ++i)
    mu.push_back((std::max)(0., random.in(-1, 1)) + (i == 0 ? 0.1 : 0));
  const double sum = sum_of(mu);
  for (double& m : mu)
    m /= sum;
  return mu;
}

std::vector<double> nearest_combination(const std::vector<Complex>& points, const Complex& z,
                                        const std::vector<double>& lambda) {
  const Nearest_convex_combination nearest(points, z, lambda.data());
  std::vector<double> mu;
  for (std::size_t i = 0; i < points.size(); ++i)
    mu.push_back(nearest.coefficient(i));
  return mu;
}

} // namespace

// In a convex set, the nearest point is the one from which all others lie in directions at a right
// angle or more to where it came from.
TEST_CASE("The nearest convex combination is one, is nearest, and is no farther from any other",
          "[harmonic]") {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const std::vector<Complex> points = clustered_points(random, random.integer(1, 30));
    const std::vector<double> exact = random_combination(random, points.size() - 4);
    const Complex z = combination_of(points, exact);
    const double noise = std::pow(10., -random.in(1, 9));
    const auto disturbed = [&](std::vector<double> mu, double size) {
      for (double& m : mu)
        m += random.in(-size, size);
      return mu;
    };
    const std::vector<double> given = disturbed(exact, noise),
                              nearest = nearest_combination(points, z, given);
    CHECK(*std::min_element(nearest.begin(), nearest.end()) >= 0);
    CHECK(std::abs(sum_of(nearest) - 1) < 1e-14);
    CHECK(std::abs(combination_of(points, nearest) - z) < 1e-14);
    for (const double size : {noise, 1e-3 * noise, 1e-6 * noise}) {
      const std::vector<double> other = nearest_combination(points, z, disturbed(nearest, size));
      CHECK(distance(nearest, other) <= distance(given, other));
      double product = 0;
      for (std::size_t i = 0; i < points.size(); ++i)
        product += (given[i] - nearest[i]) * (other[i] - nearest[i]);
      CHECK(product <= 1e-10 * noise * size + 1e-15 * noise);
    }
  }
}

TEST_CASE("On slanted slivers of any width, the nearest convex combination is one", "[harmonic]") {
  for (const double width : {1e-3, 1e-6, 1e-9})
    for (unsigned seed = 1; seed <= 100; ++seed) {
      INFO("width " << width << ", seed " << seed);
      Random random(seed);
      const Complex along = std::polar(1., random.in(0, 6));
      std::vector<Complex> points;
      for (std::size_t i = 0; i < 12; ++i)
        points.push_back(along * Complex(random.in(-0.5, 0.5), width * random.in(-0.5, 0.5)));
      const std::vector<double> exact = random_combination(random, points.size() - 4);
      const Complex z = combination_of(points, exact);
      std::vector<double> given = exact;
      for (double& mu : given)
        mu += random.in(-1e-5, 1e-5);
      const Affine_correction correction(points);
      correction(z, std::array<double, 3>{1, 0, 0}, given.data());
      const std::vector<double> nearest = nearest_combination(points, z, given);
      CHECK(*std::min_element(nearest.begin(), nearest.end()) >= 0);
      CHECK(std::abs(sum_of(nearest) - 1) < 1e-14);
      CHECK(std::abs(combination_of(points, nearest) - z) < 1e-14);
    }
}

TEST_CASE("Points outside by rounding get coordinates that are not negative and sum to one",
          "[harmonic]") {
  const std::vector<Complex> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.2, 0.5}};
  for (const double outside : {1e-16, 1e-12, 1e-6, 1e-3}) {
    std::vector<double> lambda{0.4 + outside, 0.6, -outside / 2, -outside / 2, 0};
    make_nonnegative(points, Complex(0.6, -outside), lambda.data());
    CHECK(*std::min_element(lambda.begin(), lambda.end()) >= 0);
    CHECK(std::abs(sum_of(lambda) - 1) < 1e-15);
    CHECK(std::abs(combination_of(points, lambda) - 0.6) < 3 * outside + 1e-15);
  }
}

TEST_CASE("Coordinates that are not negative stay as they are", "[harmonic]") {
  const std::vector<Complex> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<double> lambda{0.2, 0.3, 0, 0.5};
  make_nonnegative(points, Complex(0.3, 0.5), lambda.data());
  CHECK(lambda == std::vector<double>{0.2, 0.3, 0, 0.5});
}

// In proportion, the ends of the gap would change by error / gap.
TEST_CASE("Negative coordinates far away do not change those of the ends of a narrow gap",
          "[harmonic]") {
  const double gap = 1e-9, error = 1e-12;
  const std::vector<Complex> points{{0, 0},     {0, gap},    {0.5, 0},  {0.5, gap},
                                    {0.9, 0.7}, {-0.5, 0.8}, {0.8, 0.9}};
  const Complex z(0.1, 0.3 * gap);
  const std::vector<double> exact{0.56, 0.24, 0.14, 0.06, 0, 0, 0};
  // The errors far away cancel up to a shift along the gap, which its ends make up for.
  const double shift = 2.7 * error / 0.5;
  std::vector<double> lambda{0.56 - 0.7 * shift,
                             0.24 - 0.3 * shift,
                             0.14 + 0.7 * shift,
                             0.06 + 0.3 * shift,
                             -error,
                             2 * error,
                             -error};
  REQUIRE(std::abs(combination_of(points, lambda) - z) < 1e-16);
  const double before = distance(lambda, exact);
  make_nonnegative(points, z, lambda.data());
  CHECK(*std::min_element(lambda.begin(), lambda.end()) >= 0);
  CHECK(std::abs(sum_of(lambda) - 1) < 1e-15);
  CHECK(std::abs(combination_of(points, lambda) - z) < 1e-16);
  CHECK(before < 20 * error);
  CHECK(distance(lambda, exact) < before);
}
