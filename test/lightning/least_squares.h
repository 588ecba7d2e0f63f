// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_LIGHTNING_LEAST_SQUARES_H
#define MULTISIDED_PATCHES_TEST_LIGHTNING_LEAST_SQUARES_H

#include <Eigen/Core>
#include <Eigen/QR>

namespace fixtures {
namespace lightning {

// Least squares with columns of unit length (the functions differ in size), in place (the matrix
// is large).
inline Eigen::MatrixXd solve(Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::VectorXd scales = a.colwise().norm().cwiseInverse();
  a *= scales.asDiagonal();
  const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(a);
  return scales.asDiagonal() * Eigen::MatrixXd(qr.solve(b));
}

} // namespace lightning
} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_LIGHTNING_LEAST_SQUARES_H
