// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Affine_correction.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Block_cholesky.h>

#include <cmath>
#include <random>

using namespace CGAL::Multisided_patches::internal::harmonic;
using CGAL::Sequential_tag;

namespace {

Matrix random_matrix(Index rows, Index columns, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Matrix::NullaryExpr(rows, columns, [&] { return uniform(engine); });
}

// the powers 1, t, t^2, ... at points of [0,1]: columns that are more and more alike
Matrix powers(Index rows, Index columns) {
  return Matrix::NullaryExpr(rows, columns, [&](Index i, Index j) {
    return std::pow(double(i) / double(rows - 1), double(j));
  });
}

void check_orthonormal_basis(const Matrix& a) {
  const Orthonormal_basis basis = orthonormalize(a);
  const Matrix unit = Matrix::Identity(a.cols(), a.cols());
  CHECK((basis.gram - unit).norm() < 0.5);
  const Matrix gram = basis.q.transpose() * basis.q;
  CHECK((basis.penalty.size() == 0 ? gram : Matrix(gram + basis.penalty)).isApprox(basis.gram));
  for (Index j = 0; j < a.cols(); ++j)
    CHECK((basis.q * basis.r.col(j) - a.col(j)).norm() <= 1e-13 * a.col(j).norm());
}

} // namespace

// Small sizes, and some that are larger than what a kernel does at a time.
TEST_CASE("The matrix kernels do what their formulas say", "[harmonic]") {
  std::vector<Index> sizes;
  for (Index n = 1; n <= 14; ++n)
    sizes.push_back(n);
  sizes.insert(sizes.end(), {25, 300});
  for (const Index n : sizes)
    for (const Index m : {1, 2, 3, 4, 7, 8, 11, 12, 13, 24, 31}) {
      INFO(n << " by " << m);
      const Matrix a = random_matrix(n, m, 1), b = random_matrix(m, n, 2),
                   c = random_matrix(n, n, 3), d = random_matrix(n, m, 4);
      Matrix sum = c, transposed;
      add_product(0.5, a, b, sum);
      CHECK((sum - (c + 0.5 * (a * b))).norm() <= 1e-14 * double(n * m));
      add_transposed_product(-2, a, d, transposed);
      CHECK((transposed + 2 * (a.transpose() * d)).norm() <= 1e-14 * double(n * m));
      Matrix gram = Matrix::Identity(m, m);
      add_gram_matrix(1, a, gram);
      const Matrix expected = Matrix::Identity(m, m) + a.transpose() * a;
      const Matrix upper = (gram - expected).triangularView<Eigen::Upper>();
      CHECK(upper.norm() <= 1e-14 * double(n * m));

      const Matrix u = *cholesky(expected);
      CHECK((u.transpose() * u - expected).norm() <= 1e-14 * expected.norm());
      Matrix x = b, y = b, z = a;
      solve_upper(u, x);
      CHECK((u * x - b).norm() <= 1e-14 * double(n * m));
      solve_upper_transposed(u, y);
      CHECK((u.transpose() * y - b).norm() <= 1e-14 * double(n * m));
      solve_upper_from_right(u, z);
      CHECK((z * u - a).norm() <= 1e-14 * double(n * m));
    }
  CHECK_FALSE(cholesky(-Matrix::Identity(3, 3)));
}

TEST_CASE("A matrix is the product of its orthonormal basis and a triangular one", "[harmonic]") {
  check_orthonormal_basis(random_matrix(50, 20, 1));
  check_orthonormal_basis(powers(100, 8));
  CHECK(orthonormalize(powers(100, 8)).penalty.size() == 0);
}

TEST_CASE("Columns that depend on each other get penalties instead of huge coefficients",
          "[harmonic]") {
  Matrix repeated = random_matrix(60, 20, 2);
  repeated.col(7) = 3 * repeated.col(2) - repeated.col(5);
  Matrix zero = random_matrix(60, 20, 3);
  zero.col(4).setZero();
  Matrix tiny = random_matrix(60, 20, 4);
  tiny.col(4) *= 1e-200; // its square underflows
  for (const Matrix& a : {powers(200, 40), repeated, zero, tiny}) {
    check_orthonormal_basis(a);
    const Orthonormal_basis basis = orthonormalize(a);
    for (Index j = 0; j < a.cols(); ++j)
      CHECK(std::abs(basis.r(j, j)) >= 1e-15 * a.col(j).norm());
  }
  CHECK(orthonormalize(powers(200, 40)).penalty.size() > 0);
  CHECK_THROWS_AS(orthonormalize(Matrix::Constant(3, 2, std::nan(""))),
                  CGAL::Multisided_patches::Numerical_error);
}

TEST_CASE("Block matrices are factorized as if they were one", "[harmonic]") {
  const std::vector<Index> sizes{3, 1, 4, 2, 5};
  std::vector<Index> first{0};
  for (const Index size : sizes)
    first.push_back(first.back() + size);
  const Index n = first.back();
  Matrix dense = 4 * Matrix::Identity(n, n);
  Block_cholesky blocks(sizes);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    blocks.add(i, 4 * Matrix::Identity(sizes[i], sizes[i]));
    const std::size_t j = (i + 1) % sizes.size(); // a ring
    const Matrix a = random_matrix(2, sizes[i], 10 + unsigned(i)),
                 b = random_matrix(2, sizes[j], 20 + unsigned(i));
    blocks.add_transposed_product(0.3, i, a, j, b);
    dense.block(first[i], first[j], sizes[i], sizes[j]) += 0.3 * a.transpose() * b;
    dense.block(first[j], first[i], sizes[j], sizes[i]) += 0.3 * b.transpose() * a;
  }
  REQUIRE(blocks.factorize<Sequential_tag>());
  std::vector<Matrix> x(sizes.size());
  x[2] = random_matrix(sizes[2], 3, 5); // the others are zero
  Matrix right_hand_side = Matrix::Zero(n, 3);
  right_hand_side.middleRows(first[2], sizes[2]) = x[2];
  blocks.solve_in_place(x);
  Matrix solution(n, 3);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    solution.middleRows(first[i], sizes[i]) = x[i];
  CHECK((dense * solution - right_hand_side).norm() < 1e-13);
}

TEST_CASE("A block matrix that is not positive definite is found out", "[harmonic]") {
  Block_cholesky blocks({2, 2});
  blocks.add(0, Matrix::Identity(2, 2));
  blocks.add(1, Matrix::Identity(2, 2));
  blocks.add_transposed_product(2, 0, Matrix::Identity(2, 2), 1, Matrix::Identity(2, 2));
  CHECK_FALSE(blocks.factorize<Sequential_tag>());
}

// Across a sliver points are reproduced to full precision, wherever it lies and however it is
// turned. What the sum may lose is rounding times the weights of the correction, which are as large
// as 1 / width.
TEST_CASE("Linear functions are restored on slivers in all directions and places", "[harmonic]") {
  const double width = 1e-6;
  const Complex along(0.6, 0.8), across(-0.8, 0.6);
  for (const Complex& place : {Complex(0), Complex(0.3, -0.4), Complex(1, 1)}) {
    std::vector<Complex> vertices;
    for (const double t : {-0.5, 0.1, 0.5})
      vertices.push_back(place + t * along - width * across);
    for (const double t : {0.5, -0.2, -0.5})
      vertices.push_back(place + t * along + width * across);
    std::vector<double> lambda{0.1, 0.2, 0.3, 0.1, 0.15, 0.16};
    const Complex z = place + 0.05 * along + 0.3 * width * across;
    const Affine_correction correction(vertices);
    correction(z, std::array<double, 3>{1, 0, 0}, lambda.data());
    double sum = -1, offset = 0;
    for (std::size_t i = 0; i < lambda.size(); ++i) {
      sum += lambda[i];
      offset += lambda[i] * dot(vertices[i] - z, across);
    }
    CHECK(std::abs(sum) < 1e-16 / width);
    CHECK(std::abs(offset) < 3e-16);
  }
}
