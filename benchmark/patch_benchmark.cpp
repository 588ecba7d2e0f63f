// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"

#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

// From a loop of ribbons to a patch that can be evaluated: domain, harmonic coordinates and basis.

namespace {

using Patch = bench::MP::Concave_bezier_patch_3<bench::Kernel>;

void measure(benchmark::State& state, const bench::Model& model, std::int64_t threads) {
  const bench::Thread_limit limit(threads);
  double error_bound = 0;
  for (auto _ : state)
    error_bound = Patch(model).coordinates().error_bound();
  state.counters["error_bound"] = error_bound;
}

void patch_of_model(benchmark::State& state) {
  const std::string name = bench::model_names[state.range(0)];
  state.SetLabel(name);
  measure(state, bench::read_model(name), state.range(1));
}

void patch_of_dome(benchmark::State& state) {
  const auto size = [&](int k) { return static_cast<std::size_t>(state.range(k)); };
  state.SetLabel(state.range(0) == bench::regular ? "regular" : "random");
  measure(state, bench::dome(bench::plan(state.range(0), size(1)), size(2), size(3)), 1);
}

} // namespace

BENCHMARK(patch_of_model)
    ->ArgNames({"model", "threads"})
    ->ArgsProduct({{0, 1, 2, 3, 4}, bench::thread_counts()})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(patch_of_dome)
    ->ArgNames({"plan", "n", "degree", "layers"})
    ->ArgsProduct({{bench::regular, bench::random}, {3, 8, 16, 32, 64}, {3}, {2}})
    ->ArgsProduct({{bench::random}, {8}, {7}, {2, 3}})
    ->Unit(benchmark::kMillisecond);
