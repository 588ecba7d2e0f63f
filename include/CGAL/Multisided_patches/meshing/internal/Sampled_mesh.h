// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SAMPLED_MESH_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SAMPLED_MESH_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A mesh of a domain and its image on a surface.
struct Sampled_mesh {
  std::vector<Uv> uv;
  std::vector<Vec3> positions; // in any unit
  Linked_triangles triangles;
  // Vertices at which the normals of the surface may have no limit, in increasing order.
  std::vector<std::size_t> singular_vertices;

  bool is_singular(std::size_t vertex) const {
    return std::binary_search(singular_vertices.begin(), singular_vertices.end(), vertex);
  }
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SAMPLED_MESH_H
