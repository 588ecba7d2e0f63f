// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"
#include "fuzz/random_loops.h"

#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/Surface_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <atomic>

// Many random models, from loops to meshes of 10,000 triangles, each of them in one thread.

namespace {

using Patch = bench::MP::Concave_bezier_patch_3<bench::Kernel>;

// Loops as somebody might draw them: 3 to 12 sides, corners of both kinds, degrees up to 7.
std::vector<bench::Loop> random_loops(std::size_t count) {
  std::vector<bench::Loop> loops;
  for (std::uint64_t index = 0; loops.size() < count; ++index) {
    fuzz::Random random = fuzz::random_of_case(1, index);
    const fuzz::Raw_loop loop = fuzz::random_raw_loop(random);
    if (loop.is_harmless)
      loops.push_back(loop.loop());
  }
  return loops;
}

std::size_t mesh(const bench::Loop& loop) {
  CGAL::Surface_mesh<bench::Point_3> result;
  bench::MP::tessellate<CGAL::Sequential_tag>(Patch(loop), result,
                                              bench::MP::Mesh_density::triangles(10000));
  return result.number_of_faces();
}

template <typename Function>
void for_each_index(std::size_t n, const Function& f) {
#ifdef CGAL_LINKED_WITH_TBB
  tbb::parallel_for(std::size_t(0), n, f);
#else
  for (std::size_t i = 0; i < n; ++i)
    f(i);
#endif
}

void many_models(benchmark::State& state) {
  const std::vector<bench::Loop> loops = random_loops(static_cast<std::size_t>(state.range(0)));
  const bench::Thread_limit limit(state.range(1));
  std::atomic<std::size_t> failures{0}, triangles{0};
  for (auto _ : state) {
    failures = triangles = 0;
    for_each_index(loops.size(), [&](std::size_t i) {
      try {
        triangles += mesh(loops[i]);
      } catch (const bench::MP::Error&) {
        ++failures;
      }
    });
  }
  state.counters["failures"] = double(failures);
  state.counters["triangles"] = double(triangles);
  bench::report_seconds_per(state, "model", loops.size());
  bench::report_rate(state, "models/s", double(loops.size()));
}

} // namespace

BENCHMARK(many_models)
    ->ArgNames({"models", "threads"})
    ->ArgsProduct({{50}, bench::thread_counts()})
    ->ArgsProduct({{1000}, bench::thread_counts()})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
