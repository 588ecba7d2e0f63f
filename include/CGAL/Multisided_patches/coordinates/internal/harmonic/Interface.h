// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_INTERFACE_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_INTERFACE_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Vertex_block.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/cover_mesh.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/gauss_legendre.h>

#include <algorithm>
#include <map>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The common boundary of two cells.
struct Interface {
  std::array<std::size_t, 2> cell;
  std::vector<Segment> edges;
};

// The equations that glue the local solutions of the two cells of an interface,
//   rows[0] c_0 + rows[1] c_1 = rhs
// for the coefficients c_i of cell[i]: at every point one for the values, and one for the normal
// derivatives in units of the wavelength of the bases. There are none on the boundary of the
// domain: the cells satisfy them exactly. Few vertices have boundary values on either cell; for all
// others the right-hand side is zero.
struct Interface_equations {
  std::array<Matrix, 2> rows;
  std::vector<std::size_t> vertices;
  Matrix rhs; // one column each of `vertices`
};

// the right-hand side for a block of vertices; where it is zero, the matrix stays empty
inline Matrix right_hand_side(const Interface_equations& equations, const Vertex_blocking& blocking,
                              std::size_t block) {
  Matrix result;
  for (std::size_t k = 0; k < equations.vertices.size(); ++k) {
    const std::size_t vertex = equations.vertices[k];
    if (blocking.block_of(vertex) != block)
      continue;
    if (result.size() == 0)
      result.setZero(equations.rhs.rows(), static_cast<Index>(blocking.width()));
    result.col(static_cast<Index>(vertex - block * blocking.width())) =
        equations.rhs.col(static_cast<Index>(k));
  }
  return result;
}

// Shorter edges are rounding: the domain has unit size.
inline constexpr double negligible_length = 1e-15;

// the interfaces of all pairs of cells
inline std::vector<Interface> find_interfaces(const Bisection_mesh& mesh,
                                              const std::vector<std::size_t>& cell_of) {
  std::map<std::array<std::size_t, 2>, std::vector<Segment>> edges;
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const std::size_t n = mesh.triangle(t).neighbor[i];
      if (!mesh.triangle(t).is_leaf() || n == Bisection_mesh::none || cell_of[t] >= cell_of[n])
        continue;
      const Triangle_points z = mesh.corners(t);
      const Segment edge{z[(i + 1) % 3], z[(i + 2) % 3]};
      if (std::abs(edge.b - edge.a) > negligible_length)
        edges[{cell_of[t], cell_of[n]}].push_back(edge);
    }
  std::vector<Interface> result;
  for (auto& entry : edges)
    result.push_back({entry.first, std::move(entry.second)});
  return result;
}

// Sets up the equations of interfaces.
class Interface_assembler {
public:
  // Where the equations hold. They are solved in the least-squares sense at the Gauss-Legendre
  // points of every edge, so what is left oscillates, and is largest between these.
  enum class Points { gauss_legendre, between };

  static constexpr double usual_oversampling = 1;

  // The number of points is multiplied by `oversampling`. It is raised where there would be fewer
  // equations than unknowns, which has not been seen to happen with the usual number.
  Interface_assembler(const std::vector<Cell>& cells, const std::vector<Interface>& faces,
                      double oversampling = usual_oversampling)
      : cells_(cells), oversampling_(oversampling) {
    constexpr double max_oversampling = 10;
    // Just as many do not determine the unknowns well, as cells share their equations.
    if (!is_overdetermined(faces, 1))
      while (!is_overdetermined(faces, 2)) {
        oversampling_ *= 1.5;
        if (oversampling_ > max_oversampling)
          throw Numerical_error("details of the polygon are too fine to be resolved");
      }
    for (const Interface& face : faces)
      for (const Segment& s : face.edges) {
        const std::size_t m = number_of_points(s, face);
        if (rules_.size() <= m)
          rules_.resize(m + 1);
        if (rules_[m].empty())
          rules_[m] = gauss_legendre(static_cast<int>(m));
      }
  }

  double oversampling() const { return oversampling_; }

  Interface_equations assemble(const Interface& face, Points points) const {
    Interface_equations result;
    for (const int i : {0, 1})
      add_vertices(cells_[face.cell[i]], face.edges.front().a, result.vertices);
    const Index rows = 2 * static_cast<Index>(number_of_points(face, points));
    for (const int i : {0, 1})
      result.rows[i].resize(rows, size(cells_[face.cell[i]]));
    result.rhs.setZero(rows, static_cast<Index>(result.vertices.size()));
    std::vector<Analytic<1>> basis;
    Index row = 0;
    for (const Segment& s : face.edges) {
      const Complex d = s.b - s.a, normal = Complex(0, -1) * d / std::abs(d);
      for (const double t : parameters(number_of_points(s, face), points)) {
        const Complex z = s.a + t * d, scaled_normal = normal / finest_resolution(face, z);
        for (const int i : {0, 1})
          add_equations(cells_[face.cell[i]], i == 0 ? 1 : -1, z, scaled_normal, row,
                        result.rows[i], basis, result);
        row += 2;
      }
    }
    return result;
  }

private:
  // whether every cell has at least `ratio` times as many equations as unknowns; one that is alone
  // needs none
  bool is_overdetermined(const std::vector<Interface>& faces, std::size_t ratio) const {
    if (faces.empty())
      return true;
    std::vector<std::size_t> equations(cells_.size(), 0);
    for (const Interface& face : faces)
      for (const std::size_t c : face.cell)
        equations[c] += 2 * number_of_points(face, Points::gauss_legendre);
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (equations[c] < ratio * static_cast<std::size_t>(size(cells_[c])))
        return false;
    return true;
  }

  // of the bases of both cells
  double finest_resolution(const Interface& face, const Complex& z) const {
    return (std::max)(resolution(cells_[face.cell[0]], z), resolution(cells_[face.cell[1]], z));
  }

  // Enough for the oscillations: values alone would need half a point a radian in a Gauss rule, but
  // each point has a derivative, too; the cube root is for the ends. Measured on random polygons:
  // with 0.5 and 1 some errors are seven times as large, with 0.5 and 1.5 or 0.4 and 2.5 no better.
  // But not many times the number of unknowns: in a sharp corner, the high powers live near the
  // outer end of an edge only, where the Gauss points accumulate.
  std::size_t number_of_points(const Segment& s, const Interface& face) const {
    const int unknowns = size(cells_[face.cell[0]]) + size(cells_[face.cell[1]]);
    const double finest = (std::max)(finest_resolution(face, s.a), finest_resolution(face, s.b)),
                 oscillations = (std::min)(std::abs(s.b - s.a) * finest, 2. * unknowns);
    return static_cast<std::size_t>((std::max)(
        3., std::ceil(oversampling_ * (0.4 * oscillations + 2 * std::cbrt(oscillations)))));
  }
  std::size_t number_of_points(const Interface& face, Points points) const {
    std::size_t sum = 0;
    for (const Segment& s : face.edges)
      sum += number_of_points(s, face) + (points == Points::between);
    return sum;
  }

  // on an edge, in [0,1]
  std::vector<double> parameters(std::size_t m, Points points) const {
    std::vector<double> result;
    for (const Quadrature_node& node : rules_[m])
      result.push_back(node.t);
    if (points == Points::between) { // 0, the midpoints, 1
      for (std::size_t i = result.size(); i-- > 1;)
        result[i] = (result[i - 1] + result[i]) / 2;
      result.front() = 0;
      result.push_back(1);
    }
    return result;
  }

  static void add_vertices(const Cell& cell, const Complex& z, std::vector<std::size_t>& vertices) {
    std::array<Hat_term<0>, max_hat_terms> terms;
    const std::size_t count = hats<0>(cell, z, terms.data());
    for (std::size_t k = 0; k < count; ++k)
      if (std::find(vertices.begin(), vertices.end(), terms[k].vertex) == vertices.end())
        vertices.push_back(terms[k].vertex);
  }

  // the value and the scaled normal derivative on one side; the signs differ on the two
  static void add_equations(const Cell& cell, double sign, const Complex& z, const Complex& normal,
                            Index row, Matrix& rows, std::vector<Analytic<1>>& f,
                            Interface_equations& equations) {
    // d_n Re F = Re (F' n)
    f.resize(static_cast<std::size_t>(size(cell)));
    basis<1>(cell, z, f.data());
    for (std::size_t j = 0; j < f.size(); ++j) {
      rows(row, static_cast<Index>(j)) = sign * f[j][0].real();
      rows(row + 1, static_cast<Index>(j)) = sign * product(f[j][1], normal).real();
    }
    std::array<Hat_term<1>, max_hat_terms> terms;
    const std::size_t count = hats<1>(cell, z, terms.data());
    for (std::size_t k = 0; k < count; ++k) {
      const std::vector<std::size_t>& v = equations.vertices;
      const Index column = std::find(v.begin(), v.end(), terms[k].vertex) - v.begin();
      equations.rhs(row, column) -= sign * terms[k].f[0].real();
      equations.rhs(row + 1, column) -= sign * product(terms[k].f[1], normal).real();
    }
  }

  const std::vector<Cell>& cells_;
  double oversampling_;
  std::vector<std::vector<Quadrature_node>> rules_; // by the number of points
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_INTERFACE_H
