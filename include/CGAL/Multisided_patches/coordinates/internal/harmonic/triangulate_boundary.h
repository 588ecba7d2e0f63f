// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULATE_BOUNDARY_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULATE_BOUNDARY_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Bisection_mesh.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Side_subdivision.h>
#include <CGAL/Multisided_patches/internal/Boundary_triangulation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// the constrained Delaunay triangulation of the domain, with some more points on its sides; the
// point of vertex k is number k.
inline Bisection_mesh triangulate_boundary(const Boundary& boundary) {
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Triangulation = Boundary_triangulation<Kernel>;
  const Side_subdivision subdivision(boundary);

  std::vector<Complex> points = boundary.vertices();
  std::vector<std::size_t> next(boundary.size()), sides(boundary.size());
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    std::size_t last = k;
    sides[k] = k;
    const auto go_to = [&](std::size_t i) { last = next[last] = i; };
    const std::size_t end = boundary.next(k);
    for (const double t : subdivision.parameters(k)) {
      go_to(points.size());
      points.push_back(points[k] + t * (points[end] - points[k]));
      next.emplace_back();
      sides.push_back(k);
    }
    go_to(end);
  }
  std::vector<Kernel::Point_2> vertices;
  for (const Complex& z : points)
    vertices.emplace_back(z.real(), z.imag());
  const Triangulation triangulation(vertices, next);

  std::vector<Bisection_mesh::Triangle> triangles;
  for (const Linked_triangle& t : triangulation.triangles()) {
    triangles.emplace_back();
    for (int i = 0; i < 3; ++i) {
      triangles.back().vertex[i] = t.vertices[i];
      triangles.back().neighbor[i] =
          t.neighbors[i] == Triangulation::none ? Bisection_mesh::none : t.neighbors[i];
    }
  }
  return Bisection_mesh(std::move(points), std::move(sides), std::move(triangles));
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULATE_BOUNDARY_H
