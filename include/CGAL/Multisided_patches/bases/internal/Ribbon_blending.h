// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_BASES_INTERNAL_RIBBON_BLENDING_H
#define CGAL_MULTISIDED_PATCHES_BASES_INTERNAL_RIBBON_BLENDING_H

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
namespace internal {

// The weights of the control points of ribbons around a domain, as generalized Bézier patches have
// them before anything is done about their sum: for control point (j,k) of side i
// μ^i_{j,k} B^d_j(s_i) B^m_k(h_i), where d and m are the degrees along and across the side. The
// corner weights are
//   - μ = h_{i-1}^p / (h_{i-1}^p + h_i^p) for 2j < d,
//   - μ = 1 for 2j = d,
//   - μ = h_{i+1}^p / (h_{i+1}^p + h_i^p) for 2j > d,
// where p is the larger number of layers of the two sides that meet at the corner.
class Ribbon_blending {
public:
  struct Ribbon {
    std::size_t degree, layers, cross_degree;
  };

  // The weights of a side are products of one factor for the column, which has the corner weight,
  // and one for the row.
  template <typename T>
  struct Side_factors {
    boost::container::small_vector<T, 8> along, across;
  };
  template <typename T>
  struct Factors {
    boost::container::small_vector<Side_parameter<T>, 16> parameters;
    boost::container::small_vector<T, 16> at_start, at_end; // corner weights of each side
    boost::container::small_vector<Side_factors<T>, 8> sides;
    T deficiency; // what all weights lack to 1
  };

  // pre: the ribbons have degrees and layers of at least 1, and no more layers than rows of their
  // cross degree
  explicit Ribbon_blending(std::vector<Ribbon> ribbons) : ribbons_(std::move(ribbons)) {}

  std::size_t size() const { return ribbons_.size(); }
  const Ribbon& operator[](std::size_t i) const { return ribbons_[i]; }

  // O(n (d + l))
  template <typename T, typename Domain>
  Factors<T> evaluate(const Domain& domain, const T* lambda,
                      const Side_parameter_options& options) const {
    CGAL_precondition(domain.size() == size());
    const std::size_t n = size();
    Factors<T> factors;
    factors.parameters.resize(n);
    compute_side_parameters(domain, lambda, options, factors.parameters);
    factors.at_start.resize(n);
    factors.at_end.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      share_corner(factors, domain.prev(i), i);

    factors.sides.resize(n);
    boost::container::small_vector<Side_sums<T>, 16> sums(n);
    for (std::size_t i = 0; i < n; ++i)
      sums[i] = set_side_factors(factors, i);
    const std::size_t out = nearest_vertex(lambda), in = domain.prev(out);
    factors.deficiency =
        lost_at_corner(in, factors.parameters[in], sums[in], sums[in].near_start) *
            factors.at_end[in] +
        lost_at_corner(out, factors.parameters[out], sums[out], sums[out].near_end) *
            factors.at_start[out];
    for (std::size_t i = 0; i < n; ++i) {
      T along = sums[i].middle;
      if (i != out)
        along += sums[i].near_start * factors.at_start[i];
      if (i != in)
        along += sums[i].near_end * factors.at_end[i];
      factors.deficiency -= along * sums[i].across;
    }
    return factors;
  }

  // The vertex with the largest coordinate.
  template <typename T>
  std::size_t nearest_vertex(const T* lambda) const {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < size(); ++i)
      if (lambda[nearest].value() < lambda[i].value())
        nearest = i;
    return nearest;
  }

  // Calls f(c, weight) for the control points of all ribbons, ribbon by ribbon and row by row, c
  // counting them from 0.
  template <typename T, typename Function>
  static void for_each_weight(const Factors<T>& factors, const Function& f) {
    std::size_t c = 0;
    for (const Side_factors<T>& side : factors.sides)
      for (const T& across : side.across)
        for (const T& along : side.along)
          f(c++, along * across);
  }

  // The sum of weight times (point - origin) over the control points of all ribbons, where
  // `point_of(c)` is that of the c-th one. Rows are summed first: fewer products than with weights.
  template <typename T, typename PointOf>
  static std::array<T, 3> combine(const Factors<T>& factors, const PointOf& point_of,
                                  const std::array<typename T::FT, 3>& origin) {
    using FT = typename T::FT;
    std::array<T, 3> sum;
    std::size_t index = 0;
    for (const Side_factors<T>& side : factors.sides)
      for (const T& across : side.across) {
        std::array<T, 3> row;
        for (const T& along : side.along) {
          const auto& point = point_of(index++);
          for (std::size_t c = 0; c < 3; ++c)
            row[c] += along * FT(FT(point[c]) - origin[c]);
        }
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += across * row[c];
      }
    return sum;
  }

private:
  // The corner weights of side `in` at its end and of side `out` at its start, where the two meet.
  template <typename T>
  void share_corner(Factors<T>& factors, std::size_t in, std::size_t out) const {
    using FT = typename T::FT;
    T &weight_in = factors.at_end[in], &weight_out = factors.at_start[out];
    const std::size_t p = (std::max)(ribbons_[in].layers, ribbons_[out].layers);
    const T &h_in = factors.parameters[in].h, &h_out = factors.parameters[out].h;
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
    const T power = integer_power(nearer_to_in ? h_in / h_out : h_out / h_in, p);
    const T larger = T(FT(1)) / (T(FT(1)) + power), smaller = power * larger;
    weight_in = nearer_to_in ? larger : smaller;
    weight_out = nearer_to_in ? smaller : larger;
  }

  // The sums of the Bernstein polynomials of a side: of the columns nearer to its start, without
  // their corner weight, of the one in the middle, if there is one, of those nearer to the end, and
  // of the rows.
  template <typename T>
  struct Side_sums {
    T near_start, middle, near_end, across;
  };

  template <typename T>
  Side_sums<T> set_side_factors(Factors<T>& factors, std::size_t i) const {
    const Ribbon& ribbon = ribbons_[i];
    const Side_parameter<T>& parameter = factors.parameters[i];
    Side_factors<T>& side = factors.sides[i];
    const std::size_t d = ribbon.degree;
    side.along.resize(d + 1);
    side.across.resize(ribbon.layers);
    bernstein_polynomials(d, d + 1, parameter.s, parameter.one_minus_s, side.along.data());
    bernstein_polynomials(ribbon.cross_degree, ribbon.layers, parameter.h, parameter.one_minus_h,
                          side.across.data());
    Side_sums<T> sums;
    for (std::size_t j = 0; j <= d; ++j) {
      T& factor = side.along[j];
      (2 * j < d ? sums.near_start : 2 * j > d ? sums.near_end : sums.middle) += factor;
      if (2 * j != d)
        factor *= 2 * j < d ? factors.at_start[i] : factors.at_end[i];
    }
    for (const T& factor : side.across)
      sums.across += factor;
    return sums;
  }

  // What the polynomials of a side near one of its ends lack to 1; `far` is the sum of the columns
  // nearer to the other end. The two corner weights of an end have the sum 1, so these deficits
  // make up that of all weights there. Close to the corner, where the deficit is small and is
  // multiplied by the large derivatives of the corner weights, it has to be the sum of the other
  // polynomials.
  template <typename T>
  T lost_at_corner(std::size_t i, const Side_parameter<T>& parameter, const Side_sums<T>& sums,
                   const T& far) const {
    const Ribbon& ribbon = ribbons_[i];
    boost::container::small_vector<T, 8> inner_rows(ribbon.cross_degree + 1 - ribbon.layers);
    T lost;
    if (!inner_rows.empty())
      bernstein_polynomials(ribbon.cross_degree, inner_rows.size(), parameter.one_minus_h,
                            parameter.h, inner_rows.data());
    for (const T& row : inner_rows)
      lost += row;
    return lost + (far + sums.middle) * sums.across;
  }

  std::vector<Ribbon> ribbons_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_BASES_INTERNAL_RIBBON_BLENDING_H
