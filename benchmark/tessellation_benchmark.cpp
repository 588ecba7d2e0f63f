// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Peak_memory.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <map>

// From a patch to a mesh with normals: where the time goes, and how much memory it takes.

namespace {

using bench::MP::Tessellation_stage;
using Patch = bench::MP::Concave_bezier_patch_3<bench::Kernel>;
using Mesh = CGAL::Surface_mesh<bench::Point_3>;

// Adds up the time of each stage, from one report of it to the next report of anything.
class Stage_timer {
public:
  bool go_further(Tessellation_stage stage, std::size_t, std::size_t) {
    const double now = bench::cpu_seconds();
    if (running_)
      seconds_[stage_] += now - last_;
    running_ = true;
    stage_ = stage;
    last_ = now;
    return true;
  }
  void stop() {
    go_further(stage_, 1, 1);
    running_ = false;
  }
  double seconds(Tessellation_stage stage) { return seconds_[stage]; }

private:
  bool running_ = false;
  Tessellation_stage stage_ = Tessellation_stage::meshing;
  double last_ = 0;
  std::map<Tessellation_stage, double> seconds_;
};

// About so many vertices, on one thread.
void tessellate_by_edge_length(benchmark::State& state) {
  const Patch patch(bench::read_model("u_vent"));
  constexpr double area_of_patch = 13900; // about; to choose the edge length without a search
  const double length =
      std::sqrt(area_of_patch / (2 * double(state.range(0))) * 4 / std::sqrt(3.0) / 0.945);
  std::size_t vertices = 0, triangles = 0;
  Stage_timer timer;
  const bench::Peak_memory memory;
  for (auto _ : state) {
    Mesh mesh;
    bench::MP::tessellate<CGAL::Sequential_tag>(patch, mesh, length, bench::MP::Default_maps(),
                                                timer);
    timer.stop();
    vertices = mesh.number_of_vertices();
    triangles = mesh.number_of_faces();
  }
  const double all = double(vertices) * double(state.iterations());
  const auto per_vertex = [&](Tessellation_stage stage) { return timer.seconds(stage) / all; };
  state.counters["vertices"] = double(vertices);
  bench::report_seconds_per(state, "vertex", vertices);
  state.counters["s/vertex_meshing"] = per_vertex(Tessellation_stage::meshing);
  state.counters["s/vertex_evaluation"] = per_vertex(Tessellation_stage::evaluation);
  state.counters["s/vertex_assembly"] = per_vertex(Tessellation_stage::assembly);
  state.counters["peak_bytes/triangle"] = memory.bytes() / double(triangles);
}

// Evaluation and assembly alone.
void tessellate_domain_mesh(benchmark::State& state) {
  const std::string name = bench::model_names[state.range(0)];
  const Patch patch(bench::read_model(name));
  const auto domain_mesh = bench::MP::mesh_domain(
      patch, bench::MP::Mesh_density::triangles(static_cast<std::size_t>(state.range(1))));
  state.SetLabel(name);
  for (auto _ : state) {
    Mesh mesh;
    bench::MP::tessellate<CGAL::Sequential_tag>(patch, domain_mesh, mesh);
    benchmark::DoNotOptimize(mesh);
  }
  bench::report_seconds_per(state, "vertex", domain_mesh.points.size());
}

} // namespace

BENCHMARK(tessellate_domain_mesh)
    ->ArgNames({"model", "triangles"})
    ->ArgsProduct({{0, 2, 4}, {1000, 100000}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(tessellate_by_edge_length)
    ->ArgName("vertices")
    ->Arg(100000)
    ->Arg(1000000)
    ->Unit(benchmark::kMillisecond);
