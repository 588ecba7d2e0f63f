// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_INTERFACE_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_INTERFACE_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Matrix.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/cover_mesh.h>
#include <CGAL/Multisided_patches/internal/gauss_legendre.h>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The common boundary of two cells: mesh edges, and the equations that glue the local solutions on
// them, |rows[0] c_0 + rows[1] c_1 - rhs| -> min for the coefficients c_i of cell[i]; one column a
// vertex of the polygon.
struct Interface {
  std::array<std::size_t, 2> cell;
  std::vector<Segment> edges;
  std::array<Matrix, 2> rows;
  Matrix rhs;
};

// the interfaces of all pairs of cells, without the equations
inline std::vector<Interface> find_interfaces(const Bisection_mesh& mesh,
                                              const std::vector<std::size_t>& cell_of) {
  std::map<std::array<std::size_t, 2>, std::vector<Segment>> edges;
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const std::size_t n = mesh.triangle(t).neighbor[i];
      if (!mesh.triangle(t).is_leaf() || n == Bisection_mesh::none || cell_of[t] >= cell_of[n])
        continue;
      const Triangle_points z = mesh.corners(t);
      edges[{cell_of[t], cell_of[n]}].push_back({z[(i + 1) % 3], z[(i + 2) % 3]});
    }
  std::vector<Interface> result;
  for (auto& entry : edges)
    result.push_back({entry.first, std::move(entry.second), {}, {}});
  return result;
}

// of the bases of both cells
inline double finest_resolution(const Interface& face, const std::vector<Cell>& cells) {
  return (std::max)(resolution(cells[face.cell[0]]), resolution(cells[face.cell[1]]));
}

// Sets up the equations of interfaces: at Gauss-Legendre points of every edge, the values and the
// normal derivatives of both sides agree; the derivatives are in units of the wavelength of the
// bases. There are no equations on the boundary of the domain: the cells satisfy them exactly.
class Interface_assembler {
public:
  Interface_assembler(const std::vector<Cell>& cells, std::size_t number_of_vertices,
                      double oversampling)
      : cells_(cells), number_of_vertices_(number_of_vertices), oversampling_(oversampling) {}

  void assemble(Interface& face) {
    const double finest = finest_resolution(face, cells_);
    std::size_t points = 0;
    for (const Segment& s : face.edges)
      points += number_of_points(s, face);
    for (const int i : {0, 1})
      face.rows[i] = Matrix(2 * points, size(cells_[face.cell[i]]));
    face.rhs = Matrix(2 * points, number_of_vertices_);
    std::size_t row = 0;
    for (const Segment& s : face.edges) {
      const Complex d = s.b - s.a, normal = Complex(0, -1) * d / std::abs(d);
      for (const Quadrature_node& node : nodes(number_of_points(s, face))) {
        const Complex z = s.a + node.t * d;
        add_equations(face, row, 0, z, normal / finest);
        add_equations(face, row, 1, z, normal / finest);
        row += 2;
      }
    }
  }

private:
  // Enough for the oscillations, but not many times the number of unknowns: in a sharp corner, the
  // high powers live near the outer end of an edge only, where the Gauss points accumulate.
  int number_of_points(const Segment& s, const Interface& face) const {
    const int unknowns = size(cells_[face.cell[0]]) + size(cells_[face.cell[1]]);
    const double oscillations = std::abs(s.b - s.a) * finest_resolution(face, cells_);
    return (std::max)(
        3, static_cast<int>(std::ceil(oversampling_ * (std::min)(oscillations, 2. * unknowns))));
  }

  const std::vector<Quadrature_node>& nodes(int m) {
    std::vector<Quadrature_node>& rule = rules_[m];
    if (rule.empty())
      rule = gauss_legendre(m);
    return rule;
  }

  // the value and the scaled normal derivative on one side, with opposite signs on the two
  void add_equations(Interface& face, std::size_t row, int side, const Complex& z,
                     const Complex& normal) {
    const Cell& cell = cells_[face.cell[side]];
    const double sign = side == 0 ? 1 : -1;
    // d_n Re F = Re (F' n)
    basis_.resize(size(cell));
    basis<1>(cell, z, basis_.data());
    for (std::size_t j = 0; j < basis_.size(); ++j) {
      face.rows[side](row, j) = sign * basis_[j][0].real();
      face.rows[side](row + 1, j) = sign * product(basis_[j][1], normal).real();
    }
    std::array<Hat_term<1>, max_hat_terms> terms;
    const std::size_t count = hats<1>(cell, z, terms.data());
    for (std::size_t k = 0; k < count; ++k) {
      face.rhs(row, terms[k].vertex) -= sign * terms[k].f[0].real();
      face.rhs(row + 1, terms[k].vertex) -= sign * product(terms[k].f[1], normal).real();
    }
  }

  const std::vector<Cell>& cells_;
  std::size_t number_of_vertices_;
  double oversampling_;
  std::map<int, std::vector<Quadrature_node>> rules_;
  std::vector<Analytic<1>> basis_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_INTERFACE_H
