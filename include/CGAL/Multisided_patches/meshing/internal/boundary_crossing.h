// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_BOUNDARY_CROSSING_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_BOUNDARY_CROSSING_H

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The first two edges of loops that meet in more than the end of one and the start of the other,
// if there are any. The edge k is that from points[k] to points[next[k]]. Boxes are compared first,
// so edges that are short as compared to the loops take O(n log² n).
template <typename Traits>
std::optional<std::pair<std::size_t, std::size_t>>
find_boundary_crossing(const std::vector<typename Traits::Point_2>& points,
                       const std::vector<std::size_t>& next) {
  using Box = Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;
  using Segment_2 = typename Traits::Segment_2;

  const auto follows_well = [&](std::size_t a, std::size_t b) {
    const auto &p = points[a], &q = points[b], &r = points[next[b]];
    return !collinear(p, q, r) || collinear_are_strictly_ordered_along_line(p, q, r);
  };
  std::optional<std::pair<std::size_t, std::size_t>> first;
  const auto compare_edges = [&](const Box& box_a, const Box& box_b) {
    const auto pair = std::minmax({box_a.info(), box_b.info()});
    const auto [a, b] = pair;
    if (first && *first < pair)
      return;
    const bool meet = next[a] == b   ? !follows_well(a, b)
                      : next[b] == a ? !follows_well(b, a)
                                     : do_intersect(Segment_2(points[a], points[next[a]]),
                                                    Segment_2(points[b], points[next[b]]));
    if (meet)
      first = pair;
  };

  std::vector<Box> boxes;
  boxes.reserve(next.size());
  for (std::size_t k = 0; k < next.size(); ++k)
    boxes.emplace_back(points[k].bbox() + points[next[k]].bbox(), k);
  box_self_intersection_d(boxes.begin(), boxes.end(), compare_edges);
  return first;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_BOUNDARY_CROSSING_H
