// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_TESSELLATE_H
#define CGAL_MULTISIDED_PATCHES_TESSELLATE_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/mesh_domain.h>

#include <CGAL/Surface_mesh/Surface_mesh.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

namespace internal {

// Where the patch has no tangent plane: the normal of the triangles around the vertex, by area.
template <typename Point_3, typename Vector_3, typename Triangles>
void fill_missing_normals(const Triangles& triangles,
                          std::vector<std::pair<Point_3, Vector_3>>& vertices) {
  std::vector<Vec3> sums(vertices.size(), Vec3{0, 0, 0});
  bool missing = false;
  for (const auto& vertex : vertices)
    missing = missing || vertex.second == NULL_VECTOR;
  if (!missing)
    return;
  for (const auto& t : triangles) {
    const Point_3& origin = vertices[t[0]].first;
    const Vec3 normal =
        cross(to_vec3(vertices[t[1]].first - origin), to_vec3(vertices[t[2]].first - origin));
    for (const std::size_t v : t)
      sums[v] = sum(sums[v], normal);
  }
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (vertices[v].second == NULL_VECTOR) {
      const Vec3 n = normalized(sums[v]);
      vertices[v].second = Vector_3(n[0], n[1], n[2]);
    }
}

} // namespace internal

/*!
 * evaluates a patch at the vertices of a mesh of its domain, and adds the surface mesh to `mesh`.
 *
 * Vertices on the boundary of the domain get the points of the boundary curves themselves. The
 * vertex property maps `"v:normal"` (`Vector_3`, unit length), `"v:u"` and `"v:v"` (`double`,
 * domain units) are added to `mesh` if it has none, and filled for the new vertices.
 *
 * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the
 * result is the same, bit for bit.
 *
 * \tparam Patch a model of `MultisidedPatch_3`
 *
 * \throws Numerical_error if a point of the surface is not finite; `mesh` is then unchanged
 */
template <typename ConcurrencyTag = Parallel_if_available_tag, typename Patch>
void tessellate(const Patch& patch, const Domain_mesh_2<typename Patch::Geom_traits>& domain_mesh,
                Surface_mesh<typename Patch::Point_3>& mesh) {
  using Mesh = Surface_mesh<typename Patch::Point_3>;
  using Point_3 = typename Patch::Point_3;
  using Vector_3 = typename Patch::Vector_3;
  using Vertex = typename Mesh::Vertex_index;

  const std::size_t n = domain_mesh.points.size();
  std::vector<std::pair<Point_3, Vector_3>> vertices(n);
  internal::for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
    vertices[i] = patch.point_and_normal(domain_mesh.points[i], domain_mesh.locations[i]);
  });
  for (std::size_t i = 0; i < n; ++i) {
    const Point_3& p = vertices[i].first;
    if (!CGAL::is_finite(p.x()) || !CGAL::is_finite(p.y()) || !CGAL::is_finite(p.z()))
      throw Numerical_error(
          "the surface is not finite at (u,v) = (" +
          internal::to_short_text(CGAL::to_double(domain_mesh.points[i].x())) + ", " +
          internal::to_short_text(CGAL::to_double(domain_mesh.points[i].y())) + ")");
  }
  internal::fill_missing_normals(domain_mesh.triangles, vertices);

  const std::size_t faces = domain_mesh.triangles.size();
  using Size = typename Mesh::size_type;
  mesh.reserve(static_cast<Size>(mesh.number_of_vertices() + n),
               static_cast<Size>(mesh.number_of_edges() + n + faces),
               static_cast<Size>(mesh.number_of_faces() + faces));
  auto normal = mesh.template add_property_map<Vertex, Vector_3>("v:normal", NULL_VECTOR).first;
  auto u = mesh.template add_property_map<Vertex, double>("v:u", 0).first;
  auto v = mesh.template add_property_map<Vertex, double>("v:v", 0).first;
  std::vector<Vertex> handles;
  handles.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vertex vertex = mesh.add_vertex(vertices[i].first);
    handles.push_back(vertex);
    normal[vertex] = vertices[i].second;
    u[vertex] = CGAL::to_double(domain_mesh.points[i].x());
    v[vertex] = CGAL::to_double(domain_mesh.points[i].y());
  }
  for (const auto& t : domain_mesh.triangles)
    mesh.add_face(handles[t[0]], handles[t[1]], handles[t[2]]);
}

/*!
 * meshes a patch: a disk of triangles, counterclockwise as seen from the side to which the normals
 * point. This is `mesh_domain()`, followed by the function above.
 *
 * \param patch the patch
 * \param mesh receives the triangles, in addition to those that it has
 * \param density the target edge length (model units), or `Mesh_density::triangles(n)`
 *
 * \throws Input_error if the density asks for too many triangles
 * \throws Numerical_error if a point of the surface is not finite; `mesh` is unchanged in both
 * cases
 */
template <typename ConcurrencyTag = Parallel_if_available_tag, typename Patch>
void tessellate(const Patch& patch, Surface_mesh<typename Patch::Point_3>& mesh,
                const Mesh_density& density) {
  tessellate<ConcurrencyTag>(patch, mesh_domain(patch, density), mesh);
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_TESSELLATE_H
