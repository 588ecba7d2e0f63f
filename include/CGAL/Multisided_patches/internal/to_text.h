// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_TO_TEXT_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_TO_TEXT_H

#include <charconv>
#include <cmath>
#include <string>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The shortest text that is read back as the same number, whatever the locale is.
inline std::string to_text(double x) {
  char buffer[32]; // 24 characters are enough for any double
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof(buffer), x).ptr);
}

// The same, of a number in an error message: six digits tell enough.
inline std::string to_short_text(double x) {
  char buffer[32];
  return std::string(
      buffer, std::to_chars(buffer, buffer + sizeof(buffer), x, std::chars_format::general, 6).ptr);
}

// Two digits of a normal positive number below 1e308 that make a larger one, so that who asks for
// what is read asks for no less.
inline std::string to_short_text_above(double x) {
  // The margin is above all errors of the powers and products.
  const double digit = std::pow(10., std::floor(std::log10(x)) - 1);
  return to_short_text(std::ceil(x / digit * (1 + 1e-9)) * digit);
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_TO_TEXT_H
