// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_BUILDER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_BUILDER_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/check_finite.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/Mesh_maps.h>
#include <CGAL/Multisided_patches/meshing/Tessellation_visitor.h>
#include <CGAL/Multisided_patches/meshing/internal/Open_edges.h>
#include <CGAL/Multisided_patches/meshing/internal/Scaled_surface.h>
#include <CGAL/Multisided_patches/patches/Surface_geometry_3.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// What becomes of a vertex of a domain mesh.
template <typename Traits>
struct Surface_vertex {
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;

  Surface_vertex() = default;
  Surface_vertex(std::pair<Point_3, Vector_3> point_and_normal)
      : point(std::move(point_and_normal.first)), normal(std::move(point_and_normal.second)) {}

  Point_3 point;
  Vector_3 normal; // of unit length, or 0
};

// A patch with the mesh of its domain and the vertices of that on the surface.
template <typename Patch>
struct Patch_mesh {
  using Traits = typename Patch::Geom_traits;

  const Patch* patch = nullptr;
  const Domain_mesh_2<Traits>* domain_mesh = nullptr;
  std::vector<Surface_vertex<Traits>> vertices;
};

// `patch.points_and_normals()`, which a patch need not have.
template <typename ConcurrencyTag, typename Patch, typename Points, typename Locations,
          typename Iterator>
auto evaluate_points_and_normals(const Patch& patch, const Points& points,
                                 const Locations& locations, Iterator out, int)
    -> decltype(patch.template points_and_normals<ConcurrencyTag>(points, locations, out)) {
  return patch.template points_and_normals<ConcurrencyTag>(points, locations, out);
}
template <typename ConcurrencyTag, typename Patch, typename Points, typename Locations,
          typename Iterator>
Iterator evaluate_points_and_normals(const Patch& patch, const Points& points,
                                     const Locations& locations, Iterator out, long) {
  for_each_index<ConcurrencyTag>(points.size(), [&](std::size_t k) {
    out[k] = patch.point_and_normal(points[k], locations[k]);
  });
  return out + points.size();
}

// Evaluates a patch at the vertices of a mesh of its domain.
template <typename ConcurrencyTag, typename Patch, typename Visitor>
Patch_mesh<Patch> evaluate_vertices(const Patch& patch,
                                    const Domain_mesh_2<typename Patch::Geom_traits>& mesh,
                                    Visitor& visitor) {
  const std::size_t n = mesh.points.size();
  Patch_mesh<Patch> result;
  result.patch = &patch;
  result.domain_mesh = &mesh;
  result.vertices.resize(n);
  constexpr std::size_t block = 1 << 14;
  for (std::size_t first = 0; first < n; first += block) {
    report_progress(visitor, Tessellation_stage::evaluation, first, n);
    const std::size_t end = (std::min)(n, first + block);
    const auto range = [&](const auto& values) {
      return boost::make_iterator_range(values.begin() + first, values.begin() + end);
    };
    evaluate_points_and_normals<ConcurrencyTag>(patch, range(mesh.points), range(mesh.locations),
                                                result.vertices.begin() + first, 0);
    for (std::size_t k = first; k < end; ++k)
      if (!has_finite_coordinates(result.vertices[k].point))
        throw Numerical_error("the surface is not finite at " + text_of_parameters(mesh.points[k]));
  }
  return result;
}

// Where the patch has no tangent plane: the normal of the triangles around the vertex, by area.
template <typename Patch>
void fill_missing_normals(Patch_mesh<Patch>& mesh) {
  using Vector_3 = typename Patch::Geom_traits::Vector_3;
  auto& vertices = mesh.vertices;
  const auto has_normal = [](const auto& v) { return v.normal != NULL_VECTOR; };
  if (std::all_of(vertices.begin(), vertices.end(), has_normal))
    return;
  std::vector<Vec3> sums(vertices.size(), Vec3{0, 0, 0});
  for (const auto& t : mesh.domain_mesh->triangles) {
    const auto& origin = vertices[t[0]].point;
    const Vec3 normal =
        cross(to_vec3(vertices[t[1]].point - origin), to_vec3(vertices[t[2]].point - origin));
    for (const std::size_t v : t)
      sums[v] = sum(sums[v], normal);
  }
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (!has_normal(vertices[v])) {
      const Vec3 n = normalized(sums[v]);
      vertices[v].normal = Vector_3(n[0], n[1], n[2]);
    }
}

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
template <typename FaceGraph, typename Maps>
class Mesh_builder {
  using Graph = boost::graph_traits<FaceGraph>;

public:
  using Vertex = typename Graph::vertex_descriptor;
  using Halfedge = typename Graph::halfedge_descriptor;
  using Face = typename Graph::face_descriptor;

  Mesh_builder(FaceGraph& mesh, const Maps& maps) : mesh_(mesh), maps_(maps) {}

  // Makes room for so many more vertices and triangles.
  void make_room(std::size_t vertices, std::size_t triangles) {
    using Size = typename Graph::vertices_size_type;
    reserve(mesh_, static_cast<Size>(num_vertices(mesh_) + vertices),
            static_cast<Size>(num_edges(mesh_) + vertices + triangles),
            static_cast<Size>(num_faces(mesh_) + triangles));
    vertices_.reserve(vertices);
  }

  // Adds the triangles of patch number `index`, and those of its vertices that are not there yet:
  // numbers[k] is the number of vertex k among those of all patches. Those of one number are the
  // same vertex of the mesh.
  template <typename Patch>
  void add(const Patch_mesh<Patch>& patch, std::size_t index,
           const std::vector<std::size_t>& numbers) {
    add_vertices(patch, numbers);
    const auto& triangles = patch.domain_mesh->triangles;
    for (const std::array<std::size_t, 3>& t : triangles) {
      std::array<Halfedge, 3> halfedges;
      for (std::size_t i = 0; i < 3; ++i)
        halfedges[i] = halfedge_from_to(numbers[t[i]], numbers[t[(i + 1) % 3]]);
      const Face face = face_of(halfedges);
      put_if_wanted(maps_.patch, face, index);
      if constexpr (is_wanted<decltype(Maps::side)>)
        put_sides(patch, t, halfedges);
    }
  }

  // Links the halfedges on the border of what was added.
  void finish() {
    border_.for_each(
        [this](std::size_t, std::size_t, Halfedge h) { set_face(h, Graph::null_face(), mesh_); });
    border_.for_each([this](std::size_t, std::size_t end, Halfedge h) {
      // Around the vertex where it ends, from face to face, up to the next one on the border.
      Halfedge other = opposite(h, mesh_);
      do
        other = opposite(prev(other, mesh_), mesh_);
      while (face(other, mesh_) != Graph::null_face());
      set_next(h, other, mesh_);
      set_halfedge(vertices_[end], h, mesh_);
    });
  }

private:
  template <typename Patch>
  void add_vertices(const Patch_mesh<Patch>& patch, const std::vector<std::size_t>& numbers) {
    auto points = get(CGAL::vertex_point, mesh_);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (numbers[k] >= vertices_.size())
        vertices_.resize(numbers[k] + 1, Graph::null_vertex());
      Vertex& v = vertices_[numbers[k]];
      if (v != Graph::null_vertex())
        continue;
      v = add_vertex(mesh_);
      put(points, v, patch.vertices[k].point);
      put_vertex_properties(patch, k, v);
    }
  }

  template <typename Patch>
  void put_vertex_properties(const Patch_mesh<Patch>& patch, std::size_t k, Vertex v) {
    const auto& mesh = *patch.domain_mesh;
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

  // The halfedges of a triangle between consecutive vertices of a side.
  template <typename Patch>
  void put_sides(const Patch_mesh<Patch>& patch, const std::array<std::size_t, 3>& t,
                 const std::array<Halfedge, 3>& halfedges) {
    const auto& mesh = *patch.domain_mesh;
    for (int i = 0; i < 3; ++i) {
      const std::size_t from = t[i], to = t[(i + 1) % 3];
      const std::size_t n = mesh.number_of_boundary_points;
      if (from >= n || to >= n)
        continue;
      // A vertex of the domain is the start of its side; its end is the start of the next one.
      const std::size_t side = mesh.locations[from].index;
      const bool ends_side = mesh.locations[to].kind == Patch::Location::Kind::vertex &&
                             mesh.locations[to].index == patch.patch->domain().next(side);
      const bool is_next = to == from + 1 && mesh.locations[to].index == side;
      const bool is_last = ends_side && (from + 1 == n || mesh.locations[from + 1].index != side);
      if (is_next || is_last)
        put(maps_.side, halfedges[i], side);
    }
  }

  // For a new triangle: of an edge that is there already, or of a new one.
  Halfedge halfedge_from_to(std::size_t from, std::size_t to) {
    if (const auto open = border_.take(from, to))
      return *open;
    const Halfedge h = halfedge(add_edge(mesh_), mesh_), o = opposite(h, mesh_);
    set_target(h, vertices_[to], mesh_);
    set_target(o, vertices_[from], mesh_);
    border_.add(to, from, o);
    return h;
  }

  Face face_of(const std::array<Halfedge, 3>& halfedges) {
    const Face f = add_face(mesh_);
    for (std::size_t i = 0; i < 3; ++i) {
      set_next(halfedges[i], halfedges[(i + 1) % 3], mesh_);
      set_face(halfedges[i], f, mesh_);
      set_halfedge(target(halfedges[i], mesh_), halfedges[i], mesh_);
    }
    set_halfedge(f, halfedges[0], mesh_);
    return f;
  }

  FaceGraph& mesh_;
  Maps maps_;
  std::vector<Vertex> vertices_; // by number
  Open_edges<Halfedge> border_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_BUILDER_H
