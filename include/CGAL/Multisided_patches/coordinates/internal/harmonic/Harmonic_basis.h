// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_HARMONIC_BASIS_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_HARMONIC_BASIS_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Cell.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Cell_locator.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Matrix.h>

#include <boost/container/small_vector.hpp>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The number of partial derivatives, value included, that a harmonic function has up to an order:
// u, u_x, u_y, u_xx, u_xy; the sixth is u_yy = -u_xx.
template <int Order>
inline constexpr int number_of_parts = 2 * Order + 1;

// The harmonic functions of all vertices: cells, their coefficients, and a way to find the cell.
class Harmonic_basis {
public:
  Harmonic_basis() = default;
  // `coefficients` of every cell, one row a basis function and one column a vertex
  Harmonic_basis(std::vector<Cell> cells, const std::vector<Matrix>& coefficients,
                 Cell_locator locator)
      : cells_(std::move(cells)), locator_(std::move(locator)) {
    for (const Matrix& m : coefficients)
      coefficients_.push_back(m.transposed());
  }

  // the number of vertices, rounded up: the distance of the parts in the result of evaluate
  std::size_t stride() const { return coefficients_.front().stride(); }
  std::size_t locate(const Complex& z) const { return locator_(z); }

  // writes part k (see number_of_parts) of the function of vertex i to values[k * stride() + i],
  // from the local solution of a cell
  template <int Order>
  void evaluate(std::size_t cell, const Complex& z, double* values) const {
    const std::size_t size = static_cast<std::size_t>(harmonic::size(cells_[cell]));
    boost::container::small_vector<Analytic<Order>, 128> f(size, boost::container::default_init);
    basis<Order>(cells_[cell], z, f.data());
    for (std::size_t i = 0; i < stride(); i += Matrix::lanes)
      combine<Order>(coefficients_[cell], i, f.data(), values);
    std::array<Hat_term<Order>, max_hat_terms> terms;
    const std::size_t count = hats<Order>(cells_[cell], z, terms.data());
    for (std::size_t k = 0; k < count; ++k)
      for (int part = 0; part < number_of_parts<Order>; ++part)
        values[part * stride() + terms[k].vertex] += real_part(terms[k].f, part);
  }

private:
  // u, u_x = Re F', u_y = -Im F', u_xx = Re F'', u_xy = -Im F''
  template <std::size_t N>
  static double real_part(const std::array<Complex, N>& f, int part) {
    return part % 2 == 1 || part == 0 ? f[(part + 1) / 2].real() : -f[part / 2].imag();
  }

  // the sum of all basis functions times their coefficients, for a few vertices from i on
  template <int Order>
  static void combine(const Matrix& coefficients, std::size_t i, const Analytic<Order>* f,
                      double* values) {
    std::array<Lanes, number_of_parts<Order>> sum;
    sum.fill(Lanes::Zero());
    for (std::size_t j = 0; j < coefficients.columns(); ++j) {
      const Lanes c = lanes_at(coefficients.column(j) + i);
      sum[0] += c * f[j][0].real();
      if constexpr (Order >= 1) {
        sum[1] += c * f[j][1].real();
        sum[2] -= c * f[j][1].imag();
      }
      if constexpr (Order >= 2) {
        sum[3] += c * f[j][2].real();
        sum[4] -= c * f[j][2].imag();
      }
    }
    for (int part = 0; part < number_of_parts<Order>; ++part)
      lanes_at(values + part * coefficients.stride() + i) = sum[part];
  }

  std::vector<Cell> cells_;
  Cell_locator locator_;
  std::vector<Matrix> coefficients_; // of every cell; one column a basis function
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_HARMONIC_BASIS_H
