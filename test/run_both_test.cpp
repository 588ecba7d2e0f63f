// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"

#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/internal/run_both.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_group.h>
#endif

#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>

using CGAL::Multisided_patches::internal::run_both;

TEMPLATE_TEST_CASE("Two functions are run, and the error of the first one goes before the other's",
                   "", CGAL::Sequential_tag, CGAL::Parallel_if_available_tag) {
  const auto error_of = [](bool here_throws, bool aside_throws) -> std::string {
    bool has_run_here = false, has_run_aside = false;
    try {
      run_both<TestType>(
          [&] {
            has_run_here = true;
            if (here_throws)
              throw std::logic_error("here");
          },
          [&] {
            has_run_aside = true;
            if (aside_throws)
              throw std::runtime_error("aside");
          });
    } catch (const std::exception& e) {
      return e.what();
    }
    return has_run_here && has_run_aside ? "none" : "left out";
  };
  for (int k = 0; k < 100; ++k) { // in whatever order the threads get there
    CHECK(error_of(false, false) == "none");
    CHECK(error_of(false, true) == "aside");
    CHECK(error_of(true, false) == "here");
    CHECK(error_of(true, true) == "here");
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("What cancels the tasks of a caller leaves nothing of ours undone") {
  using CGAL::Multisided_patches::internal::for_each_index;
  constexpr std::size_t n = 10000;
  std::atomic<std::size_t> calls(0);
  std::atomic<bool> has_run_here(false), has_run_aside(false);
  tbb::task_group group;
  group.run_and_wait([&] {
    group.cancel();
    run_both<CGAL::Parallel_tag>([&] { has_run_here = true; }, [&] { has_run_aside = true; });
    for_each_index<CGAL::Parallel_tag>(
        n, [&](std::size_t) { ++calls; }, 16);
  });
  CHECK(has_run_here);
  CHECK(has_run_aside);
  CHECK(calls == n);
}
#endif
