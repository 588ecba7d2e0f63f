// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_BOUNDARY_DEVIATION_H
#define CGAL_MULTISIDED_PATCHES_BOUNDARY_DEVIATION_H

#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <CGAL/Surface_mesh/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! How far the boundary of a mesh is from the boundary curves that it stands for (model units).
struct Boundary_deviation {
  //! the largest distance of a boundary vertex from its point of the curve
  double vertices = 0;
  //! the largest distance of the curve, halfway between two vertices, from the edge between them
  double edges = 0;
};

namespace internal {

// The boundary curve by de Casteljau's algorithm in extended precision: on purpose not the way in
// which the mesh was computed.
template <typename Ribbon>
Vec3 de_casteljau(const Ribbon& ribbon, double s) {
  using Point = std::array<long double, 3>;
  std::vector<Point> points;
  for (std::size_t j = 0; j <= ribbon.degree(); ++j) {
    const auto& p = ribbon.control_point(j, 0);
    points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  const long double t = s;
  for (std::size_t d = ribbon.degree(); d > 0; --d)
    for (std::size_t j = 0; j < d; ++j)
      for (std::size_t c = 0; c < 3; ++c)
        points[j][c] = (1 - t) * points[j][c] + t * points[j + 1][c];
  return {static_cast<double>(points[0][0]), static_cast<double>(points[0][1]),
          static_cast<double>(points[0][2])};
}

} // namespace internal

/*!
 * measures how well a mesh keeps to the boundary curves of a loop.
 *
 * \param loop the ribbons
 * \param domain_mesh the mesh of the domain: tells which vertices lie where on the boundary
 * \param mesh the surface mesh (model units) whose first vertices are those of `domain_mesh`
 *
 * Complexity: O(d²) for each boundary vertex, d being the degree of its curve.
 */
template <typename Traits>
Boundary_deviation boundary_deviation(const Ribbon_loop_3<Traits>& loop,
                                      const Domain_mesh_2<Traits>& domain_mesh,
                                      const Surface_mesh<typename Traits::Point_3>& mesh) {
  const std::size_t n = domain_mesh.number_of_boundary_points;
  using Vertex = typename Surface_mesh<typename Traits::Point_3>::Vertex_index;
  const auto point = [&](std::size_t k) {
    return internal::to_vec3(mesh.point(Vertex(static_cast<typename Vertex::size_type>(k))) -
                             ORIGIN);
  };
  Boundary_deviation deviation;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = k + 1 == n ? 0 : k + 1;
    const auto &here = domain_mesh.locations[k], &there = domain_mesh.locations[next];
    const auto& ribbon = loop[here.index];
    // A vertex is the start of its side; the end of a side is the next side's vertex.
    const double s = CGAL::to_double(here.s);
    const double end = there.index == here.index ? CGAL::to_double(there.s) : 1;
    const internal::Vec3 curve = internal::de_casteljau(ribbon, s), p = point(k);
    deviation.vertices = (std::max)(
        deviation.vertices, internal::norm({curve[0] - p[0], curve[1] - p[1], curve[2] - p[2]}));
    deviation.edges = (std::max)(
        deviation.edges, internal::distance_to_segment(
                             internal::de_casteljau(ribbon, (s + end) / 2), p, point(next)));
  }
  return deviation;
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_BOUNDARY_DEVIATION_H
