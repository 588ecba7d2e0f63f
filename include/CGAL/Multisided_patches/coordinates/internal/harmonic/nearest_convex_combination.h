// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_NEAREST_CONVEX_COMBINATION_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_NEAREST_CONVEX_COMBINATION_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/plane_geometry.h>

#include <Eigen/Cholesky>
#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The convex combination of points that is z and whose coefficients are nearest to given ones in
// the Euclidean norm. The nearest is mu_i = max(0, lambda_i + y . m_i) with m_i = (1, v_i - z), for
// the y where sum mu_i m_i = (1, 0, 0): where a convex function of three variables with this
// gradient, piecewise quadratic, is smallest. Newton's method; each step is a better guess of which
// coefficients are zero. The points are at most about 1 away from z, which is in their convex hull.
class Nearest_convex_combination {
public:
  Nearest_convex_combination(const std::vector<Complex>& points, const Complex& z,
                             const double* lambda)
      : lambda_(lambda), offsets_(points.size()) {
    const Complex axis = principal_axis(points, z);
    for (std::size_t i = 0; i < points.size(); ++i)
      offsets_[i] = product(points[i] - z, std::conj(axis));
    minimize();
  }

  double coefficient(std::size_t i) const { return (std::max)(lambda_[i] + y_.dot(moment(i)), 0.); }

private:
  using Vector = Eigen::Vector3d;

  struct Derivatives {
    Vector gradient;
    Eigen::Matrix3d hessian;
  };

  // the direction in which the points are spread most, seen from z; along it and across, a thin
  // polygon makes equations that are badly scaled, which does no harm, but not nearly dependent
  static Complex principal_axis(const std::vector<Complex>& points, const Complex& z) {
    double uu = 0, uv = 0, vv = 0;
    for (const Complex& p : points) {
      const Complex w = p - z;
      uu += w.real() * w.real();
      uv += w.real() * w.imag();
      vv += w.imag() * w.imag();
    }
    return std::polar(1., std::atan2(2 * uv, uu - vv) / 2);
  }

  Vector moment(std::size_t i) const { return {1, offsets_[i].real(), offsets_[i].imag()}; }

  Derivatives derivatives(const Vector& y) const {
    double g = -1, g_u = 0, g_v = 0, count = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
    for (std::size_t i = 0; i < offsets_.size(); ++i) {
      const Complex& w = offsets_[i];
      const double value = lambda_[i] + y[0] + y[1] * w.real() + y[2] * w.imag();
      const double mu = value > 0 ? value : 0, positive = value > 0 ? 1 : 0;
      g += mu;
      g_u += mu * w.real();
      g_v += mu * w.imag();
      count += positive;
      u += positive * w.real();
      v += positive * w.imag();
      uu += positive * w.real() * w.real();
      uv += positive * w.real() * w.imag();
      vv += positive * w.imag() * w.imag();
    }
    Derivatives d{{g, g_u, g_v}, {}};
    d.hessian << count, u, v, u, uu, uv, v, uv, vv;
    return d;
  }

  // Where z is outside the points by rounding, there is no minimum. What is left then is where the
  // gradient was smallest.
  void minimize() {
    constexpr int max_steps = 30, max_halvings = 50;
    constexpr double rounding = 2 * std::numeric_limits<double>::epsilon(); // of coefficients
    const double rounding_of_sums = rounding * std::sqrt(static_cast<double>(offsets_.size()));
    Vector y = y_;
    Derivatives here = derivatives(y);
    double smallest = here.gradient.lpNorm<Eigen::Infinity>();
    for (int i = 0; i < max_steps; ++i) {
      Vector step = newton_step(here);
      double slope = here.gradient.dot(step);
      if (!(slope < 0))
        return;
      Derivatives there = derivatives(y + step);
      for (int j = 0; j < max_halvings && there.gradient.dot(step) > -slope / 2; ++j) {
        step /= 2;
        slope /= 2;
        there = derivatives(y + step);
      }
      y += step;
      const double size = there.gradient.lpNorm<Eigen::Infinity>();
      if (size <= (std::max)(smallest, rounding_of_sums)) {
        smallest = (std::min)(smallest, size);
        y_ = y;
      }
      const bool is_quadratic = there.hessian == here.hessian; // no coefficient became zero or not
      if ((is_quadratic && size <= rounding_of_sums) || step.lpNorm<1>() < rounding)
        return;
      here = there;
    }
  }

  // With fewer than three points that count, or on a line, the Hessian is singular.
  static Vector newton_step(const Derivatives& d) {
    Eigen::Matrix3d hessian = d.hessian;
    hessian.diagonal() *= 1 + 8 * std::numeric_limits<double>::epsilon();
    return hessian.ldlt().solve(-d.gradient);
  }

  const double* lambda_;
  boost::container::small_vector<Complex, 32> offsets_; // from z, along and across the axis
  Vector y_ = Vector::Zero();
};

// Replaces approximate coordinates of z, where some are negative, by the nearest ones that are not
// and still have the sum 1 and reproduce z.
//
// The exact coordinates are such ones, and a projection onto a convex set brings no point farther
// away from any point of the set: but for rounding, the error does not grow. (Setting negative
// values to zero and changing the others in proportion does not do: in a narrow gap, those of its
// ends would have to change a lot to make up for a tiny one far away.)
inline void make_nonnegative(const std::vector<Complex>& vertices, const Complex& z,
                             double* lambda) {
  double deficit = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    deficit += (std::max)(-lambda[i], 0.);
  if (deficit < std::numeric_limits<double>::epsilon()) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      lambda[i] = (std::max)(lambda[i], 0.);
    return;
  }
  const Nearest_convex_combination nearest(vertices, z, lambda);
  double sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    lambda[i] = nearest.coefficient(i); // depends on no other value
    sum += lambda[i];
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
    lambda[i] /= sum;
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_NEAREST_CONVEX_COMBINATION_H
