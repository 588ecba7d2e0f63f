// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "child_process.h"
#include "filling.h"

#include <cmath>
#include <optional>

// Peers that fill holes, next to ours: the same loops, with time, and the angle between the tangent
// planes of filling and ribbons along the boundary. Each case runs in a process of its own, on one
// thread; one that fails or crashes is an entry of the table.

namespace {

constexpr const char* models[] = {"triangle_corner", "pentagon_cap", "l_bracket", "u_vent",
                                  "plus_hub"};
constexpr const char* methods[] = {"ours: patch", "ours: patch and mesh", "CGAL: hole filling",
                                   "Open CASCADE: default", "Open CASCADE: finer"};

bench::Filling_outcome fill(const bench::Model& model, double edge_length, std::int64_t method) {
  const bench::Thread_limit limit(1);
  const bench::Hole hole = bench::make_hole(model, edge_length);
  switch (method) {
  case 0:
    return fill_with_patch(hole);
  case 1:
    return fill_with_patch_mesh(hole);
  case 2:
    return fill_with_cgal(hole);
#ifdef MULTISIDED_PATCHES_HAS_OPEN_CASCADE
  case 3:
    return fill_with_open_cascade(hole, false);
  case 4:
    return fill_with_open_cascade(hole, true);
#endif
  }
  throw std::runtime_error("not compiled in");
}

void peer_filling(benchmark::State& state) {
  constexpr unsigned time_limit = 60; // seconds
  const bench::Model model = bench::read_model(models[state.range(0)]);
  const std::int64_t method = state.range(2);
  state.SetLabel(std::string(models[state.range(0)]) + ", " + methods[method]);
  // As many edges along the diagonal.
  const double edge_length = model.loop.diagonal() / static_cast<double>(state.range(1));
  bench::Filling_outcome outcome;
  try {
    for (auto _ : state) {
      outcome = bench::run_in_child([&] { return fill(model, edge_length, method); }, time_limit);
      state.SetIterationTime(outcome.seconds);
    }
  } catch (const std::exception& error) {
    state.SkipWithError(error.what());
    return;
  }
  if (outcome.triangles > 0)
    state.counters["triangles"] = outcome.triangles;
  state.counters["degrees"] = outcome.largest_degrees;
  state.counters["mean_degrees"] = outcome.mean_degrees;
  state.counters["gap"] = outcome.largest_gap;
}

// Surfaces do not depend on the edge length.
void cases(benchmark::internal::Benchmark* b) {
  b->ArgNames({"model", "edges", "method"});
  for (int model = 0; model < 5; ++model) {
    b->Args({model, 50, 0});
#ifdef MULTISIDED_PATCHES_HAS_OPEN_CASCADE
    b->Args({model, 50, 3})->Args({model, 50, 4});
#endif
    for (const int edges : {50, 100})
      for (const int method : {1, 2})
        b->Args({model, edges, method});
  }
  b->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
}

} // namespace

BENCHMARK(peer_filling)->Apply(cases);
