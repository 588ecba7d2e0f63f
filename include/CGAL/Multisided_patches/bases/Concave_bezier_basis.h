// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_BASIS_H
#define CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_BASIS_H

#include <CGAL/Multisided_patches/bases/Central_weight.h>
#include <CGAL/Multisided_patches/bases/internal/Ribbon_blending.h>
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
 * every ribbon, for extra control points at corners, and one for the central control point. They
 * depend on the structure of the ribbons and on the point of the domain, not on where the control
 * points are, and sum to 1.
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
 * An extra control point at the corner where side i ends and side i+1 starts has the weight
 * 9/2 μ (1 - μ) B^m_1(h_i) B^{m'}_1(h_{i+1}), where μ is the corner weight of side i there, m is
 * 2l - 1 for the layers l of side i, but at least 3, and m' the same for side i+1. It vanishes on
 * all sides together with its derivatives of first order, and also of second order if both have 3
 * layers. (On three sides this takes a further factor, h² or a higher power of the third side's h,
 * as many as it has layers.)
 *
 * Along side i the patch has the ribbon's derivatives up to order r if side i has at least r + 1
 * layers, both its neighbours have degree at least 2r + 1, and all other sides have at least r + 1
 * layers; the central weights `adjacent_products` and `full_product` allow r = 1 at most. See
 * `contact_order()`.
 *
 * \cgalModels{ControlNetBasis}
 */
class Concave_bezier_basis {
  using Blending = internal::Ribbon_blending;

public:
  /*!
   * \param degrees_and_layers the degree along and the number of layers of each side, both at
   * least 1
   * \param central_weight how the central control point is weighted, not `automatic`
   * \param parameter_options what goes into the side parameters, see `compute_side_parameters()`
   * \param corners the sides at whose ends there are extra control points
   */
  explicit Concave_bezier_basis(
      const std::vector<std::pair<std::size_t, std::size_t>>& degrees_and_layers,
      Central_weight central_weight = Central_weight::none,
      const Side_parameter_options& parameter_options = {}, std::vector<std::size_t> corners = {})
      : blending_(ribbons(degrees_and_layers)), central_weight_(central_weight),
        parameter_options_(parameter_options), corners_(std::move(corners)) {
    for (std::size_t i = 0; i < number_of_sides(); ++i) {
      offsets_.push_back(ribbon_points_);
      ribbon_points_ += (blending_[i].degree + 1) * blending_[i].layers;
    }
    CGAL_precondition(central_weight_ != Central_weight::automatic);
    CGAL_precondition(std::all_of(corners_.begin(), corners_.end(),
                                  [this](std::size_t i) { return i < number_of_sides(); }));
  }

  std::size_t number_of_sides() const { return blending_.size(); }
  //! the number of weights: all control points, ribbon by ribbon and row by row, then the extra
  //! ones at corners, and then the central one
  std::size_t size() const { return central_index() + 1; }
  //! the index of control point (j,k) of side `i`
  std::size_t index(std::size_t i, std::size_t j, std::size_t k) const {
    return offsets_[i] + k * (blending_[i].degree + 1) + j;
  }
  //! the index of the `c`-th extra control point
  std::size_t corner_index(std::size_t c) const { return ribbon_points_ + c; }
  //! the index of the central control point
  std::size_t central_index() const { return ribbon_points_ + corners_.size(); }
  Central_weight central_weight() const { return central_weight_; }
  const Side_parameter_options& parameter_options() const { return parameter_options_; }

  //! memory for evaluation, which may be used for one point after the other
  template <typename T>
  struct Workspace {
#ifndef DOXYGEN_RUNNING
    // All weights before they are divided by their sum.
    internal::Ribbon_blending::Factors<T> ribbons;
    boost::container::small_vector<T, 4> corners;
    T central, sum;
#endif
  };

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
    Workspace<T> factors;
    evaluate(domain, lambda, weights, factors);
  }

  //! the same with memory of the caller's
  template <typename T, typename Domain>
  void evaluate(const Domain& domain, const T* lambda, T* weights, Workspace<T>& factors) const {
    compute_factors(domain, lambda, factors);
    const T scale = internal::reciprocal(factors.sum);
    for (T& across : factors.ribbons.across)
      across *= scale;
    blending_.for_each_weight(factors.ribbons,
                              [&](std::size_t c, const T& weight) { weights[c] = weight; });
    for (std::size_t c = 0; c < corners_.size(); ++c)
      weights[corner_index(c)] = factors.corners[c] * scale;
    weights[central_index()] = factors.central * scale;
  }

  //! what the weights of the ribbons, before all weights are divided by their sum, lack to 1:
  //! their deficiency, without extra control points at corners. Parameters as for `evaluate()`
  template <typename T, typename Domain>
  T weight_deficiency(const Domain& domain, const T* lambda, Workspace<T>& factors) const {
    blending_.evaluate(domain, lambda, parameter_options_, factors.ribbons);
    return factors.ribbons.deficiency;
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
    Workspace<T> factors;
    return combine(domain, lambda, control_net, factors);
  }

  //! the same with memory of the caller's
  template <typename T, typename Domain, typename Point>
  std::array<T, 3> combine(const Domain& domain, const T* lambda,
                           const std::vector<Point>& control_net, Workspace<T>& factors) const {
    using FT = typename T::FT;
    compute_factors(domain, lambda, factors);
    // As the weights sum to 1, any point may be the origin. Near a corner it has to be that corner:
    // the derivatives of its two weights grow without bound there, and only their sum does not.
    const std::array<FT, 3> o = Blending::origin(factors.ribbons, control_net,
                                                 [this](std::size_t i) { return index(i, 0, 0); });
    std::array<T, 3> sum = blending_.combine(
        factors.ribbons, [&](std::size_t c) -> const Point& { return control_net[c]; }, o);
    const auto add = [&](const T& weight, const Point& point) {
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += weight * FT(FT(point[c]) - o[c]);
    };
    for (std::size_t c = 0; c < corners_.size(); ++c)
      add(factors.corners[c], control_net[corner_index(c)]);
    if (central_weight_ != Central_weight::none)
      add(factors.central, control_net[central_index()]);
    const T scale = internal::reciprocal(factors.sum);
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] = sum[c] * scale + T(o[c]);
    return sum;
  }

private:
  static std::vector<Blending::Ribbon>
  ribbons(const std::vector<std::pair<std::size_t, std::size_t>>& degrees_and_layers) {
    std::vector<Blending::Ribbon> result;
    for (const auto& [degree, layers] : degrees_and_layers)
      result.push_back({degree, layers, 2 * layers - 1});
    return result;
  }

  template <typename T, typename Domain>
  void compute_factors(const Domain& domain, const T* lambda, Workspace<T>& factors) const {
    using FT = typename T::FT;
    blending_.evaluate(domain, lambda, parameter_options_, factors.ribbons);
    T deficiency = factors.ribbons.deficiency;
    factors.corners.resize(corners_.size());
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      factors.corners[c] = corner_weight(factors.ribbons, corners_[c], domain.next(corners_[c]));
      deficiency -= factors.corners[c];
    }
    factors.sum = T(FT(1));
    if (central_weight_ == Central_weight::weight_deficiency) {
      factors.central = deficiency;
    } else {
      factors.central = central_product<T>(domain, factors.ribbons.parameters);
      factors.sum += factors.central - deficiency;
    }
  }

  // The weight of the extra control point where side `in` ends and side `out` starts.
  template <typename T>
  T corner_weight(const Blending::Factors<T>& factors, std::size_t in, std::size_t out) const {
    using FT = typename T::FT;
    const auto second_row = [&](std::size_t i) {
      // Of degree 1 this would not vanish on the sides that do not touch side i.
      const std::size_t degree = (std::max<std::size_t>)(blending_[i].cross_degree, 3);
      const Side_parameter<T>& parameter = factors.parameters[i];
      return parameter.h * internal::integer_power(parameter.one_minus_h, degree - 1) *
             FT(static_cast<int>(degree));
    };
    T weight = factors.at_end[in] * factors.at_start[out] * second_row(in) * second_row(out) *
               FT(FT(9) / FT(2));
    if (number_of_sides() == 3) { // on the third side neither h is 0 or 1
      const std::size_t third = 3 - in - out;
      weight *= internal::integer_power(factors.parameters[third].h,
                                        (std::max<std::size_t>)(blending_[third].layers, 2));
    }
    return weight;
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

  Blending blending_;
  std::vector<std::size_t> offsets_; // of the control points of each side
  std::size_t ribbon_points_ = 0;
  Central_weight central_weight_;
  Side_parameter_options parameter_options_;
  std::vector<std::size_t> corners_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_BASIS_H
