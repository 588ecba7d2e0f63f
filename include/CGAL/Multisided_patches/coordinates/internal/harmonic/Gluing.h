// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_GLUING_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_GLUING_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Block_cholesky.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Interface.h>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// Solves the least-squares problem of all interfaces.
//
// The bases of the cells are ill-conditioned (a power series on part of a disc), so first each gets
// one that is orthonormal on its interfaces: the QR factorization of all rows of a cell. With it
// the diagonal blocks of the normal equations are unit matrices, the equations are
// well-conditioned, and one step of iterative refinement makes up for having squared the condition
// number.
class Gluing {
public:
  // `interfaces` are overwritten
  Gluing(std::vector<Interface>& interfaces, const std::vector<Cell>& cells)
      : interfaces_(interfaces), triangular_(cells.size()) {
    for (const Cell& cell : cells)
      sizes_.push_back(static_cast<std::size_t>(size(cell)));
  }

  // whether every cell has at least as many equations as unknowns
  bool is_overdetermined() const {
    for (std::size_t c = 0; c < sizes_.size(); ++c)
      if (height(c) < sizes_[c])
        return false;
    return true;
  }

  // the coefficients of every cell; one column a vertex
  std::vector<Matrix> solve() {
    for (std::size_t c = 0; c < sizes_.size(); ++c)
      orthonormalize_cell(c);
    Block_cholesky factorization = normal_equations();
    factorization.factorize();
    std::vector<Matrix> x;
    for (const std::size_t size : sizes_)
      x.emplace_back(size, interfaces_.front().rhs.columns());
    constexpr int max_passes = 4; // two suffice in general
    for (int pass = 0; pass < max_passes; ++pass) {
      std::vector<Matrix> r = residual(x);
      factorization.solve_in_place(r);
      double update = 0;
      for (std::size_t c = 0; c < x.size(); ++c) {
        x[c] += r[c];
        update = (std::max)(update, r[c].max_abs());
      }
      if (update < 1e-7) // and the next is its square
        break;
    }
    for (std::size_t c = 0; c < x.size(); ++c)
      triangular_[c].solve(x[c]);
    return x;
  }

private:
  std::size_t height(std::size_t c) const {
    std::size_t sum = 0;
    for_each_part(c, [&](const Matrix& part) { sum += part.rows(); });
    return sum;
  }

  // all rows of a cell, in the order of the interfaces
  Matrix stack_rows(std::size_t c) const {
    Matrix all(height(c), sizes_[c]);
    std::size_t row = 0;
    for_each_part(c, [&](const Matrix& part) {
      for (std::size_t j = 0; j < sizes_[c]; ++j)
        std::copy_n(part.column(j), part.rows(), all.column(j) + row);
      row += part.rows();
    });
    return all;
  }

  void orthonormalize_cell(std::size_t c) {
    Matrix all = stack_rows(c);
    triangular_[c] = orthonormalize(all);
    std::size_t row = 0;
    for_each_part(c, [&](Matrix& part) {
      for (std::size_t j = 0; j < sizes_[c]; ++j)
        std::copy_n(all.column(j) + row, part.rows(), part.column(j));
      row += part.rows();
    });
  }

  template <typename Function>
  void for_each_part(std::size_t c, const Function& function) const {
    for (Interface& face : interfaces_)
      for (const int i : {0, 1})
        if (face.cell[i] == c)
          function(face.rows[i]);
  }

  Block_cholesky normal_equations() const {
    Block_cholesky equations(sizes_);
    for (std::size_t c = 0; c < sizes_.size(); ++c) {
      // The shift keeps the pivots positive if two cells nearly span the same functions; it is at
      // the level of rounding, and the refinement removes its effect.
      Matrix unit(sizes_[c], sizes_[c]);
      for (std::size_t i = 0; i < sizes_[c]; ++i)
        unit(i, i) = 1 + 1e-13;
      equations.add(c, c, unit);
    }
    for (const Interface& face : interfaces_) {
      Matrix block(face.rows[0].columns(), face.rows[1].columns());
      add_transposed_product(1, face.rows[0], face.rows[1], block);
      equations.add(face.cell[0], face.cell[1], block);
    }
    return equations;
  }

  // A^T (b - A x), with the tall A: no cancellation of large products
  std::vector<Matrix> residual(const std::vector<Matrix>& x) const {
    std::vector<Matrix> r;
    for (const std::size_t size : sizes_)
      r.emplace_back(size, interfaces_.front().rhs.columns());
    for (const Interface& face : interfaces_) {
      Matrix defect = face.rhs;
      for (const int i : {0, 1})
        add_product(-1, face.rows[i], x[face.cell[i]], defect);
      for (const int i : {0, 1})
        add_transposed_product(1, face.rows[i], defect, r[face.cell[i]]);
    }
    return r;
  }

  std::vector<Interface>& interfaces_;
  std::vector<Upper_triangular> triangular_; // the R of the QR factorizations
  std::vector<std::size_t> sizes_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_GLUING_H
