// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_VERTEX_BLOCK_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_VERTEX_BLOCK_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/dense_algebra.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The coefficients of one cell for some consecutive vertices of the polygon, in the columns; one
// row a basis function. Columns beyond the last vertex are zero.
struct Vertex_block {
  std::size_t first;
  Matrix coefficients;
};

// Of one cell: by ascending vertices. The functions of vertices in no block are negligible there.
using Cell_coefficients = std::vector<Vertex_block>;

// How the vertices are cut into blocks: wide enough for fast matrix products, narrow enough to
// leave out the far away ones.
class Vertex_blocking {
public:
  explicit Vertex_blocking(std::size_t vertices) : vertices_(vertices) {
    const std::size_t blocks = (vertices + max_width - 1) / max_width;
    width_ = (vertices + blocks - 1) / blocks;
    width_ = (width_ + lanes - 1) / lanes * lanes;
  }

  std::size_t width() const { return width_; }
  std::size_t size() const { return (vertices_ + width_ - 1) / width_; }
  std::size_t block_of(std::size_t vertex) const { return vertex / width_; }

  // of the doubles that are added and multiplied at a time
  static constexpr std::size_t lanes = 4;

private:
  static constexpr std::size_t max_width = 32;

  std::size_t vertices_, width_;
};

// 1 or -1: what column j of a few random combinations has for an index i
inline double random_sign(std::size_t i, Index j) {
  std::uint32_t h = static_cast<std::uint32_t>(i) * 0x9e3779b1u + static_cast<std::uint32_t>(j);
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return h >> 31 ? 1 : -1;
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_VERTEX_BLOCK_H
