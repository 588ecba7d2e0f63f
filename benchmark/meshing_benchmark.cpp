// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshing_fixtures.h"

#include <CGAL/Multisided_patches/meshing/mesh_domain.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

// Meshing of domains, on one thread: evenly, and so that the mesh of a surface is as fine as asked
// for.

namespace {

using bench::MP::Mesh_density;
using Patch = bench::MP::Concave_bezier_patch_3<bench::Kernel>;

void mesh_evenly(benchmark::State& state) {
  const bench::Domain domain = bench::mesh_domain(state.range(0));
  const bench::Even_spacing spacing(domain, state.range(1));
  bench::Domain_mesh mesh;
  for (auto _ : state)
    mesh = bench::MP::triangulate_domain(domain, spacing.segments, spacing.length,
                                         static_cast<int>(state.range(2)));
  state.SetLabel(bench::mesh_domain_names[state.range(0)]);
  bench::report_mesh(state, mesh.triangles.size(), bench::smallest_angle(mesh));
}

void mesh_for_surface(benchmark::State& state, const Mesh_density& density, const Patch& patch) {
  std::size_t triangles = 0;
  for (auto _ : state)
    triangles = bench::MP::mesh_domain<CGAL::Sequential_tag>(patch, density).triangles.size();
  state.counters["triangles"] = static_cast<double>(triangles);
  bench::report_seconds_per(state, "triangle", triangles);
}

void mesh_by_count(benchmark::State& state) {
  const std::string name = bench::model_names[state.range(0)];
  state.SetLabel(name);
  mesh_for_surface(state, Mesh_density::triangles(static_cast<std::size_t>(state.range(1))),
                   Patch(bench::read_model(name)));
}

// A chordal deviation of the diagonal divided by the argument.
void mesh_by_deviation(benchmark::State& state) {
  const std::string name = bench::model_names[state.range(0)];
  state.SetLabel(name);
  const Patch patch(bench::read_model(name));
  const double deviation = patch.loop().diagonal() / static_cast<double>(state.range(1));
  mesh_for_surface(state, Mesh_density::chordal_deviation(deviation), patch);
}

} // namespace

BENCHMARK(mesh_evenly)
    ->ArgNames({"domain", "triangles", "sweeps"})
    ->ArgsProduct({{0, 1, 2}, {10000, 100000, 1000000}, {0}})
    ->ArgsProduct({{0, 1, 2}, {100000}, {2}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(mesh_by_count)
    ->ArgNames({"model", "triangles"})
    ->ArgsProduct({{0, 2, 4}, {1000, 100000}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(mesh_by_deviation)
    ->ArgNames({"model", "part"})
    ->ArgsProduct({{2, 4}, {1000, 10000, 100000}})
    ->Unit(benchmark::kMillisecond);
