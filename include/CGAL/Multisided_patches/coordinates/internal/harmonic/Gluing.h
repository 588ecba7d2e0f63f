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
// are nearly unit matrices, and the equations are well-conditioned. Where having squared the
// condition number matters all the same, one step of iterative refinement makes up for it; as that
// takes longer than all else, it is first estimated whether it does.
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
  std::vector<Cell_coefficients> solve(const Vertex_blocking& blocking, double accuracy) {
    std::vector<std::vector<Matrix>> x(blocking.size());
    x[0] = right_hand_sides(blocking, 0);
    rounding_ = solve_with_estimate(x[0]);
    if (!(rounding_ < 0.1 * accuracy))
      rounding_ = measure_rounding();
    const bool needs_refinement = !(rounding_ < 0.1 * accuracy);
    std::vector<double> left(blocking.size());
    for_each_index<ConcurrencyTag>(
        blocking.size(),
        [&](std::size_t k) {
          if (k > 0)
            x[k] = right_hand_sides(blocking, k);
          left[k] = solve_block(blocking, k, needs_refinement, accuracy, x[k]);
        },
        1);
    if (needs_refinement)
      rounding_ = *std::max_element(left.begin(), left.end());
    std::vector<Cell_coefficients> result(sizes_.size());
    for (std::size_t k = 0; k < blocking.size(); ++k)
      for (std::size_t c = 0; c < sizes_.size(); ++c)
        if (x[k][c].size() > 0)
          result[c].push_back({k * blocking.width(), std::move(x[k][c])});
    return result;
  }

  // how far rounding may have spoilt the values of what solve() returned, where the jumps at the
  // interfaces need not show it
  double rounding() const { return rounding_; }

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

  // A^T (b - A x), with the tall A: no cancellation of large products; less the penalties. An empty
  // matrix right_hand_side(f) stands for zero.
  template <typename Right_hand_side>
  std::vector<Matrix> residual(const Right_hand_side& right_hand_side,
                               const std::vector<Matrix>& x) const {
    std::vector<Matrix> r(sizes_.size());
    for (std::size_t c = 0; c < sizes_.size(); ++c)
      if (penalties_[c].size() > 0 && x[c].size() > 0)
        add_product(-1, penalties_[c], x[c], r[c]);
    for (std::size_t f = 0; f < interfaces_.size(); ++f) {
      Matrix defect = right_hand_side(f);
      for (const std::size_t i : {0, 1})
        if (x[interfaces_[f].cell[i]].size() > 0)
          add_product(-1, equations_[f].rows[i], x[interfaces_[f].cell[i]], defect);
      if (defect.size() > 0)
        for (const std::size_t i : {0, 1})
          add_transposed_product(1, equations_[f].rows[i], defect, r[interfaces_[f].cell[i]]);
    }
    return r;
  }

  // replaces x by the solution, and returns a bound, in experience, of what measure_rounding()
  // returns: rounding is like random right-hand sides of its size, and these are solved for along
  // with the others
  double solve_with_estimate(std::vector<Matrix>& x) const {
    constexpr double size = 1e-14; // 1e-16 to 8e-15 were measured
    constexpr Index more = Vertex_blocking::lanes;
    Index width = 0;
    for (const Matrix& m : x)
      width = (std::max)(width, m.cols());
    for (std::size_t c = 0; c < sizes_.size(); ++c) {
      Matrix wider = Matrix::Zero(sizes_[c], width + more);
      if (x[c].size() > 0)
        wider.leftCols(width) = x[c];
      for (Index k = 0; k < sizes_[c]; ++k)
        for (Index j = 0; j < more; ++j)
          wider(k, width + j) = size * random_sign(1000 * c + static_cast<std::size_t>(k), j);
      x[c] = std::move(wider);
    }
    factorization_.solve_in_place(x);
    double largest = 0;
    for (Matrix& m : x) {
      if (!m.allFinite())
        return std::numeric_limits<double>::infinity();
      largest = (std::max)(largest, m.rightCols(more).cwiseAbs().maxCoeff());
      m = m.leftCols(width).eval();
    }
    return largest;
  }

  // how much refinement would change the values of functions whose boundary values are 1 and -1 at
  // random at the vertices, so that they are of size 1 everywhere
  double measure_rounding() const {
    const auto signs = [&](std::size_t f) {
      const std::vector<std::size_t>& v = equations_[f].vertices;
      return Matrix::NullaryExpr(static_cast<Index>(v.size()), Vertex_blocking::lanes,
                                 [&](Index k, Index j) { return random_sign(v[k], j); })
          .eval();
    };
    std::vector<Matrix> x(sizes_.size());
    for (std::size_t f = 0; f < interfaces_.size(); ++f)
      for (const std::size_t i : {0, 1})
        add_product(1, products_[f][i], signs(f), x[interfaces_[f].cell[i]]);
    factorization_.solve_in_place(x);
    std::vector<Matrix> update = residual(
        [&](std::size_t f) {
          Matrix b;
          add_product(1, equations_[f].rhs, signs(f), b);
          return b;
        },
        x);
    factorization_.solve_in_place(update);
    double largest = 0;
    for (std::size_t c = 0; c < sizes_.size(); ++c)
      for (const Side& s : sides_of_[c]) {
        Matrix values;
        add_product(1, rows(s), update[c], values);
        if (!values.allFinite())
          return std::numeric_limits<double>::infinity();
        largest = (std::max)(largest, values.cwiseAbs().maxCoeff());
      }
    return largest;
  }

  // replaces the right-hand sides of a block, for the first block its solution, by coefficients;
  // returns what refinement has left to do, or 0 if there was none
  double solve_block(const Vertex_blocking& blocking, std::size_t block, bool needs_refinement,
                     double accuracy, std::vector<Matrix>& x) const {
    const double negligible = 1e-3 * accuracy;
    if (block > 0)
      factorization_.solve_in_place(x, negligible);
    else
      for (Matrix& m : x)
        if (m.size() > 0 && m.cwiseAbs().maxCoeff() <= negligible)
          m.resize(0, 0);
    const double left = needs_refinement ? refine(blocking, block, accuracy, x) : 0;
    for (std::size_t c = 0; c < sizes_.size(); ++c)
      if (x[c].size() > 0)
        solve_upper(triangular_[c], x[c]);
    return left;
  }

  // improves a solution as far as rounding permits, or `accuracy` asks for, and returns about how
  // much further improvement would change it
  double refine(const Vertex_blocking& blocking, std::size_t block, double accuracy,
                std::vector<Matrix>& x) const {
    constexpr int max_passes = 6; // one suffices in general
    // Updates decrease by a constant factor, the first of which was from 1.
    double previous = 1, left = 1;
    for (int pass = 0; pass < max_passes && !(left < 0.01 * accuracy); ++pass) {
      std::vector<Matrix> r = residual(
          [&](std::size_t f) { return right_hand_side(equations_[f], blocking, block); }, x);
      factorization_.solve_in_place(r);
      double update = 0;
      for (const Matrix& m : r)
        if (m.size() > 0)
          update = (std::max)(update, m.cwiseAbs().maxCoeff());
      if (!(pass == 0 || update < 0.5 * previous)) // rounding; adding more would not help
        return 2 * update;
      for (std::size_t c = 0; c < x.size(); ++c)
        if (x[c].size() > 0 && r[c].size() > 0)
          x[c] += r[c];
      left = update * (std::min)(1., update / previous);
      previous = update;
    }
    return left;
  }

  const std::vector<Interface>& interfaces_;
  std::vector<Interface_equations> equations_; // of every interface
  std::vector<Index> sizes_;
  std::vector<std::vector<Side>> sides_of_;            // of every cell
  std::vector<Matrix> triangular_, grams_, penalties_; // of the orthonormal basis of every cell
  std::vector<std::array<Matrix, 2>> products_;        // A^T b, for the vertices of every interface
  Block_cholesky factorization_;
  double rounding_ = 0;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_GLUING_H
