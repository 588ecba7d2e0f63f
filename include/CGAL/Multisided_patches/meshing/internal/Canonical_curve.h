// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CANONICAL_CURVE_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CANONICAL_CURVE_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/internal/even_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A curve, known by its points at parameters in [0,1] (model units).
using Curve_3 = std::function<Vec3(double)>;

/*
 * A curve in a form that depends neither on the direction in which it is run nor on its size: run
 * from the end whose points come first lexicographically, moved to the origin, and scaled by a
 * power of 2 so that coordinates differ by 1 to 2. What is computed from this form in whatever
 * order is the same, bit for bit, for the curve and its reverse.
 *
 * A curve that runs back the way it came has no such end. It is folded: its form is that of its
 * first half, and samples are mirrored.
 */
class Canonical_curve {
public:
  // \throws Numerical_error if a point is not finite; `name` says which curve that is
  Canonical_curve(Curve_3 point, std::string name)
      : point_(std::move(point)), name_(std::move(name)) {
    std::vector<Vec3> probes;
    for (int k = 0; k <= number_of_probes; ++k)
      probes.push_back(point_at(static_cast<double>(k) / number_of_probes));
    set_size(probes);
    set_direction(probes);
    const Vec3 start = canonical_point(0);
    for (std::size_t c = 0; c < 3; ++c)
      half_origin_[c] = start[c] / 2;
  }

  // whether the curve does not leave its first point
  bool is_a_point() const { return is_a_point_; }

  // A point of the canonical form. \pre `t` is a multiple of 2^-53 in [0,1]
  Vec3 operator()(double t) const {
    Vec3 p = canonical_point(t);
    for (std::size_t c = 0; c < 3; ++c)
      p[c] = std::ldexp(p[c] / 2 - half_origin_[c], exponent_);
    return p;
  }

  // Lengths of the canonical form, for lengths in model units, and back.
  double scaled(double length) const { return std::ldexp(length / 2, exponent_); }
  double unscaled(double length) const { return std::ldexp(length, 1 - exponent_); }
  // About the rounding error of the coordinates of points, in units of the canonical form.
  double rounding() const { return rounding_; }

  // The parameters of the curve itself, strictly inside (0,1), for increasing ones of this form.
  std::vector<double> parameters(const std::vector<double>& samples) const {
    std::vector<double> result;
    result.reserve(folded_ ? 2 * samples.size() + 1 : samples.size());
    for (const double t : samples)
      result.push_back(with_exact_complement(folded_ ? t / 2 : t));
    if (folded_) {
      result.push_back(0.5);
      for (std::size_t k = samples.size(); k > 0; --k)
        result.push_back(1 - result[k - 1]);
    } else if (backwards_) {
      std::reverse(result.begin(), result.end());
      for (double& s : result)
        s = 1 - s;
    }
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

private:
  // A curve that looks folded at so many points is; if it is not, its samples are still valid.
  static constexpr int number_of_probes = 128;
  // Points of a folded curve differ by their rounding; relative to the largest coordinate.
  static constexpr double folding_tolerance = 64 * 0x1p-53;

  Vec3 point_at(double s) const {
    const Vec3 p = point_(s);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      throw Numerical_error(name_ + ": the point at s = " + to_short_text(s) + " is not finite");
    return p;
  }

  Vec3 canonical_point(double t) const {
    if (!folded_)
      return point_at(backwards_ ? 1 - t : t);
    const double s = with_exact_complement(t / 2);
    return (std::min)(point_at(s), point_at(1 - s));
  }

  void set_size(const std::vector<Vec3>& probes) {
    double half_size = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      double low = probes[0][c], high = low;
      for (const Vec3& p : probes) {
        low = (std::min)(low, p[c]);
        high = (std::max)(high, p[c]);
      }
      half_size = (std::max)(half_size, high / 2 - low / 2); // halved, it cannot overflow
      largest_coordinate_ = (std::max)({largest_coordinate_, std::abs(low), std::abs(high)});
    }
    is_a_point_ = !(half_size > 0);
    exponent_ = is_a_point_ ? 0 : -std::ilogb(half_size);
    rounding_ = scaled(4 * 0x1p-53 * largest_coordinate_);
  }

  void set_direction(const std::vector<Vec3>& probes) {
    const std::size_t last = probes.size() - 1;
    folded_ = !is_a_point_;
    for (std::size_t k = 0; folded_ && 2 * k < last; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        folded_ = folded_ && std::abs(probes[k][c] - probes[last - k][c]) <=
                                 folding_tolerance * largest_coordinate_;
    for (std::size_t k = 0; 2 * k < last; ++k)
      if (probes[k] != probes[last - k]) {
        backwards_ = probes[last - k] < probes[k];
        return;
      }
  }

  Curve_3 point_;
  std::string name_;
  bool is_a_point_ = false, folded_ = false, backwards_ = false;
  double largest_coordinate_ = 0, rounding_ = 0;
  int exponent_ = 0; // of the power of 2 by which halves of coordinates are multiplied
  Vec3 half_origin_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CANONICAL_CURVE_H
