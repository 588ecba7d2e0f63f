// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_CONNECTIVITY_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_CONNECTIVITY_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/internal/Corner_table.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// How the triangles of one or several domain meshes make up one surface mesh: they are joined where
// they have the numbers of two vertices in common. It knows the elements of that mesh by their
// numbers, and nothing of where they are.
//
// Corner c = 3 t + i is that of triangle t at its vertex i; it has the edge that starts there.
class Mesh_connectivity {
public:
  using Index = Corner_table::Index;
  static constexpr Index none = Corner_table::none;

  // `numbers` has for each domain mesh the numbers of its vertices among those of all. A mesh has
  // vertices of the meshes before it, and those with the next numbers, which it brings in.
  //
  // Throws Input_error if there are too many triangles.
  template <typename Traits, typename ConcurrencyTag>
  Mesh_connectivity(const std::vector<const Domain_mesh_2<Traits>*>& meshes,
                    std::vector<std::vector<std::size_t>> numbers, ConcurrencyTag concurrency)
      : numbers_(std::move(numbers)) {
    count_elements(meshes);
    collect_triangles<ConcurrencyTag>(meshes);
    const Corner_table corners(triangles_, number_of_vertices(), concurrency);
    number_halfedges(corners);
    corners_.resize(number_of_vertices());
    for (std::size_t v = 0; v < corners_.size(); ++v)
      corners_[v] = corners.corner_at(v);
  }

  std::size_t number_of_vertices() const { return first_vertices_.back(); }
  std::size_t number_of_edges() const { return number_of_edges_; }
  std::size_t number_of_triangles() const { return triangles_.size(); }

  // The numbers of the vertices of a domain mesh.
  const std::vector<std::size_t>& numbers(std::size_t mesh) const { return numbers_[mesh]; }
  // Whether a vertex is one of those that a domain mesh brings in.
  bool is_new(std::size_t mesh, std::size_t number) const {
    return number >= first_vertices_[mesh];
  }
  // Of a domain mesh; that of one more is one past the last one.
  std::size_t first_triangle(std::size_t mesh) const { return first_triangles_[mesh]; }

  std::size_t vertex(std::size_t corner) const { return triangles_[corner / 3][corner % 3]; }
  // A corner at a vertex, or `none` if there are none.
  Index corner_at(std::size_t vertex) const { return corners_[vertex]; }
  // The halfedge of a corner's triangle along its edge. Those of an edge have the numbers 2 k and
  // 2 k + 1, and the first one of them always is that of a corner.
  std::size_t halfedge(std::size_t corner) const { return halfedges_[corner]; }
  // The corners whose edges have one triangle.
  const std::vector<Index>& border() const { return border_; }

  static std::size_t next_corner(std::size_t c) { return c % 3 < 2 ? c + 1 : c - 2; }
  static std::size_t previous_corner(std::size_t c) { return c % 3 > 0 ? c - 1 : c + 2; }

private:
  template <typename Traits>
  void count_elements(const std::vector<const Domain_mesh_2<Traits>*>& meshes) {
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      std::size_t end = first_vertices_.back();
      for (const std::size_t number : numbers_[m])
        end = (std::max)(end, number + 1);
      first_vertices_.push_back(end);
      first_triangles_.push_back(first_triangles_.back() + meshes[m]->triangles.size());
    }
    if (first_triangles_.back() > Corner_table::max_triangles)
      throw Input_error("a mesh of " + std::to_string(first_triangles_.back()) +
                        " triangles is too large; there may be up to " +
                        std::to_string(Corner_table::max_triangles));
  }

  template <typename ConcurrencyTag, typename Traits>
  void collect_triangles(const std::vector<const Domain_mesh_2<Traits>*>& meshes) {
    triangles_.resize(first_triangles_.back());
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const auto& triangles = meshes[m]->triangles;
      for_each_index<ConcurrencyTag>(triangles.size(), [&](std::size_t t) {
        for (std::size_t i = 0; i < 3; ++i)
          triangles_[first_triangles_[m] + t][i] = static_cast<Index>(numbers_[m][triangles[t][i]]);
      });
    }
  }

  // An edge belongs to the first of its triangles, and so does the first of its halfedges.
  void number_halfedges(const Corner_table& corners) {
    halfedges_.resize(3 * triangles_.size());
    for (std::size_t c = 0; c < halfedges_.size(); ++c) {
      const Index twin = corners.twin(c);
      if (twin < c) {
        halfedges_[c] = halfedges_[twin] + 1;
        continue;
      }
      halfedges_[c] = static_cast<Index>(2 * number_of_edges_++);
      if (twin == none)
        border_.push_back(static_cast<Index>(c));
    }
  }

  std::vector<std::vector<std::size_t>> numbers_; // of vertices, by domain mesh
  // Of each domain mesh, and one past those of the last one.
  std::vector<std::size_t> first_vertices_{0}, first_triangles_{0};
  std::vector<Corner_table::Triangle> triangles_; // with the numbers of vertices among all
  std::vector<Index> corners_;                    // by vertex
  std::vector<Index> halfedges_;                  // by corner
  std::size_t number_of_edges_ = 0;
  std::vector<Index> border_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_CONNECTIVITY_H
