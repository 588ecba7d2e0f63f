// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_LAPLACE_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_LAPLACE_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Gluing.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Harmonic_basis.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/triangulate_boundary.h>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// A basis, and an estimate of the largest error of any of its functions.
struct Solution {
  Harmonic_basis basis;
  double error;
};

// The jumps across the interfaces, between the points where they were made small: of the values,
// and of the normal derivatives in units of the oscillations of the bases. By Green's
// representation formula they bound the error of a piecewise harmonic function with exact boundary
// values.
template <typename ConcurrencyTag>
double largest_jump(const Interface_assembler& assembler, const std::vector<Interface>& interfaces,
                    const Vertex_blocking& blocking,
                    const std::vector<Cell_coefficients>& coefficients) {
  std::vector<double> jumps(interfaces.size());
  for_each_index<ConcurrencyTag>(
      interfaces.size(),
      [&](std::size_t f) {
        const Interface_equations equations =
            assembler.assemble(interfaces[f], Interface_assembler::Points::between);
        std::map<std::size_t, Matrix> defects; // by block of vertices
        for (const std::size_t vertex : equations.vertices) {
          const std::size_t block = blocking.block_of(vertex);
          defects[block] = right_hand_side(equations, blocking, block);
        }
        for (const std::size_t i : {0, 1})
          for (const Vertex_block& b : coefficients[interfaces[f].cell[i]])
            add_product(-1, equations.rows[i], b.coefficients, defects[blocking.block_of(b.first)]);
        for (const auto& defect : defects) {
          const double jump = defect.second.cwiseAbs().maxCoeff();
          jumps[f] = defect.second.allFinite() ? (std::max)(jumps[f], jump)
                                               : std::numeric_limits<double>::infinity();
        }
      },
      16);
  return jumps.empty() ? 0 : *std::max_element(jumps.begin(), jumps.end());
}

// The error from the largest jump. A factor of 4 was on the safe side on all shapes without fine
// detail; where the cells shrink towards one, jumps on all scales can add up.
inline double error_estimate(double jump, const std::vector<Interface>& interfaces) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (const Interface& face : interfaces)
    for (const Segment& s : face.edges) {
      shortest = (std::min)(shortest, std::abs(s.b - s.a));
      longest = (std::max)(longest, std::abs(s.b - s.a));
    }
  return (std::max)(4., 0.5 * std::log2(longest / shortest)) * jump;
}

// solves Laplace's equation on the polygon for the hat functions of all vertices. Every cell's
// local solutions converge by the factor tau; the result is meant to have errors of `accuracy`.
template <typename ConcurrencyTag>
Solution solve_laplace(const Boundary& boundary, Bisection_mesh mesh, double tau, double accuracy) {
  Cover cover = Cover_builder(boundary, tau, mesh).build();
  const std::vector<Interface> interfaces = find_interfaces(mesh, cover.cell_of);
  const Interface_assembler assembler(cover.cells, interfaces);
  std::vector<Interface_equations> equations(interfaces.size());
  for_each_index<ConcurrencyTag>(
      interfaces.size(),
      [&](std::size_t f) {
        equations[f] =
            assembler.assemble(interfaces[f], Interface_assembler::Points::gauss_legendre);
      },
      16);
  std::vector<Index> sizes;
  for (const Cell& cell : cover.cells)
    sizes.push_back(size(cell));
  const Vertex_blocking blocking(boundary.size());
  std::vector<Cell_coefficients> coefficients =
      Gluing<ConcurrencyTag>(interfaces, std::move(equations), std::move(sizes))
          .solve(blocking, accuracy);
  const double jump = largest_jump<ConcurrencyTag>(assembler, interfaces, blocking, coefficients);
  return {Harmonic_basis(std::move(cover.cells), std::move(coefficients), boundary.size(),
                         Cell_locator(mesh, cover.cell_of)),
          error_estimate(jump, interfaces)};
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_LAPLACE_H
