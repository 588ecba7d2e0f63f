// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_BASES_INTERNAL_RIBBON_BLENDING_H
#define CGAL_MULTISIDED_PATCHES_BASES_INTERNAL_RIBBON_BLENDING_H

#include <CGAL/Multisided_patches/internal/Number_pack.h>
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

// 1 / x: for jets with a single division, for other types as they divide.
template <typename T>
T reciprocal(const T& x) {
  return T(typename T::FT(1)) / x;
}
template <typename FT, int Order>
Jet_2<FT, Order> reciprocal(const Jet_2<FT, Order>& x) {
  return inverse(x);
}

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

  // The sums of the Bernstein polynomials of a side: of the columns nearer to its start, without
  // their corner weight, of the one in the middle, if there is one, of those nearer to the end, and
  // of the rows.
  template <typename T>
  struct Side_sums {
    T near_start, middle, near_end, across;
  };

  // The weights of a side are products of one factor for the column, which has the corner weight,
  // and one for the row. To be used for one point after the other, so that memory is allocated
  // once.
  template <typename T>
  struct Factors {
    boost::container::small_vector<Side_parameter<T>, 16> parameters;
    boost::container::small_vector<T, 16> at_start, at_end; // corner weights of each side
    boost::container::small_vector<T, 64> along;            // of all sides, one after the other
    boost::container::small_vector<T, 32> across;
    boost::container::small_vector<Side_sums<T>, 16> sums;
    Lane_indices<typename T::FT> nearest_vertex; // that with the largest coordinate
    T deficiency;                                // what all weights lack to 1
  };

  // pre: the ribbons have degrees and layers of at least 1, and no more layers than rows of their
  // cross degree
  explicit Ribbon_blending(std::vector<Ribbon> ribbons) : ribbons_(std::move(ribbons)) {
    for (const Ribbon& ribbon : ribbons_) {
      columns_ += ribbon.degree + 1;
      rows_ += ribbon.layers;
    }
  }

  std::size_t size() const { return ribbons_.size(); }
  const Ribbon& operator[](std::size_t i) const { return ribbons_[i]; }

  // O(n (d + l))
  template <typename T, typename Domain>
  void evaluate(const Domain& domain, const T* lambda, const Side_parameter_options& options,
                Factors<T>& factors) const {
    CGAL_precondition(domain.size() == size());
    const std::size_t n = size();
    factors.parameters.resize(n);
    compute_side_parameters(domain, lambda, options, factors.parameters);
    factors.at_start.resize(n);
    factors.at_end.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      share_corner(factors, domain.prev(i), i);

    factors.along.resize(columns_);
    factors.across.resize(rows_);
    factors.sums.resize(n);
    T *along = factors.along.data(), *across = factors.across.data();
    for (std::size_t i = 0; i < n; ++i) {
      set_side_factors(factors, i, along, across);
      along += ribbons_[i].degree + 1;
      across += ribbons_[i].layers;
    }
    factors.nearest_vertex = nearest_vertex(lambda);
    set_deficiency(domain, factors);
  }

  // Calls f(c, weight) for the control points of all ribbons, ribbon by ribbon and row by row, c
  // counting them from 0.
  template <typename T, typename Function>
  void for_each_weight(const Factors<T>& factors, const Function& f) const {
    std::size_t c = 0;
    const T *along = factors.along.data(), *across = factors.across.data();
    for (const Ribbon& ribbon : ribbons_) {
      for (std::size_t k = 0; k < ribbon.layers; ++k, ++across)
        for (std::size_t j = 0; j <= ribbon.degree; ++j)
          f(c++, along[j] * *across);
      along += ribbon.degree + 1;
    }
  }

  // The sum of weight times (point - origin) over the control points of all ribbons, where
  // `point_of(c)` is that of the c-th one. Rows are summed first: fewer products than with weights.
  template <typename T, typename PointOf>
  std::array<T, 3> combine(const Factors<T>& factors, const PointOf& point_of,
                           const std::array<typename T::FT, 3>& origin) const {
    using FT = typename T::FT;
    std::array<T, 3> sum;
    std::size_t first = 0;
    const T *along = factors.along.data(), *across = factors.across.data();
    for (const Ribbon& ribbon : ribbons_) {
      for (std::size_t k = 0; k < ribbon.layers; ++k, ++across) {
        for (std::size_t c = 0; c < 3; ++c) {
          T row;
          for (std::size_t j = 0; j <= ribbon.degree; ++j)
            row += along[j] * FT(FT(point_of(first + j)[c]) - origin[c]);
          sum[c] += *across * row;
        }
        first += ribbon.degree + 1;
      }
      along += ribbon.degree + 1;
    }
    return sum;
  }

  // The coordinates of control point `index_of(i)`, where i is the nearest vertex.
  template <typename T, typename Point, typename IndexOf>
  static std::array<typename T::FT, 3> origin(const Factors<T>& factors,
                                              const std::vector<Point>& control_net,
                                              const IndexOf& index_of) {
    using FT = typename T::FT;
    std::array<FT, 3> result;
    for (std::size_t l = 0; l < lanes_of<FT>; ++l) {
      const Point& p = control_net[index_of(index_in_lane(factors.nearest_vertex, l))];
      for (std::size_t c = 0; c < 3; ++c)
        set_lane(result[c], l, typename Scalar_of<FT>::type(p[c]));
    }
    return result;
  }

private:
  // The corner weights of side `in` at its end and of side `out` at its start, where the two meet.
  template <typename T>
  void share_corner(Factors<T>& factors, std::size_t in, std::size_t out) const {
    using FT = typename T::FT;
    T &weight_in = factors.at_end[in], &weight_out = factors.at_start[out];
    const std::size_t p = (std::max)(ribbons_[in].layers, ribbons_[out].layers);
    const T &h_in = factors.parameters[in].h, &h_out = factors.parameters[out].h;
    const auto magnitude = [](const T& h) {
      return FT(select(h.value() < FT(0), FT(-h.value()), h.value()));
    };
    const auto nearer_to_in = magnitude(h_in) <= magnitude(h_out);
    const T &numerator = select(nearer_to_in, h_in, h_out),
            &denominator = select(nearer_to_in, h_out, h_in);
    const auto at_corner = denominator.value() == FT(0);
    // The power of the quotient does not underflow, however close to the corner.
    const T power = integer_power(
        numerator / (any(at_corner) ? select(at_corner, T(FT(1)), denominator) : denominator), p);
    const T larger = reciprocal(T(T(FT(1)) + power)), smaller = power * larger;
    weight_in = select(nearer_to_in, larger, smaller);
    weight_out = select(nearer_to_in, smaller, larger);
    if (any(at_corner)) {
      // At the corner itself both sides have the same point, and only the sum of the weights
      // matters.
      const T half(FT(1) / FT(2));
      weight_in = select(at_corner, half, weight_in);
      weight_out = select(at_corner, half, weight_out);
    }
  }

  template <typename T>
  void set_side_factors(Factors<T>& factors, std::size_t i, T* along, T* across) const {
    const Ribbon& ribbon = ribbons_[i];
    const Side_parameter<T>& parameter = factors.parameters[i];
    const std::size_t d = ribbon.degree;
    bernstein_polynomials(d, d + 1, parameter.s, parameter.one_minus_s, along);
    bernstein_polynomials(ribbon.cross_degree, ribbon.layers, parameter.h, parameter.one_minus_h,
                          across);
    Side_sums<T>& sums = factors.sums[i] = Side_sums<T>();
    for (std::size_t j = 0; j <= d; ++j) {
      T& factor = along[j];
      (2 * j < d ? sums.near_start : 2 * j > d ? sums.near_end : sums.middle) += factor;
      if (2 * j != d)
        factor *= 2 * j < d ? factors.at_start[i] : factors.at_end[i];
    }
    for (std::size_t k = 0; k < ribbon.layers; ++k)
      sums.across += across[k];
  }

  template <typename T>
  Lane_indices<typename T::FT> nearest_vertex(const T* lambda) const {
    using FT = typename T::FT;
    auto nearest = same_index<FT>(0);
    FT largest = lambda[0].value();
    for (std::size_t i = 1; i < size(); ++i) {
      const auto is_larger = largest < lambda[i].value();
      nearest = select(is_larger, same_index<FT>(i), nearest);
      largest = select(is_larger, lambda[i].value(), largest);
    }
    return nearest;
  }

  // 1 minus the sum of all weights, in which what the two sides at the nearest corner have there
  // does not cancel.
  template <typename T, typename Domain>
  void set_deficiency(const Domain& domain, Factors<T>& factors) const {
    using FT = typename T::FT;
    const auto& out = factors.nearest_vertex;
    factors.deficiency = gather<T>(out, [&](std::size_t i) {
      const Side_sums<T>& sums = factors.sums[i];
      return lost_at_corner(i, factors.parameters[i], sums, sums.near_end) * factors.at_start[i];
    });
    factors.deficiency += gather<T>(out, [&](std::size_t next) {
      const std::size_t i = domain.prev(next);
      const Side_sums<T>& sums = factors.sums[i];
      return lost_at_corner(i, factors.parameters[i], sums, sums.near_start) * factors.at_end[i];
    });
    for (std::size_t i = 0; i < size(); ++i) {
      const Side_sums<T>& sums = factors.sums[i];
      T along = sums.middle;
      along += select(out == same_index<FT>(i), T(), sums.near_start * factors.at_start[i]);
      along +=
          select(out == same_index<FT>(domain.next(i)), T(), sums.near_end * factors.at_end[i]);
      factors.deficiency -= along * sums.across;
    }
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
  std::size_t columns_ = 0, rows_ = 0; // of all ribbons
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_BASES_INTERNAL_RIBBON_BLENDING_H
