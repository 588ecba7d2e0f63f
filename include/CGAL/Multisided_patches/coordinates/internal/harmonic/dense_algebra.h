// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_DENSE_ALGEBRA_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_DENSE_ALGEBRA_H

#include <CGAL/Multisided_patches/errors.h>

#include <Eigen/Cholesky>

#include <optional>
#include <utility>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// By rows, so that the columns of right-hand sides, one a vertex of the polygon, are contiguous.
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Index = Eigen::Index;

// The kernels of Eigen that the solver needs. All uses go through these functions, because every
// further combination of operands costs each program that includes them a second to compile.

// c += factor a b; an empty c stands for zero
inline void add_product(double factor, const Matrix& a, const Matrix& b, Matrix& c) {
  if (c.size() == 0)
    c.setZero(a.rows(), b.cols());
  c.noalias() += factor * (a * b);
}

// c += factor a^T b; an empty c stands for zero
inline void add_transposed_product(double factor, const Matrix& a, const Matrix& b, Matrix& c) {
  if (c.size() == 0)
    c.setZero(a.cols(), b.cols());
  c.noalias() += factor * (a.transpose() * b);
}

// adds factor a^T a to the upper triangle of c, and nothing to the rest; an empty c stands for zero
inline void add_gram_matrix(double factor, const Matrix& a, Matrix& c) {
  if (c.size() == 0)
    c.setZero(a.cols(), a.cols());
  c.selfadjointView<Eigen::Upper>().rankUpdate(a.transpose(), factor);
}

// replaces b by u^{-1} b, for an upper triangular u
inline void solve_upper(const Matrix& u, Matrix& b) {
  u.triangularView<Eigen::Upper>().solveInPlace(b);
}

// replaces b by u^{-T} b
inline void solve_upper_transposed(const Matrix& u, Matrix& b) {
  u.transpose().triangularView<Eigen::Lower>().solveInPlace(b);
}

// replaces a by a u^{-1}
inline void solve_upper_from_right(const Matrix& u, Matrix& a) {
  u.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(a);
}

// the upper triangular u with u^T u = a, if a is positive definite; of a, only the upper triangle
// counts
inline std::optional<Matrix> cholesky(const Matrix& a) {
  const Eigen::LLT<Matrix, Eigen::Upper> factorization(a);
  if (factorization.info() != Eigen::Success)
    return std::nullopt;
  return Matrix(factorization.matrixU());
}

// An orthonormal basis q of the columns of a matrix a = q r, but for a harmless rest.
struct Orthonormal_basis {
  Matrix q, r;
  // q^T q + penalty: within 1/2 of the unit matrix, which q^T q need not be
  Matrix gram;
  // What makes up for columns that depend on each other up to rounding: coefficients c of q are to
  // be found with c^T penalty c in mind. Empty if there is none.
  Matrix penalty;
};

// whether no column comes close to the span of those before it, from the Cholesky factor of the
// Gram matrix; what is closer is lost in rounding there
inline bool is_well_conditioned(const Matrix& u) {
  constexpr double threshold = 1e-6;
  for (Index j = 0; j < u.cols(); ++j)
    if (!(u(j, j) > threshold * u.col(j).head(j + 1).norm()))
      return false;
  return true;
}

// the Cholesky factor of a Gram matrix of unit columns, with a shift as large as necessary
inline Matrix shifted_cholesky(const Matrix& gram) {
  const Matrix unit = Matrix::Identity(gram.rows(), gram.cols());
  for (double shift = 1e-15 * static_cast<double>(gram.cols()); shift < 1; shift *= 100)
    if (std::optional<Matrix> u = cholesky(gram + shift * unit))
      return std::move(*u);
  throw Numerical_error("the functions of a cell depend on each other");
}

// a matrix of unit columns with a multiple of the unit matrix below: no combination of the columns
// is small any more unless its coefficients are
inline Matrix with_penalty_rows(const Matrix& a) {
  constexpr double weight = 1e-14;
  Matrix result(a.rows() + a.cols(), a.cols());
  result << a, weight * Matrix::Identity(a.cols(), a.cols());
  return result;
}

// orthonormalizes the columns of a matrix with at least as many rows.
//
// Cholesky factorizations of Gram matrices, repeated: each pass squares the defect of
// orthogonality, and all of it is matrix products. Columns that are dependent up to rounding get
// penalty rows, and a shift lets their first passes through. Fukaya et al., "Shifted Cholesky QR
// for computing the QR factorization of ill-conditioned matrices", SIAM J. Sci. Comput. 42 (2020).
inline Orthonormal_basis orthonormalize(Matrix a) {
  constexpr int max_passes = 6;
  const Index rows = a.rows(), columns = a.cols();
  if (!a.allFinite())
    throw Numerical_error("a basis function overflows");
  Orthonormal_basis result;
  Eigen::VectorXd norms(columns);
  for (Index j = 0; j < columns; ++j) {
    const double norm = a.col(j).stableNorm();
    norms[j] = norm > 0 ? norm : 1;
    a.col(j) /= norms[j];
  }
  for (int pass = 0;; ++pass) {
    result.gram.resize(0, 0);
    add_gram_matrix(1, a, result.gram);
    result.gram = result.gram.selfadjointView<Eigen::Upper>().toDenseMatrix();
    if (pass > 0 && (result.gram - Matrix::Identity(columns, columns)).norm() < 0.5)
      break;
    if (pass == max_passes)
      throw Numerical_error("the functions of a cell depend on each other");
    std::optional<Matrix> u = cholesky(result.gram);
    if (pass == 0 && !(u && is_well_conditioned(*u))) {
      a = with_penalty_rows(a);
      u.reset(); // the penalty is below the rounding of the Gram matrix
    }
    const Matrix factor = u ? std::move(*u) : shifted_cholesky(result.gram);
    solve_upper_from_right(factor, a);
    if (pass == 0) {
      result.r = factor * norms.asDiagonal();
    } else {
      Matrix product;
      add_product(1, factor, result.r, product);
      result.r = std::move(product);
    }
  }
  if (a.rows() > rows) {
    const Matrix penalty_rows = a.bottomRows(a.rows() - rows);
    add_transposed_product(1, penalty_rows, penalty_rows, result.penalty);
    a.conservativeResize(rows, Eigen::NoChange);
  }
  result.q = std::move(a);
  return result;
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_DENSE_ALGEBRA_H
