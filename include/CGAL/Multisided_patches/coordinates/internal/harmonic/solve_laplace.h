// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_LAPLACE_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_LAPLACE_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Harmonic_basis.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Gluing.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/triangulate_boundary.h>


namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// A basis, and the largest jump of any of its functions found between neighbouring cells.
struct Solution {
  Harmonic_basis basis;
  double jump = std::numeric_limits<double>::infinity();
};

// The jump of the values across the interfaces, sampled. By the maximum principle, the error of a
// piecewise harmonic function with exact boundary values is bounded by its jumps of value and
// normal derivative; these shrink together.
inline double largest_jump(const Harmonic_basis& basis, const std::vector<Interface>& interfaces,
                           const std::vector<Cell>& cells) {
  std::vector<double> a(basis.stride()), b(basis.stride());
  double jump = 0;
  for (const Interface& face : interfaces)
    for (const Segment& s : face.edges) {
      const double oscillations = finest_resolution(face, cells) * std::abs(s.b - s.a);
      const int samples = static_cast<int>((std::min)(200., (std::max)(6., 1.5 * oscillations)));
      for (int i = 0; i <= samples; ++i) {
        const Complex z = s.a + (double(i) / samples) * (s.b - s.a);
        basis.evaluate<0>(face.cell[0], z, a.data());
        basis.evaluate<0>(face.cell[1], z, b.data());
        for (std::size_t k = 0; k < a.size(); ++k)
          if (!(std::abs(a[k] - b[k]) <= jump)) // NaN counts
            jump = std::abs(a[k] - b[k]);
      }
    }
  return jump;
}

// solves Laplace's equation on the polygon for the hat functions of all vertices. Every cell's
// local solutions converge by the factor tau.
inline Solution solve_laplace(const Boundary& boundary, Bisection_mesh mesh, double tau) {
  const Cover cover = Cover_builder(boundary, tau, mesh).build();
  std::vector<Interface> interfaces = find_interfaces(mesh, cover.cell_of);
  Gluing gluing(interfaces, cover.cells);
  double oversampling = 1;
  do {
    Interface_assembler assembler(cover.cells, boundary.size(), oversampling);
    for (Interface& face : interfaces)
      assembler.assemble(face);
    oversampling *= 1.5;
  } while (!gluing.is_overdetermined());
  Solution result{Harmonic_basis(cover.cells, gluing.solve(), Cell_locator(mesh, cover.cell_of)), 0};
  result.jump = largest_jump(result.basis, interfaces, cover.cells);
  return result;
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_LAPLACE_H
