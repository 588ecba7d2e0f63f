// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_STRIP_MAP_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_STRIP_MAP_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Boundary.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/analytic_functions.h>

#include <limits>
#include <utility>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// A closed interval of reals.
struct Interval {
  double low, high;
  double length() const { return high - low; }
};

// The conformal map of the wedge between two facing sides onto a strip: Im W is 0 on side e1 and pi
// on side e2. Let e2 rise from e1 at the angle beta >= 0, be h above the point c of e1, and
// x = (z - c) / d1. The wedge has its apex at x = -1/kappa, kappa = tan(beta) / h, and
//   W = (pi / beta) log(1 + kappa x) = Lambda x log(1 + kappa x) / (kappa x),
// of which the latter form is stable up to parallel sides, beta = 0.
class Strip_map {
public:
  // \pre h > 0, 0 <= beta < pi/2
  Strip_map(const Complex& origin, const Complex& direction, double height, double beta)
      : origin_(origin), inverse_direction_(std::conj(direction)), height_(height), beta_(beta),
        kappa_(std::tan(beta) / height),
        lambda_(beta < 1e-12 ? pi / height : pi * std::tan(beta) / (beta * height)) {}

  double height() const { return height_; }
  double beta() const { return beta_; }
  double kappa() const { return kappa_; }
  double lambda() const { return lambda_; }
  const Complex& inverse_direction() const { return inverse_direction_; }

  template <typename Real>
  std::complex<Real> local(const std::complex<Real>& z) const {
    return product(z - std::complex<Real>(origin_), std::complex<Real>(inverse_direction_));
  }

  // W as a function of x
  template <typename Real>
  std::complex<Real> image(const std::complex<Real>& x) const {
    return product(Real(lambda_) * x, log1p_ratio(Real(kappa_) * x));
  }
  // dW/dz
  template <typename Real>
  std::complex<Real> derivative(const std::complex<Real>& x) const {
    return Real(lambda_) * std::complex<Real>(inverse_direction_) / (Real(1) + Real(kappa_) * x);
  }

  // the abscissa x of the point of e1 with Re W = s
  double abscissa(double s) const {
    return s / lambda_ * expm1_ratio(Complex(beta_ * s / pi)).real();
  }
  // the same map less s: seen from that point
  Strip_map moved_to(double s) const {
    const double x = abscissa(s);
    return Strip_map(origin_ + x * std::conj(inverse_direction_), std::conj(inverse_direction_),
                     height_ * (1 + kappa_ * x), beta_);
  }

  // the range of Re W on a segment inside the wedge: circles about the apex are its level lines
  Interval range(const Segment& segment) const {
    const Complex xa = local(segment.a), xb = local(segment.b);
    const double sa = real_image(xa), sb = real_image(xb);
    Interval r{(std::min)(sa, sb), (std::max)(sa, sb)};
    const Complex d = xb - xa;
    const double t = -dot(1. + kappa_ * xa, d) / (kappa_ * std::norm(d));
    if (kappa_ > 0 && t > 0 && t < 1)
      r.low = (std::min)(r.low, real_image(xa + t * d));
    return r;
  }

private:
  double real_image(const Complex& x) const {
    return 1. + kappa_ * x == Complex(0) ? -std::numeric_limits<double>::infinity()
                                         : image(x).real();
  }

  Complex origin_, inverse_direction_;
  double height_, beta_, kappa_, lambda_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_STRIP_MAP_H
