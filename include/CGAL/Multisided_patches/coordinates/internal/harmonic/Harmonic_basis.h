// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_HARMONIC_BASIS_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_HARMONIC_BASIS_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Cell.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Cell_locator.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Vertex_block.h>

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
  Harmonic_basis(std::vector<Cell> cells, std::vector<Cell_coefficients> coefficients,
                 std::size_t vertices, Cell_locator locator)
      : cells_(std::move(cells)), locator_(std::move(locator)),
        coefficients_(std::move(coefficients)) {
    const Vertex_blocking blocking(vertices);
    stride_ = blocking.size() * blocking.width();
  }

  // the number of vertices, rounded up: the distance of the parts in the result of evaluate
  std::size_t stride() const { return stride_; }
  std::size_t locate(const Complex& z) const { return locator_(z); }

  // writes part k (see number_of_parts) of the function of vertex i to values[k * stride() + i],
  // from the local solution of a cell
  template <int Order, typename Real>
  void evaluate(std::size_t cell, const std::complex<Real>& z, Real* values) const {
    const std::size_t size = static_cast<std::size_t>(harmonic::size(cells_[cell]));
    boost::container::small_vector<Analytic<Order, Real>, 128> f(size,
                                                                 boost::container::default_init);
    basis<Order>(cells_[cell], z, f.data());
    std::fill_n(values, number_of_parts<Order> * stride(), Real(0));
    for (const Vertex_block& b : coefficients_[cell])
      for (Index i = 0; i < b.coefficients.cols(); i += lanes)
        combine<Order>(b.coefficients, i, f.data(), values + b.first + i);
    add_hats<Order>(cell, z, values);
  }

private:
  static constexpr int lanes = Vertex_blocking::lanes;

  // u, u_x = Re F', u_y = -Im F', u_xx = Re F'', u_xy = -Im F''
  template <typename Real, std::size_t N>
  static Real real_part(const std::array<std::complex<Real>, N>& f, int part) {
    const std::complex<Real>& derivative = f[static_cast<std::size_t>(part + 1) / 2];
    return part % 2 == 1 || part == 0 ? derivative.real() : -derivative.imag();
  }

  // the sum of all basis functions times their coefficients, for a few vertices from i on
  template <int Order, typename Real>
  void combine(const Matrix& coefficients, Index i, const Analytic<Order, Real>* f,
               Real* values) const {
    using Lanes = Eigen::Array<Real, lanes, 1>;
    std::array<Lanes, number_of_parts<Order>> sum;
    sum.fill(Lanes::Zero());
    const double* row = coefficients.data() + i;
    for (Index j = 0; j < coefficients.rows(); ++j, row += coefficients.cols()) {
      const Lanes c = Eigen::Map<const Eigen::Array<double, lanes, 1>>(row).template cast<Real>();
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
      Eigen::Map<Lanes>(values + static_cast<std::size_t>(part) * stride()) = sum[part];
  }

  // the parts that carry the boundary values
  template <int Order, typename Real>
  void add_hats(std::size_t cell, const std::complex<Real>& z, Real* values) const {
    std::array<Hat_term<Order, Real>, max_hat_terms> terms;
    const std::size_t count = hats<Order>(cells_[cell], z, terms.data());
    for (std::size_t k = 0; k < count; ++k)
      for (int part = 0; part < number_of_parts<Order>; ++part)
        values[static_cast<std::size_t>(part) * stride() + terms[k].vertex] +=
            real_part(terms[k].f, part);
  }

  std::vector<Cell> cells_;
  Cell_locator locator_;
  std::vector<Cell_coefficients> coefficients_; // of every cell
  std::size_t stride_ = 0;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_HARMONIC_BASIS_H
