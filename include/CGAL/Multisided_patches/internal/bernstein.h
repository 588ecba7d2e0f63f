// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_BERNSTEIN_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_BERNSTEIN_H

#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Writes the Bernstein polynomials B^degree_0(t), ..., B^degree_degree(t) to values[0..degree]. The
// triangular recurrence only adds non-negative numbers for t in [0,1], so it is stable, and it
// works for any number type, exact ones and jets included. O(degree²).
template <typename T>
void bernstein_polynomials(std::size_t degree, const T& t, T* values) {
  const T one_minus_t = T(1) - t;
  values[0] = T(1);
  for (std::size_t d = 1; d <= degree; ++d) {
    values[d] = values[d - 1] * t;
    for (std::size_t j = d - 1; j > 0; --j)
      values[j] = values[j] * one_minus_t + values[j - 1] * t;
    values[0] = values[0] * one_minus_t;
  }
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_BERNSTEIN_H
