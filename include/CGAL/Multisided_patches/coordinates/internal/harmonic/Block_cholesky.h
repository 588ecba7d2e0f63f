// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BLOCK_CHOLESKY_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BLOCK_CHOLESKY_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/triangular.h>

#include <map>
#include <set>
#include <utility>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The Cholesky factorization U^T U of a sparse symmetric positive definite matrix of dense blocks,
// with the pivots in the order of minimum degree. A vector, or several at once, is one Matrix a
// block.
class Block_cholesky {
public:
  // `sizes` of the diagonal blocks
  explicit Block_cholesky(const std::vector<std::size_t>& sizes)
      : sizes_(sizes), degrees_(sizes.size(), 0), neighbors_(sizes.size()) {}

  // adds to the block (i,j) and, by symmetry, its transpose to (j,i)
  void add(std::size_t i, std::size_t j, const Matrix& block) {
    Matrix& m = blocks_[std::minmax(i, j)];
    if (m.rows() == 0 && i != j) {
      couple(i, j);
      couple(j, i);
    }
    if (m.rows() == 0)
      m = i <= j ? block : block.transposed();
    else
      m += i <= j ? block : block.transposed();
  }

  void factorize() {
    std::set<std::size_t> remaining;
    for (std::size_t i = 0; i < neighbors_.size(); ++i)
      remaining.insert(i);
    while (!remaining.empty()) {
      const std::size_t pivot =
          *std::min_element(remaining.begin(), remaining.end(), [&](std::size_t i, std::size_t j) {
            return degrees_[i] < degrees_[j];
          });
      remaining.erase(pivot);
      eliminate(pivot);
    }
  }

  // replaces b by the solution
  void solve_in_place(std::vector<Matrix>& b) const {
    for (const Row& row : rows_) {
      row.diagonal.solve_transposed(b[row.pivot]);
      for (const auto& entry : row.blocks)
        add_transposed_product(-1, entry.second, b[row.pivot], b[entry.first]);
    }
    for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
      for (const auto& entry : row->blocks)
        add_product(-1, entry.second, b[entry.first], b[row->pivot]);
      row->diagonal.solve(b[row->pivot]);
    }
  }

private:
  struct Row {
    std::size_t pivot;
    Upper_triangular diagonal;
    std::vector<std::pair<std::size_t, Matrix>> blocks; // with their columns
  };

  void couple(std::size_t i, std::size_t j) {
    neighbors_[i].insert(j);
    degrees_[i] += sizes_[j];
  }
  void uncouple(std::size_t i, std::size_t j) {
    neighbors_[i].erase(j);
    degrees_[i] -= sizes_[j];
  }

  void eliminate(std::size_t pivot) {
    Row row{pivot, cholesky(blocks_.at({pivot, pivot})), {}};
    for (const std::size_t i : neighbors_[pivot]) {
      const auto block = blocks_.find(std::minmax(pivot, i));
      row.blocks.push_back({i, pivot < i ? std::move(block->second) : block->second.transposed()});
      row.diagonal.solve_transposed(row.blocks.back().second);
      blocks_.erase(block);
      uncouple(i, pivot);
    }
    // the Schur complement
    for (std::size_t i = 0; i < row.blocks.size(); ++i)
      for (std::size_t j = i; j < row.blocks.size(); ++j) {
        const Matrix &a = row.blocks[i].second, &b = row.blocks[j].second;
        Matrix update(a.columns(), b.columns());
        add_transposed_product(-1, a, b, update);
        add(row.blocks[i].first, row.blocks[j].first, update);
      }
    rows_.push_back(std::move(row));
  }

  std::map<std::pair<std::size_t, std::size_t>, Matrix> blocks_; // (i,j) with i <= j, still to do
  std::vector<std::size_t> sizes_;
  std::vector<std::size_t> degrees_; // the number of rows that the elimination of a block couples
  std::vector<std::set<std::size_t>> neighbors_;
  std::vector<Row> rows_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BLOCK_CHOLESKY_H
