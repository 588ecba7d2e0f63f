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
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The weights of control points at a few consecutive samples of a surface, and the products of
// weights and control points: points, and with order 1 first derivatives. Weights of one control
// point are next to each other; control points without influence here have none.
//
// Storage is the number type of the weights, `double` or `float`. Where all control points are
// taken together, so are products and their sums; all else is in `double`.
template <typename Storage, int Order>
class Weight_block {
public:
  static constexpr std::size_t samples = 64;
  // of a weight: its value and, with order 1, the derivatives by u and v
  static constexpr std::size_t parts = Jet_2<double, Order>::size;
  static constexpr std::size_t row = parts * samples;

  // `dense` has, for one control point after the other, the values at all samples, and then the
  // derivatives; 0 at samples that there are not.
  void set_weights(const std::vector<double>& dense) {
    const std::size_t size = dense.size() / row;
    std::size_t count = 0;
    const auto has_influence = [&](std::size_t c) {
      return std::any_of(&dense[c * row], &dense[c * row] + row, [](double w) { return w != 0; });
    };
    std::vector<bool> needed(size);
    for (std::size_t c = 0; c < size; ++c) {
      needed[c] = has_influence(c);
      count += needed[c] ? 1 : 0;
    }
    points_.reserve(count);
    weights_.reserve(count * row);
    double largest = -1;
    for (std::size_t c = 0; c < size; ++c)
      if (needed[c]) {
        points_.push_back(static_cast<std::uint32_t>(c));
        for (std::size_t k = 0; k < row; ++k) {
          const double w = dense[c * row + k];
          weights_.push_back(static_cast<Storage>(w));
          if (std::abs(w) > largest) {
            largest = std::abs(w);
            origin_ = c;
          }
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
    std::array<Storage, 3 * row> sums; // in units of `unit`
    sums.fill(0);
    Weighted_triples<Storage, together> rows;
    for (std::size_t e = 0; e < points_.size(); e += together) {
      for (std::size_t i = 0; i < together; ++i) {
        // Beyond the last point: any weights, times 0.
        const bool exists = e + i < points_.size();
        rows.weights[i] = &weights_[(exists ? e + i : e) * row];
        const std::array<double, 3>& p = exists ? net[points_[e + i]] : o;
        for (std::size_t c = 0; c < 3; ++c)
          rows.triples[i][c] = static_cast<Storage>((p[c] - o[c]) / unit);
      }
      add_weighted_triples<samples, parts>(rows, sums.data());
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
      const auto found = std::lower_bound(points_.begin(), points_.end(), c);
      if (found != points_.end() && *found == c)
        add(&weights_[static_cast<std::size_t>(found - points_.begin()) * row], motion[c]);
    }
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

  // How many rows are read side by side.
  static constexpr std::size_t together = std::is_same_v<Storage, float> ? 8 : 4;

  void set_result(std::size_t part, std::size_t c, const Storage* sums, double unit,
                  double origin) {
    const Number_pack factor(unit), offset(origin);
    double* const values = result(part, c);
    for (std::size_t k = 0; k < samples; k += lanes)
      (offset + factor * Number_pack::load(sums + k)).store(values + k);
  }

  // Adds the products of the motion of one control point with its weights.
  void add(const Storage* weights, const std::array<double, 3>& motion) {
    const Number_pack mx(motion[0]), my(motion[1]), mz(motion[2]);
    for (std::size_t part = 0; part < parts; ++part) {
      double *const x = result(part, 0), *const y = result(part, 1), *const z = result(part, 2);
      for (std::size_t k = 0; k < samples; k += Number_pack::lanes) {
        prefetch_next_results(part * samples + k);
        const Number_pack w = Number_pack::load(weights + part * samples + k);
        (w * mx).add_to(x + k);
        (w * my).add_to(y + k);
        (w * mz).add_to(z + k);
      }
    }
  }

  // The results of the next block, if blocks are elements of an array: those at the same places as
  // three packs here.
  void prefetch_next_results(std::size_t number) const {
    constexpr std::size_t share = 3 * sizeof(double);
    if (number * share % 64 < Number_pack::lanes * share)
      prefetch_memory(&results_, sizeof(*this) + number * share);
  }

  static bool any_is_undefined(const Number_pack& x) { return !(x[0] == x[0] && x[1] == x[1]); }

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
  std::vector<Storage> weights_;      // `row` for each of them
  std::size_t origin_ = 0;
  // x, y and z for all samples of points and derivatives
  alignas(16) std::array<double, parts * 3 * samples> results_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_WEIGHT_BLOCK_H
