// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CHANNEL_CELL_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CHANNEL_CELL_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Strip_map.h>

#include <algorithm>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// A part of the domain between two facing sides e1 and e2, see Strip_map. A harmonic function that
// vanishes on both has the basis Im e^{j (W - high)}, Im e^{-j (W - low)}, j = 1..degree, where
// [low, high] is the range of Re W: what enters at the ends decays exponentially inwards. One such
// cell resolves a gap of any thinness. As W may be as large as the channel is longer than wide, it
// is measured from the nearer end.
//
// The boundary values are carried by four harmonic functions, 0 on one side and on the other
//   O1: 1 on e1,  X1: x on e1,  O2: 1 on e2,  X2: the abscissa on e2, along it from above c.
class Channel_cell {
public:
  Channel_cell(const Boundary& boundary, std::size_t e1, std::size_t e2, const Strip_map& map,
               const Complex& origin, const Interval& range, int degree)
      : side_{e1, e2}, target_{boundary.next(e1), boundary.next(e2)},
        inverse_length_{1 / boundary.length(e1), 1 / boundary.length(e2)},
        map_(map), end_{map.moved_to(range.high), map.moved_to(range.low)}, length_(range.length()),
        middle_(map.abscissa((range.low + range.high) / 2)), degree_(degree) {
    const double beta = map.beta();
    const Complex d1 = boundary.direction(e1), d2 = boundary.direction(e2);
    const Complex above =
        origin + d1 * (map.height() * std::cos(beta)) * Complex(-std::tan(beta / 2), 1);
    abscissa_[0] = dot(origin - boundary.vertex(e1), d1);
    abscissa_[1] = dot(above - boundary.vertex(e2), d2);
  }

  int size() const { return 2 * degree_; }
  // In a wedge the basis oscillates the faster the narrower the wedge is.
  double resolution(const Complex& z) const {
    return 1.5 * degree_ * std::abs(map_.derivative(map_.local(z)));
  }

  template <int Order, typename Real>
  void basis(const std::complex<Real>& z, Analytic<Order, Real>* f) const {
    using Number = std::complex<Real>;
    const Number x = map_.local(z);
    const int nearer = x.real() > Real(middle_) ? 0 : 1;
    const Number w = end_[nearer].image(end_[nearer].local(z));
    // A point within rounding of the cell may be far outside, in units of W.
    const Number inwards((std::min)(nearer == 0 ? w.real() : -w.real(), Real(1)),
                         nearer == 0 ? w.imag() : -w.imag());
    Number factor[2];
    factor[nearer] = std::exp(inwards);
    factor[1 - nearer] = std::exp(-Real(length_) - inwards);
    const Number d = Order > 0 ? map_.derivative(x) : Number(0);
    // W'' / W'
    const Number bend = Order > 1 ? -d * bending<Real>() : Number(0);
    Number power[2] = {Number(0, -1), Number(0, -1)};
    for (int j = 1; j <= degree_; ++j)
      for (const int end : {0, 1}) {
        Analytic<Order, Real>& g = f[2 * (j - 1) + end];
        power[end] = product(power[end], factor[end]);
        const Real rate = end == 0 ? j : -j;
        g[0] = power[end];
        if constexpr (Order >= 1)
          g[1] = product(rate * d, g[0]);
        if constexpr (Order >= 2)
          g[2] = product(rate * d + bend, g[1]);
      }
  }

  template <int Order, typename Real>
  std::size_t hats(const std::complex<Real>& z, Hat_term<Order, Real>* terms) const {
    using Number = std::complex<Real>;
    using Function = Analytic<Order, Real>;
    const Number x = map_.local(z);
    const Function one{Number(1)}, o2 = constant_on_e2<Order>(x), x2 = linear_on_e2<Order>(x);
    const Function o1 = combination<Order, Real>(1, one, -1, o2);
    // Re x on e2 is q + cos(beta) times the abscissa there
    const Real cosine = std::cos(map_.beta()),
               q = -map_.height() * cosine * std::tan(map_.beta() / 2);
    Function x1 = combination<Order, Real>(-q, o2, -cosine, x2);
    x1[0] += x;
    if constexpr (Order >= 1)
      x1[1] += Number(map_.inverse_direction());
    // The abscissa on e2 runs against its direction: the domain is on its left, too.
    const Real slope1 = inverse_length_[0], slope2 = inverse_length_[1];
    terms[1] = {target_[0], combination<Order, Real>(slope1, x1, slope1 * abscissa_[0], o1)};
    terms[0] = {side_[0], combination<Order, Real>(1, o1, -1, terms[1].f)};
    terms[3] = {target_[1], combination<Order, Real>(-slope2, x2, slope2 * abscissa_[1], o2)};
    terms[2] = {side_[1], combination<Order, Real>(1, o2, -1, terms[3].f)};
    return 4;
  }

private:
  // W'' / W'^2, up to its sign
  template <typename Real>
  Real bending() const {
    return Real(map_.kappa()) / Real(map_.lambda());
  }

  // O2 = Im W / pi
  template <int Order, typename Real>
  Analytic<Order, Real> constant_on_e2(const std::complex<Real>& x) const {
    const Real scale = 1 / Real(pi);
    Analytic<Order, Real> f{scale * minus_i_times(map_.image(x))};
    if constexpr (Order >= 1)
      f[1] = scale * minus_i_times(map_.derivative(x));
    if constexpr (Order >= 2)
      f[2] = -f[1] * map_.derivative(x) * bending<Real>();
    return f;
  }

  // X2 = Im [x / sin(beta) - log(1 + kappa x) / (beta kappa)], arranged for small beta
  template <int Order, typename Real>
  Analytic<Order, Real> linear_on_e2(const std::complex<Real>& x) const {
    using Number = std::complex<Real>;
    const double beta = map_.beta();
    const Real slope =
        beta < 1e-2 ? beta / 6 + 7 * beta * beta * beta / 360 : 1 / std::sin(beta) - 1 / beta;
    const Real scale = Real(map_.lambda()) / Real(pi), kappa = map_.kappa();
    const Number bent = product(product(x, x), log1p_defect(kappa * x));
    const Number d(map_.inverse_direction()), stretch = Real(1) + kappa * x;
    Analytic<Order, Real> f{minus_i_times(slope * x + scale * bent)};
    if constexpr (Order >= 1)
      f[1] = minus_i_times(product(d, slope + scale * x / stretch));
    if constexpr (Order >= 2)
      f[2] = minus_i_times(scale * product(d, d) / (stretch * stretch));
    return f;
  }

  std::size_t side_[2], target_[2];
  double inverse_length_[2];
  double abscissa_[2]; // along the side, of the point from which X1 or X2 is measured
  Strip_map map_;
  Strip_map end_[2]; // with W = 0 where Re W is high or low
  double length_;    // in units of Re W
  double middle_;    // the abscissa where it changes which end is nearer
  int degree_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CHANNEL_CELL_H
