// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_RATIONAL_RANDOM_H
#define MULTISIDED_PATCHES_TEST_RATIONAL_RANDOM_H

#include <cstddef>
#include <random>
#include <vector>

namespace fixtures {

// Random numbers and points of a kernel with exact arithmetic: fractions with small denominators.
template <typename Traits>
class Rational_random {
public:
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;

  explicit Rational_random(unsigned seed) : engine_(seed) {}

  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  FT number() { return FT(integer(-99, 99)) / FT(integer(1, 9)); }
  Point_3 point() {
    const FT x = number(), y = number(), z = number();
    return Point_3(x, y, z);
  }
  std::vector<Point_3> points(std::size_t n) {
    std::vector<Point_3> points;
    for (std::size_t i = 0; i < n; ++i)
      points.push_back(point());
    return points;
  }

private:
  std::mt19937 engine_;
};

} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_RATIONAL_RANDOM_H
