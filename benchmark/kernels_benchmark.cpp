// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels.h"

// The time of each kernel; `count_kernels.cpp` is about what they do in it.

namespace {

void kernel(benchmark::State& state) {
  const auto index = static_cast<std::size_t>(state.range(0));
  const std::unique_ptr<bench::Kernel_run> run = bench::make_kernel(index);
  state.SetLabel(bench::kernel_names[index]);
  for (auto _ : state)
    run->run();
  bench::report_seconds_per(state, "item", run->items());
}

} // namespace

BENCHMARK(kernel)->ArgName("kernel")->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
