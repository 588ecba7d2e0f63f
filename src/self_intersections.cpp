// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_statistics.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

namespace multipatch {

namespace {

using Face = Mesh::Face_index;
using Corners = std::array<Kernel::Point_3, 3>;

Corners corners(const Mesh& mesh, Face f) {
  const auto h = mesh.halfedge(f);
  return {mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))),
          mesh.point(mesh.source(h))};
}

// Whether the triangles have a corner in common and nothing else. If there were more, it would
// reach the edge opposite to that corner in one of them.
bool touch_at_corner(const Corners& a, const Corners& b) {
  const auto meets_opposite_edge = [](const Corners& t, std::size_t i, const Corners& other) {
    return CGAL::do_intersect(Kernel::Segment_3(t[(i + 1) % 3], t[(i + 2) % 3]),
                              Kernel::Triangle_3(other[0], other[1], other[2]));
  };
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a[i] == b[j])
        return !meets_opposite_edge(a, i, b) && !meets_opposite_edge(b, j, a);
  return false;
}

} // namespace

std::size_t self_intersections(const Mesh& mesh) {
  using Pair = std::pair<Face, Face>;
  std::vector<Pair> pairs;
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Parallel_if_available_tag>(
      mesh, std::back_inserter(pairs));
  // A degenerate triangle is reported as one that meets itself.
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&](const Pair& pair) {
    return pair.first != pair.second &&
           !touch_at_corner(corners(mesh, pair.first), corners(mesh, pair.second));
  }));
}

} // namespace multipatch
