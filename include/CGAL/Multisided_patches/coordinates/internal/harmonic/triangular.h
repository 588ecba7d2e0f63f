// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULAR_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULAR_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Matrix.h>

#include <CGAL/Multisided_patches/errors.h>

#include <cmath>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// An upper triangular matrix U with positive or negative, but not zero, diagonal.
class Upper_triangular {
public:
  Upper_triangular() = default;
  explicit Upper_triangular(std::size_t size) : strict_(size, size), diagonal_(size, 0.) {}

  std::size_t size() const { return diagonal_.size(); }

  // the part of column j above the diagonal; what is below is zero
  double* above(std::size_t j) { return strict_.column(j); }
  double& diagonal(std::size_t j) { return diagonal_[j]; }

  // replaces b by U^{-T} b
  void solve_transposed(Matrix& b) const {
    for (std::size_t j = 0; j < b.columns(); j += 4) {
      const auto four = four_columns(b, j);
      const std::size_t count = (std::min)(b.columns() - j, std::size_t(4));
      for (std::size_t i = 0; i < size(); ++i) {
        const std::array<double, 4> d = dots(strict_.column(i), four, Matrix::padded(i));
        for (std::size_t k = 0; k < count; ++k)
          four[k][i] = (four[k][i] - d[k]) / diagonal_[i];
      }
    }
  }

  // replaces b by U^{-1} b; an unknown without an equation becomes 0
  void solve(Matrix& b) const {
    for (std::size_t j = 0; j < b.columns(); ++j)
      for (std::size_t i = size(); i-- > 0;) {
        double& x = b(i, j);
        x = diagonal_[i] == 0 ? 0 : x / diagonal_[i];
        add_multiple(-x, strict_.column(i), b.column(j), Matrix::padded(i));
      }
  }

private:
  Matrix strict_;
  std::vector<double> diagonal_;
};

// the U with U^T U = a, of which only the upper triangle is read
inline Upper_triangular cholesky(const Matrix& a) {
  Upper_triangular u(a.rows());
  for (std::size_t j = 0; j < a.rows(); ++j) {
    double* c = u.above(j);
    for (std::size_t i = 0; i < j; ++i)
      c[i] = (a(i, j) - dot(u.above(i), c, Matrix::padded(i))) / u.diagonal(i);
    const double square = a(j, j) - dot(c, c, Matrix::padded(j));
    if (!(square > 0))
      throw Numerical_error("the equations are not positive definite");
    u.diagonal(j) = std::sqrt(square);
  }
  return u;
}

// applies the reflection I - v v^T, |v|^2 = 2, to the columns from `first` on; v starts with
// `first` zeros
inline void reflect(const double* v, std::size_t first, Matrix& a, std::size_t first_column) {
  const std::size_t skip = first / Matrix::lanes * Matrix::lanes, length = a.stride() - skip;
  for (std::size_t j = first_column; j < a.columns(); j += 4) {
    const auto four = four_columns(a, j);
    const std::size_t count = (std::min)(a.columns() - j, std::size_t(4));
    const std::array<double, 4> d =
        dots(v + skip, std::array{four[0] + skip, four[1] + skip, four[2] + skip, four[3] + skip},
             length);
    for (std::size_t k = 0; k < count; ++k)
      add_multiple(-d[k], v + skip, four[k] + skip, length);
  }
}

// replaces a, with at least as many rows as columns, by the Q with orthonormal columns of its QR
// factorization by Householder reflections, and returns R. The columns of Q are orthonormal however
// ill-conditioned a is.
inline Upper_triangular orthonormalize(Matrix& a) {
  Upper_triangular r(a.columns());
  for (std::size_t j = 0; j < a.columns(); ++j) {
    double* v = a.column(j);
    std::copy(v, v + j, r.above(j));
    std::fill(v, v + j, 0.);
    const double norm = std::sqrt(dot(v, v, a.stride()));
    r.diagonal(j) = v[j] > 0 ? -norm : norm;
    v[j] -= r.diagonal(j); // no cancellation, by the choice of the sign
    const double square = dot(v, v, a.stride());
    const double scale = square > 0 ? std::sqrt(2 / square) : 0;
    for (std::size_t i = j; i < a.rows(); ++i)
      v[i] *= scale;
    reflect(v, j, a, j + 1);
  }
  Matrix q(a.rows(), a.columns());
  for (std::size_t j = a.columns(); j-- > 0;) {
    q(j, j) = 1;
    reflect(a.column(j), j, q, j);
  }
  a = std::move(q);
  return r;
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_TRIANGULAR_H
