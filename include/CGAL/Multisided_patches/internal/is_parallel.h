// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_IS_PARALLEL_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_IS_PARALLEL_H

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Whether a concurrency tag asks for threads. Other types than such tags, and threads in a program
// without TBB, do not compile.
template <typename ConcurrencyTag>
constexpr bool is_parallel() {
  constexpr bool parallel = std::is_convertible_v<ConcurrencyTag, Parallel_tag>;
  static_assert(parallel || std::is_convertible_v<ConcurrencyTag, Sequential_tag>,
                "a concurrency tag of CGAL is needed");
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!parallel, "Parallel_tag needs TBB, which this program is not linked with");
#endif
  return parallel;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_IS_PARALLEL_H
