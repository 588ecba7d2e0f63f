// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_RUN_BOTH_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_RUN_BOTH_H

#include <CGAL/Multisided_patches/internal/is_parallel.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_group.h>
#endif

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Calls two functions that do not depend on each other; if the concurrency tag allows it and a
// thread is free, that calls `aside`. What `here` throws goes before what `aside` throws, which
// need not run then. Nothing else cancels them.
template <typename ConcurrencyTag, typename Here, typename Aside>
void run_both(const Here& here, const Aside& aside) {
  if constexpr (is_parallel<ConcurrencyTag>()) {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::task_group_context context(tbb::task_group_context::isolated);
    tbb::task_group group(context);
    group.run([&] { aside(); });
    try {
      here();
    } catch (...) {
      group.cancel();
      try {
        group.wait();
      } catch (...) {
        // It ended, which is what matters.
      }
      throw;
    }
    group.wait();
#endif
  } else {
    here();
    aside();
  }
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_RUN_BOTH_H
