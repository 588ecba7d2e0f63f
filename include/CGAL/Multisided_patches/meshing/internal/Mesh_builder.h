// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_BUILDER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_BUILDER_H

#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/meshing/Mesh_maps.h>
#include <CGAL/Multisided_patches/meshing/internal/Mesh_connectivity.h>
#include <CGAL/Multisided_patches/meshing/internal/New_elements.h>
#include <CGAL/Multisided_patches/meshing/internal/Patch_mesh.h>
#include <CGAL/Multisided_patches/patches/Surface_geometry_3.h>

#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <limits>
#include <optional>
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

// Adds patches to a mesh of any kind. Nothing is joined to what the mesh already has.
//
// What a map throws leaves a mesh that is whole, but without some of the properties.
template <typename ConcurrencyTag, typename FaceGraph, typename Maps>
class Mesh_builder {
  using Elements = New_elements<FaceGraph>;
  using Concurrency = typename Elements::template Concurrency<ConcurrencyTag>;
  using Halfedge = typename Elements::Halfedge;

public:
  // The connectivity has to outlive this object.
  Mesh_builder(FaceGraph& mesh, const Maps& maps, const Mesh_connectivity& connectivity)
      : mesh_(mesh), maps_(maps), connectivity_(connectivity) {}

  // Adds the patches whose domain meshes the connectivity is made of, in the same order.
  template <typename Patch>
  void add(const std::vector<Patch_mesh<Patch>>& patches) {
    const Elements elements(mesh_, connectivity_.number_of_vertices(),
                            connectivity_.number_of_edges(), connectivity_.number_of_triangles());
    link_triangles(elements);
    link_vertices(elements);
    link_border(elements);
    put_points(elements, patches);
    for (std::size_t p = 0; p < patches.size(); ++p) {
      put_vertex_properties(elements, patches[p], p);
      put_triangle_properties(elements, patches[p], p);
    }
  }

private:
  Halfedge halfedge(const Elements& elements, std::size_t corner) const {
    return elements.halfedge(connectivity_.halfedge(corner));
  }
  auto vertex(const Elements& elements, std::size_t corner) const {
    return elements.vertex(connectivity_.vertex(corner));
  }

  // ------------------------------------------------------------------------------------- linking

  void link_triangles(const Elements& elements) {
    for_each_index<Concurrency>(connectivity_.number_of_triangles(), [&](std::size_t t) {
      const auto face = elements.face(t);
      for (std::size_t c = 3 * t; c < 3 * t + 3; ++c) {
        const Halfedge h = halfedge(elements, c);
        const std::size_t next = Mesh_connectivity::next_corner(c);
        set_target(h, vertex(elements, next), mesh_);
        set_next(h, halfedge(elements, next), mesh_);
        set_face(h, face, mesh_);
      }
      set_halfedge(face, halfedge(elements, 3 * t), mesh_);
    });
  }

  void link_vertices(const Elements& elements) {
    for_each_index<Concurrency>(connectivity_.number_of_vertices(), [&](std::size_t v) {
      const auto c = connectivity_.corner_at(v);
      if (c != Mesh_connectivity::none)
        set_halfedge(elements.vertex(v), halfedge(elements, Mesh_connectivity::previous_corner(c)),
                     mesh_);
    });
  }

  void link_border(const Elements& elements) {
    const auto none = boost::graph_traits<FaceGraph>::null_face();
    for (const auto c : connectivity_.border()) {
      const Halfedge h = opposite(halfedge(elements, c), mesh_);
      set_target(h, vertex(elements, c), mesh_);
      set_face(h, none, mesh_);
      set_halfedge(vertex(elements, c), h, mesh_);
    }
    for (const auto c : connectivity_.border()) {
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
  void put_points(const Elements& elements, const std::vector<Patch_mesh<Patch>>& patches) {
    const auto points = get(CGAL::vertex_point, mesh_);
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const std::vector<std::size_t>& numbers = connectivity_.numbers(p);
      for_each_index<Concurrency>(numbers.size(), [&](std::size_t k) {
        if (connectivity_.is_new(p, numbers[k]))
          put(points, elements.vertex(numbers[k]), patches[p].vertices[k].point);
      });
    }
  }

  template <typename Patch>
  void put_vertex_properties(const Elements& elements, const Patch_mesh<Patch>& patch,
                             std::size_t index) {
    const auto& mesh = *patch.domain_mesh;
    const std::vector<std::size_t>& numbers = connectivity_.numbers(index);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (!connectivity_.is_new(index, numbers[k]))
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
    const std::size_t first = connectivity_.first_triangle(index);
    if constexpr (is_wanted<decltype(Maps::patch)>)
      for (std::size_t t = first; t < connectivity_.first_triangle(index + 1); ++t)
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
  const Mesh_connectivity& connectivity_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_BUILDER_H
