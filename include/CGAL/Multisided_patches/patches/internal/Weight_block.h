// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_WEIGHT_BLOCK_H
#define CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_WEIGHT_BLOCK_H

#include <CGAL/Multisided_patches/internal/Number_pack.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/patches/internal/add_weighted_triples.h>
#include <CGAL/Multisided_patches/patches/internal/surface_derivatives.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The weights of control points at a few consecutive samples of a surface, and the products of
// weights and control points: points, and with order 1 first derivatives. Control points without
// influence here have no weights.
//
// Weights are in the order in which they are used where all control points are taken together, so
// that memory is read straight on. A strip has the values, or one of the derivatives, at as many
// samples as sums of them fit into registers: a row for one control point after the other.
//
// Storage is the number type of the weights, `double` or `float`. Where all control points are
// taken together, so are products and their sums; all else is in `double`.
template <typename Storage, int Order>
class Weight_block {
public:
  static constexpr std::size_t samples = 64;
  // of a weight: its value and, with order 1, the derivatives by u and v
  static constexpr std::size_t parts = Jet_2<double, Order>::size;
  static constexpr std::size_t weights_of_point = parts * samples;
  static constexpr std::size_t row_length = 128 / sizeof(Storage); // of a strip

  // `dense` has, for one control point after the other, the values at all samples, and then the
  // derivatives; 0 at samples that there are not.
  void set_weights(const std::vector<double>& dense) {
    for (std::size_t c = 0; c < dense.size() / weights_of_point; ++c)
      if (has_nonzero(&dense[c * weights_of_point], weights_of_point))
        points_.push_back(static_cast<std::uint32_t>(c));
    points_.shrink_to_fit();
    weights_.reserve(points_.size() * weights_of_point);
    double largest = -1;
    for (std::size_t strip = 0; strip < strips; ++strip)
      for (const std::size_t c : points_)
        for (std::size_t k = 0; k < row_length; ++k) {
          const double w = dense[c * weights_of_point + first_of(strip) + k];
          weights_.push_back(static_cast<Storage>(w));
          if (std::abs(w) > largest) {
            largest = std::abs(w);
            origin_ = c;
          }
        }
  }

  std::size_t number_of_weights() const { return weights_.size(); }
  std::size_t number_of_bytes() const {
    return sizeof(*this) + weights_.capacity() * sizeof(Storage) +
           points_.capacity() * sizeof(std::uint32_t);
  }

  // Computes everything from the control net, whose size is not much larger than `unit`, a power of
  // two: lengths relative to that are in the range of `Storage`.
  //
  // As the weights sum to 1, any point may be the origin. Near a corner the derivatives of some
  // weights are large, and only their sum is not; so it is the point that has the largest.
  void compute(const std::vector<std::array<double, 3>>& net, double unit) {
    const std::array<double, 3> o = net[origin_];
    std::array<Storage, 3 * weights_of_point> sums; // in units of `unit`
    sums.fill(0);
    constexpr std::size_t together = 64; // as many as models have, so that reading goes straight on
    std::array<std::array<Storage, 3>, together> triples;
    for (std::size_t first = 0; first < points_.size(); first += together) {
      const std::size_t count = (std::min)(together, points_.size() - first);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 3; ++c)
          triples[i][c] = static_cast<Storage>((net[points_[first + i]][c] - o[c]) / unit);
      for (std::size_t strip = 0; strip < strips; ++strip)
        add_weighted_triples<row_length>(weights(strip, first), triples.data(), count,
                                         &sums[first_result_of(strip)], samples);
    }
    for (std::size_t part = 0; part < parts; ++part)
      for (std::size_t c = 0; c < 3; ++c)
        set_result(part, c, &sums[(part * 3 + c) * samples], unit, part == 0 ? o[c] : 0);
  }

  // Adds what changes if control points move: those with the given indices, in ascending order, by
  // `motion[index]`.
  void move(const std::vector<std::size_t>& indices,
            const std::vector<std::array<double, 3>>& motion) {
    for (const std::size_t c : indices) {
      const std::size_t i = index_of(c);
      if (i < points_.size())
        add(i, motion[c]);
    }
  }

  // Asks memory for what move() will need, which lies too scattered for processors to foresee.
  void prefetch_move(const std::vector<std::size_t>& indices) const {
    bool moves = false;
    for (const std::size_t c : indices) {
      const std::size_t i = index_of(c);
      if (i == points_.size())
        continue;
      moves = true;
      for (std::size_t strip = 0; strip < strips; ++strip)
        prefetch(weights(strip, i), row_length);
    }
    if (moves)
      prefetch(results_.data(), results_.size());
  }

  // coordinate `c` of a point, part 0, or a derivative, parts 1 and 2
  double value(std::size_t part, std::size_t c, std::size_t sample) const {
    return results_[(part * 3 + c) * samples + sample];
  }

  // Numbers that are worked on at once in `double`, and the normals at the samples from `k` on, as
  // many, which is a multiple of that. pre: order 1
  static constexpr std::size_t lanes = Number_pack::lanes;
  std::array<Vec3, lanes> normals(std::size_t k) const {
    const auto u = pack(1, k), v = pack(2, k);
    const std::array<Number_pack, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                       u[0] * v[1] - u[1] * v[0]};
    const Number_pack nn = square(n), uu = square(u), vv = square(v);
    const Number_pack inverse = Number_pack(1) / sqrt(nn);
    // Far from where derivatives are too large, too small or too parallel.
    const Number_pack least = select(uu < vv, uu, vv), most = select(uu < vv, vv, uu);
    const bool needs_care = any(nn < uu * vv * 1e-12) || any(least <= most * 1e-20) ||
                            any(nn <= 1e-200) || any(1e200 <= most * most) || any_is_undefined(nn);
    const std::array<Number_pack, 3> unit_normal{n[0] * inverse, n[1] * inverse, n[2] * inverse};
    std::array<Vec3, lanes> result;
    for (std::size_t l = 0; l < lanes; ++l)
      result[l] = needs_care ? tangent_plane_normal(derivative(1, k + l), derivative(2, k + l))
                             : Vec3{unit_normal[0][l], unit_normal[1][l], unit_normal[2][l]};
    return result;
  }

private:
  double* result(std::size_t part, std::size_t c) { return &results_[(part * 3 + c) * samples]; }

  static constexpr std::size_t strips = weights_of_point / row_length;
  static_assert(samples % row_length == 0 && row_length % lanes == 0);
  // Where a strip begins in what has the values at all samples first, and then the derivatives.
  static constexpr std::size_t first_of(std::size_t strip) {
    return strip % parts * samples + strip / parts * row_length;
  }
  static constexpr std::size_t first_result_of(std::size_t strip) {
    return strip % parts * 3 * samples + strip / parts * row_length;
  }

  // The row of a strip for the i-th control point that has influence.
  const Storage* weights(std::size_t strip, std::size_t i) const {
    return &weights_[(strip * points_.size() + i) * row_length];
  }

  // Which one of those with influence a control point is; their number if it has none.
  std::size_t index_of(std::size_t c) const {
    const auto found = std::lower_bound(points_.begin(), points_.end(), c);
    return found != points_.end() && *found == c ? static_cast<std::size_t>(found - points_.begin())
                                                 : points_.size();
  }

  // Into the cache of the second level: what several control points need may be too much for the
  // first. pre: count > 0
  template <typename Number>
  static void prefetch([[maybe_unused]] const Number* numbers, [[maybe_unused]] std::size_t count) {
#ifdef __GNUC__
    constexpr std::size_t line = 64 / sizeof(Number);
    for (std::size_t k = 0; k < count; k += line)
      __builtin_prefetch(numbers + k, 0, 2);
    __builtin_prefetch(numbers + count - 1, 0, 2); // they need not begin where a line does
#endif
  }

  static bool has_nonzero(const double* numbers, std::size_t count) {
    return std::any_of(numbers, numbers + count, [](double w) { return w != 0; });
  }

  void set_result(std::size_t part, std::size_t c, const Storage* sums, double unit,
                  double origin) {
    const Number_pack factor(unit), offset(origin);
    double* const values = result(part, c);
    for (std::size_t k = 0; k < samples; k += lanes)
      (offset + factor * Number_pack::load(sums + k)).store(values + k);
  }

  // Adds the products of the motion of the i-th control point that has influence with its weights.
  void add(std::size_t i, const std::array<double, 3>& motion) {
    const Number_pack mx(motion[0]), my(motion[1]), mz(motion[2]);
    for (std::size_t strip = 0; strip < strips; ++strip) {
      const Storage* const w = weights(strip, i);
      double* const x = &results_[first_result_of(strip)];
      for (std::size_t k = 0; k < row_length; k += lanes) {
        const Number_pack weight = Number_pack::load(w + k);
        (weight * mx).add_to(x + k);
        (weight * my).add_to(x + samples + k);
        (weight * mz).add_to(x + 2 * samples + k);
      }
    }
  }

  static bool any_is_undefined(const Number_pack& x) {
    return !(x[0] == x[0] && x[1] == x[1]);
  }

  std::array<Number_pack, 3> pack(std::size_t part, std::size_t k) const {
    return {load(part, 0, k), load(part, 1, k), load(part, 2, k)};
  }
  Number_pack load(std::size_t part, std::size_t c, std::size_t k) const {
    return Number_pack::load(&results_[(part * 3 + c) * samples + k]);
  }

  static Number_pack square(const std::array<Number_pack, 3>& v) {
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  }

  Vec3 derivative(std::size_t part, std::size_t k) const {
    return {value(part, 0, k), value(part, 1, k), value(part, 2, k)};
  }

  std::vector<std::uint32_t> points_; // the indices of those with influence, ascending
  std::vector<Storage> weights_;      // strip by strip
  std::size_t origin_ = 0;
  // x, y and z for all samples of points and derivatives
  alignas(16) std::array<double, parts * 3 * samples> results_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_WEIGHT_BLOCK_H
