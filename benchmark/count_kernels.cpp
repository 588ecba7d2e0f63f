// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels.h"

#include <cstdlib>
#include <iostream>

// Runs one kernel once, for callgrind to count what happens inside measured_kernel():
//
//   multisided_patches_kernels        prints the names of all kernels
//   multisided_patches_kernels NAME   runs one, and prints its number of points or triangles

extern "C" {
// The name that `--toggle-collect` knows.
__attribute__((noinline)) void measured_kernel(bench::Kernel_run& kernel) {
  kernel.run();
}
}

int main(int argc, char* argv[]) {
  for (std::size_t index = 0; index < std::size(bench::kernel_names); ++index) {
    const std::string name = bench::kernel_names[index];
    if (argc < 2) {
      std::cout << name << '\n';
    } else if (name == argv[1]) {
      const std::unique_ptr<bench::Kernel_run> kernel = bench::make_kernel(index);
      kernel->run(); // what is set up at the first call does not count
      measured_kernel(*kernel);
      std::cout << kernel->items() << '\n';
      return EXIT_SUCCESS;
    }
  }
  return argc < 2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
