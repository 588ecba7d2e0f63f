// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_ANALYTIC_FUNCTIONS_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_ANALYTIC_FUNCTIONS_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/plane_geometry.h>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The value and the derivatives with respect to z, up to Order, of an analytic function F at a
// point. The harmonic function meant is u = Re F; by the Cauchy-Riemann equations
// u_x - i u_y = F' and u_xx - i u_xy = F''.
//
// Functions are evaluated in the precision of the point, `Real`. The constants of a cell are
// doubles all the same: they define the function.
template <int Order, typename Real = double>
using Analytic = std::array<std::complex<Real>, Order + 1>;

// The part of a local solution that carries the boundary values: the function of one vertex.
template <int Order, typename Real = double>
struct Hat_term {
  std::size_t vertex;
  Analytic<Order, Real> f;
};

// No cell touches more than two sides, so at most four vertices have boundary values on it.
inline constexpr std::size_t max_hat_terms = 4;

// a f + b g
template <int Order, typename Real>
Analytic<Order, Real> combination(Real a, const Analytic<Order, Real>& f, Real b,
                                  const Analytic<Order, Real>& g) {
  Analytic<Order, Real> r;
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] = a * f[i] + b * g[i];
  return r;
}

// -i w: its real part is the imaginary part of w.
template <typename Real>
std::complex<Real> minus_i_times(const std::complex<Real>& w) {
  return {w.imag(), -w.real()};
}

// (e^w - 1) / w, without cancellation at small w.
template <typename Real>
std::complex<Real> expm1_ratio(const std::complex<Real>& w) {
  if (w == std::complex<Real>(0))
    return 1;
  const Real x = w.real(), y = w.imag(), s = std::sin(y / 2);
  return std::complex<Real>(std::expm1(x) * std::cos(y) - 2 * s * s, std::exp(x) * std::sin(y)) / w;
}

// log(1 + t) / t, without cancellation at small t; the principal branch.
template <typename Real>
std::complex<Real> log1p_ratio(const std::complex<Real>& t) {
  if (t == std::complex<Real>(0))
    return 1;
  const Real x = t.real(), y = t.imag();
  const Real real = std::abs(x) + std::abs(y) < Real(0.5) ? std::log1p(x * (2 + x) + y * y) / 2
                                                          : std::log(std::norm(Real(1) + t)) / 2;
  return std::complex<Real>(real, std::atan2(y, 1 + x)) / t;
}

// (1 - log(1 + t) / t) / t = 1/2 - t/3 + t^2/4 - ..., without cancellation at small t.
template <typename Real>
std::complex<Real> log1p_defect(const std::complex<Real>& t) {
  if (std::norm(t) > Real(0.0625))
    return (Real(1) - log1p_ratio(t)) / t;
  std::complex<Real> sum = 0;
  constexpr int terms = std::numeric_limits<Real>::digits / 2 + 1; // 0.25^terms is below rounding
  for (int k = terms; k >= 2; --k)                                 // by Horner's scheme
    sum = Real(1) / k - product(t, sum);
  return sum;
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_ANALYTIC_FUNCTIONS_H
