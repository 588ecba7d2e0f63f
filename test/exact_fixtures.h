// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_EXACT_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_EXACT_FIXTURES_H

#include "fixtures.h"

#include <CGAL/Multisided_patches/internal/bernstein.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// Ribbons and nets in exact arithmetic, where what is the same is equal.
namespace exact_fixtures {

namespace MP = CGAL::Multisided_patches;
using fixtures::Random;
using FT = CGAL::Exact_rational;
using Exact = CGAL::Simple_cartesian<FT>;
using Point = Exact::Point_3;
using Vector = Exact::Vector_3;
using Ribbon = MP::Bezier_ribbon_3<Exact>;
using Loop = MP::Ribbon_loop_3<Exact>;
using Grid = std::vector<std::vector<Point>>; // of a tensor product patch, [along u][along v]

inline int to_int(std::size_t i) {
  return static_cast<int>(i);
}

inline FT ratio(int numerator, int denominator) {
  return FT(numerator) / FT(denominator);
}

inline Point random_point(Random& random) {
  const auto coordinate = [&] { return FT(static_cast<int>(random.integer(0, 2000)) - 1000); };
  const FT x = coordinate(), y = coordinate(), z = coordinate();
  return Point(x, y, z);
}

inline std::vector<Point> random_points(Random& random, std::size_t count) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(random_point(random));
  return points;
}

inline Ribbon random_ribbon(Random& random, std::size_t degree, std::size_t layers) {
  return Ribbon(degree, layers, random_points(random, (degree + 1) * layers));
}

// Parameters at which two polynomials of degree at most `degree` are equal only if they are the
// same.
inline std::vector<FT> parameters(std::size_t degree) {
  std::vector<FT> s;
  for (std::size_t i = 0; i <= degree; ++i)
    s.push_back(FT(to_int(i)) / FT(to_int(degree + 1)));
  return s;
}

// The point at parameter s of row k of a ribbon.
inline Point row_point(const Ribbon& r, std::size_t k, const FT& s) {
  std::vector<FT> b(r.degree() + 1);
  MP::internal::bernstein_polynomials(r.degree(), s, b.data());
  Vector sum(0, 0, 0);
  for (std::size_t j = 0; j <= r.degree(); ++j)
    sum = sum + b[j] * (r.control_point(j, k) - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum;
}

// The derivative of order `order` across the side at h = 0, of the surface whose first rows a
// ribbon is: of degree d by 2l - 1.
inline Vector cross_derivative(const Ribbon& r, const FT& s, std::size_t order) {
  Vector difference(0, 0, 0);
  FT binomial(1), factor(1);
  for (std::size_t k = 0; k <= order; ++k) {
    const Vector row = row_point(r, order - k, s) - CGAL::ORIGIN;
    difference = difference + (k % 2 == 0 ? binomial : FT(-binomial)) * row;
    binomial = binomial * FT(to_int(order - k)) / FT(to_int(k + 1));
    if (k < order)
      factor *= FT(to_int(r.cross_degree() - k));
  }
  return factor * difference;
}

inline bool same_derivatives(const Ribbon& a, const Ribbon& b, std::size_t order) {
  for (const FT& s : parameters((std::max)(a.degree(), b.degree())))
    if (cross_derivative(a, s, order) != cross_derivative(b, s, order))
      return false;
  return true;
}

} // namespace exact_fixtures

#endif // MULTISIDED_PATCHES_TEST_EXACT_FIXTURES_H
