// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BLOCK_CHOLESKY_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BLOCK_CHOLESKY_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/dense_algebra.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

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
  explicit Block_cholesky(std::vector<Index> sizes)
      : sizes_(std::move(sizes)), degrees_(sizes_.size(), 0), neighbors_(sizes_.size()) {}

  // adds a^T b to the block (i,j) and, by symmetry, its transpose to (j,i)
  void add_transposed_product(double factor, std::size_t i, const Matrix& a, std::size_t j,
                              const Matrix& b) {
    Matrix& m = block(i, j);
    if (i <= j)
      harmonic::add_transposed_product(factor, a, b, m);
    else
      harmonic::add_transposed_product(factor, b, a, m);
  }
  void add(std::size_t i, const Matrix& diagonal_block) { block(i, i) += diagonal_block; }

  // whether the matrix was positive definite; if not, the object is of no further use
  template <typename ConcurrencyTag>
  bool factorize() {
    std::set<std::pair<Index, std::size_t>> remaining; // by degree
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      remaining.insert({degrees_[i], i});
    while (!remaining.empty()) {
      const std::size_t pivot = remaining.begin()->second;
      const std::set<std::size_t> neighbors = neighbors_[pivot];
      remaining.erase({degrees_[pivot], pivot});
      for (const std::size_t i : neighbors)
        remaining.erase({degrees_[i], i});
      if (!eliminate<ConcurrencyTag>(pivot))
        return false;
      for (const std::size_t i : neighbors)
        remaining.insert({degrees_[i], i});
    }
    return true;
  }

  // Replaces b by the solution. An empty matrix stands for a block of zeros; so it does in the
  // solution, for blocks without an entry above `negligible`.
  void solve_in_place(std::vector<Matrix>& b, double negligible = 0) const {
    for (const Row& row : rows_) {
      if (b[row.pivot].size() == 0)
        continue;
      solve_upper_transposed(row.diagonal, b[row.pivot]);
      for (const Entry& entry : row.entries)
        harmonic::add_transposed_product(-1, entry.block, b[row.pivot], b[entry.column]);
    }
    for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
      Matrix& x = b[row->pivot];
      for (const Entry& entry : row->entries)
        if (b[entry.column].size() > 0)
          add_product(-1, entry.block, b[entry.column], x);
      if (x.size() == 0)
        continue;
      solve_upper(row->diagonal, x);
      if (x.cwiseAbs().maxCoeff() <= negligible)
        x.resize(0, 0);
    }
  }

private:
  struct Entry {
    std::size_t column;
    Matrix block;
  };
  struct Row {
    std::size_t pivot;
    Matrix diagonal;
    std::vector<Entry> entries; // right of the diagonal
  };

  // the stored one of the blocks (i,j) and (j,i); a zero one if there was none
  Matrix& block(std::size_t i, std::size_t j) {
    const std::pair<std::size_t, std::size_t> key = std::minmax(i, j);
    Matrix& m = blocks_[key];
    if (m.size() == 0) {
      m.setZero(sizes_[key.first], sizes_[key.second]);
      if (i != j) {
        couple(i, j);
        couple(j, i);
      }
    }
    return m;
  }

  void couple(std::size_t i, std::size_t j) {
    neighbors_[i].insert(j);
    degrees_[i] += sizes_[j];
  }
  void uncouple(std::size_t i, std::size_t j) {
    neighbors_[i].erase(j);
    degrees_[i] -= sizes_[j];
  }

  template <typename ConcurrencyTag>
  bool eliminate(std::size_t pivot) {
    std::optional<Matrix> diagonal = cholesky(blocks_.at({pivot, pivot}));
    if (!diagonal)
      return false;
    Row row{pivot, std::move(*diagonal), {}};
    for (const std::size_t i : neighbors_[pivot]) {
      const auto found = blocks_.find(std::minmax(pivot, i));
      Matrix& m = found->second;
      row.entries.push_back({i, pivot < i ? std::move(m) : Matrix(m.transpose())});
      blocks_.erase(found);
      uncouple(i, pivot);
    }
    blocks_.erase({pivot, pivot});
    subtract_schur_complement<ConcurrencyTag>(row);
    rows_.push_back(std::move(row));
    return true;
  }

  template <typename ConcurrencyTag>
  void subtract_schur_complement(Row& row) {
    std::vector<Entry>& entries = row.entries;
    for_each_index<ConcurrencyTag>(
        entries.size(),
        [&](std::size_t i) { solve_upper_transposed(row.diagonal, entries[i].block); }, 1);
    struct Update {
      const Entry &a, &b;
      Matrix& target;
    };
    std::vector<Update> updates;
    for (std::size_t i = 0; i < entries.size(); ++i)
      for (std::size_t j = i; j < entries.size(); ++j) // by column, ascending
        updates.push_back({entries[i], entries[j], block(entries[i].column, entries[j].column)});
    for_each_index<ConcurrencyTag>(
        updates.size(),
        [&](std::size_t k) {
          const Update& u = updates[k];
          if (&u.a == &u.b)
            add_gram_matrix(-1, u.a.block, u.target);
          else
            harmonic::add_transposed_product(-1, u.a.block, u.b.block, u.target);
        },
        1);
  }

  std::map<std::pair<std::size_t, std::size_t>, Matrix> blocks_; // (i,j) with i <= j, still to do
  std::vector<Index> sizes_;
  std::vector<Index> degrees_; // the number of rows that the elimination of a block couples
  std::vector<std::set<std::size_t>> neighbors_;
  std::vector<Row> rows_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BLOCK_CHOLESKY_H
