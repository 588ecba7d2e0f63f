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
        radius_(radius), angle_(boundary.angle(k)), size_(size),
        inverse_direction_(std::conj(boundary.direction(k))),
        to_bisector_(inverse_direction_ * std::polar(1., -angle_ * pi / 2)),
        slope_next_(1 / boundary.length(k)), slope_prev_(1 / boundary.length(prev_)) {
    set_lift();
  }

  int size() const { return size_; }
  double resolution() const { return size_ / (angle_ * radius_); }

  template <int Order>
  void basis(const Complex& z, Analytic<Order>* f) const {
    const Complex offset = offset_from_vertex(z);
    const Complex w = std::exp(local_log(offset) / angle_);
    const Complex inverse = Order > 0 ? 1. / offset : Complex(0);
    Complex power(0, -1);
    for (int j = 1; j <= size_; ++j) {
      power = product(power, w);
      f[j - 1][0] = power;
      if constexpr (Order >= 1)
        f[j - 1][1] = product(j / angle_ * inverse, power);
      if constexpr (Order >= 2)
        f[j - 1][2] = product((j / angle_ - 1) * inverse, f[j - 1][1]);
    }
  }

  template <int Order>
  std::size_t hats(const Complex& z, Hat_term<Order>* terms) const {
    const Complex offset = offset_from_vertex(z);
    Analytic<Order> x{product(offset, inverse_direction_)};
    if constexpr (Order >= 1)
      x[1] = inverse_direction_;
    const Analytic<Order> y = lift<Order>(offset);
    const double cosine = std::cos(angle_ * pi);
    terms[1] = {next_, combination<Order>(slope_next_, x, -slope_next_ * cosine, y)};
    terms[2] = {prev_, combination<Order>(0, x, slope_prev_, y)};
    terms[0] = {index_, combination<Order>(-1, terms[1].f, -1, terms[2].f)};
    terms[0].f[0] += 1.;
    return 3;
  }

private:
  // z - v, but never 0, where the logarithm and the negative powers end.
  Complex offset_from_vertex(const Complex& z) const {
    return z == vertex_ ? 1e-100 * std::conj(to_bisector_) : z - vertex_;
  }

  // log(zeta / r), with the argument running continuously from 0 to a pi through the domain
  Complex local_log(const Complex& offset) const {
    const Complex q = product(offset, to_bisector_);
    return {std::log(std::norm(offset)) / 2 - std::log(radius_),
            std::atan2(q.imag(), q.real()) + angle_ * pi / 2};
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

  template <int Order>
  Analytic<Order> lift(const Complex& offset) const {
    const Complex zeta = product(offset, inverse_direction_);
    const Complex d = inverse_direction_;
    Analytic<Order> y{};
    if (!lift_is_power_) {
      y[0] = lift_factor_ * minus_i_times(zeta);
      if constexpr (Order >= 1)
        y[1] = lift_factor_ * minus_i_times(d);
      return y;
    }
    const Complex log = local_log(offset), w = lift_exponent_ * log;
    const Complex ratio = product(log, expm1_ratio(w)); // ((zeta/r)^e - 1) / e
    y[0] = -lift_factor_ * minus_i_times(product(zeta, ratio));
    if constexpr (Order >= 1) {
      const Complex power = 1. + lift_exponent_ * ratio;
      y[1] = -lift_factor_ * minus_i_times(product(d, ratio + power));
      if constexpr (Order >= 2)
        y[2] = -lift_factor_ * (1 + lift_exponent_) * minus_i_times(product(d, power) / offset);
    }
    return y;
  }

  Complex vertex_;
  std::size_t index_, next_, prev_;
  double radius_, angle_;
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
