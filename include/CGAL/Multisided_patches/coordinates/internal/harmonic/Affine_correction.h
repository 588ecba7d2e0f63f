// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_AFFINE_CORRECTION_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_AFFINE_CORRECTION_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/plane_geometry.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/triangular.h>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// Makes coordinates reproduce affine functions to the last digits. Of all corrections it takes the
// smallest, lambda += M^T (M M^T)^{-1} (b - M lambda), where the rows of M are 1, x_i and y_i, and
// b = (1, x, y). It is one constant linear map, so derivatives are corrected by the same map, with
// the derivatives of b. It vanishes where lambda is exact, and so keeps the boundary values.
class Affine_correction {
public:
  Affine_correction() = default;
  explicit Affine_correction(const std::vector<Complex>& vertices) : vertices_(vertices) {
    Matrix q(vertices.size(), 3);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      q(i, 0) = 1;
      q(i, 1) = vertices[i].real();
      q(i, 2) = vertices[i].imag();
    }
    // With M^T = Q R, the map is Q R^{-T}: no squared condition number on thin polygons.
    const Upper_triangular r = orthonormalize(q);
    weights_ = q.transposed();
    r.solve(weights_);
  }

  // corrects one value, or one partial derivative, of all coordinates; b is what sum lambda_i,
  // sum lambda_i x_i and sum lambda_i y_i should be
  void operator()(const std::array<double, 3>& b, double* lambda) const {
    double d0 = b[0], d1 = b[1], d2 = b[2];
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      d0 -= lambda[i];
      d1 -= lambda[i] * vertices_[i].real();
      d2 -= lambda[i] * vertices_[i].imag();
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const double* w = weights_.column(i);
      lambda[i] += d0 * w[0] + d1 * w[1] + d2 * w[2];
    }
  }

private:
  std::vector<Complex> vertices_;
  Matrix weights_; // one column a vertex
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_AFFINE_CORRECTION_H
