// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_LIGHTNING_ORTHONORMAL_POLYNOMIALS_H
#define MULTISIDED_PATCHES_TEST_LIGHTNING_ORTHONORMAL_POLYNOMIALS_H

#include "numbers.h"

#include <Eigen/Core>

#include <cmath>

namespace fixtures {
namespace lightning {

// Polynomials that are orthonormal over given points ("Vandermonde with Arnoldi"): powers would
// be as good as linearly dependent.
class Orthonormal_polynomials {
public:
  Orthonormal_polynomials(const Eigen::VectorXcd& points, Eigen::Index degree)
      : hessenberg_(Eigen::MatrixXcd::Zero(degree + 1, degree)) {
    const double count = static_cast<double>(points.size());
    Eigen::MatrixXcd q = Eigen::MatrixXcd::Ones(points.size(), degree + 1);
    for (Eigen::Index k = 0; k < degree; ++k) {
      q.col(k + 1) = points.cwiseProduct(q.col(k));
      for (int pass = 0; pass < 2; ++pass)
        for (Eigen::Index j = 0; j <= k; ++j) {
          const Complex h = q.col(j).dot(q.col(k + 1)) / count;
          hessenberg_(j, k) += h;
          q.col(k + 1) -= h * q.col(j);
        }
      hessenberg_(k + 1, k) = q.col(k + 1).norm() / std::sqrt(count);
      q.col(k + 1) /= hessenberg_(k + 1, k);
    }
  }

  Eigen::VectorXcd operator()(Complex z) const {
    Eigen::VectorXcd q = Eigen::VectorXcd::Ones(hessenberg_.rows());
    for (Eigen::Index k = 0; k < hessenberg_.cols(); ++k) {
      const Complex lower = (hessenberg_.col(k).head(k + 1).array() * q.head(k + 1).array()).sum();
      q[k + 1] = (z * q[k] - lower) / hessenberg_(k + 1, k);
    }
    return q;
  }

private:
  Eigen::MatrixXcd hessenberg_;
};

} // namespace lightning
} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_LIGHTNING_ORTHONORMAL_POLYNOMIALS_H
