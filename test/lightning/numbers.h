// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_LIGHTNING_NUMBERS_H
#define MULTISIDED_PATCHES_TEST_LIGHTNING_NUMBERS_H

#include <Eigen/Core>

#include <complex>
#include <cstddef>

// What the parts of the lightning solver compute with. (Eigen has signed indices.)
namespace fixtures {
namespace lightning {

using Complex = std::complex<double>;

inline Eigen::Index index(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

} // namespace lightning
} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_LIGHTNING_NUMBERS_H
