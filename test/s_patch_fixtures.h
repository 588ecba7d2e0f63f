// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_S_PATCH_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_S_PATCH_FIXTURES_H

#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/S_patch_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <vector>

// What tests of S-patches share.
namespace s_patch_fixtures {

using namespace fixtures;
using Rational = CGAL::Exact_rational;
using Exact = CGAL::Simple_cartesian<Rational>;
using Exact_net = MP::S_patch_net_3<Exact>;
using Net = MP::S_patch_net_3<Kernel>;
using Patch = MP::S_patch_3<Kernel>;
using Mean_value = MP::Mean_value_coordinates_2<Kernel>;
using Index = Net::Multi_index;

inline double distance(const Point_3& a, const Point_3& b) {
  return std::sqrt(CGAL::squared_distance(a, b));
}

template <typename Traits>
std::vector<typename Traits::Point_2> pentagon() {
  using Point = typename Traits::Point_2;
  return {Point(0, 0), Point(4, -1), Point(6, 2), Point(3, 5), Point(-1, 3)};
}

// Of points on a side.
inline std::vector<Rational> parameters() {
  return {0, Rational(1) / 100, Rational(3) / 7, Rational(5) / 6, 1};
}

} // namespace s_patch_fixtures

#endif // MULTISIDED_PATCHES_TEST_S_PATCH_FIXTURES_H
