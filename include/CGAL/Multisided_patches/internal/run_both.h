// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_RUN_BOTH_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_RUN_BOTH_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_group.h>
#endif

#include <exception>
#include <type_traits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Calls two functions that do not depend on each other, `aside` on another thread if the
// concurrency tag allows it and one is free. If both throw, what `aside` throws is thrown.
template <typename ConcurrencyTag, typename Aside, typename Here>
void run_both(const Aside& aside, const Here& here) {
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible_v<ConcurrencyTag, Parallel_tag>) {
    std::exception_ptr error;
    tbb::task_group group;
    group.run([&] { aside(); });
    try {
      here();
    } catch (...) {
      error = std::current_exception();
    }
    group.wait();
    if (error)
      std::rethrow_exception(error);
    return;
  }
#endif
  aside();
  here();
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_RUN_BOTH_H
