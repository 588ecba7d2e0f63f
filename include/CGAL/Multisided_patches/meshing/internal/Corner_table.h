// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CORNER_TABLE_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CORNER_TABLE_H

#include <CGAL/Multisided_patches/internal/for_each_index.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// What triangles have to do with each other, found from the numbers of their vertices. Corner
// c = 3 t + i is that of triangle t at its vertex i; the edge that starts there has its number.
//
// Complexity: linear, if no vertex has very many triangles.
class Corner_table {
public:
  using Index = std::uint32_t;
  using Triangle = std::array<Index, 3>;
  static constexpr Index none = (std::numeric_limits<Index>::max)();
  // Halfedges can be numbered, too, of which a triangle has six if it is alone.
  static constexpr std::size_t max_triangles = none / 6;

  // No two triangles have an edge in the same direction. pre: there are at most `max_triangles`
  template <typename ConcurrencyTag>
  Corner_table(const std::vector<Triangle>& triangles, std::size_t number_of_vertices,
               ConcurrencyTag)
      : last_corners_(number_of_vertices, none), twins_(3 * triangles.size(), none) {
    std::vector<Index> previous(twins_.size()); // corner at the same vertex
    for (std::size_t c = 0; c < previous.size(); ++c) {
      Index& last = last_corners_[triangles[c / 3][c % 3]];
      previous[c] = last;
      last = static_cast<Index>(c);
    }
    for_each_index<ConcurrencyTag>(triangles.size(), [&](std::size_t t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Index start = triangles[t][i], end = triangles[t][(i + 1) % 3];
        if (end < start) // the other edge looks for this one
          continue;
        Index c = last_corners_[end];
        while (c != none && triangles[c / 3][(c + 1) % 3] != start)
          c = previous[c];
        if (c != none) {
          twins_[3 * t + i] = c;
          twins_[c] = static_cast<Index>(3 * t + i);
        }
      }
    });
  }

  // The edge in the other direction, or `none` on a border.
  Index twin(std::size_t c) const { return twins_[c]; }
  // One of the corners at a vertex, or `none` if there are none.
  Index corner_at(std::size_t vertex) const { return last_corners_[vertex]; }

private:
  std::vector<Index> last_corners_; // by vertex
  std::vector<Index> twins_;        // by corner
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CORNER_TABLE_H
