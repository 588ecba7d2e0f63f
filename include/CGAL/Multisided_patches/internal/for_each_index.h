// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_FOR_EACH_INDEX_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_FOR_EACH_INDEX_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Calls f(i) for i = 0..n-1, in parallel if the tag says so. The calls must not depend on each
// other; `grain` of them should take far longer than handing a block of them to a thread.
template <typename ConcurrencyTag, typename Function>
void for_each_index(std::size_t n, const Function& f, [[maybe_unused]] std::size_t grain = 256) {
  static_assert(std::is_convertible_v<ConcurrencyTag, Parallel_tag> ||
                    std::is_convertible_v<ConcurrencyTag, Sequential_tag>,
                "a concurrency tag of CGAL is needed");
  if constexpr (std::is_convertible_v<ConcurrencyTag, Parallel_tag>) {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain), [&](const auto& block) {
      for (std::size_t i = block.begin(); i != block.end(); ++i)
        f(i);
    });
#else
    static_assert(!std::is_convertible_v<ConcurrencyTag, Parallel_tag>,
                  "Parallel_tag needs TBB, which this program is not linked with");
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
