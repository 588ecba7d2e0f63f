// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_INTEGER_POWER_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_INTEGER_POWER_H

#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// base^exponent for any number type, jets included.
template <typename T>
T integer_power(const T& base, std::size_t exponent) {
  if (exponent == 0)
    return T(1);
  T result = base;
  for (std::size_t i = 1; i < exponent; ++i)
    result = result * base;
  return result;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_INTEGER_POWER_H
