// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_PATCH_MESH_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_PATCH_MESH_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/check_finite.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/Tessellation_visitor.h>
#include <CGAL/Multisided_patches/meshing/internal/Scaled_surface.h>

#include <boost/container/vector.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
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
  boost::container::vector<Surface_vertex<Traits>> vertices;
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
  result.vertices.resize(n, boost::container::default_init); // threads touch it first
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

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_PATCH_MESH_H
