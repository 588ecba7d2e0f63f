// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_MATRIX_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_MATRIX_H

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// A dense matrix in columns, and the few operations that the solver needs, each as a short kernel
// over Eigen's fixed-size arrays. Eigen's own products and factorizations of dynamic size would run
// as fast, but take every program that includes them ten seconds longer to compile.
//
// Columns are padded with zeros to whole lanes, and every operation keeps it so.
class Matrix {
public:
  Matrix() = default;
  // zero
  Matrix(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), stride_(padded(rows)), data_(stride_ * columns, 0.) {}

  static constexpr std::size_t lanes = 4;
  static std::size_t padded(std::size_t length) { return (length + lanes - 1) / lanes * lanes; }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  // the distance of the columns: the number of rows, rounded up
  std::size_t stride() const { return stride_; }

  double* column(std::size_t j) { return data_.data() + j * stride_; }
  const double* column(std::size_t j) const { return data_.data() + j * stride_; }
  double& operator()(std::size_t i, std::size_t j) { return data_[j * stride_ + i]; }
  double operator()(std::size_t i, std::size_t j) const { return data_[j * stride_ + i]; }

  Matrix transposed() const {
    Matrix t(columns_, rows_);
    for (std::size_t j = 0; j < columns_; ++j)
      for (std::size_t i = 0; i < rows_; ++i)
        t(j, i) = (*this)(i, j);
    return t;
  }
  Matrix& operator+=(const Matrix& b) {
    for (std::size_t i = 0; i < data_.size(); ++i)
      data_[i] += b.data_[i];
    return *this;
  }
  double max_abs() const {
    double max = 0;
    for (const double x : data_)
      max = (std::max)(max, std::abs(x));
    return max;
  }

private:
  std::size_t rows_ = 0, columns_ = 0, stride_ = 0;
  std::vector<double> data_;
};

using Lanes = Eigen::Array<double, Matrix::lanes, 1>;

inline Eigen::Map<const Lanes> lanes_at(const double* p) {
  return Eigen::Map<const Lanes>(p);
}
inline Eigen::Map<Lanes> lanes_at(double* p) {
  return Eigen::Map<Lanes>(p);
}

// Four columns of a matrix; the last is repeated where there are no more.
template <typename Double>
using Four_columns = std::array<Double*, 4>;

template <typename Matrix_type>
auto four_columns(Matrix_type& m, std::size_t j) {
  const std::size_t last = m.columns() - 1;
  return std::array{m.column(j), m.column((std::min)(j + 1, last)),
                    m.column((std::min)(j + 2, last)), m.column((std::min)(j + 3, last))};
}

// All lengths are multiples of the number of lanes.

inline double dot(const double* a, const double* b, std::size_t length) {
  Lanes sum = Lanes::Zero();
  for (std::size_t i = 0; i < length; i += Matrix::lanes)
    sum += lanes_at(a + i) * lanes_at(b + i);
  return sum.sum();
}

// the products of one column with four
template <typename Double>
std::array<double, 4> dots(const double* a, const Four_columns<Double>& b, std::size_t length) {
  Lanes s0 = Lanes::Zero(), s1 = s0, s2 = s0, s3 = s0;
  const double *b0 = b[0], *b1 = b[1], *b2 = b[2], *b3 = b[3];
  for (std::size_t i = 0; i < length; i += Matrix::lanes) {
    const Lanes x = lanes_at(a + i);
    s0 += x * lanes_at(b0 + i);
    s1 += x * lanes_at(b1 + i);
    s2 += x * lanes_at(b2 + i);
    s3 += x * lanes_at(b3 + i);
  }
  return {s0.sum(), s1.sum(), s2.sum(), s3.sum()};
}

// y += factor x
inline void add_multiple(double factor, const double* x, double* y, std::size_t length) {
  for (std::size_t i = 0; i < length; i += Matrix::lanes)
    lanes_at(y + i) += factor * lanes_at(x + i);
}

// y += the combination of four columns
inline void add_combination(const std::array<double, 4>& factor,
                            const Four_columns<const double>& x, double* y, std::size_t length) {
  const double *x0 = x[0], *x1 = x[1], *x2 = x[2], *x3 = x[3];
  const double f0 = factor[0], f1 = factor[1], f2 = factor[2], f3 = factor[3];
  for (std::size_t i = 0; i < length; i += Matrix::lanes)
    lanes_at(y + i) += (f0 * lanes_at(x0 + i) + f1 * lanes_at(x1 + i)) +
                       (f2 * lanes_at(x2 + i) + f3 * lanes_at(x3 + i));
}

// c += factor a^T b
inline void add_transposed_product(double factor, const Matrix& a, const Matrix& b, Matrix& c) {
  for (std::size_t j = 0; j < b.columns(); j += 4) {
    const auto four = four_columns(b, j);
    const std::size_t count = (std::min)(b.columns() - j, std::size_t(4));
    for (std::size_t i = 0; i < a.columns(); ++i) {
      const std::array<double, 4> d = dots(a.column(i), four, a.stride());
      for (std::size_t k = 0; k < count; ++k)
        c(i, j + k) += factor * d[k];
    }
  }
}

// c += factor a b
inline void add_product(double factor, const Matrix& a, const Matrix& b, Matrix& c) {
  for (std::size_t k = 0; k < a.columns(); k += 4) {
    const auto four = four_columns(a, k);
    const std::size_t count = (std::min)(a.columns() - k, std::size_t(4));
    for (std::size_t j = 0; j < b.columns(); ++j) {
      std::array<double, 4> f{};
      for (std::size_t i = 0; i < count; ++i)
        f[i] = factor * b(k + i, j);
      add_combination(f, four, c.column(j), a.stride());
    }
  }
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_MATRIX_H
