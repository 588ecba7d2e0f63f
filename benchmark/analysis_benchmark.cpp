// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"

#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/analysis/fairness_report.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

// The reports on a patch, on one thread.

namespace {

using Patch = bench::MP::Concave_bezier_patch_3<bench::Kernel>;

Patch patch(benchmark::State& state) {
  const std::string name = bench::model_names[state.range(0)];
  state.SetLabel(name);
  return Patch(bench::read_model(name));
}

void analysis_continuity(benchmark::State& state) {
  const Patch p = patch(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(bench::MP::continuity_report(p));
}

void analysis_fairness(benchmark::State& state) {
  const Patch p = patch(state);
  const auto mesh = bench::MP::mesh_domain(p, bench::MP::Mesh_density::triangles(10000));
  for (auto _ : state)
    benchmark::DoNotOptimize(bench::MP::fairness_report<CGAL::Sequential_tag>(p, mesh));
  bench::report_seconds_per(state, "triangle", mesh.triangles.size());
}

} // namespace

BENCHMARK(analysis_continuity)->ArgName("model")->DenseRange(0, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(analysis_fairness)->ArgName("model")->DenseRange(0, 4)->Unit(benchmark::kMillisecond);
