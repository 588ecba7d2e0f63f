// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SIDE_CELL_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SIDE_CELL_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Boundary.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/analytic_functions.h>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// A part of the domain around a point in the middle of a side. A harmonic function that vanishes on
// the side continues across it by reflection, and so has the basis Im zeta^j, j = 1..degree, with
// zeta = (z - centre) / (direction radius). The boundary values, continued constantly across the
// side, are harmonic as they are.
class Side_cell {
public:
  Side_cell(const Boundary& boundary, std::size_t side, const Complex& centre, double radius,
            int degree)
      : source_(side), target_(boundary.next(side)), centre_(centre),
        // conj(direction) is 1/direction
        to_local_(std::conj(boundary.direction(side)) / radius), degree_(degree),
        centre_parameter_(dot(centre - boundary.vertex(side), boundary.direction(side)) /
                          boundary.length(side)),
        parameter_slope_(radius / boundary.length(side)) {}

  int size() const { return degree_; }
  double resolution(const Complex&) const { return degree_ * std::abs(to_local_); }

  template <int Order, typename Real>
  void basis(const std::complex<Real>& z, Analytic<Order, Real>* f) const {
    using Number = std::complex<Real>;
    const Number to_local(to_local_), zeta = product(z - Number(centre_), to_local);
    std::array<Number, 3> power{Number(0, -1), 0, 0}; // -i times zeta^j, zeta^{j-1}, zeta^{j-2}
    for (int j = 1; j <= degree_; ++j) {
      power = {product(power[0], zeta), power[0], power[1]};
      f[j - 1][0] = power[0];
      if constexpr (Order >= 1)
        f[j - 1][1] = product(Real(j) * to_local, power[1]);
      if constexpr (Order >= 2)
        f[j - 1][2] = product(Real(j * (j - 1)) * product(to_local, to_local), power[2]);
    }
  }

  template <int Order, typename Real>
  std::size_t hats(const std::complex<Real>& z, Hat_term<Order, Real>* terms) const {
    using Number = std::complex<Real>;
    // F = the parameter along the side, continued to complex z
    const Real slope = parameter_slope_;
    const Number to_local(to_local_);
    Analytic<Order, Real> rising{Real(centre_parameter_) +
                                 slope * product(z - Number(centre_), to_local)};
    if constexpr (Order >= 1)
      rising[1] = slope * to_local;
    const Analytic<Order, Real> one{Number(1)};
    terms[0] = {source_, combination<Order, Real>(1, one, -1, rising)};
    terms[1] = {target_, rising};
    return 2;
  }

private:
  std::size_t source_, target_;
  Complex centre_, to_local_;
  int degree_;
  double centre_parameter_, parameter_slope_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SIDE_CELL_H
