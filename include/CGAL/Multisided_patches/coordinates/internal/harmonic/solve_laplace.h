// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_LAPLACE_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_LAPLACE_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Gluing.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Harmonic_basis.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/triangulate_boundary.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

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
//
// Those of all vertices take as long as solving for them. But the jumps of a few combinations of
// all, with random signs, tell where they are large, and the others are only looked at there.
template <typename ConcurrencyTag>
class Jump_measure {
public:
  Jump_measure(const Interface_assembler& assembler, const std::vector<Interface>& interfaces,
               const Vertex_blocking& blocking, const std::vector<Cell_coefficients>& coefficients)
      : assembler_(assembler), interfaces_(interfaces), blocking_(blocking),
        coefficients_(coefficients) {}

  // the largest jump for any vertex
  double largest() const {
    constexpr std::size_t batch = 32;
    std::vector<double> combined(interfaces_.size(), std::numeric_limits<double>::infinity());
    if (blocking_.size() * blocking_.width() > 4 * combinations)
      combined = combined_jumps();
    std::vector<std::size_t> order(interfaces_.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return combined[a] > combined[b]; });
    double result = 0;
    for (std::size_t begin = 0; begin < order.size(); begin += batch) {
      // A random combination is hardly ever below a third of its mean square, let alone all, at
      // all points.
      if (3 * combined[order[begin]] < result)
        break;
      std::vector<double> jumps((std::min)(batch, order.size() - begin));
      for_each_index<ConcurrencyTag>(
          jumps.size(), [&](std::size_t i) { jumps[i] = jump(order[begin + i]); }, 4);
      result = (std::max)(result, *std::max_element(jumps.begin(), jumps.end()));
    }
    return result;
  }

private:
  static constexpr std::size_t combinations = Vertex_blocking::lanes;

  static double largest_entry(const Matrix& m) {
    return m.allFinite() ? m.cwiseAbs().maxCoeff() : std::numeric_limits<double>::infinity();
  }

  static Matrix signs(const std::vector<std::size_t>& vertices) {
    return Matrix::NullaryExpr(
        static_cast<Index>(vertices.size()), static_cast<Index>(combinations),
        [&](Index i, Index j) { return random_sign(vertices[static_cast<std::size_t>(i)], j); });
  }

  // the largest jump of each interface for the combinations
  std::vector<double> combined_jumps() const {
    std::vector<Matrix> sums(coefficients_.size());
    for_each_index<ConcurrencyTag>(
        coefficients_.size(),
        [&](std::size_t c) {
          for (const Vertex_block& b : coefficients_[c]) {
            std::vector<std::size_t> vertices(blocking_.width());
            std::iota(vertices.begin(), vertices.end(), b.first);
            add_product(1, b.coefficients, signs(vertices), sums[c]);
          }
        },
        16);
    std::vector<double> result(interfaces_.size());
    for_each_index<ConcurrencyTag>(
        interfaces_.size(),
        [&](std::size_t f) {
          const Interface_equations equations =
              assembler_.assemble(interfaces_[f], Interface_assembler::Points::between);
          Matrix defect;
          add_product(1, equations.rhs, signs(equations.vertices), defect);
          for (const std::size_t i : {0, 1})
            if (sums[interfaces_[f].cell[i]].size() > 0)
              add_product(-1, equations.rows[i], sums[interfaces_[f].cell[i]], defect);
          result[f] = largest_entry(defect);
        },
        16);
    return result;
  }

  // the largest jump of an interface for any vertex
  double jump(std::size_t f) const {
    const Interface_equations equations =
        assembler_.assemble(interfaces_[f], Interface_assembler::Points::between);
    std::map<std::size_t, Matrix> defects; // by block of vertices
    for (const std::size_t vertex : equations.vertices) {
      const std::size_t block = blocking_.block_of(vertex);
      defects[block] = right_hand_side(equations, blocking_, block);
    }
    for (const std::size_t i : {0, 1})
      for (const Vertex_block& b : coefficients_[interfaces_[f].cell[i]])
        add_product(-1, equations.rows[i], b.coefficients, defects[blocking_.block_of(b.first)]);
    double result = 0;
    for (const auto& defect : defects)
      result = (std::max)(result, largest_entry(defect.second));
    return result;
  }

  const Interface_assembler& assembler_;
  const std::vector<Interface>& interfaces_;
  const Vertex_blocking& blocking_;
  const std::vector<Cell_coefficients>& coefficients_; // of every cell
};

// How much larger errors may be than jumps. A factor of 4 was on the safe side on all shapes
// without fine detail; where cells shrink towards one, jumps on all scales can add up.
inline double safety_factor(double longest, double shortest) {
  return (std::max)(4., 0.5 * std::log2(longest / shortest));
}

// The error from the largest jump.
inline double error_estimate(double jump, const std::vector<Interface>& interfaces) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (const Interface& face : interfaces)
    for (const Segment& s : face.edges) {
      shortest = (std::min)(shortest, std::abs(s.b - s.a));
      longest = (std::max)(longest, std::abs(s.b - s.a));
    }
  return safety_factor(longest, shortest) * jump;
}

// solves Laplace's equation on the polygon for the hat functions of all vertices. Every cell's
// local solutions converge by the factor tau; the result is meant to have errors of `accuracy`.
// For `oversampling` see Interface_assembler.
template <typename ConcurrencyTag>
Solution solve_laplace(const Boundary& boundary, Bisection_mesh mesh, double tau, double accuracy,
                       double oversampling = Interface_assembler::usual_oversampling) {
  Cover cover = Cover_builder(boundary, tau, mesh).build();
  const std::vector<Interface> interfaces = find_interfaces(mesh, cover.cell_of);
  const Interface_assembler assembler(cover.cells, interfaces, oversampling);
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
  Gluing<ConcurrencyTag> gluing(interfaces, std::move(equations), std::move(sizes));
  std::vector<Cell_coefficients> coefficients = gluing.solve(blocking, accuracy);
  const double jump =
      Jump_measure<ConcurrencyTag>(assembler, interfaces, blocking, coefficients).largest();
  return {Harmonic_basis(std::move(cover.cells), std::move(coefficients), boundary.size(),
                         Cell_locator(mesh, cover.cell_of)),
          error_estimate(jump, interfaces) + gluing.rounding()};
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_LAPLACE_H
