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

// The jumps across the interfaces, sampled: of the values, and of the normal derivatives in units
// of the oscillations of the bases. By Green's representation formula they bound the error of a
// piecewise harmonic function with exact boundary values.
inline double largest_jump(const Harmonic_basis& basis, const std::vector<Interface>& interfaces,
                           const std::vector<Cell>& cells) {
  const std::size_t stride = basis.stride();
  std::vector<double> a(3 * stride), b(3 * stride);
  double jump = 0;
  for (const Interface& face : interfaces)
    for (const Segment& s : face.edges) {
      const double finest = finest_resolution(face, cells);
      const double oscillations = finest * std::abs(s.b - s.a);
      const int samples = static_cast<int>((std::min)(200., (std::max)(6., 1.5 * oscillations)));
      const Complex normal = Complex(0, -1) * (s.b - s.a) / oscillations;
      for (int i = 0; i <= samples; ++i) {
        const Complex z = s.a + (double(i) / samples) * (s.b - s.a);
        basis.evaluate<1>(face.cell[0], z, a.data());
        basis.evaluate<1>(face.cell[1], z, b.data());
        for (std::size_t k = 0; k < stride; ++k) {
          const double value = std::abs(a[k] - b[k]);
          const Complex gradient(a[k + stride] - b[k + stride],
                                 a[k + 2 * stride] - b[k + 2 * stride]);
          const double largest = (std::max)(value, std::abs(dot(gradient, normal)));
          if (!(largest <= jump)) // NaN counts
            jump = largest;
        }
      }
    }
  return jump;
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
// local solutions converge by the factor tau.
inline Solution solve_laplace(const Boundary& boundary, Bisection_mesh mesh, double tau) {
  const Cover cover = Cover_builder(boundary, tau, mesh).build();
  std::vector<Interface> interfaces = find_interfaces(mesh, cover.cell_of);
  Gluing gluing(interfaces, cover.cells);
  double oversampling = 0.8; // from half to twice as much makes no difference
  do {
    Interface_assembler assembler(cover.cells, boundary.size(), oversampling);
    for (Interface& face : interfaces)
      assembler.assemble(face);
    oversampling *= 1.5;
  } while (!gluing.is_overdetermined());
  Solution result{Harmonic_basis(cover.cells, gluing.solve(), Cell_locator(mesh, cover.cell_of)),
                  0};
  result.error = error_estimate(largest_jump(result.basis, interfaces, cover.cells), interfaces);
  return result;
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_LAPLACE_H
