// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_GAUSS_LEGENDRE_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_GAUSS_LEGENDRE_H

#include <CGAL/Multisided_patches/internal/vector_utils.h>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

struct Quadrature_node {
  double t, weight; // on [0,1]
};

// the nodes of the m-point Gauss-Legendre rule on [0,1], by Newton's method on P_m from Tricomi's
// approximation of its roots
inline std::vector<Quadrature_node> gauss_legendre(int m) {
  std::vector<Quadrature_node> nodes;
  for (int i = 0; i < m; ++i) {
    double x = std::cos(pi * (i + 0.75) / (m + 0.5)), slope = 1;
    for (int iteration = 0; iteration < 8; ++iteration) {
      double p = 1, previous = 0; // P_j and P_{j-1} at x, by the three-term recurrence
      for (int j = 1; j <= m; ++j)
        previous = std::exchange(p, ((2 * j - 1) * x * p - (j - 1) * previous) / j);
      slope = m * (x * p - previous) / (x * x - 1);
      const double step = p / slope;
      x -= step;
      if (std::abs(step) < 1e-15)
        break;
    }
    nodes.push_back({(1 - x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_GAUSS_LEGENDRE_H
