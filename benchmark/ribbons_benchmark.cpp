// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"

// The first stage: reading models, and checking loops.

namespace {

void ribbons_read_file(benchmark::State& state) {
  const std::string name = bench::model_names[state.range(0)];
  state.SetLabel(name);
  for (auto _ : state)
    benchmark::DoNotOptimize(bench::read_model(name));
}

void ribbons_check_loop(benchmark::State& state) {
  const auto size = [&](int k) { return static_cast<std::size_t>(state.range(k)); };
  const bench::Loop loop = bench::dome(bench::plan(bench::regular, size(0)), size(1), size(2));
  for (auto _ : state)
    benchmark::DoNotOptimize(bench::Loop(loop.ribbons()));
}

} // namespace

BENCHMARK(ribbons_read_file)->ArgName("model")->DenseRange(0, 4)->Unit(benchmark::kMicrosecond);
BENCHMARK(ribbons_check_loop)
    ->ArgNames({"n", "degree", "layers"})
    ->ArgsProduct({{3, 8, 64}, {3, 7}, {2, 3}})
    ->Unit(benchmark::kMicrosecond);
