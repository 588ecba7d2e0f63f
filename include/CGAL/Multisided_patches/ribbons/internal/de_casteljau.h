// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_DE_CASTELJAU_H
#define CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_DE_CASTELJAU_H

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The point (1 - s) a + s b. Written as a step from the nearer of the two, it is in floating-point
// arithmetic, too, exactly a for s = 0 and b for s = 1, and for any s if a and b coincide.
template <typename Point_3, typename FT>
Point_3 between(const Point_3& a, const Point_3& b, const FT& s, const FT& one_minus_s) {
  return s < one_minus_s ? Point_3(a + s * (b - a)) : Point_3(b + one_minus_s * (a - b));
}

// The control points of a curve on [0,s] and on [s,1], by the algorithm of de Casteljau. With s
// outside of [0,1] one of the two is longer than the curve, and the other runs back. O(d²).
template <typename Point_3, typename FT>
std::pair<std::vector<Point_3>, std::vector<Point_3>> split_curve(std::vector<Point_3> points,
                                                                  const FT& s) {
  const FT one_minus_s = FT(1) - s;
  std::vector<Point_3> first;
  first.reserve(points.size());
  for (std::size_t last = points.size(); last-- > 0;) {
    first.push_back(points.front());
    for (std::size_t j = 0; j < last; ++j)
      points[j] = between(points[j], points[j + 1], s, one_minus_s);
  }
  return {std::move(first), std::move(points)};
}

// The control points of a curve on [begin,end]. pre: 0 <= begin < end <= 1
template <typename Point_3, typename FT>
std::vector<Point_3> curve_piece(const std::vector<Point_3>& points, const FT& begin,
                                 const FT& end) {
  std::vector<Point_3> piece = begin == FT(0) ? points : split_curve(points, begin).second;
  if (end == FT(1))
    return piece;
  return split_curve(std::move(piece), FT((end - begin) / (FT(1) - begin))).first;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_DE_CASTELJAU_H
