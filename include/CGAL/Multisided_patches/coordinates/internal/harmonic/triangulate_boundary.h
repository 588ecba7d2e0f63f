// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULATE_BOUNDARY_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULATE_BOUNDARY_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Bisection_mesh.h>
#include <CGAL/Multisided_patches/internal/Boundary_triangulation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// the constrained Delaunay triangulation of the domain; the point of vertex k is points[k].
//
// The combinatorics come from `exact`, the coordinates as they were given: points are the same up
// to a translation, whose rounding could make a thin triangle lie the wrong way round.
inline Bisection_mesh triangulate_boundary(const std::vector<Complex>& exact,
                                           const std::vector<std::size_t>& next,
                                           const std::vector<Complex>& points) {
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Triangulation = Boundary_triangulation<Kernel>;
  std::vector<Kernel::Point_2> vertices;
  for (const Complex& z : exact)
    vertices.emplace_back(z.real(), z.imag());
  const Triangulation triangulation(vertices, next);

  std::vector<Bisection_mesh::Triangle> triangles;
  for (const Triangulation::Triangle& t : triangulation.triangles()) {
    triangles.emplace_back();
    for (int i = 0; i < 3; ++i) {
      triangles.back().vertex[i] = t.vertices[i];
      triangles.back().neighbor[i] =
          t.neighbors[i] == Triangulation::none ? Bisection_mesh::none : t.neighbors[i];
    }
  }
  return Bisection_mesh(points, std::move(triangles));
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULATE_BOUNDARY_H
