// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_BUILDER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_BUILDER_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/meshing/Mesh_maps.h>
#include <CGAL/Multisided_patches/meshing/internal/Corner_table.h>
#include <CGAL/Multisided_patches/meshing/internal/New_elements.h>
#include <CGAL/Multisided_patches/meshing/internal/Patch_mesh.h>
#include <CGAL/Multisided_patches/patches/Surface_geometry_3.h>

#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

template <typename Map>
inline constexpr bool is_wanted = !std::is_same_v<Map, No_map>;

template <typename Map, typename Key, typename Value>
void put_if_wanted([[maybe_unused]] const Map& map, [[maybe_unused]] const Key& key,
                   [[maybe_unused]] const Value& value) {
  if constexpr (is_wanted<Map>)
    put(map, key, value);
}

// Adds patches to a mesh of any kind. Triangles, of one patch or of several, are joined where they
// have the numbers of two vertices in common; nothing is looked for in the mesh.
//
// What a map throws leaves a mesh that is whole, but without some of the properties.
template <typename ConcurrencyTag, typename FaceGraph, typename Maps>
class Mesh_builder {
  using Elements = New_elements<FaceGraph>;
  using Concurrency = typename Elements::template Concurrency<ConcurrencyTag>;
  using Halfedge = typename Elements::Halfedge;
  using Index = Corner_table::Index;
  // For each patch, the numbers that its vertices have among those of all. A patch has the vertices
  // of the patches before it or those with the next numbers, which it brings in.
  using Vertex_numbers = std::vector<std::vector<std::size_t>>;

public:
  Mesh_builder(FaceGraph& mesh, const Maps& maps) : mesh_(mesh), maps_(maps) {}

  template <typename Patch>
  void add(const std::vector<Patch_mesh<Patch>>& patches, const Vertex_numbers& numbers) {
    count_elements(patches, numbers);
    collect_triangles(patches, numbers);
    const Corner_table corners(triangles_, first_vertices_.back(), ConcurrencyTag());
    number_halfedges(corners);
    const Elements elements(mesh_, first_vertices_.back(), number_of_edges_, triangles_.size());
    link_triangles(elements);
    link_vertices(elements, corners);
    link_border(elements);
    put_points(elements, patches, numbers);
    for (std::size_t p = 0; p < patches.size(); ++p) {
      put_vertex_properties(elements, patches[p], p, numbers[p]);
      put_triangle_properties(elements, patches[p], p);
    }
  }

private:
  // ---------------------------------------------------------------------------------- numbering

  template <typename Patch>
  void count_elements(const std::vector<Patch_mesh<Patch>>& patches,
                      const Vertex_numbers& numbers) {
    for (std::size_t p = 0; p < patches.size(); ++p) {
      std::size_t end = first_vertices_.back();
      for (const std::size_t number : numbers[p])
        end = (std::max)(end, number + 1);
      first_vertices_.push_back(end);
      first_triangles_.push_back(first_triangles_.back() +
                                 patches[p].domain_mesh->triangles.size());
    }
    if (first_triangles_.back() > Corner_table::max_triangles)
      throw Input_error("a mesh of " + std::to_string(first_triangles_.back()) +
                        " triangles is too large; there may be up to " +
                        std::to_string(Corner_table::max_triangles));
  }

  template <typename Patch>
  void collect_triangles(const std::vector<Patch_mesh<Patch>>& patches,
                         const Vertex_numbers& numbers) {
    triangles_.resize(first_triangles_.back());
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto& triangles = patches[p].domain_mesh->triangles;
      for_each_index<ConcurrencyTag>(triangles.size(), [&](std::size_t t) {
        for (std::size_t i = 0; i < 3; ++i)
          triangles_[first_triangles_[p] + t][i] = static_cast<Index>(numbers[p][triangles[t][i]]);
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
      if (twin == Corner_table::none)
        border_.push_back(static_cast<Index>(c));
    }
  }

  static std::size_t next_corner(std::size_t c) { return c % 3 < 2 ? c + 1 : c - 2; }
  static std::size_t previous_corner(std::size_t c) { return c % 3 > 0 ? c - 1 : c + 2; }

  Halfedge halfedge(const Elements& elements, std::size_t corner) const {
    return elements.halfedge(halfedges_[corner]);
  }
  auto vertex(const Elements& elements, std::size_t corner) const {
    return elements.vertex(triangles_[corner / 3][corner % 3]);
  }

  // ------------------------------------------------------------------------------------- linking

  void link_triangles(const Elements& elements) {
    for_each_index<Concurrency>(triangles_.size(), [&](std::size_t t) {
      const auto face = elements.face(t);
      for (std::size_t c = 3 * t; c < 3 * t + 3; ++c) {
        const Halfedge h = halfedge(elements, c);
        set_target(h, vertex(elements, next_corner(c)), mesh_);
        set_next(h, halfedge(elements, next_corner(c)), mesh_);
        set_face(h, face, mesh_);
      }
      set_halfedge(face, halfedge(elements, 3 * t), mesh_);
    });
  }

  void link_vertices(const Elements& elements, const Corner_table& corners) {
    for_each_index<Concurrency>(first_vertices_.back(), [&](std::size_t v) {
      const Index c = corners.corner_at(v);
      if (c != Corner_table::none)
        set_halfedge(elements.vertex(v), halfedge(elements, previous_corner(c)), mesh_);
    });
  }

  void link_border(const Elements& elements) {
    const auto none = boost::graph_traits<FaceGraph>::null_face();
    for (const Index c : border_) {
      const Halfedge h = opposite(halfedge(elements, c), mesh_);
      set_target(h, vertex(elements, c), mesh_);
      set_face(h, none, mesh_);
      set_halfedge(vertex(elements, c), h, mesh_);
    }
    for (const Index c : border_) {
      const Halfedge h = opposite(halfedge(elements, c), mesh_);
      // Around the vertex where it ends, from face to face, up to the next one on the border.
      Halfedge other = halfedge(elements, c);
      do
        other = opposite(prev(other, mesh_), mesh_);
      while (face(other, mesh_) != none);
      set_next(h, other, mesh_);
    }
  }

  // ---------------------------------------------------------------------------------- properties

  template <typename Patch>
  void put_points(const Elements& elements, const std::vector<Patch_mesh<Patch>>& patches,
                  const Vertex_numbers& numbers) {
    const auto points = get(CGAL::vertex_point, mesh_);
    for (std::size_t p = 0; p < patches.size(); ++p)
      for_each_index<Concurrency>(numbers[p].size(), [&](std::size_t k) {
        if (is_new(p, numbers[p][k]))
          put(points, elements.vertex(numbers[p][k]), patches[p].vertices[k].point);
      });
  }

  // Whether a vertex is one of those that a patch brings in.
  bool is_new(std::size_t patch, std::size_t number) const {
    return number >= first_vertices_[patch];
  }

  template <typename Patch>
  void put_vertex_properties(const Elements& elements, const Patch_mesh<Patch>& patch,
                             std::size_t index, const std::vector<std::size_t>& numbers) {
    const auto& mesh = *patch.domain_mesh;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (!is_new(index, numbers[k]))
        continue;
      const auto v = elements.vertex(numbers[k]);
      put_if_wanted(maps_.normal, v, patch.vertices[k].normal);
      put_if_wanted(maps_.uv, v, mesh.points[k]);
      if constexpr (is_wanted<decltype(Maps::mean_curvature)> ||
                    is_wanted<decltype(Maps::gaussian_curvature)>) {
        const auto curvature =
            surface_geometry(*patch.patch, mesh.points[k], mesh.locations[k]).curvature;
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        put_if_wanted(maps_.mean_curvature, v, curvature ? curvature->mean() : none);
        put_if_wanted(maps_.gaussian_curvature, v, curvature ? curvature->gaussian() : none);
      }
    }
  }

  template <typename Patch>
  void put_triangle_properties(const Elements& elements, const Patch_mesh<Patch>& patch,
                               std::size_t index) {
    const std::size_t first = first_triangles_[index];
    if constexpr (is_wanted<decltype(Maps::patch)>)
      for (std::size_t t = first; t < first_triangles_[index + 1]; ++t)
        put(maps_.patch, elements.face(t), index);
    if constexpr (is_wanted<decltype(Maps::side)>) {
      const auto& triangles = patch.domain_mesh->triangles;
      for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
          if (const auto side = side_of_edge(patch, triangles[t][i], triangles[t][(i + 1) % 3]))
            put(maps_.side, halfedge(elements, 3 * (first + t) + i), *side);
    }
  }

  // The side on which two vertices are consecutive.
  template <typename Patch>
  static std::optional<std::size_t> side_of_edge(const Patch_mesh<Patch>& patch, std::size_t from,
                                                 std::size_t to) {
    const auto& mesh = *patch.domain_mesh;
    const std::size_t n = mesh.number_of_boundary_points;
    if (from >= n || to >= n)
      return std::nullopt;
    // A vertex of the domain is the start of its side; its end is the start of the next one.
    const std::size_t side = mesh.locations[from].index;
    const bool ends_side = mesh.locations[to].kind == Patch::Location::Kind::vertex &&
                           mesh.locations[to].index == patch.patch->domain().next(side);
    const bool is_next = to == from + 1 && mesh.locations[to].index == side;
    const bool is_last = ends_side && (from + 1 == n || mesh.locations[from + 1].index != side);
    return is_next || is_last ? std::make_optional(side) : std::nullopt;
  }

  FaceGraph& mesh_;
  Maps maps_;
  // Of each patch, and one past those of the last patch.
  std::vector<std::size_t> first_vertices_{0}, first_triangles_{0};
  std::vector<Corner_table::Triangle> triangles_; // with the numbers of vertices among all
  std::vector<Index> halfedges_;                  // by corner
  std::size_t number_of_edges_ = 0;
  std::vector<Index> border_; // corners
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_BUILDER_H
