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
#include <array>
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
 * 2018, where p = 2).
 *
 * Along side i the patch has the ribbon's derivatives up to order r if side i has at least r + 1
 * layers, both its neighbours have degree at least 2r + 1, and all other sides have at least r + 1
 * layers; the central weights `adjacent_products` and `full_product` allow r = 1 at most. See
 * `contact_order()`.
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
  double parameter_dilation() const { return parameter_dilation_; }

  /*!
   * computes all weights from barycentric coordinates.
   *
   * \tparam T the number type: a `Jet_2`, so that derivatives come along
   *
   * \param domain the domain, with one vertex for each side
   * \param lambda the coordinates
   * \param weights receives `size()` weights whose sum is 1
   *
   * Complexity: linear in the number of control points.
   */
  template <typename T, typename Domain>
  void evaluate(const Domain& domain, const T* lambda, T* weights) const {
    const Factors<T> factors = compute_factors(domain, lambda);
    const T inverse = inverse_of_sum(factors);
    T* w = weights;
    for (const Side_factors<T>& side : factors.sides)
      for (const T& across : side.across) {
        const T scaled = across * inverse;
        for (const T& along : side.along)
          *w++ = along * scaled;
      }
    *w = factors.central * inverse;
  }

  /*!
   * computes the sum of all control points times their weights, at less cost than with weights from
   * `evaluate()`.
   *
   * \tparam T the number type, a `Jet_2`
   * \tparam Point an indexable type with three coordinates
   *
   * \param domain,lambda as for `evaluate()`
   * \param control_net all control points, in the order of their indices
   *
   * Complexity: linear in the number of control points.
   */
  template <typename T, typename Domain, typename Point>
  std::array<T, 3> combine(const Domain& domain, const T* lambda,
                           const std::vector<Point>& control_net) const {
    using FT = typename T::FT;
    const Factors<T> factors = compute_factors(domain, lambda);
    // As the weights sum to 1, any point may be the origin. Near a corner it has to be that corner:
    // the derivatives of its two weights grow without bound there, and only their sum does not.
    const Point& origin = control_net[index(nearest_vertex(lambda), 0, 0)];
    const std::array<FT, 3> o{FT(origin[0]), FT(origin[1]), FT(origin[2])};
    std::array<T, 3> sum;
    auto point = control_net.begin();
    for (const Side_factors<T>& side : factors.sides)
      for (const T& across : side.across) {
        std::array<T, 3> row;
        for (const T& along : side.along) {
          for (std::size_t c = 0; c < 3; ++c)
            row[c] += along * FT(FT((*point)[c]) - o[c]);
          ++point;
        }
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += across * row[c];
      }
    const T inverse = inverse_of_sum(factors);
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += factors.central * FT(FT((*point)[c]) - o[c]);
      sum[c] = sum[c] * inverse + T(o[c]);
    }
    return sum;
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
    const T &h_in = parameters[in].h, &h_out = parameters[out].h;
    // At the corner itself both sides have the same point, and only the sum of the weights matters.
    if (h_in.value() == FT(0) && h_out.value() == FT(0)) {
      weight_in = weight_out = T(FT(1) / FT(2));
      return;
    }
    // The power of the quotient does not underflow, however close to the corner.
    const auto magnitude = [](const T& h) {
      return FT(h.value() < FT(0) ? FT(-h.value()) : h.value());
    };
    const bool nearer_to_in = magnitude(h_in) <= magnitude(h_out);
    const T power = internal::integer_power(nearer_to_in ? h_in / h_out : h_out / h_in, p);
    const T larger = T(FT(1)) / (T(FT(1)) + power), smaller = power * larger;
    weight_in = nearer_to_in ? larger : smaller;
    weight_out = nearer_to_in ? smaller : larger;
  }

  // The weights of a side, before normalization, are products of one factor for the column, which
  // has the corner weight, and one for the row.
  template <typename T>
  struct Side_factors {
    boost::container::small_vector<T, 8> along, across;
  };
  template <typename T>
  struct Factors {
    boost::container::small_vector<Side_factors<T>, 8> sides;
    T central, sum; // the sum is that of all weights before normalization
  };

  template <typename T, typename Domain>
  Factors<T> compute_factors(const Domain& domain, const T* lambda) const {
    using FT = typename T::FT;
    CGAL_precondition(domain.size() == number_of_sides());
    const std::size_t n = number_of_sides();
    boost::container::small_vector<Side_parameter<T>, 16> parameters(n);
    compute_side_parameters(domain, lambda, FT(parameter_dilation_), parameters);
    boost::container::small_vector<T, 16> at_start(n), at_end(n);
    for (std::size_t i = 0; i < n; ++i)
      share_corner(parameters, domain.prev(i), i, at_end[domain.prev(i)], at_start[i]);

    Factors<T> factors;
    factors.sides.resize(n);
    boost::container::small_vector<Side_sums<T>, 16> sums(n);
    for (std::size_t i = 0; i < n; ++i)
      sums[i] =
          set_side_factors(sides_[i], parameters[i], at_start[i], at_end[i], factors.sides[i]);
    const std::size_t out = nearest_vertex(lambda), in = domain.prev(out);
    T deficiency =
        lost_at_corner(sides_[in], parameters[in], sums[in], sums[in].near_start) * at_end[in] +
        lost_at_corner(sides_[out], parameters[out], sums[out], sums[out].near_end) * at_start[out];
    for (std::size_t i = 0; i < n; ++i) {
      T along = sums[i].middle;
      if (i != out)
        along += sums[i].near_start * at_start[i];
      if (i != in)
        along += sums[i].near_end * at_end[i];
      deficiency -= along * sums[i].across;
    }

    factors.sum = T(FT(1));
    if (central_weight_ == Central_weight::weight_deficiency) {
      factors.central = deficiency;
    } else {
      factors.central = central_product<T>(domain, parameters);
      factors.sum += factors.central - deficiency;
    }
    return factors;
  }

  template <typename T>
  std::size_t nearest_vertex(const T* lambda) const {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < number_of_sides(); ++i)
      if (lambda[nearest].value() < lambda[i].value())
        nearest = i;
    return nearest;
  }

  template <typename T>
  static T inverse_of_sum(const Factors<T>& factors) {
    return T(typename T::FT(1)) / factors.sum;
  }

  // The sums of the Bernstein polynomials of a side: of the columns nearer to its start, without
  // their corner weight, of the one in the middle, if there is one, of those nearer to the end, and
  // of the rows.
  template <typename T>
  struct Side_sums {
    T near_start, middle, near_end, across;
  };

  template <typename T>
  static Side_sums<T> set_side_factors(const Side& side, const Side_parameter<T>& parameter,
                                       const T& at_start, const T& at_end,
                                       Side_factors<T>& factors) {
    const std::size_t d = side.degree;
    factors.along.resize(d + 1);
    factors.across.resize(side.layers);
    internal::bernstein_polynomials(d, d + 1, parameter.s, parameter.one_minus_s,
                                    factors.along.data());
    internal::bernstein_polynomials(2 * side.layers - 1, side.layers, parameter.h,
                                    parameter.one_minus_h, factors.across.data());
    Side_sums<T> sums;
    for (std::size_t j = 0; j <= d; ++j) {
      T& factor = factors.along[j];
      (2 * j < d ? sums.near_start : 2 * j > d ? sums.near_end : sums.middle) += factor;
      if (2 * j != d)
        factor *= 2 * j < d ? at_start : at_end;
    }
    for (const T& factor : factors.across)
      sums.across += factor;
    return sums;
  }

  // What the polynomials of a side near one of its ends lack to 1; `far` is the sum of the columns
  // nearer to the other end. The two corner weights of an end have the sum 1, so these deficits
  // make up that of all weights there. Close to the corner, where the deficit is small and is
  // multiplied by the large derivatives of the corner weights, it has to be the sum of the other
  // polynomials.
  template <typename T>
  static T lost_at_corner(const Side& side, const Side_parameter<T>& parameter,
                          const Side_sums<T>& sums, const T& far) {
    boost::container::small_vector<T, 8> inner_rows(side.layers);
    internal::bernstein_polynomials(2 * side.layers - 1, side.layers, parameter.one_minus_h,
                                    parameter.h, inner_rows.data());
    T lost;
    for (const T& row : inner_rows)
      lost += row;
    return lost + (far + sums.middle) * sums.across;
  }

  template <typename T, typename Domain, typename Parameters>
  T central_product(const Domain& domain, const Parameters& parameters) const {
    using FT = typename T::FT;
    const std::size_t n = number_of_sides();
    const FT sides(static_cast<int>(n));
    switch (central_weight_) {
    case Central_weight::adjacent_products: {
      const auto bump = [&](std::size_t i) {
        return internal::integer_power(parameters[i].h * parameters[i].one_minus_h, 2);
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
        product *= internal::integer_power(parameters[i].h * FT(sides / (sides - FT(2))), 2);
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
