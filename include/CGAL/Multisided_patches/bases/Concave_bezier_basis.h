// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_BASIS_H
#define CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_BASIS_H

#include <CGAL/Multisided_patches/bases/Central_weight.h>
#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/internal/integer_power.h>
#include <CGAL/Multisided_patches/parameters/barycentric_side_parameters.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The blending functions of the concave generalized Bézier patch: one for every control point of
 * every ribbon, and one for the central control point. They depend on the structure of the ribbons
 * and on the point of the domain, not on where the control points are, and sum to 1.
 *
 * For control point (j,k) of side i with degree d and l layers the weight, before all weights are
 * divided by their sum, is μ^i_{j,k} B^d_j(s_i) B^{2l-1}_k(h_i), with the corner weights
 *   - μ = h_{i-1}^p / (h_{i-1}^p + h_i^p) for 2j < d,
 *   - μ = 1 for 2j = d,
 *   - μ = h_{i+1}^p / (h_{i+1}^p + h_i^p) for 2j > d,
 *
 * where p is the larger number of layers of the two sides that meet at the corner (Salvi and
 * Várady, *Multi-sided Bézier surfaces over concave polygonal domains*, Computers & Graphics 74,
 * 2018). The weights of the other sides then vanish on side i to order l, so that the patch has the
 * ribbon's boundary curve if d ≥ 1, its tangent planes if also l ≥ 2 and d ≥ 3, and its curvatures
 * if l ≥ 3 and d ≥ 5, d being the degrees of side i and of its neighbours.
 */
class Concave_bezier_basis {
public:
  /*!
   * \param degrees_and_layers the degree along and the number of layers of each side, both at
   * least 1
   * \param central_weight how the central control point is weighted
   * \param parameter_dilation δ of the side parameters, see `compute_side_parameters()`
   */
  explicit Concave_bezier_basis(
      const std::vector<std::pair<std::size_t, std::size_t>>& degrees_and_layers,
      Central_weight central_weight = Central_weight::none, double parameter_dilation = 0)
      : central_weight_(central_weight), parameter_dilation_(parameter_dilation) {
    for (const auto& [degree, layers] : degrees_and_layers) {
      sides_.push_back({degree, layers, size_});
      size_ += (degree + 1) * layers;
    }
  }

  std::size_t number_of_sides() const { return sides_.size(); }
  //! the number of weights: all control points, ribbon by ribbon and row by row, and then the
  //! central one
  std::size_t size() const { return size_ + 1; }
  //! the index of control point (j,k) of side `i`
  std::size_t index(std::size_t i, std::size_t j, std::size_t k) const {
    return sides_[i].offset + k * (sides_[i].degree + 1) + j;
  }
  //! the index of the central control point
  std::size_t central_index() const { return size_; }
  Central_weight central_weight() const { return central_weight_; }

  /*!
   * computes all weights from barycentric coordinates.
   *
   * \tparam T the number type: a `Jet_2`, so that derivatives come along
   *
   * \param domain the domain, with one vertex for each side
   * \param lambda the coordinates
   * \param weights receives `size()` weights whose sum is 1
   *
   * Complexity: linear in the number of control points, and quadratic in the degree.
   */
  template <typename T, typename Domain>
  void evaluate(const Domain& domain, const T* lambda, T* weights) const {
    using FT = typename T::FT;
    CGAL_precondition(domain.size() == number_of_sides());
    const std::size_t n = number_of_sides();
    boost::container::small_vector<Side_parameter<T>, 16> parameters(n);
    compute_side_parameters(domain, lambda, FT(parameter_dilation_), parameters);

    boost::container::small_vector<T, 16> at_start(n), at_end(n);
    for (std::size_t i = 0; i < n; ++i)
      share_corner(parameters, domain.prev(i), i, at_end[domain.prev(i)], at_start[i]);

    T sum;
    for (std::size_t i = 0; i < n; ++i)
      sum += side_weights(sides_[i], parameters[i], at_start[i], at_end[i], weights);
    T& central = weights[central_index()];
    if (central_weight_ == Central_weight::weight_deficiency) {
      central = T(FT(1)) - sum;
      return;
    }
    central = central_product<T>(domain, parameters);
    sum += central;
    for (std::size_t i = 0; i < size(); ++i)
      weights[i] /= sum;
  }

private:
  struct Side {
    std::size_t degree, layers, offset;
  };

  // The corner weights of side `in` at its end and of side `out` at its start, where the two meet.
  template <typename T, typename Parameters>
  void share_corner(const Parameters& parameters, std::size_t in, std::size_t out, T& weight_in,
                    T& weight_out) const {
    using FT = typename T::FT;
    const std::size_t p = (std::max)(sides_[in].layers, sides_[out].layers);
    const T h_in = internal::integer_power(parameters[in].h, p);
    const T h_out = internal::integer_power(parameters[out].h, p);
    const T sum = h_in + h_out;
    // At the corner itself both sides have the same point, and only the sum of the weights matters.
    const bool at_corner = sum.value() == FT(0);
    weight_in = at_corner ? T(FT(1) / FT(2)) : h_out / sum;
    weight_out = at_corner ? T(FT(1) / FT(2)) : h_in / sum;
  }

  template <typename T>
  static T side_weights(const Side& side, const Side_parameter<T>& parameter, const T& at_start,
                        const T& at_end, T* weights) {
    const std::size_t d = side.degree, cross_degree = 2 * side.layers - 1;
    boost::container::small_vector<T, 8> along(d + 1), across(cross_degree + 1);
    internal::bernstein_polynomials(d, parameter.s, along.data());
    internal::bernstein_polynomials(cross_degree, parameter.h, across.data());
    for (std::size_t j = 0; j <= d; ++j)
      if (2 * j != d)
        along[j] *= 2 * j < d ? at_start : at_end;
    T sum;
    T* w = weights + side.offset;
    for (std::size_t k = 0; k < side.layers; ++k)
      for (std::size_t j = 0; j <= d; ++j, ++w) {
        *w = along[j] * across[k];
        sum += *w;
      }
    return sum;
  }

  template <typename T, typename Domain, typename Parameters>
  T central_product(const Domain& domain, const Parameters& parameters) const {
    using FT = typename T::FT;
    const std::size_t n = number_of_sides();
    const FT sides(static_cast<int>(n));
    switch (central_weight_) {
    case Central_weight::adjacent_products: {
      const auto bump = [&](std::size_t i) {
        return internal::integer_power(parameters[i].h * (T(FT(1)) - parameters[i].h), 2);
      };
      // Of three sides two always are adjacent to the third, on which their product is not 0.
      if (n == 3)
        return bump(0) * bump(1) * bump(2) * sides;
      T sum;
      for (std::size_t i = 0; i < n; ++i)
        sum += bump(i) * bump(domain.next(i));
      return sum * sides;
    }
    case Central_weight::full_product: {
      // h_i is 1 - 2/n where all coordinates are equal.
      T product(FT(2) / FT(9));
      for (std::size_t i = 0; i < n; ++i)
        product *= internal::integer_power(parameters[i].h * (sides / (sides - FT(2))), 2);
      return product;
    }
    default:
      return T();
    }
  }

  std::vector<Side> sides_;
  std::size_t size_ = 0;
  Central_weight central_weight_;
  double parameter_dilation_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_BASIS_H
