// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"

#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/Surface_mesh.h>

#include <cmath>

// The main job as a user sees it: from a file to a mesh with normals in memory, with harmonic
// coordinates to 1e-8.

namespace {

using bench::MP::Mesh_density;
using Patch = bench::MP::Concave_bezier_patch_3<bench::Kernel>;
using Mesh = CGAL::Surface_mesh<bench::Point_3>;

Mesh whole_job(const std::string& name, const Mesh_density& density) {
  const Patch patch(bench::read_model(name));
  Mesh mesh;
  bench::MP::tessellate(patch, mesh, density);
  return mesh;
}

void measure(benchmark::State& state, const std::string& name, const Mesh_density& density,
             std::int64_t threads) {
  state.SetLabel(name);
  state.counters["error_bound"] = Patch(bench::read_model(name)).coordinates().error_bound();
  const bench::Thread_limit limit(threads);
  std::size_t vertices = 0, triangles = 0;
  for (auto _ : state) {
    const Mesh mesh = whole_job(name, density);
    vertices = mesh.number_of_vertices();
    triangles = mesh.number_of_faces();
  }
  state.counters["vertices"] = double(vertices);
  state.counters["triangles"] = double(triangles);
}

// The edge length with which a model gets about so many vertices.
double edge_length_for(const std::string& name, std::int64_t vertices) {
  const Patch patch(bench::read_model(name));
  double length = patch.loop().diagonal() / 100;
  for (int round = 0; round < 4; ++round) {
    const double count = double(bench::MP::mesh_domain(patch, length).points.size());
    length *= std::sqrt(count / double(vertices));
  }
  return length;
}

// A given edge length.
void whole_job_by_edge_length(benchmark::State& state) {
  const std::string name = bench::model_names[state.range(0)];
  measure(state, name, Mesh_density(edge_length_for(name, state.range(1))), state.range(2));
}

// A given number of triangles, for which an edge length is searched.
void whole_job_by_count(benchmark::State& state) {
  measure(state, bench::model_names[state.range(0)],
          Mesh_density::triangles(static_cast<std::size_t>(state.range(1))), state.range(2));
}

} // namespace

BENCHMARK(whole_job_by_edge_length)
    ->ArgNames({"model", "vertices", "threads"})
    ->ArgsProduct({{2}, {50000}, bench::thread_counts()})
    ->ArgsProduct({{0, 1, 3, 4}, {50000}, {bench::thread_counts().back()}})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(whole_job_by_count)
    ->ArgNames({"model", "triangles", "threads"})
    ->ArgsProduct({{0, 2, 4}, {1000, 100000, 1000000}, {bench::thread_counts().back()}})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
