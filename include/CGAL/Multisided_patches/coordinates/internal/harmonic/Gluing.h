// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_GLUING_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_GLUING_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Block_cholesky.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Interface.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Vertex_block.h>

#include <CGAL/Multisided_patches/errors.h>

#include <algorithm>
#include <array>
#include <limits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// Solves the least-squares problem of all interfaces.
//
// The bases of the cells are ill-conditioned (a power series on part of a disc), so first each gets
// one that is orthonormal on its interfaces. With it the diagonal blocks of the normal equations
// are nearly unit matrices, the equations are well-conditioned, and one step of iterative
// refinement makes up for having squared the condition number.
template <typename ConcurrencyTag>
class Gluing {
public:
  // `equations` of the interfaces of `sizes.size()` cells with that many unknowns each
  Gluing(const std::vector<Interface>& interfaces, std::vector<Interface_equations> equations,
         std::vector<Index> sizes)
      : interfaces_(interfaces), equations_(std::move(equations)), sizes_(std::move(sizes)),
        sides_of_(sizes_.size()), triangular_(sizes_.size()), grams_(sizes_.size()),
        penalties_(sizes_.size()), factorization_(sizes_) {
    for (std::size_t f = 0; f < interfaces_.size(); ++f)
      for (const std::size_t i : {0, 1})
        sides_of_[interfaces_[f].cell[i]].push_back({f, i});
    for_each_index<ConcurrencyTag>(
        sizes_.size(), [&](std::size_t c) { orthonormalize_cell(c); }, 1);
    factorize();
    products_.resize(equations_.size());
    for_each_index<ConcurrencyTag>(
        equations_.size(), [&](std::size_t f) { multiply_right_hand_sides(f); }, 16);
  }

  // the coefficients of every cell, to about `accuracy`, the unit being that of the values on the
  // interfaces
  std::vector<Cell_coefficients> solve(const Vertex_blocking& blocking, double accuracy) const {
    std::vector<std::vector<Matrix>> x(blocking.size());
    // How far rounding spoils the result is seen in the first block, unless there are bad cells.
    const bool has_penalties = std::any_of(penalties_.begin(), penalties_.end(),
                                           [](const Matrix& p) { return p.size() > 0; });
    const bool refine =
        solve_block(blocking, 0, true, accuracy, x[0]) > 0.1 * accuracy || has_penalties;
    for_each_index<ConcurrencyTag>(
        blocking.size() - 1,
        [&](std::size_t k) { solve_block(blocking, k + 1, refine, accuracy, x[k + 1]); }, 1);
    std::vector<Cell_coefficients> result(sizes_.size());
    for (std::size_t k = 0; k < blocking.size(); ++k)
      for (std::size_t c = 0; c < sizes_.size(); ++c)
        if (x[k][c].size() > 0)
          result[c].push_back({k * blocking.width(), std::move(x[k][c])});
    return result;
  }

private:
  struct Side {
    std::size_t interface, index; // 0 or 1
  };

  const Matrix& rows(const Side& s) const { return equations_[s.interface].rows[s.index]; }

  void orthonormalize_cell(std::size_t c) {
    Index height = 0;
    for (const Side& s : sides_of_[c])
      height += rows(s).rows();
    Matrix all(height, sizes_[c]);
    Index row = 0;
    for (const Side& s : sides_of_[c]) {
      all.middleRows(row, rows(s).rows()) = rows(s);
      row += rows(s).rows();
    }
    Orthonormal_basis basis = orthonormalize(std::move(all));
    row = 0;
    for (const Side& s : sides_of_[c]) {
      Matrix& part = equations_[s.interface].rows[s.index];
      part = basis.q.middleRows(row, part.rows());
      row += part.rows();
    }
    triangular_[c] = std::move(basis.r);
    grams_[c] = std::move(basis.gram);
    penalties_[c] = std::move(basis.penalty);
  }

  // A shift keeps the pivots positive where two cells nearly span the same functions. It starts at
  // the level of rounding, and the refinement removes its effect: unlike the penalties, it is no
  // part of the problem.
  void factorize() {
    for (double shift = 1e-15; shift < 1e-3; shift *= 1000) {
      factorization_ = normal_equations(shift);
      if (factorization_.template factorize<ConcurrencyTag>())
        return;
    }
    throw Numerical_error("the equations are singular");
  }

  Block_cholesky normal_equations(double shift) const {
    Block_cholesky result(sizes_);
    for (std::size_t c = 0; c < sizes_.size(); ++c)
      result.add(c, grams_[c] + shift * Matrix::Identity(sizes_[c], sizes_[c]));
    for (std::size_t f = 0; f < interfaces_.size(); ++f) {
      const std::array<std::size_t, 2>& cell = interfaces_[f].cell;
      const std::array<Matrix, 2>& r = equations_[f].rows;
      result.add_transposed_product(1, cell[0], r[0], cell[1], r[1]);
    }
    return result;
  }

  // A^T b
  void multiply_right_hand_sides(std::size_t f) {
    for (const std::size_t i : {0, 1})
      add_transposed_product(1, equations_[f].rows[i], equations_[f].rhs, products_[f][i]);
  }

  // A^T b for a block of vertices; where it is zero, the matrix stays empty
  std::vector<Matrix> right_hand_sides(const Vertex_blocking& blocking, std::size_t block) const {
    std::vector<Matrix> b(sizes_.size());
    for (std::size_t f = 0; f < interfaces_.size(); ++f)
      for (std::size_t k = 0; k < equations_[f].vertices.size(); ++k) {
        const std::size_t vertex = equations_[f].vertices[k];
        if (blocking.block_of(vertex) != block)
          continue;
        for (const std::size_t i : {0, 1}) {
          const std::size_t c = interfaces_[f].cell[i];
          if (b[c].size() == 0)
            b[c].setZero(sizes_[c], static_cast<Index>(blocking.width()));
          b[c].col(static_cast<Index>(vertex - block * blocking.width())) +=
              products_[f][i].col(static_cast<Index>(k));
        }
      }
    return b;
  }

  // A^T (b - A x), with the tall A: no cancellation of large products; less the penalties
  std::vector<Matrix> residual(const Vertex_blocking& blocking, std::size_t block,
                               const std::vector<Matrix>& x) const {
    std::vector<Matrix> r(sizes_.size());
    for (std::size_t c = 0; c < sizes_.size(); ++c)
      if (penalties_[c].size() > 0 && x[c].size() > 0)
        add_product(-1, penalties_[c], x[c], r[c]);
    for (std::size_t f = 0; f < interfaces_.size(); ++f) {
      Matrix defect = right_hand_side(equations_[f], blocking, block);
      for (const std::size_t i : {0, 1})
        if (x[interfaces_[f].cell[i]].size() > 0)
          add_product(-1, equations_[f].rows[i], x[interfaces_[f].cell[i]], defect);
      if (defect.size() > 0)
        for (const std::size_t i : {0, 1})
          add_transposed_product(1, equations_[f].rows[i], defect, r[interfaces_[f].cell[i]]);
    }
    return r;
  }

  // sets x and returns by how much refinement changed it
  double solve_block(const Vertex_blocking& blocking, std::size_t block, bool refine,
                     double accuracy, std::vector<Matrix>& x) const {
    const double negligible = 1e-3 * accuracy;
    x = right_hand_sides(blocking, block);
    factorization_.solve_in_place(x, negligible);
    double first_update = 0, previous = std::numeric_limits<double>::infinity();
    constexpr int max_passes = 6; // one suffices in general
    for (int pass = 0; refine && pass < max_passes; ++pass) {
      std::vector<Matrix> r = residual(blocking, block, x);
      factorization_.solve_in_place(r);
      double update = 0;
      for (const Matrix& m : r)
        if (m.size() > 0)
          update = (std::max)(update, m.cwiseAbs().maxCoeff());
      if (pass == 0)
        first_update = update;
      if (!(update < 0.5 * previous)) // rounding; adding more would not help
        break;
      for (std::size_t c = 0; c < x.size(); ++c)
        if (x[c].size() > 0 && r[c].size() > 0)
          x[c] += r[c];
      // Updates decrease by a constant factor, the first of which was from 1.
      if (update * (std::min)(1., update / (pass == 0 ? 1 : previous)) < 0.01 * accuracy)
        break;
      previous = update;
    }
    for (std::size_t c = 0; c < x.size(); ++c)
      if (x[c].size() > 0)
        solve_upper(triangular_[c], x[c]);
    return first_update;
  }

  const std::vector<Interface>& interfaces_;
  std::vector<Interface_equations> equations_; // of every interface
  std::vector<Index> sizes_;
  std::vector<std::vector<Side>> sides_of_;            // of every cell
  std::vector<Matrix> triangular_, grams_, penalties_; // of the orthonormal basis of every cell
  std::vector<std::array<Matrix, 2>> products_;        // A^T b, for the vertices of every interface
  Block_cholesky factorization_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_GLUING_H
