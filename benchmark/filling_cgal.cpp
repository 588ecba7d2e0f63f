// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filling.h"

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iterator>
#include <tuple>

// CGAL's hole filling: it triangulates the hole, refines the triangles to the density of those
// around it, and moves its vertices such that the mesh is fair. What it knows of the tangent planes
// is the mesh around the hole, which we make.

namespace bench {

namespace {

using Mesh = CGAL::Surface_mesh<Point_3>;
using Vector_3 = Kernel::Vector_3;

Vector_3 normalized(const Vector_3& v) {
  const double length = std::sqrt(v.squared_length());
  return length > 0 ? v / length : v;
}

// The direction in the ribbon's tangent plane that leads straight away from the hole.
Vector_3 outwards(const Ribbon& ribbon, double s) {
  const Vector_3 t = ribbon.boundary_derivative(s), inwards = ribbon.cross_derivative(s);
  return normalized((t * inwards) * t - (t * t) * inwards);
}

// At a corner the bisector, so far that the strips on both sides are as wide as elsewhere.
Vector_3 step_outwards(const Loop& loop, const Hole::Sample& sample) {
  const Vector_3 here = outwards(loop[sample.side], sample.s);
  if (sample.s > 0)
    return here;
  const Vector_3 bisector = normalized(here + outwards(loop[loop.prev(sample.side)], 1));
  return bisector / std::fmax(bisector * here, 0.5);
}

// Two strips of triangles around the hole. The first vertices are those of its boundary.
Mesh make_surroundings(const Hole& hole) {
  constexpr double width = 0.4; // of a strip, in edges; so there is room for two at reflex corners
  constexpr std::size_t rings = 3;
  const Loop& loop = hole.model.loop;
  const std::size_t n = hole.boundary.size();
  Mesh mesh;
  for (std::size_t ring = 0; ring < rings; ++ring)
    for (const Hole::Sample& sample : hole.boundary)
      mesh.add_vertex(loop[sample.side].boundary_point(sample.s) +
                      width * hole.edge_length * double(ring) * step_outwards(loop, sample));
  const auto vertex = [&](std::size_t ring, std::size_t k) {
    return Mesh::Vertex_index(static_cast<Mesh::size_type>(ring * n + k % n));
  };
  for (std::size_t ring = 0; ring + 1 < rings; ++ring)
    for (std::size_t k = 0; k < n; ++k) {
      mesh.add_face(vertex(ring, k + 1), vertex(ring, k), vertex(ring + 1, k));
      mesh.add_face(vertex(ring, k + 1), vertex(ring + 1, k), vertex(ring + 1, k + 1));
    }
  return mesh;
}

} // namespace

Filling_outcome fill_with_cgal(const Hole& hole) {
  Mesh mesh = make_surroundings(hole);
  const auto border = mesh.halfedge(Mesh::Vertex_index(0), Mesh::Vertex_index(1));
  std::vector<Mesh::Face_index> faces;
  std::vector<Mesh::Vertex_index> vertices;
  const double begin = cpu_seconds();
  const bool is_fair = std::get<0>(CGAL::Polygon_mesh_processing::triangulate_refine_and_fair_hole(
      mesh, border, std::back_inserter(faces), std::back_inserter(vertices)));
  Filling_outcome outcome;
  outcome.seconds = cpu_seconds() - begin;
  if (faces.empty())
    throw std::runtime_error("the hole was not triangulated");
  if (!is_fair)
    throw std::runtime_error("the mesh was not faired");
  Filling_mesh filling;
  for (const Mesh::Vertex_index v : mesh.vertices())
    filling.points.push_back(mesh.point(v));
  for (const Mesh::Face_index f : faces) {
    const auto h = mesh.halfedge(f);
    filling.triangles.push_back({std::size_t(mesh.source(h)), std::size_t(mesh.target(h)),
                                 std::size_t(mesh.target(mesh.next(h)))});
  }
  outcome.triangles = double(faces.size());
  measure_boundary(filling, hole, outcome);
  return outcome;
}

} // namespace bench
