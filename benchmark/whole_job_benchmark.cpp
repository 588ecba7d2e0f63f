// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multisided_patches.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#include <string>

// The stages of the main job, one by one and together, on models of growing complexity.

namespace {

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Patch = MP::Concave_bezier_patch_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

const char* const models[] = {"triangle_corner", "l_bracket", "u_vent", "plus_hub",
                              "spiral_volute"};

MP::Concave_bezier_model_3<Kernel> model(const benchmark::State& state) {
  return MP::IO::read_CGB<Kernel>(std::string(MODELS_DIR) + "/" + models[state.range(0)] + ".cgb");
}

std::size_t triangles(const benchmark::State& state) {
  return static_cast<std::size_t>(state.range(1));
}

void domain(benchmark::State& state) {
  const auto input = model(state);
  state.SetLabel(models[state.range(0)]);
  for (auto _ : state)
    benchmark::DoNotOptimize(MP::make_domain(input.loop, input.domain));
}

void harmonic_setup(benchmark::State& state) {
  const auto input = model(state);
  const auto generated = MP::make_domain(input.loop, input.domain);
  state.SetLabel(models[state.range(0)]);
  for (auto _ : state)
    benchmark::DoNotOptimize(MP::Harmonic_coordinates_2<Kernel>(generated.domain));
}

void domain_meshing(benchmark::State& state) {
  const Patch patch(model(state));
  state.SetLabel(models[state.range(0)]);
  for (auto _ : state)
    benchmark::DoNotOptimize(MP::mesh_domain(patch, MP::Mesh_density::triangles(triangles(state))));
  state.SetItemsProcessed(state.iterations() * state.range(1));
}

void evaluation(benchmark::State& state) {
  const Patch patch(model(state));
  const auto domain_mesh = MP::mesh_domain(patch, MP::Mesh_density::triangles(triangles(state)));
  state.SetLabel(models[state.range(0)]);
  for (auto _ : state) {
    Mesh mesh;
    MP::tessellate<CGAL::Sequential_tag>(patch, domain_mesh, mesh);
    benchmark::DoNotOptimize(mesh);
  }
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(domain_mesh.points.size()));
}

void whole_job(benchmark::State& state) {
  const auto input = model(state);
  state.SetLabel(models[state.range(0)]);
  for (auto _ : state) {
    Mesh mesh;
    MP::tessellate(Patch(input), mesh, MP::Mesh_density::triangles(triangles(state)));
    benchmark::DoNotOptimize(mesh);
  }
  state.SetItemsProcessed(state.iterations() * state.range(1));
}

} // namespace

BENCHMARK(domain)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(harmonic_setup)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(domain_meshing)
    ->ArgsProduct({{0, 2, 4}, {1000, 100000}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(evaluation)
    ->ArgsProduct({{0, 2, 4}, {1000, 100000}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(whole_job)
    ->ArgsProduct({{0, 2, 4}, {1000, 100000, 1000000}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
