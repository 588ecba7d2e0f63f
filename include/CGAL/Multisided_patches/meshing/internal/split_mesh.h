// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SPLIT_MESH_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SPLIT_MESH_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>

#include <boost/pending/disjoint_sets.hpp>

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
  boost::disjoint_sets_with_storage<> sets(mesh.size());
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (const std::size_t n : mesh[t].neighbors)
      if (n != none && n < t)
        sets.union_set(t, n);
  std::vector<std::size_t> number(mesh.size(), none), component;
  component.reserve(mesh.size());
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    std::size_t& c = number[sets.find_set(t)];
    if (c == none)
      c = count++;
    component.push_back(c);
  }
  return component;
}

// Puts components together to groups, in order, each with at least `least` triangles but for the
// last one. Returns the group of each component.
inline std::vector<std::size_t> group_components(const std::vector<std::size_t>& component,
                                                 std::size_t least) {
  std::vector<std::size_t> sizes; // of the components
  for (const std::size_t c : component) {
    sizes.resize((std::max)(sizes.size(), c + 1), 0);
    ++sizes[c];
  }
  std::vector<std::size_t> group;
  std::size_t next = 0, size = 0;
  for (const std::size_t s : sizes) {
    group.push_back(next);
    size += s;
    if (size >= least) {
      ++next;
      size = 0;
    }
  }
  return group;
}

// Splits a mesh whose connected components have no points in common into parts of some of these,
// each with at least `least` triangles but for the last one. All points are corners of triangles.
//
// Complexity: linear.
inline std::vector<Mesh_part> split_mesh(const Linked_triangles& mesh, std::size_t number_of_points,
                                         std::size_t least) {
  const std::vector<std::size_t> component = connected_components(mesh),
                                 group = group_components(component, least);
  std::vector<Mesh_part> parts(group.empty() ? 0 : group.back() + 1);
  const auto part_of = [&](std::size_t t) -> Mesh_part& { return parts[group[component[t]]]; };

  std::vector<std::size_t> triangle_at(number_of_points);
  std::vector<Linked_triangle::Index> local_triangle(mesh.size()), local_point(number_of_points);
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    Linked_triangles& triangles = part_of(t).triangles;
    local_triangle[t] = static_cast<Linked_triangle::Index>(triangles.size());
    triangles.push_back(mesh[t]);
    for (const std::size_t v : mesh[t].vertices)
      triangle_at[v] = t;
  }
  for (std::size_t v = 0; v < number_of_points; ++v) {
    std::vector<std::size_t>& points = part_of(triangle_at[v]).points;
    local_point[v] = static_cast<Linked_triangle::Index>(points.size());
    points.push_back(v);
  }
  for (Mesh_part& part : parts)
    for (Linked_triangle& t : part.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        t.vertices[i] = local_point[t.vertices[i]];
        if (t.neighbors[i] != Linked_triangle::none)
          t.neighbors[i] = local_triangle[t.neighbors[i]];
      }
  return parts;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SPLIT_MESH_H
