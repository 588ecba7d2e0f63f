// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CHECK_MESH_H
#define CGAL_MULTISIDED_PATCHES_CHECK_MESH_H

#include <CGAL/Multisided_patches/analysis/internal/triangle_shape.h>
#include <CGAL/Multisided_patches/analysis/mesh_topology.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! What `check_mesh()` finds out about a mesh of triangles.
struct Mesh_check : Mesh_topology {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t triangles = 0;

  //! triangles whose corners are collinear, or coincide; decided by the predicates of the kernel
  std::size_t degenerate_triangles = 0;
  //! edges whose two triangles lie on top of each other: the angle between their normals is larger
  //! than the limit. Degenerate triangles have no normal, and are left out
  std::size_t folded_edges = 0;
  //! triangles that all three vertex normals see from behind, if there are vertex normals
  std::optional<std::size_t> inverted_triangles = {};

  //! the angles of all triangles (degrees). Those of a degenerate triangle count as 0 and 180
  double smallest_angle = 0, largest_angle = 0;
  //! model units
  double shortest_edge = 0, longest_edge = 0;

  //! one element for each patch, in ascending order of their numbers, if the faces have patches
  std::vector<Patch_topology> patches = {};

  //! whether the faces of every patch are connected across edges
  bool has_one_component_per_patch() const {
    return std::all_of(patches.begin(), patches.end(),
                       [](const Patch_topology& patch) { return patch.components == 1; });
  }
};

namespace internal {

template <typename Mesh, typename VertexPointMap>
class Mesh_checker {
public:
  using Graph_traits = boost::graph_traits<Mesh>;
  using Vertex = typename Graph_traits::vertex_descriptor;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Face = typename Graph_traits::face_descriptor;

  Mesh_checker(const Mesh& mesh, const VertexPointMap& points) : mesh_(mesh), points_(points) {
    require_finite_points();
    require_triangles();
    static_cast<Mesh_topology&>(result_) = mesh_topology(mesh);
    measure_triangles();
  }

  void measure_edges(double fold_angle) {
    for (const auto e : edges(mesh_)) {
      const Halfedge h = halfedge(e, mesh_), o = opposite(h, mesh_);
      const double length = norm(along(h));
      result_.shortest_edge =
          result_.edges == 0 ? length : (std::min)(result_.shortest_edge, length);
      result_.longest_edge = (std::max)(result_.longest_edge, length);
      ++result_.edges;
      if (!is_border(h, mesh_) && !is_border(o, mesh_))
        result_.folded_edges +=
            angle_between(normal(face(h, mesh_)), normal(face(o, mesh_))) * 180 / pi > fold_angle;
    }
  }

  template <typename VertexNormalMap>
  void compare_normals(const VertexNormalMap& normals) {
    std::size_t inverted = 0;
    for (const Face f : faces(mesh_)) {
      const Halfedge h = halfedge(f, mesh_);
      const auto sees_back = [&](Vertex v) {
        return dot(normal(f), normalized(to_vec3(get(normals, v)))) < 0;
      };
      inverted += sees_back(source(h, mesh_)) && sees_back(target(h, mesh_)) &&
                  sees_back(target(next(h, mesh_), mesh_));
    }
    result_.inverted_triangles = inverted;
  }

  template <typename FacePatchMap>
  void count_patches(const FacePatchMap& face_patch_map) {
    result_.patches = patch_topologies(mesh_, face_patch_map);
  }

  const Mesh_check& result() const { return result_; }

private:
  Vec3 along(Halfedge h) const {
    return to_vec3(get(points_, target(h, mesh_)) - get(points_, source(h, mesh_)));
  }
  const Vec3& normal(Face f) const { return normals_[get(face_index_, f)]; }

  void require_finite_points() {
    for (const Vertex v : vertices(mesh_)) {
      const auto& p = get(points_, v);
      if (!CGAL::is_finite(p.x()) || !CGAL::is_finite(p.y()) || !CGAL::is_finite(p.z()))
        throw Input_error("vertex " + std::to_string(result_.vertices) +
                          " of the mesh is not finite");
      ++result_.vertices;
    }
  }

  void require_triangles() {
    for (const Face f : faces(mesh_)) {
      const Halfedge h = halfedge(f, mesh_);
      if (!is_triangle(h, mesh_))
        throw Input_error("face " + std::to_string(result_.triangles) + " of the mesh has " +
                          std::to_string(degree(f, mesh_)) + " corners; triangles were expected");
      ++result_.triangles;
    }
  }

  void measure_triangles() {
    normals_.assign(num_faces(mesh_), Vec3{0, 0, 0});
    result_.smallest_angle = result_.triangles > 0 ? 180 : 0;
    for (const Face f : faces(mesh_)) {
      const Halfedge h = halfedge(f, mesh_), i = next(h, mesh_), j = next(i, mesh_);
      Triangle_shape shape{{0, 0, 0}, {0, 0, 180}};
      if (collinear(get(points_, target(h, mesh_)), get(points_, target(i, mesh_)),
                    get(points_, target(j, mesh_))))
        ++result_.degenerate_triangles;
      else
        shape = triangle_shape({along(h), along(i), along(j)});
      normals_[get(face_index_, f)] = shape.normal;
      for (const double angle : shape.angles) {
        result_.smallest_angle = (std::min)(result_.smallest_angle, angle);
        result_.largest_angle = (std::max)(result_.largest_angle, angle);
      }
    }
  }

  const Mesh& mesh_;
  const VertexPointMap& points_;
  const typename GetInitializedFaceIndexMap<Mesh>::const_type face_index_ =
      get_initialized_face_index_map(mesh_);
  std::vector<Vec3> normals_; // of unit length, by face; zero for degenerate triangles
  Mesh_check result_;
};

} // namespace internal

/*!
 * measures a mesh of triangles. Coordinates of any size between 1e-150 and 1e150 are fine.
 *
 * Self-intersections are not looked for; that is what `number_of_self_intersections()` does.
 *
 * \tparam Mesh a model of `FaceListGraph` and `HalfedgeListGraph`, such as `CGAL::Surface_mesh` or
 * `CGAL::Polyhedron_3`
 *
 * \param mesh the mesh
 * \param np optional named parameters of CGAL: `vertex_point_map`, `vertex_normal_map` (vectors of
 * any length, asks for `Mesh_check::inverted_triangles`) and `face_patch_map` (non-negative
 * integers, asks for `Mesh_check::patches`)
 * \param fold_angle from which angle between the normals of neighbouring triangles on an edge is a
 * fold (degrees, in (0,180)). A smooth surface needs no more than a few degrees, and the edges of
 * a solid turn by 90 and seldom by more than 135; by default, 150, a fold is sharper than that
 *
 * \throws Input_error if a face is not a triangle, a point is not finite, or `fold_angle` is out of
 * range
 *
 * Complexity: linear in the size of the mesh, and O(m log p) for m faces of p patches.
 */
template <typename Mesh, typename NamedParameters = parameters::Default_named_parameters>
Mesh_check check_mesh(const Mesh& mesh, const NamedParameters& np = parameters::default_values(),
                      double fold_angle = 150) {
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  if (!(0 < fold_angle && fold_angle < 180))
    throw Input_error("the angle of a fold must lie between 0 and 180 degrees, not " +
                      internal::to_short_text(fold_angle));
  const auto points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, mesh));
  internal::Mesh_checker<Mesh, std::decay_t<decltype(points)>> checker(mesh, points);
  checker.measure_edges(fold_angle);
  if constexpr (!is_default_parameter<NamedParameters, internal_np::vertex_normal_map_t>::value)
    checker.compare_normals(get_parameter(np, internal_np::vertex_normal_map));
  if constexpr (!is_default_parameter<NamedParameters, internal_np::face_patch_t>::value)
    checker.count_patches(get_parameter(np, internal_np::face_patch));
  return checker.result();
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CHECK_MESH_H
