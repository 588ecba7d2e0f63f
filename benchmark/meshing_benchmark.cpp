// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How the time of meshing grows with the number of vertices, where it goes, and how much memory it
// takes; and how many triangles meshing by deviation spares. Sizes are in increasing order, because
// the peak of the memory is that of the whole run so far.

#include <CGAL/Multisided_patches.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <map>
#include <string>

#include <sys/resource.h>

namespace {

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Patch = MP::Concave_bezier_patch_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Patch patch(const std::string& name) {
  return Patch(MP::IO::read_CGB<Kernel>(std::string(MODELS_DIR) + "/" + name + ".cgb"));
}

double peak_memory() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * static_cast<double>(usage.ru_maxrss);
}

// Adds up the time of each stage, from one report of it to the next report of anything.
class Stage_timer {
public:
  bool go_further(MP::Tessellation_stage stage, std::size_t, std::size_t) {
    const auto now = std::chrono::steady_clock::now();
    if (running_)
      seconds_[stage_] += std::chrono::duration<double>(now - last_).count();
    running_ = true;
    stage_ = stage;
    last_ = now;
    return true;
  }
  double seconds(MP::Tessellation_stage stage) { return seconds_[stage]; }

private:
  bool running_ = false;
  MP::Tessellation_stage stage_ = MP::Tessellation_stage::meshing;
  std::chrono::steady_clock::time_point last_;
  std::map<MP::Tessellation_stage, double> seconds_;
};

// From a patch to a mesh with normals, about this many vertices, on one thread.
void mesh_by_edge_length(benchmark::State& state) {
  const Patch u_vent = patch("u_vent");
  const auto wanted = static_cast<double>(state.range(0));
  constexpr double area_of_patch = 13900; // about; to choose the edge length without a search
  const double length = std::sqrt(area_of_patch / (2 * wanted) * 4 / std::sqrt(3.0) / 0.945);
  std::size_t vertices = 0, triangles = 0;
  Stage_timer timer;
  for (auto _ : state) {
    Mesh mesh;
    MP::tessellate<CGAL::Sequential_tag>(u_vent, mesh, length, MP::Default_maps(), timer);
    timer.go_further(MP::Tessellation_stage::assembly, 1, 1); // the end
    vertices += mesh.number_of_vertices();
    triangles = mesh.number_of_faces();
  }
  const auto per_vertex = [&](double seconds) { return 1e6 * seconds / double(vertices); };
  const double meshing = timer.seconds(MP::Tessellation_stage::meshing),
               evaluation = timer.seconds(MP::Tessellation_stage::evaluation),
               assembly = timer.seconds(MP::Tessellation_stage::assembly);
  state.counters["vertices"] = double(vertices) / double(state.iterations());
  state.counters["us/vertex"] = per_vertex(meshing + evaluation + assembly);
  state.counters["meshing_us"] = per_vertex(meshing);
  state.counters["evaluation_us"] = per_vertex(evaluation);
  state.counters["assembly_us"] = per_vertex(assembly);
  state.counters["peak_bytes/triangle"] = peak_memory() / double(triangles);
}

// A chordal deviation of the diagonal divided by the argument.
void mesh_by_deviation(benchmark::State& state, const std::string& name) {
  const Patch p = patch(name);
  const double deviation = p.loop().diagonal() / static_cast<double>(state.range(0));
  std::size_t triangles = 0;
  for (auto _ : state) {
    Mesh mesh;
    MP::tessellate<CGAL::Sequential_tag>(p, mesh, MP::Mesh_density::chordal_deviation(deviation));
    triangles = mesh.number_of_faces();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

// The domain alone, evenly spaced.
void mesh_domain(benchmark::State& state) {
  const MP::Polygonal_domain_2<Kernel> u(
      {{-0.5, 1}, {-0.5, 2}, {-2, 2}, {-2, 0}, {2, 0}, {2, 2}, {0.5, 2}, {0.5, 1}});
  const double spacing = std::sqrt(7 / static_cast<double>(state.range(0)) * 4 / std::sqrt(3.0));
  std::vector<std::size_t> segments;
  for (std::size_t i = 0; i < u.size(); ++i)
    segments.push_back(static_cast<std::size_t>(std::ceil(u.side_length(i) / spacing)));
  std::size_t triangles = 0;
  for (auto _ : state)
    triangles += MP::triangulate_domain(u, segments, spacing).triangles.size();
  state.counters["triangles"] = static_cast<double>(triangles) / double(state.iterations());
  state.SetItemsProcessed(static_cast<std::int64_t>(triangles));
}

} // namespace

BENCHMARK(mesh_domain)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mesh_by_deviation, u_vent, std::string("u_vent"))
    ->Arg(1000)
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mesh_by_deviation, spiral_volute, std::string("spiral_volute"))
    ->Arg(1000)
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(mesh_by_edge_length)
    ->Arg(100000)
    ->Arg(1000000)
    ->Arg(10000000)
    ->Unit(benchmark::kMillisecond);
