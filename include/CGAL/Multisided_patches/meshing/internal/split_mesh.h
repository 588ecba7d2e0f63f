// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SPLIT_MESH_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SPLIT_MESH_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Some of the connected components of a mesh, with numbers of their own.
struct Mesh_part {
  std::vector<std::size_t> points; // their numbers in the mesh, increasing
  Linked_triangles triangles;
};

// For each triangle the number of its connected component. Components are numbered by their first
// triangles.
inline std::vector<std::size_t> connected_components(const Linked_triangles& mesh) {
  constexpr std::size_t none = Linked_triangle::none;
  std::vector<std::size_t> component(mesh.size(), none), stack;
  std::size_t count = 0;
  const auto visit = [&](std::size_t t) {
    if (t == none || component[t] != none)
      return;
    component[t] = count;
    stack.push_back(t);
  };
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    if (component[t] != none)
      continue;
    for (visit(t); !stack.empty();) {
      const std::size_t next = stack.back();
      stack.pop_back();
      for (const std::size_t neighbor : mesh[next].neighbors)
        visit(neighbor);
    }
    ++count;
  }
  return component;
}

// Splits a mesh whose connected components have no points in common into parts of some of these,
// each with at least `least` triangles but for the last one. All points are corners of triangles.
//
// Complexity: linear.
inline std::vector<Mesh_part> split_mesh(const Linked_triangles& mesh, std::size_t number_of_points,
                                         std::size_t least) {
  std::vector<std::size_t> part_of =
      connected_components(mesh); // first the component of a triangle
  std::vector<std::size_t> sizes;
  for (const std::size_t c : part_of) {
    sizes.resize((std::max)(sizes.size(), c + 1), 0);
    ++sizes[c];
  }
  std::vector<std::size_t> part_of_component;
  std::size_t parts = 0, size = 0;
  for (const std::size_t s : sizes) {
    parts += size == 0;
    part_of_component.push_back(parts - 1);
    size = size + s < least ? size + s : 0;
  }
  for (std::size_t& p : part_of)
    p = part_of_component[p];

  std::vector<Mesh_part> result(parts);
  std::vector<std::size_t> local_triangle(mesh.size()), part_of_point(number_of_points),
      local_point(number_of_points);
  std::vector<std::size_t> counts(parts, 0);
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    local_triangle[t] = counts[part_of[t]]++;
    for (const std::size_t v : mesh[t].vertices)
      part_of_point[v] = part_of[t];
  }
  for (std::size_t v = 0; v < number_of_points; ++v) {
    std::vector<std::size_t>& points = result[part_of_point[v]].points;
    local_point[v] = points.size();
    points.push_back(v);
  }
  for (std::size_t p = 0; p < parts; ++p)
    result[p].triangles.reserve(counts[p]);
  const auto index = [](std::size_t k) { return static_cast<Linked_triangle::Index>(k); };
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    Linked_triangle local;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t neighbor = mesh[t].neighbors[i];
      local.vertices[i] = index(local_point[mesh[t].vertices[i]]);
      local.neighbors[i] =
          index(neighbor == Linked_triangle::none ? neighbor : local_triangle[neighbor]);
    }
    result[part_of[t]].triangles.push_back(local);
  }
  return result;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SPLIT_MESH_H
