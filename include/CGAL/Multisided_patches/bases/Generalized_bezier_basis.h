// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_GENERALIZED_BEZIER_BASIS_H
#define CGAL_MULTISIDED_PATCHES_GENERALIZED_BEZIER_BASIS_H

#include <CGAL/Multisided_patches/bases/internal/Ribbon_blending.h>
#include <CGAL/Multisided_patches/parameters/barycentric_side_parameters.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The blending functions of the generalized Bézier patch of degree d with n sides and
 * l = ⌊(d + 1) / 2⌋ layers, one for every point of a `Generalized_bezier_net_3`. They sum to 1.
 *
 * Side i gives control point (j,k) the weight μ^i_{j,k} B^d_j(s_i) B^d_k(h_i), with the corner
 * weights
 *   - μ = h_{i-1}^l / (h_{i-1}^l + h_i^l) for 2j < d,
 *   - μ = 1 for 2j = d,
 *   - μ = h_{i+1}^l / (h_{i+1}^l + h_i^l) for 2j > d,
 *
 * and a point near a corner, which belongs to two sides, has the sum of both. What all these
 * weights lack to 1, their deficiency, is the weight of the central control point (Várady, Salvi
 * and Karikó, *A multi-sided Bézier patch with a simple control structure*, Computer Graphics Forum
 * 35, 2016). There the corner weights have the exponent 1, hold for j, k < 2 only, and are followed
 * by 1/2 and 0, which suffices for tangent planes. As they are here, the patch has all derivatives
 * up to order l - 1 of the ribbons `Generalized_bezier_net_3::loop()`.
 *
 * On a square, with s_i = 1 - h_{i+1}, these are the products of Bernstein polynomials in u and v.
 *
 * \cgalModels{ControlNetBasis}
 */
class Generalized_bezier_basis {
  using Blending = internal::Ribbon_blending;

public:
  /*!
   * \param net a `Generalized_bezier_net_3`, of which only the structure matters
   */
  template <typename Net>
  explicit Generalized_bezier_basis(const Net& net)
      : blending_(
            std::vector<Blending::Ribbon>(net.size(), {net.degree(), net.layers(), net.degree()})),
        central_index_(net.central_index()) {
    for (std::size_t i = 0; i < net.size(); ++i)
      for (std::size_t k = 0; k < net.layers(); ++k)
        for (std::size_t j = 0; j <= net.degree(); ++j)
          index_.push_back(net.index(i, j, k));
  }

  std::size_t number_of_sides() const { return blending_.size(); }
  //! the number of weights, which is that of the points of the net
  std::size_t size() const { return central_index_ + 1; }
  //! the index of the central control point
  std::size_t central_index() const { return central_index_; }
  //! what goes into the side parameters: nothing but the coordinates
  Side_parameter_options parameter_options() const { return {}; }

  //! memory for evaluation, which may be used for one point after the other
  template <typename T>
  using Workspace = internal::Ribbon_blending::Factors<T>;

  /*!
   * computes all weights from barycentric coordinates.
   *
   * \tparam T the number type: a `Jet_2`, so that derivatives come along
   *
   * \param domain the domain, with one vertex for each side
   * \param lambda the coordinates
   * \param weights receives `size()` weights whose sum is 1, in the order of the net
   *
   * Complexity: O(n d²).
   */
  template <typename T, typename Domain>
  void evaluate(const Domain& domain, const T* lambda, T* weights) const {
    Workspace<T> factors;
    evaluate(domain, lambda, weights, factors);
  }

  //! the same with memory of the caller's
  template <typename T, typename Domain>
  void evaluate(const Domain& domain, const T* lambda, T* weights, Workspace<T>& factors) const {
    blending_.evaluate(domain, lambda, {}, factors);
    std::fill(weights, weights + size(), T());
    blending_.for_each_weight(
        factors, [&](std::size_t c, const T& weight) { weights[index_[c]] += weight; });
    weights[central_index_] = factors.deficiency;
  }

  /*!
   * computes the sum of all control points times their weights, at less cost than with weights from
   * `evaluate()`.
   *
   * \tparam T the number type, a `Jet_2`
   * \tparam Point an indexable type with three coordinates
   *
   * \param domain,lambda as for `evaluate()`
   * \param control_net all control points, in the order of the net
   *
   * Complexity: O(n d²).
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
    blending_.evaluate(domain, lambda, {}, factors);
    // As for the concave basis, the origin has to be the nearest corner.
    const std::array<FT, 3> o =
        Blending::origin(factors, control_net, [this](std::size_t i) { return corner_index(i); });
    std::array<T, 3> sum = blending_.combine(
        factors, [&](std::size_t c) -> const Point& { return control_net[index_[c]]; }, o);
    const Point& central = control_net[central_index_];
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += factors.deficiency * FT(FT(central[c]) - o[c]) + T(o[c]);
    return sum;
  }

private:
  std::size_t corner_index(std::size_t i) const {
    return index_[i * (index_.size() / number_of_sides())];
  }

  Blending blending_;
  std::vector<std::size_t> index_; // in the net, of the points of side after side, row by row
  std::size_t central_index_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_GENERALIZED_BEZIER_BASIS_H
