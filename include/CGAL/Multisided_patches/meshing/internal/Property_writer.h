// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_PROPERTY_WRITER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_PROPERTY_WRITER_H

#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/meshing/Mesh_maps.h>
#include <CGAL/Multisided_patches/meshing/internal/Mesh_connectivity.h>
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

// Writes the points and other properties of patches to the elements of a mesh.
//
// What a map throws leaves a mesh that is whole, but without some of the properties.
template <typename Elements, typename Maps>
class Property_writer {
  using Concurrency = typename Elements::Concurrency;

public:
  Property_writer(const Elements& elements, const Mesh_connectivity& connectivity, const Maps& maps)
      : elements_(elements), connectivity_(connectivity), maps_(maps) {}

  // Of the patches whose domain meshes the connectivity is made of, in the same order.
  template <typename FaceGraph, typename Patch>
  void write(FaceGraph& mesh, const std::vector<Patch_mesh<Patch>>& patches) {
    put_points(get(CGAL::vertex_point, mesh), patches);
    for (std::size_t p = 0; p < patches.size(); ++p) {
      put_vertex_properties(patches[p], p);
      put_triangle_properties(patches[p], p);
    }
  }

private:
  template <typename Map, typename Patch>
  void put_points(const Map& points, const std::vector<Patch_mesh<Patch>>& patches) {
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const std::vector<std::size_t>& numbers = connectivity_.numbers(p);
      for_each_index<Concurrency>(numbers.size(), [&](std::size_t k) {
        if (connectivity_.is_new(p, numbers[k]))
          put(points, elements_.new_vertex(numbers[k]), patches[p].vertices[k].point);
      });
    }
  }

  template <typename Patch>
  void put_vertex_properties(const Patch_mesh<Patch>& patch, std::size_t index) {
    const auto& mesh = *patch.domain_mesh;
    const std::vector<std::size_t>& numbers = connectivity_.numbers(index);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (!connectivity_.is_new(index, numbers[k]))
        continue;
      const auto v = elements_.new_vertex(numbers[k]);
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
  void put_triangle_properties(const Patch_mesh<Patch>& patch, std::size_t index) {
    const std::size_t first = connectivity_.first_triangle(index);
    if constexpr (is_wanted<decltype(Maps::patch)>)
      for (std::size_t t = first; t < connectivity_.first_triangle(index + 1); ++t)
        put(maps_.patch, elements_.new_face(t), index);
    if constexpr (is_wanted<decltype(Maps::side)>) {
      const auto& triangles = patch.domain_mesh->triangles;
      for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
          if (const auto side = side_of_edge(patch, triangles[t][i], triangles[t][(i + 1) % 3]))
            put(maps_.side, elements_.corner_halfedge(3 * (first + t) + i), *side);
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

  const Elements& elements_;
  const Mesh_connectivity& connectivity_;
  Maps maps_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_PROPERTY_WRITER_H
