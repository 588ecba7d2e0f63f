// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_LINKED_TRIANGLE_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_LINKED_TRIANGLE_H

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A triangle of an indexed mesh that knows its neighbours.
struct Linked_triangle {
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::array<std::size_t, 3> vertices;  // indices of points, counterclockwise
  std::array<std::size_t, 3> neighbors; // opposite to the vertices; none across the boundary
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_LINKED_TRIANGLE_H
