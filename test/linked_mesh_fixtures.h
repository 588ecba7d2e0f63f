// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_LINKED_MESH_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_LINKED_MESH_FIXTURES_H

#include "fixtures.h"

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace fixtures {

// Two triangles in each square of a grid of n x n; the vertices are numbered row by row.
inline MP::internal::Linked_triangles grid(MP::internal::Linked_triangle::Index n) {
  using Index = MP::internal::Linked_triangle::Index;
  const auto vertex = [&](Index i, Index j) { return j * (n + 1) + i; };
  MP::internal::Linked_triangles mesh;
  constexpr Index none = MP::internal::Linked_triangle::none;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index lower = 2 * (j * n + i), upper = lower + 1;
      mesh.push_back({{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)},
                      {i + 1 < n ? lower + 3 : none, upper, j > 0 ? upper - 2 * n : none}});
      mesh.push_back({{vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)},
                      {j + 1 < n ? lower + 2 * n : none, i > 0 ? lower - 2 : none, lower}});
    }
  return mesh;
}

// The same with the vertices on the border first.
struct Bordered_grid {
  MP::internal::Linked_triangles triangles;
  std::vector<std::array<std::size_t, 2>> vertices; // column and row of each
  std::size_t border;                               // number of vertices there

  explicit Bordered_grid(std::size_t n)
      : triangles(grid(static_cast<MP::internal::Linked_triangle::Index>(n))), border(4 * n) {
    std::vector<std::size_t> place((n + 1) * (n + 1));
    for (const bool inside : {false, true})
      for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i)
          if ((i > 0 && i < n && j > 0 && j < n) == inside) {
            place[j * (n + 1) + i] = vertices.size();
            vertices.push_back({i, j});
          }
    for (auto& t : triangles)
      for (auto& v : t.vertices)
        v = static_cast<MP::internal::Linked_triangle::Index>(place[v]);
  }
};

// Whether neighbours know each other, across the edges that they have in common.
inline bool is_linked_well(const MP::internal::Linked_triangles& mesh) {
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t n = mesh[t].neighbors[i];
      if (n == MP::internal::Linked_triangle::none)
        continue;
      const auto& back = mesh[n].neighbors;
      const auto j =
          static_cast<std::size_t>(std::find(back.begin(), back.end(), t) - back.begin());
      if (j == 3 || mesh[n].vertices[(j + 1) % 3] != mesh[t].vertices[(i + 2) % 3] ||
          mesh[n].vertices[(j + 2) % 3] != mesh[t].vertices[(i + 1) % 3])
        return false;
    }
  return true;
}

} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_LINKED_MESH_FIXTURES_H
