// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_NEAREST_CONVEX_COMBINATION_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_NEAREST_CONVEX_COMBINATION_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/plane_geometry.h>

#include <Eigen/Cholesky>

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
// coefficients are zero. The points are at most about 1 away from z.
class Nearest_convex_combination {
public:
  Nearest_convex_combination(const std::vector<Complex>& points, const Complex& z,
                             const double* lambda)
      : points_(points), z_(z), lambda_(lambda) {
    minimize();
  }

  double coefficient(std::size_t i) const { return (std::max)(lambda_[i] + y_.dot(moment(i)), 0.); }

private:
  using Vector = Eigen::Vector3d;

  struct Derivatives {
    Vector gradient;
    Eigen::Matrix3d hessian;
  };

  Vector moment(std::size_t i) const {
    const Complex w = points_[i] - z_;
    return {1, w.real(), w.imag()};
  }

  Derivatives derivatives(const Vector& y) const {
    double g = -1, g_u = 0, g_v = 0, count = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Complex w = points_[i] - z_;
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

  void minimize() {
    constexpr int max_steps = 30, max_halvings = 50; // a few, or none, in experience
    constexpr double rounding = 2 * std::numeric_limits<double>::epsilon(); // of coefficients
    Derivatives here = derivatives(y_);
    for (int i = 0; i < max_steps; ++i) {
      Vector step = here.hessian.ldlt().solve(-here.gradient);
      const double slope = here.gradient.dot(step);
      if (!(slope < 0))
        return;
      Derivatives there = derivatives(y_ + step);
      const bool is_minimum = there.hessian == here.hessian; // the same coefficients are positive
      for (int j = 0; j < max_halvings && there.gradient.dot(step) > -slope / 2; ++j) {
        step /= 2;
        there = derivatives(y_ + step);
      }
      y_ += step;
      if (is_minimum || step.lpNorm<1>() < rounding)
        return;
      here = there;
    }
  }

  const std::vector<Complex>& points_;
  Complex z_;
  const double* lambda_;
  Vector y_ = Vector::Zero();
};

// Replaces approximate coordinates of z, where some are negative, by the nearest ones that are not
// and still have the sum 1 and reproduce z.
//
// The exact coordinates are such ones, and a projection onto a convex set brings no point farther
// away from any point of the set: the error does not grow, whatever the polygon. (Setting negative
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
  for (std::size_t i = 0; i < vertices.size(); ++i)
    lambda[i] = nearest.coefficient(i);
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_NEAREST_CONVEX_COMBINATION_H
