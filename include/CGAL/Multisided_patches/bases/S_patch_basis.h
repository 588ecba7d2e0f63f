// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_S_PATCH_BASIS_H
#define CGAL_MULTISIDED_PATCHES_S_PATCH_BASIS_H

#include <CGAL/Multisided_patches/internal/Number_pack.h>
#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/ribbons/internal/multi_index.h>

#include <CGAL/assertions.h>
#include <CGAL/use.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The blending functions of the S-patch with n sides and depth d: for every multi-index
 * i = (i_0, …, i_{n-1}) with the sum d the Bernstein polynomial of n variables
 * d! / (i_0! ⋯ i_{n-1}!) λ_0^{i_0} ⋯ λ_{n-1}^{i_{n-1}}, on barycentric coordinates (Loop and
 * DeRose, *A multisided generalization of Bézier surfaces*, ACM Transactions on Graphics 8, 1989).
 * By the multinomial theorem they sum to (Σ λ_k)^d = 1.
 *
 * Weights are in lexicographically descending order of their indices, as are the points of an
 * `S_patch_net_3`.
 *
 * \cgalModels{ControlNetBasis}
 */
class S_patch_basis {
public:
  //! the largest depth, up to which jets of second order do not overflow in `double`
  static constexpr std::size_t max_depth = internal::max_s_patch_depth;

  /*!
   * \param sides n
   * \param depth d
   *
   * \pre there is an `S_patch_net_3` of these
   */
  S_patch_basis(std::size_t sides, std::size_t depth)
      : sides_(sides), depth_(depth), size_(internal::number_of_multi_indices(sides, depth)) {
    CGAL_precondition(sides >= 3 && depth >= 1 && depth <= max_depth);
    CGAL_precondition(size_ <= internal::max_multi_indices);
  }

  std::size_t number_of_sides() const { return sides_; }
  //! the sum d of every multi-index
  std::size_t depth() const { return depth_; }
  //! the number of weights, (n + d - 1 choose d)
  std::size_t size() const { return size_; }

  //! memory for evaluation, which may be used for one point after the other
  template <typename T>
  struct Workspace {
#ifndef DOXYGEN_RUNNING
    boost::container::small_vector<T, 64> powers; // of all coordinates up to the depth
#endif
  };

  /*!
   * computes all weights from barycentric coordinates.
   *
   * \tparam T the number type: a `Jet_2`, so that derivatives come along, or a plain number
   *
   * \param domain the domain, with one vertex for each side
   * \param lambda the coordinates
   * \param weights receives `size()` weights whose sum is that of the coordinates to the power d
   *
   * Complexity: linear in the number of weights.
   */
  template <typename T, typename Domain>
  void evaluate(const Domain& domain, const T* lambda, T* weights) const {
    Workspace<T> workspace;
    evaluate(domain, lambda, weights, workspace);
  }

  //! the same with memory of the caller's
  template <typename T, typename Domain>
  void evaluate(const Domain& domain, const T* lambda, T* weights, Workspace<T>& workspace) const {
    CGAL_precondition(domain.size() == number_of_sides());
    CGAL_USE(domain);
    for_each_weight(lambda, workspace, [&](const T& weight) { *weights++ = weight; });
  }

  /*!
   * computes the sum of all control points times their weights, without storing the weights.
   *
   * \tparam T the number type, as for `evaluate()`
   * \tparam Point an indexable type with three coordinates
   *
   * \param domain,lambda as for `evaluate()`
   * \param control_net all control points, in order
   *
   * \pre the coordinates sum to 1
   *
   * Complexity: linear in the number of control points.
   */
  template <typename T, typename Domain, typename Point>
  std::array<T, 3> combine(const Domain& domain, const T* lambda,
                           const std::vector<Point>& control_net) const {
    Workspace<T> workspace;
    return combine(domain, lambda, control_net, workspace);
  }

  //! the same with memory of the caller's
  template <typename T, typename Domain, typename Point>
  std::array<T, 3> combine(const Domain& domain, const T* lambda,
                           const std::vector<Point>& control_net, Workspace<T>& workspace) const {
    using FT = typename internal::Scalar_of<T>::type;
    CGAL_precondition(domain.size() == number_of_sides() && control_net.size() == size());
    CGAL_USE(domain);
    // As the weights sum to 1, any point may be the origin; one of the patch's own keeps rounding
    // errors below its size.
    const std::array<FT, 3> o{FT(control_net[0][0]), FT(control_net[0][1]), FT(control_net[0][2])};
    std::array<T, 3> sum{T(o[0]), T(o[1]), T(o[2])};
    auto point = control_net.begin();
    for_each_weight(lambda, workspace, [&](const T& weight) {
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += weight * FT(FT((*point)[c]) - o[c]);
      ++point;
    });
    return sum;
  }

private:
  template <typename T, typename Function>
  void for_each_weight(const T* lambda, Workspace<T>& workspace, const Function& function) const {
    auto& powers = workspace.powers;
    powers.clear();
    powers.reserve(sides_ * (depth_ + 1));
    for (std::size_t k = 0; k < sides_; ++k) {
      powers.push_back(T(1));
      for (std::size_t a = 1; a <= depth_; ++a)
        powers.push_back(a == 1 ? lambda[k] : T(powers.back() * lambda[k]));
    }
    for_each_weight(powers.data(), 0, depth_, T(1), function);
  }

  // The weights of all indices with the same entries before the k-th one, and the sum `rest` from
  // there on; `factor` is what those entries contribute. A multinomial coefficient is the product
  // of binomial ones, (rest choose entry).
  template <typename T, typename Function>
  void for_each_weight(const T* powers, std::size_t k, std::size_t rest, const T& factor,
                       const Function& function) const {
    using Scalar = typename internal::Scalar_of<T>::type;
    if (rest == 0)
      return function(factor);
    const T* power = powers + k * (depth_ + 1);
    if (k + 1 == sides_)
      return function(T(factor * power[rest]));
    Scalar binomial(1);
    for (std::size_t entry = rest; entry > 0; --entry) {
      for_each_weight(powers, k + 1, rest - entry, T(factor * T(power[entry] * binomial)),
                      function);
      binomial =
          binomial * Scalar(static_cast<int>(entry)) / Scalar(static_cast<int>(rest - entry + 1));
    }
    for_each_weight(powers, k + 1, rest, factor, function);
  }

  std::size_t sides_, depth_, size_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_S_PATCH_BASIS_H
