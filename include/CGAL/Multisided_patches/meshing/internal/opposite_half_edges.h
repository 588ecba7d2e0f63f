// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_OPPOSITE_HALF_EDGES_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_OPPOSITE_HALF_EDGES_H

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

inline constexpr std::size_t no_half_edge = (std::numeric_limits<std::size_t>::max)();

// For each half-edge of a mesh the one that runs the other way, or `no_half_edge`. Half-edge
// 3 t + i runs from triangles[t][i] to the next corner; no two run the same way between the same
// vertices.
inline std::vector<std::size_t>
opposite_half_edges(const std::vector<std::array<std::size_t, 3>>& triangles,
                    std::size_t number_of_vertices) {
  // The half-edges, ordered by the vertex from which they start.
  std::vector<std::size_t> first(number_of_vertices + 1, 0), starting(3 * triangles.size());
  for (const auto& t : triangles)
    for (const std::size_t v : t)
      ++first[v + 1];
  for (std::size_t v = 0; v < number_of_vertices; ++v)
    first[v + 1] += first[v];
  std::vector<std::size_t> next_free(first.begin(), first.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      starting[next_free[triangles[t][i]]++] = 3 * t + i;

  const auto end_of = [&](std::size_t h) { return triangles[h / 3][(h + 1 - h / 3 * 3) % 3]; };
  std::vector<std::size_t> opposite(3 * triangles.size(), no_half_edge);
  for (std::size_t h = 0; h < opposite.size(); ++h) {
    if (opposite[h] != no_half_edge)
      continue;
    const std::size_t start = triangles[h / 3][h % 3], end = end_of(h);
    for (std::size_t k = first[end]; k < first[end + 1]; ++k)
      if (end_of(starting[k]) == start) {
        opposite[h] = starting[k];
        opposite[starting[k]] = h;
      }
  }
  return opposite;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_OPPOSITE_HALF_EDGES_H
