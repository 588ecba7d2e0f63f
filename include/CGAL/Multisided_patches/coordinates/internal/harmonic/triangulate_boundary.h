// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULATE_BOUNDARY_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULATE_BOUNDARY_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Bisection_mesh.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

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
  using Vertex_base = Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Face_base =
      Triangulation_face_base_with_info_2<std::size_t, Kernel,
                                          Constrained_triangulation_face_base_2<Kernel>>;
  using Tds = Triangulation_data_structure_2<Vertex_base, Face_base>;
  using Cdt = Constrained_Delaunay_triangulation_2<Kernel, Tds>;
  using Face_handle = Cdt::Face_handle;
  constexpr std::size_t none = Bisection_mesh::none;

  Cdt cdt;
  std::vector<Cdt::Vertex_handle> handles;
  for (const Complex& z : exact) {
    const Cdt::Vertex_handle v = cdt.insert(Kernel::Point_2(z.real(), z.imag()));
    v->info() = handles.size();
    handles.push_back(v);
  }
  for (std::size_t k = 0; k < next.size(); ++k)
    cdt.insert_constraint(handles[k], handles[next[k]]);

  // A face with a constrained edge is in the domain if it is on the left of that side. The others
  // are where their neighbours are.
  std::vector<Face_handle> inside;
  for (const Face_handle f : cdt.all_face_handles())
    f->info() = none;
  for (const Face_handle f : cdt.finite_face_handles())
    for (int i = 0; i < 3; ++i)
      if (f->info() == none && f->is_constrained(i) &&
          next[f->vertex(Cdt::ccw(i))->info()] == f->vertex(Cdt::cw(i))->info()) {
        f->info() = inside.size();
        inside.push_back(f);
      }
  for (std::size_t t = 0; t < inside.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Face_handle f = inside[t], n = f->neighbor(i);
      if (!f->is_constrained(i) && n->info() == none) {
        n->info() = inside.size();
        inside.push_back(n);
      }
    }

  std::vector<Bisection_mesh::Triangle> triangles(inside.size());
  for (std::size_t t = 0; t < inside.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      triangles[t].vertex[i] = inside[t]->vertex(i)->info();
      triangles[t].neighbor[i] =
          inside[t]->is_constrained(i) ? none : inside[t]->neighbor(i)->info();
    }
  return Bisection_mesh(points, std::move(triangles));
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULATE_BOUNDARY_H
