// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_FOR_EACH_INDEX_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_FOR_EACH_INDEX_H

#include <CGAL/Multisided_patches/internal/is_parallel.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Calls f(i) for i = 0..n-1, in parallel if the tag says so. The calls must not depend on each
// other; `grain` of them should take far longer than handing a block of them to a thread.
//
// All calls are made unless one throws: what cancels tasks around this one does not cancel them.
template <typename ConcurrencyTag, typename Function>
void for_each_index(std::size_t n, const Function& f, [[maybe_unused]] std::size_t grain = 256) {
  if constexpr (is_parallel<ConcurrencyTag>()) {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::task_group_context context(tbb::task_group_context::isolated);
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, n, grain),
        [&](const auto& block) {
          for (std::size_t i = block.begin(); i != block.end(); ++i)
            f(i);
        },
        context);
#endif
  } else {
    for (std::size_t i = 0; i < n; ++i)
      f(i);
  }
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_FOR_EACH_INDEX_H
