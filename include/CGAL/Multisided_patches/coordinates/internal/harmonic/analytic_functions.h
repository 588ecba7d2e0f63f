// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_ANALYTIC_FUNCTIONS_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_ANALYTIC_FUNCTIONS_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/plane_geometry.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The value and the derivatives with respect to z, up to Order, of an analytic function F at a
// point. The harmonic function meant is u = Re F; by the Cauchy-Riemann equations
// u_x - i u_y = F' and u_xx - i u_xy = F''.
template <int Order>
using Analytic = std::array<Complex, Order + 1>;

// The part of a local solution that carries the boundary values: the function of one vertex.
template <int Order>
struct Hat_term {
  std::size_t vertex;
  Analytic<Order> f;
};

// No cell touches more than two sides, so at most four vertices have boundary values on it.
inline constexpr std::size_t max_hat_terms = 4;

// a f + b g
template <int Order>
Analytic<Order> combination(double a, const Analytic<Order>& f, double b,
                            const Analytic<Order>& g) {
  Analytic<Order> r;
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] = a * f[i] + b * g[i];
  return r;
}

// -i w: its real part is the imaginary part of w.
inline Complex minus_i_times(const Complex& w) {
  return {w.imag(), -w.real()};
}

// (e^w - 1) / w, without cancellation at small w.
inline Complex expm1_ratio(const Complex& w) {
  if (w == Complex(0))
    return 1;
  const double x = w.real(), y = w.imag(), s = std::sin(y / 2);
  return Complex(std::expm1(x) * std::cos(y) - 2 * s * s, std::exp(x) * std::sin(y)) / w;
}

// log(1 + t) / t, without cancellation at small t; the principal branch.
inline Complex log1p_ratio(const Complex& t) {
  if (t == Complex(0))
    return 1;
  const double x = t.real(), y = t.imag();
  const double real = std::abs(x) + std::abs(y) < 0.5 ? std::log1p(x * (2 + x) + y * y) / 2
                                                      : std::log(std::norm(1. + t)) / 2;
  return Complex(real, std::atan2(y, 1 + x)) / t;
}

// (1 - log(1 + t) / t) / t = 1/2 - t/3 + t^2/4 - ..., without cancellation at small t.
inline Complex log1p_defect(const Complex& t) {
  if (std::norm(t) > 0.0625)
    return (1. - log1p_ratio(t)) / t;
  Complex sum = 0;
  for (int k = 27; k >= 2; --k) // 0.25^26 < 2^-52, by Horner's scheme
    sum = 1. / k - product(t, sum);
  return sum;
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_ANALYTIC_FUNCTIONS_H
