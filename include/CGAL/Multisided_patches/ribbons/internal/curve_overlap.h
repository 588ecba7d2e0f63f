// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_CURVE_OVERLAP_H
#define CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_CURVE_OVERLAP_H

#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/ribbons/internal/bezier_pieces.h>
#include <CGAL/Multisided_patches/ribbons/internal/degree_change.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The quotient of two small integers that is closest to t in [0,1] among those that continued
// fractions find, in lowest terms.
inline std::pair<int, int> simple_fraction(double t) {
  constexpr int max_denominator = 1 << 12;
  constexpr double close_enough = 1e-10;
  int p0 = 0, q0 = 1, p = 1, q = 0; // the last two convergents
  double rest = t;
  for (;;) {
    const double whole = std::floor(rest);
    if (whole * q + q0 > max_denominator)
      break;
    const int a = static_cast<int>(whole);
    p0 = std::exchange(p, a * p + p0);
    q0 = std::exchange(q, a * q + q0);
    if (std::abs(static_cast<double>(p) / q - t) < close_enough || rest == whole)
      break;
    rest = 1 / (rest - whole);
  }
  return {p, q};
}

// A curve in double, relative to a point: its position and derivative at t.
class Curve_from_point {
public:
  template <typename Point_3>
  Curve_from_point(const std::vector<Point_3>& curve, const Point_3& point) {
    for (const Point_3& p : curve)
      points_.push_back(to_vec3(p - point));
  }
  std::pair<Vec3, Vec3> operator()(double t) const {
    std::vector<Vec3> p = points_;
    for (std::size_t last = p.size() - 1; last > 1; --last)
      step(p, last, t);
    const Vec3 derivative = difference(p[1], p[0]);
    step(p, 1, t);
    const double d = static_cast<double>(points_.size() - 1);
    return {p[0], {d * derivative[0], d * derivative[1], d * derivative[2]}};
  }
  double distance(double t) const { return norm((*this)(t).first); }
  // A parameter near t where the curve is closest to the point, by Gauss and Newton.
  double closest_from(double t) const {
    constexpr int max_steps = 60; // it takes about 5, but for cusps
    for (int i = 0; i < max_steps; ++i) {
      const auto [position, derivative] = (*this)(t);
      const double speed = dot(derivative, derivative);
      if (!(speed > 0))
        break;
      const double next = (std::min)((std::max)(t - dot(position, derivative) / speed, 0.0), 1.0);
      if (next == t)
        break;
      t = next;
    }
    return t;
  }
  // Whether the bounding box of the control points, and so the curve, is farther away in one
  // coordinate.
  bool box_is_farther_than(double distance) const {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto less = [c](const Vec3& p, const Vec3& q) { return p[c] < q[c]; };
      const auto [min, max] = std::minmax_element(points_.begin(), points_.end(), less);
      if ((*min)[c] > distance || (*max)[c] < -distance)
        return true;
    }
    return false;
  }
  double polygon_length() const {
    double length = 0;
    for (std::size_t j = 1; j < points_.size(); ++j)
      length += norm(difference(points_[j], points_[j - 1]));
    return length;
  }

private:
  static void step(std::vector<Vec3>& p, std::size_t last, double t) {
    for (std::size_t j = 0; j < last; ++j)
      for (std::size_t c = 0; c < 3; ++c)
        p[j][c] += t * (p[j + 1][c] - p[j][c]);
  }
  std::vector<Vec3> points_;
};

// t in the number type of an exact kernel is not where a curve was cut, but a simple fraction may
// be.
template <typename Point_3>
auto cut_parameter(const std::vector<Point_3>& curve, const Point_3& point, double t) {
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  const auto [numerator, denominator] = simple_fraction(t);
  const FT fraction = FT(numerator) / FT(denominator);
  const auto squared_distance_at = [&](const FT& s) -> FT {
    return (split_curve(curve, s).second.front() - point).squared_length();
  };
  return squared_distance_at(fraction) <= squared_distance_at(FT(t)) ? fraction : FT(t);
}

template <typename Point_3>
bool is_close(const Point_3& a, const Point_3& b, double tolerance) {
  return a == b || norm(to_vec3(a - b)) <= tolerance;
}

// The parameters in the open interval (0,1) at which a curve may go through a point; there are none
// for a point that is one of its ends, within `tolerance`.
template <typename Point_3>
auto parameters_of(const std::vector<Point_3>& curve, const Point_3& point, double tolerance) {
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  std::vector<FT> found;
  // What is no end by this test has to be looked for inside, however close to an end it is.
  if (is_close(curve.front(), point, tolerance) || is_close(curve.back(), point, tolerance))
    return found;
  const Curve_from_point from_point(curve, point);
  const double close = (std::max)(tolerance, 1e-12 * from_point.polygon_length());
  if (from_point.box_is_farther_than(close))
    return found;
  const std::size_t samples = 16 * (curve.size() - 1);
  std::vector<double> distances, accepted;
  const auto parameter = [&](std::size_t i) {
    return static_cast<double>(i) / static_cast<double>(samples);
  };
  for (std::size_t i = 0; i <= samples; ++i)
    distances.push_back(from_point.distance(parameter(i)));
  for (std::size_t i = 0; i <= samples; ++i) {
    if ((i > 0 && distances[i - 1] < distances[i]) ||
        (i < samples && distances[i + 1] < distances[i]))
      continue;
    const double t = from_point.closest_from(parameter(i));
    if (!(0 < t && t < 1) || !(from_point.distance(t) <= close))
      continue;
    const bool known = std::any_of(accepted.begin(), accepted.end(),
                                   [&](double other) { return std::abs(t - other) < 1e-9; });
    if (known)
      continue;
    accepted.push_back(t);
    found.push_back(cut_parameter(curve, point, t));
  }
  return found;
}

// Where two curves are the same: the first on [begin,end] and the second on [other_begin,
// other_end], each in its own parameter.
template <typename FT>
struct Curve_overlap {
  FT begin, end, other_begin, other_end;
};

// Whether two curves, of any degrees, are the same within `tolerance`.
template <typename Point_3>
bool same_curve(std::vector<Point_3> a, std::vector<Point_3> b, double tolerance) {
  if (!is_close(a.front(), b.front(), tolerance) || !is_close(a.back(), b.back(), tolerance))
    return false;
  while (a.size() < b.size())
    raise_curve(a);
  while (b.size() < a.size())
    raise_curve(b);
  return same_control_points(a, b, tolerance);
}

// The pairs of parameters at which an overlap may start: at the start of one curve or of both.
template <typename Point_3>
auto overlap_starts(const std::vector<Point_3>& a, const std::vector<Point_3>& b,
                    const Point_3& start_of_a, const Point_3& start_of_b, int end,
                    double tolerance) {
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  std::vector<std::pair<FT, FT>> starts;
  if (is_close(start_of_a, start_of_b, tolerance))
    starts.emplace_back(FT(end), FT(end));
  for (const FT& t : parameters_of(a, start_of_b, tolerance))
    starts.emplace_back(t, FT(end));
  for (const FT& t : parameters_of(b, start_of_a, tolerance))
    starts.emplace_back(FT(end), t);
  return starts;
}

// Where two curves that run the same way are the same, up to a linear change of their parameters:
// on an interval that starts and ends where one of them does.
template <typename Point_3>
auto find_overlap(const std::vector<Point_3>& a, const std::vector<Point_3>& b, double tolerance) {
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  std::optional<Curve_overlap<FT>> none;
  Bbox_3 box_a, box_b;
  for (const Point_3& p : a)
    box_a += p.bbox();
  for (const Point_3& p : b)
    box_b += p.bbox();
  for (int c = 0; c < 3; ++c)
    if (box_a.max(c) + tolerance < box_b.min(c) || box_b.max(c) + tolerance < box_a.min(c))
      return none;
  const auto starts = overlap_starts(a, b, a.front(), b.front(), 0, tolerance);
  if (starts.empty())
    return none;
  const auto ends = overlap_starts(a, b, a.back(), b.back(), 1, tolerance);
  for (const auto& [t0, s0] : starts)
    for (const auto& [t1, s1] : ends)
      if (t0 < t1 && s0 < s1 &&
          same_curve(curve_piece(a, t0, t1), curve_piece(b, s0, s1), tolerance))
        return std::optional<Curve_overlap<FT>>(Curve_overlap<FT>{t0, t1, s0, s1});
  return none;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_CURVE_OVERLAP_H
