// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_MERGE_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_MERGE_FIXTURES_H

#include "exact_fixtures.h"

#include <CGAL/Multisided_patches/ribbons/merge_loops.h>

#include <cstddef>
#include <utility>
#include <vector>

// Loops to merge.
namespace merge_fixtures {

using namespace exact_fixtures;
using Polygon = std::vector<std::pair<int, int>>;

// A loop over a polygon with corners on a lattice, whose boundary lies on the surface z = x y: so
// wherever two polygons share a part of a side, the loops share the curve.
inline Loop loop_over(const Polygon& polygon) {
  std::vector<Ribbon> ribbons;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto [x0, y0] = polygon[i];
    const auto [x1, y1] = polygon[(i + 1) % polygon.size()];
    std::vector<Point> points;
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 4; ++j) {
        // z as a cubic curve, by the polar form of x y.
        const FT z = ratio((3 - j) * (2 - j) * x0 * y0 + (3 - j) * j * (x0 * y1 + x1 * y0) +
                               j * (j - 1) * x1 * y1,
                           6);
        points.emplace_back(x0 + ratio(j * (x1 - x0), 3) - k * ratio(y1 - y0, 10),
                            y0 + ratio(j * (y1 - y0), 3) + k * ratio(x1 - x0, 10), z);
      }
    ribbons.emplace_back(3, 2, points);
  }
  return Loop(ribbons);
}

} // namespace merge_fixtures

#endif // MULTISIDED_PATCHES_TEST_MERGE_FIXTURES_H
