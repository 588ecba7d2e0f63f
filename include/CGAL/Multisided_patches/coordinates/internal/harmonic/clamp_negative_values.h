// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CLAMP_NEGATIVE_VALUES_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CLAMP_NEGATIVE_VALUES_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/plane_geometry.h>

#include <Eigen/Cholesky>

#include <limits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// Multiplies all values by 1 + alpha + beta (v_i - z), with the alpha and beta that give
// sum lambda_i = 1 and sum lambda_i v_i = z: what is zero stays so, and what is small changes
// little, and stays positive.
inline void rescale_affinely(const std::vector<Complex>& vertices, const Complex& z,
                             double* lambda) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Complex w = vertices[i] - z;
    const Eigen::Vector3d affine(1, w.real(), w.imag());
    moments += lambda[i] * affine * affine.transpose();
  }
  const Eigen::Vector3d defect = Eigen::Vector3d(1, 0, 0) - moments.col(0);
  // Next to a side the moments across it are as small as the distance, and so is the defect; down
  // to where both are rounding.
  Eigen::Vector3d factor = moments.ldlt().solve(defect);
  if (!(factor.norm() < 0.1))
    factor = {1 / moments(0, 0) - 1, 0, 0};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Complex w = vertices[i] - z;
    lambda[i] *= 1 + factor[0] + factor[1] * w.real() + factor[2] * w.imag();
  }
}

// sets negative values of coordinates at z to zero, and restores what that spoils by small changes
// of all others. The coordinates are positive, so their approximations are hardly below zero; where
// none is, nothing changes.
inline void clamp_negative_values(const std::vector<Complex>& vertices, const Complex& z,
                                  double* lambda) {
  double excess = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (lambda[i] < 0) {
      excess -= lambda[i];
      lambda[i] = 0;
    }
  if (excess >= std::numeric_limits<double>::epsilon())
    rescale_affinely(vertices, z, lambda);
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CLAMP_NEGATIVE_VALUES_H
