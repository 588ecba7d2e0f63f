// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"

#include <CGAL/Multisided_patches/internal/run_both.h>

#include <stdexcept>
#include <string>

using CGAL::Multisided_patches::internal::run_both;

TEMPLATE_TEST_CASE("Two functions are run, and their errors are heard, that of the first one first",
                   "", CGAL::Sequential_tag, CGAL::Parallel_if_available_tag) {
  const auto error_of = [](bool aside_throws, bool here_throws) -> std::string {
    bool has_run_aside = false, has_run_here = false;
    try {
      run_both<TestType>(
          [&] {
            has_run_aside = true;
            if (aside_throws)
              throw std::runtime_error("aside");
          },
          [&] {
            has_run_here = true;
            if (here_throws)
              throw std::logic_error("here");
          });
    } catch (const std::runtime_error& e) {
      return e.what();
    } catch (const std::logic_error& e) {
      return e.what();
    }
    return has_run_aside && has_run_here ? "none" : "left out";
  };
  for (int k = 0; k < 100; ++k) { // in whatever order the threads get there
    CHECK(error_of(false, false) == "none");
    CHECK(error_of(true, false) == "aside");
    CHECK(error_of(false, true) == "here");
    CHECK(error_of(true, true) == "aside");
  }
}
