// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_LINKED_TRIANGLE_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_LINKED_TRIANGLE_H

#include <CGAL/Multisided_patches/errors.h>

#include <boost/container/vector.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A triangle of an indexed mesh that knows its neighbours. Indices are small, as first touching the
// memory of large meshes takes as long as much of what is done with it.
struct Linked_triangle {
  using Index = std::uint32_t;
  using Indices = std::array<Index, 3>;

  static constexpr std::size_t none = (std::numeric_limits<Index>::max)();

  Indices vertices;  // of points, counterclockwise
  Indices neighbors; // of triangles, opposite to the vertices; none across the boundary
};

// Refuses meshes whose indices 32 bits do not hold.
inline void check_number_of_indices(std::size_t n) {
  if (n >= Linked_triangle::none)
    throw Input_error("a mesh of " + std::to_string(n) + " points or triangles is too large");
}

// Elements can be left for threads to fill: `boost::container::default_init`.
using Linked_triangles = boost::container::vector<Linked_triangle>;

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_LINKED_TRIANGLE_H
