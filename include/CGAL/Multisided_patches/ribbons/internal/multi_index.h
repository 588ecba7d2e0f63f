// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_MULTI_INDEX_H
#define CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_MULTI_INDEX_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A tuple of non-negative integers. Those with a given sum come in lexicographically descending
// order: (2,0,0), (1,1,0), (1,0,1), (0,2,0), (0,1,1), (0,0,2).
using Multi_index = std::vector<std::size_t>;

// The largest number of tuples with which the functions below can do.
inline constexpr std::size_t max_multi_indices = 5000000;

// The largest depth of an S-patch. Binomial coefficients, up to 2^200, times the second derivatives
// of powers of coordinates stay within the range of double, also on domains of size 1e-100.
inline constexpr std::size_t max_s_patch_depth = 200;

// The number of tuples of `parts` integers with this sum, (parts + sum - 1 choose sum); if it is
// beyond the largest one, that number plus 1. O(min(parts, sum)). \pre parts >= 1
inline std::size_t number_of_multi_indices(std::size_t parts, std::size_t sum) {
  constexpr std::size_t too_many = max_multi_indices + 1;
  const std::size_t small = (std::min)(parts - 1, sum), large = (std::max)(parts - 1, sum);
  if (small == 0)
    return 1;
  if (large >= max_multi_indices)
    return too_many;
  std::size_t count = 1;
  for (std::size_t k = 1; k <= small; ++k) {
    count = count * (large + k) / k; // (large + k choose k)
    if (count > max_multi_indices)
      return too_many;
  }
  return count;
}

// The number of tuples of the same size and sum before this one. O(n²) for n parts, or less.
template <typename Index>
std::size_t rank_of_multi_index(const Index& index) {
  const std::size_t n = index.size();
  std::size_t rest = std::accumulate(index.begin(), index.end(), std::size_t(0)), rank = 0;
  for (std::size_t k = 0; k + 1 < n && rest > 0; ++k) {
    // Those with the same entries up to here and a larger one at k are, diminished by index[k] + 1
    // there, all the tuples with the rest of the sum.
    if (index[k] < rest)
      rank += number_of_multi_indices(n - k, rest - index[k] - 1);
    rest -= index[k];
  }
  return rank;
}

// The tuple before which there are `rank` ones.
inline Multi_index multi_index_of_rank(std::size_t parts, std::size_t sum, std::size_t rank) {
  CGAL_precondition(rank < number_of_multi_indices(parts, sum));
  Multi_index index(parts, 0);
  for (std::size_t k = 0; k + 1 < parts; ++k) {
    index[k] = sum;
    for (;;) {
      const std::size_t count = number_of_multi_indices(parts - k - 1, sum - index[k]);
      if (rank < count)
        break;
      rank -= count;
      --index[k];
    }
    sum -= index[k];
  }
  index[parts - 1] = sum;
  return index;
}

// The first tuple, (sum, 0, ..., 0).
inline Multi_index first_multi_index(std::size_t parts, std::size_t sum) {
  Multi_index index(parts, 0);
  index[0] = sum;
  return index;
}

// Goes on to the next tuple; false if there is none. O(n).
inline bool advance(Multi_index& index) {
  const std::size_t last = index.size() - 1;
  std::size_t k = last;
  while (k > 0 && index[k - 1] == 0)
    --k;
  if (k == 0)
    return false;
  const std::size_t rest = index[last] + 1;
  index[last] = 0;
  --index[k - 1];
  index[k] = rest;
  return true;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_MULTI_INDEX_H
