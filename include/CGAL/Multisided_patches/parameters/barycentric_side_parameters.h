// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_BARYCENTRIC_SIDE_PARAMETERS_H
#define CGAL_MULTISIDED_PATCHES_BARYCENTRIC_SIDE_PARAMETERS_H

#include <CGAL/Multisided_patches/internal/Number_pack.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The parameters of one side: `s` runs from 0 to 1 along it, `h` is 0 on it and grows inwards.
 * Their complements are kept as well: as differences from 1 they would lose the digits on which
 * derivatives depend near a corner.
 */
template <typename T>
struct Side_parameter {
  T s, one_minus_s, h, one_minus_h;
};

//! What goes into the side parameters beyond the coordinates; the defaults give the plain ones.
struct Side_parameter_options {
  //! δ in h_i (1 - δ λ_{i-1} λ_{i+2})
  double dilation = 0;
  //! by what the coordinates of reflex corners are multiplied for the distance parameters h;
  //! positive
  double reflex_weight = 1;
  //! the vertices that are the reflex corners; a domain that was rounded need not tell
  std::vector<std::size_t> reflex_corners;

  Side_parameter_options(double delta = 0, double weight = 1, std::vector<std::size_t> corners = {})
      : dilation(delta), reflex_weight(weight), reflex_corners(std::move(corners)) {}
};

namespace internal {

// The n coordinates with those of reflex corners multiplied by their weight, divided by their sum.
template <typename T, typename Output>
void weigh_reflex_corners(const T* lambda, std::size_t n, const Side_parameter_options& options,
                          Output& weighted) {
  using FT = typename T::FT;
  weighted.assign(lambda, lambda + n);
  for (const std::size_t i : options.reflex_corners)
    weighted[i] *= FT(options.reflex_weight);
  T sum;
  for (const T& l : weighted)
    sum += l;
  const T inverse = T(FT(1)) / sum;
  for (T& l : weighted)
    l *= inverse;
}

// h_i before dilation: the sum of all λ but λ_i and λ_{i+1}. Unlike 1 - λ_i - λ_{i+1} this is
// exactly 0 on the side, and does not cancel near it. O(n) for all sides.
template <typename T, typename Domain, typename Output>
void sums_of_others(const Domain& domain, const T* lambda, Output& h) {
  const std::size_t n = domain.size();
  boost::container::small_vector<T, 33> after(n + 1);
  for (std::size_t j = n; j-- > 0;)
    after[j] = after[j + 1] + lambda[j];
  for (std::size_t loop = 0; loop < domain.number_of_loops(); ++loop) {
    const std::size_t first = domain.loop_begin(loop), last = domain.loop_begin(loop + 1) - 1;
    T before;
    for (std::size_t j = 0; j < first; ++j)
      before += lambda[j];
    T between; // the first and the last vertex of the loop
    h[last].h = before + after[last + 1];
    for (std::size_t i = first; i < last; ++i) {
      h[i].h = before + after[i + 2];
      before += lambda[i];
      if (i > first)
        between += lambda[i];
    }
    h[last].h += between;
  }
}

// s = N / D with N = λ_{i+1} and D = λ_i + λ_{i+1}, where both are 0: on the sides that do not
// touch side i. Both grow linearly from there, so the limit is the ratio of their derivatives
// across the side, that is along g = ∇D; and with the second derivatives that of s is known, too.
// Second derivatives of s are multiplied by D = 0 wherever they occur. At vertices, and where
// derivatives are not computed, nothing depends on s.
template <typename T>
T limit_of_s(const T& next, const T& sum) {
  using FT = typename T::FT;
  T s(FT(1) / FT(2));
  if constexpr (T::order >= 1) {
    const FT gu = sum[1], gv = sum[2], square = gu * gu + gv * gv;
    if (!(square > FT(0)))
      return s;
    s[0] = (next[1] * gu + next[2] * gv) / square;
    if constexpr (T::order >= 2) {
      // the Hessian of N - s D, times g
      const FT uu = next[3] - s[0] * sum[3], uv = next[4] - s[0] * sum[4],
               vv = next[5] - s[0] * sum[5];
      const FT x = uu * gu + uv * gv, y = uv * gu + vv * gv;
      const FT across = (x * gu + y * gv) / (square + square), along = (y * gu - x * gv) / square;
      s[1] = (across * gu - along * gv) / square;
      s[2] = (across * gv + along * gu) / square;
    }
  }
  return s;
}

// s and 1 - s of a side from the coordinates of its two ends.
template <typename T>
void set_s(const T& start, const T& end, Side_parameter<T>& parameter) {
  using FT = typename T::FT;
  const T sum = start + end;
  const auto nearer_to_start = end.value() < start.value();
  const auto vanishes = sum.value() == FT(0);
  // The larger quotient is taken from the smaller one, as its derivatives would cancel.
  const T quotient =
      select(nearer_to_start, end, start) / (any(vanishes) ? select(vanishes, T(FT(1)), sum) : sum);
  const T rest = T(FT(1)) - quotient;
  parameter.s = select(nearer_to_start, quotient, rest);
  parameter.one_minus_s = select(nearer_to_start, rest, quotient);
  if (any(vanishes)) {
    for (std::size_t l = 0; l < lanes_of<FT>; ++l)
      if (holds(vanishes, l))
        set_lane(parameter.s, l, limit_of_s(lane(end, l), lane(sum, l)));
    parameter.one_minus_s = select(vanishes, T(FT(1)) - parameter.s, parameter.one_minus_s);
  }
}

} // namespace internal

/*!
 * computes the side parameters of all sides from barycentric coordinates:
 * s_i = λ_{i+1} / (λ_i + λ_{i+1}) and h_i = (1 - λ_i - λ_{i+1}) (1 - δ λ_{i-1} λ_{i+2}) (Salvi and
 * Várady, *Multi-sided Bézier surfaces over concave polygonal domains*, Computers & Graphics 74,
 * 2018). On sides that do not touch side i, where λ_i + λ_{i+1} = 0, s_i is the limit from inside.
 * Of its derivatives there only those of first order are computed, and only with second-order jets:
 * all others are multiplied by 0 wherever they occur.
 *
 * If reflex corners have a weight, h_i is computed from coordinates that are multiplied by it there
 * and divided by their sum: with a weight above 1 the sides at reflex corners reach further into
 * the surface. The side parameters s_i are those without weights, so that the sides are run at the
 * same pace as without.
 *
 * \tparam T the number type of the coordinates: a `Jet_2`, so that derivatives come along
 *
 * \param domain the domain of the coordinates, with n vertices
 * \param lambda n coordinates
 * \param options δ and the weight of reflex corners; the first has no effect on loops of 3 or 4
 * sides
 * \param parameters an indexable range of n elements of type `Side_parameter<T>` that is
 * overwritten
 *
 * Complexity: O(n).
 */
template <typename T, typename Domain, typename Output>
void compute_side_parameters(const Domain& domain, const T* lambda,
                             const Side_parameter_options& options, Output& parameters) {
  using FT = typename T::FT;
  boost::container::small_vector<T, 16> weighted;
  const T* coordinates = lambda; // for h
  if (options.reflex_weight != 1 && !options.reflex_corners.empty()) {
    internal::weigh_reflex_corners(lambda, domain.size(), options, weighted);
    coordinates = weighted.data();
  }
  internal::sums_of_others(domain, coordinates, parameters);
  for (std::size_t i = 0; i < domain.size(); ++i) {
    const std::size_t next = domain.next(i), prev = domain.prev(i), after = domain.next(next);
    Side_parameter<T>& parameter = parameters[i];
    internal::set_s(lambda[i], lambda[next], parameter);
    parameter.one_minus_h = coordinates[i] + coordinates[next];
    // On loops of 3 or 4 sides λ_{i-1} and λ_{i+2} are not 0 on all other sides, as h needs.
    if (options.dilation != 0 && after != prev && domain.next(after) != prev) {
      const T reduction = coordinates[prev] * coordinates[after] * FT(options.dilation);
      parameter.one_minus_h += parameter.h * reduction;
      parameter.h *= T(FT(1)) - reduction;
    }
  }
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_BARYCENTRIC_SIDE_PARAMETERS_H
