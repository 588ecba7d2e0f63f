// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshing_fixtures.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>

// CGAL's mesher by Delaunay refinement next to ours: the same domains, and as many triangles. CGAL
// chooses its samples on the sides, ours takes them as they are given.

namespace {

using Vertex_base = CGAL::Triangulation_vertex_base_2<bench::Kernel>;
using Face_base = CGAL::Delaunay_mesh_face_base_2<bench::Kernel>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    bench::Kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;

Triangulation mesh_with_cgal(const bench::Domain& domain, double max_edge_length) {
  Triangulation triangulation;
  triangulation.insert_constraint(domain.vertices().begin(), domain.vertices().end(), true);
  constexpr double sine_bound = 0.125; // its default: angles of at least 20.7 degrees
  CGAL::refine_Delaunay_mesh_2(triangulation, Criteria(sine_bound, max_edge_length));
  return triangulation;
}

struct Mesh_quality {
  std::size_t triangles = 0;
  double smallest_angle = 180;
};

Mesh_quality quality(const Triangulation& triangulation) {
  Mesh_quality result;
  for (const auto face : triangulation.finite_face_handles())
    if (face->is_in_domain()) {
      ++result.triangles;
      result.smallest_angle =
          (std::min)(result.smallest_angle,
                     bench::smallest_angle(face->vertex(0)->point(), face->vertex(1)->point(),
                                           face->vertex(2)->point()));
    }
  return result;
}

// The length with which there are about so many triangles: their number is inverse to its square,
// so we search with few of them.
double max_edge_length_for(const bench::Domain& domain, std::int64_t triangles) {
  const double few = std::fmin(double(triangles), 20000);
  double length = std::sqrt(domain.area() / few * 4);
  for (int round = 0; round < 4; ++round)
    length *= std::sqrt(double(quality(mesh_with_cgal(domain, length)).triangles) / few);
  return length * std::sqrt(few / double(triangles));
}

void peer_mesher_cgal(benchmark::State& state) {
  const bench::Domain domain = bench::mesh_domain(state.range(0));
  const double length = max_edge_length_for(domain, state.range(1));
  Triangulation mesh;
  for (auto _ : state)
    mesh = mesh_with_cgal(domain, length);
  const Mesh_quality result = quality(mesh);
  state.SetLabel(bench::mesh_domain_names[state.range(0)]);
  bench::report_mesh(state, result.triangles, result.smallest_angle);
}

void peer_mesher_ours(benchmark::State& state) {
  const bench::Domain domain = bench::mesh_domain(state.range(0));
  const bench::Even_spacing spacing(domain, state.range(1));
  bench::Domain_mesh mesh;
  for (auto _ : state)
    mesh = bench::MP::triangulate_domain(domain, spacing.segments, spacing.length);
  state.SetLabel(bench::mesh_domain_names[state.range(0)]);
  bench::report_mesh(state, mesh.triangles.size(), bench::smallest_angle(mesh));
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"domain", "triangles"})
      ->ArgsProduct({{0, 1, 2}, {100000, 1000000}})
      ->Unit(benchmark::kMillisecond);
}

} // namespace

BENCHMARK(peer_mesher_cgal)->Apply(sizes);
BENCHMARK(peer_mesher_ours)->Apply(sizes);
