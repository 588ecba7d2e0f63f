// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"

#include <CGAL/Multisided_patches/domains/make_domain.h>

// Planar domains from loops, with their checks and repairs.

namespace {

void domain_of_model(benchmark::State& state) {
  const std::string name = bench::model_names[state.range(0)];
  const bench::Model model = bench::read_model(name);
  state.SetLabel(name);
  for (auto _ : state)
    benchmark::DoNotOptimize(bench::MP::make_domain(model.loop, model.domain));
}

void domain_of_dome(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(1));
  const bench::Loop loop = bench::dome(bench::plan(state.range(0), n), 3, 2);
  state.SetLabel(state.range(0) == bench::regular ? "regular" : "random");
  for (auto _ : state)
    benchmark::DoNotOptimize(bench::MP::make_domain(loop));
}

} // namespace

BENCHMARK(domain_of_model)->ArgName("model")->DenseRange(0, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(domain_of_dome)
    ->ArgNames({"plan", "n"})
    ->ArgsProduct({{bench::regular, bench::random}, {3, 8, 16, 32, 64}})
    ->Unit(benchmark::kMillisecond);
