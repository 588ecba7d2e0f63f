// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_INTERIOR_CELL_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_INTERIOR_CELL_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/analytic_functions.h>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// A part of the domain around a point inside it. There, a harmonic function is the real part of a
// power series, which converges up to the boundary: basis 1, Re zeta^j, -Im zeta^j, j = 1..degree,
// with zeta = (z - centre) / radius.
class Interior_cell {
public:
  Interior_cell(const Complex& centre, double radius, int degree)
      : centre_(centre), radius_(radius), degree_(degree) {}

  int size() const { return 2 * degree_ + 1; }
  // how fast the basis oscillates around z: radians per unit of length
  double resolution(const Complex&) const { return degree_ / radius_; }

  template <int Order, typename Real>
  void basis(const std::complex<Real>& z, Analytic<Order, Real>* f) const {
    using Number = std::complex<Real>;
    const Real radius = radius_;
    const Number zeta = (z - Number(centre_)) / radius;
    f[0] = {Number(1)};
    std::array<Number, 3> power{1, 0, 0}; // zeta^j, zeta^{j-1}, zeta^{j-2}
    for (int j = 1; j <= degree_; ++j) {
      power = {product(power[0], zeta), power[0], power[1]};
      Analytic<Order, Real>&re = f[2 * j - 1], &im = f[2 * j];
      Real factor = 1;
      for (int k = 0; k <= Order; factor *= (j - k) / radius, ++k) {
        re[k] = factor * power[k];
        im[k] = -minus_i_times(re[k]);
      }
    }
  }

  // No side, no boundary values.
  template <int Order, typename Real>
  std::size_t hats(const std::complex<Real>&, Hat_term<Order, Real>*) const {
    return 0;
  }

private:
  Complex centre_;
  double radius_;
  int degree_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_INTERIOR_CELL_H
