// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_AFFINE_CORRECTION_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_AFFINE_CORRECTION_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/dense_algebra.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/plane_geometry.h>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// Makes coordinates reproduce affine functions to the last digits. Of all corrections it takes the
// smallest, lambda += M^T (M M^T)^{-1} (b - M lambda), where the rows of M are 1, x_i and y_i, and
// b = (1, x, y): a projection onto coordinates that do, so the error does not grow in the Euclidean
// norm. It is one constant linear map, so derivatives are corrected by the same map, with the
// derivatives of b. It vanishes where lambda is exact, and so keeps the boundary values.
class Affine_correction {
public:
  Affine_correction() = default;
  explicit Affine_correction(const std::vector<Complex>& vertices) : vertices_(vertices) {
    Matrix m(static_cast<Index>(vertices.size()), 3);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      m.row(static_cast<Index>(i)) << 1, vertices[i].real(), vertices[i].imag();
    // With M^T = Q R, the map is Q (Q^T Q)^{-1} R^{-T}: no squared condition number on thin
    // polygons.
    const Orthonormal_basis basis = orthonormalize(std::move(m));
    const Matrix u = *cholesky(basis.gram);
    weights_ = basis.q.transpose();
    solve_upper_transposed(u, weights_);
    solve_upper(u, weights_);
    solve_upper(basis.r, weights_);
    weights_.transposeInPlace();
  }

  // corrects one value, or one partial derivative, of all coordinates of z; b is what sum lambda_i,
  // and sum lambda_i (v_i - z) should be. Differences from z keep the digits that the position of a
  // thin polygon in the plane would cost.
  template <typename Real>
  void operator()(const std::complex<Real>& z, const std::array<Real, 3>& b, Real* lambda) const {
    std::array<Real, 3> defect = b;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      defect[0] -= lambda[i];
      defect[1] -= lambda[i] * (vertices_[i].real() - z.real());
      defect[2] -= lambda[i] * (vertices_[i].imag() - z.imag());
    }
    defect[1] += z.real() * defect[0];
    defect[2] += z.imag() * defect[0];
    const double* w = weights_.data();
    for (std::size_t i = 0; i < vertices_.size(); ++i, w += 3)
      lambda[i] += defect[0] * w[0] + defect[1] * w[1] + defect[2] * w[2];
  }

private:
  std::vector<Complex> vertices_;
  Matrix weights_; // one row a vertex
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_AFFINE_CORRECTION_H
