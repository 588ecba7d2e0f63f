// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch_run.h"
#include "mpi_batch.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <thread>
#include <vector>

namespace multipatch {

namespace {

// Where it is known, that of the processors that this process may use.
std::size_t number_of_processors() {
#ifdef CGAL_LINKED_WITH_TBB
  return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
#else
  return (std::max)(1u, std::thread::hardware_concurrency());
#endif
}

// Each thread has one file at a time; so much memory is needed, and no more for more files.
void run_in_threads(Batch_run& run, std::size_t n) {
  std::vector<std::thread> others;
  try {
    while (others.size() + 1 < (std::min)(n, run.size()))
      others.emplace_back([&run] { work_on(run); });
  } catch (...) { // there are no more threads to be had
    run.give_up(std::current_exception());
  }
  work_on(run);
  for (std::thread& thread : others)
    thread.join();
}

} // namespace

void batch_command(const Mesh_options& options) {
  if (options.batch.mpi) {
    mpi_batch(options);
    return;
  }
  Batch_run run(options);
  run_in_threads(run, options.batch.threads.value_or(number_of_processors()));
  run.conclude();
}

} // namespace multipatch
