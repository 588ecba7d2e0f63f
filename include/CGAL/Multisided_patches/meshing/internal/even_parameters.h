// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EVEN_PARAMETERS_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EVEN_PARAMETERS_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The nearest multiple of 2^-53, whose complement to 1 is exact: a curve that is run from its other
// end needs that to get the same points. \pre 0 <= s <= 1
inline double with_exact_complement(double s) {
  return 1 - (1 - s);
}

// Parameters k/m strictly between 0 and 1, such that the one of k and that of m - k sum to 1
// exactly.
inline std::vector<double> even_parameters(std::size_t m) {
  std::vector<double> parameters(m - 1);
  for (std::size_t k = 1; 2 * k <= m; ++k) {
    const double s = with_exact_complement(static_cast<double>(k) / static_cast<double>(m));
    parameters[m - k - 1] = 1 - s;
    parameters[k - 1] = s;
  }
  return parameters;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EVEN_PARAMETERS_H
