// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CORNER_CELL_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CORNER_CELL_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Boundary.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/analytic_functions.h>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The part of the domain around vertex k with interior angle a pi. A harmonic function that
// vanishes on both sides has the basis Im (zeta / r)^{j/a}, j = 1..size, where zeta is
// z - v_k seen in the direction of side k: the powers that make it singular at a corner.
//
// The boundary values, of slopes s1 along side k and s2 along side k-1, are carried by
// c0 + s1 Re zeta + (s2 - s1 cos(a pi)) Y, where Y is harmonic, 0 on side k and |zeta| on side k-1.
class Corner_cell {
public:
  Corner_cell(const Boundary& boundary, std::size_t k, double radius, int size)
      : vertex_(boundary.vertex(k)), index_(k), next_(boundary.next(k)), prev_(boundary.prev(k)),
        radius_(radius), log_radius_(std::log(radius)), angle_(boundary.angle(k)),
        half_opening_(angle_ * pi / 2), cosine_(std::cos(angle_ * pi)), size_(size),
        inverse_direction_(std::conj(boundary.direction(k))),
        to_bisector_(inverse_direction_ * std::polar(1., -half_opening_)),
        slope_next_(1 / boundary.length(k)), slope_prev_(1 / boundary.length(prev_)) {
    set_lift();
  }

  int size() const { return size_; }
  double resolution(const Complex&) const { return size_ / (angle_ * radius_); }

  template <int Order, typename Real>
  void basis(const std::complex<Real>& z, Analytic<Order, Real>* f) const {
    using Number = std::complex<Real>;
    const Number offset = offset_from_vertex(z);
    const Real angle = angle_;
    const Number w = std::exp(local_log(offset) / angle);
    const Number inverse = Order > 0 ? Real(1) / offset : Number(0);
    Number power(0, -1);
    for (int j = 1; j <= size_; ++j) {
      power = product(power, w);
      f[j - 1][0] = power;
      if constexpr (Order >= 1)
        f[j - 1][1] = product(j / angle * inverse, power);
      if constexpr (Order >= 2)
        f[j - 1][2] = product((j / angle - 1) * inverse, f[j - 1][1]);
    }
  }

  template <int Order, typename Real>
  std::size_t hats(const std::complex<Real>& z, Hat_term<Order, Real>* terms) const {
    using Number = std::complex<Real>;
    const Number offset = offset_from_vertex(z);
    const Number direction(inverse_direction_);
    Analytic<Order, Real> x{product(offset, direction)};
    if constexpr (Order >= 1)
      x[1] = direction;
    const Analytic<Order, Real> y = lift<Order>(offset);
    const Real slope = slope_next_, cosine = cosine_;
    terms[1] = {next_, combination<Order, Real>(slope, x, -slope * cosine, y)};
    terms[2] = {prev_, combination<Order, Real>(0, x, slope_prev_, y)};
    terms[0] = {index_, combination<Order, Real>(-1, terms[1].f, -1, terms[2].f)};
    terms[0].f[0] += Real(1);
    return 3;
  }

private:
  // z - v, but never 0, where the logarithm and the negative powers end.
  template <typename Real>
  std::complex<Real> offset_from_vertex(const std::complex<Real>& z) const {
    const std::complex<Real> offset = z - std::complex<Real>(vertex_);
    return offset == std::complex<Real>(0) ? std::complex<Real>(1e-100 * std::conj(to_bisector_))
                                           : offset;
  }

  // log(zeta / r), with the argument running continuously from 0 to a pi through the domain
  template <typename Real>
  std::complex<Real> local_log(const std::complex<Real>& offset) const {
    const std::complex<Real> q = product(offset, std::complex<Real>(to_bisector_));
    return {std::log(std::norm(offset)) / 2 - log_radius_,
            std::atan2(q.imag(), q.real()) + Real(half_opening_)};
  }

  // Y = Im zeta / sin(a pi) breaks down where sin(a pi) vanishes. Near such an angle a = m / (1 +
  // e) the multiple of Im zeta^{m/a} that is taken off turns it into
  //   Y = -Im [zeta ((zeta/r)^e - 1) / e] e / sin(a pi),
  // which stays bounded and contains the limit zeta log zeta exactly.
  void set_lift() {
    lift_factor_ = 1 / std::sin(angle_ * pi);
    for (const int m : {1, 2}) {
      const double e = m / angle_ - 1;
      if (std::abs(e) < 0.25) {
        const double t = m * pi * e / (1 + e), sign = m == 1 ? 1 : -1;
        lift_exponent_ = e;
        lift_is_power_ = true;
        lift_factor_ = sign * (t == 0 ? 1 / (m * pi) : e / std::sin(t));
      }
    }
  }

  template <int Order, typename Real>
  Analytic<Order, Real> lift(const std::complex<Real>& offset) const {
    using Number = std::complex<Real>;
    const Number d(inverse_direction_), zeta = product(offset, d);
    const Real factor = lift_factor_, exponent = lift_exponent_;
    Analytic<Order, Real> y{};
    if (!lift_is_power_) {
      y[0] = factor * minus_i_times(zeta);
      if constexpr (Order >= 1)
        y[1] = factor * minus_i_times(d);
      return y;
    }
    const Number log = local_log(offset), w = exponent * log;
    const Number ratio = product(log, expm1_ratio(w)); // ((zeta/r)^e - 1) / e
    y[0] = -factor * minus_i_times(product(zeta, ratio));
    if constexpr (Order >= 1) {
      const Number power = Real(1) + exponent * ratio;
      y[1] = -factor * minus_i_times(product(d, ratio + power));
      if constexpr (Order >= 2)
        y[2] = -factor * (1 + exponent) * minus_i_times(product(d, power) / offset);
    }
    return y;
  }

  Complex vertex_;
  std::size_t index_, next_, prev_;
  double radius_, log_radius_, angle_, half_opening_, cosine_;
  int size_;
  Complex inverse_direction_, to_bisector_;
  double slope_next_, slope_prev_;
  double lift_factor_ = 0, lift_exponent_ = 0;
  bool lift_is_power_ = false;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CORNER_CELL_H
