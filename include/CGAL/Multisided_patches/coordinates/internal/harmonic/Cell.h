// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CELL_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CELL_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Channel_cell.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Corner_cell.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Interior_cell.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Side_cell.h>

#include <variant>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// A part of the domain with its local solutions: every harmonic function with the right boundary
// values on the cell's own sides is hats + a combination of the basis. The boundary values hold
// exactly, whatever the coefficients are. A further kind of cell is one more alternative here and
// one more Candidate::Kind.
using Cell = std::variant<Corner_cell, Channel_cell, Interior_cell, Side_cell>;

inline int size(const Cell& cell) {
  return std::visit([](const auto& c) { return c.size(); }, cell);
}

inline double resolution(const Cell& cell, const Complex& z) {
  return std::visit([&](const auto& c) { return c.resolution(z); }, cell);
}

template <int Order, typename Real>
void basis(const Cell& cell, const std::complex<Real>& z, Analytic<Order, Real>* f) {
  std::visit([&](const auto& c) { c.template basis<Order>(z, f); }, cell);
}

template <int Order, typename Real>
std::size_t hats(const Cell& cell, const std::complex<Real>& z, Hat_term<Order, Real>* terms) {
  return std::visit([&](const auto& c) { return c.template hats<Order>(z, terms); }, cell);
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CELL_H
