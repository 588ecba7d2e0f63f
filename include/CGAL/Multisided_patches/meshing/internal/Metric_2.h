// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_2_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_2_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Points and vectors of the domain in double: positions to aim at, which predicates then judge.
struct Uv {
  double x, y;
};

inline Uv operator+(const Uv& a, const Uv& b) {
  return {a.x + b.x, a.y + b.y};
}
inline Uv operator-(const Uv& a, const Uv& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Uv operator*(double s, const Uv& a) {
  return {s * a.x, s * a.y};
}
inline double cross(const Uv& a, const Uv& b) {
  return a.x * b.y - a.y * b.x;
}

template <typename Point_2>
Uv to_uv(const Point_2& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

// A symmetric positive definite tensor, which tells how long the vectors of the domain are meant to
// be: with the first fundamental form of a surface as long as on the surface, divided by the square
// of the wanted edge length as multiples of that.
struct Metric_2 {
  double E, F, G;

  double dot(const Uv& a, const Uv& b) const {
    return E * a.x * b.x + F * (a.x * b.y + a.y * b.x) + G * a.y * b.y;
  }
  double squared_norm(const Uv& a) const { return dot(a, a); }
  double norm(const Uv& a) const { return std::sqrt((std::max)(0.0, dot(a, a))); }
  double determinant() const { return E * G - F * F; }
  // The ratio of areas in this metric and in the domain.
  double area_factor() const { return std::sqrt((std::max)(0.0, determinant())); }

  friend Metric_2 operator+(const Metric_2& a, const Metric_2& b) {
    return {a.E + b.E, a.F + b.F, a.G + b.G};
  }
  friend Metric_2 operator*(double s, const Metric_2& a) { return {s * a.E, s * a.F, s * a.G}; }
};

// A triangle of the domain as a metric sees it.
class Metric_triangle {
public:
  Metric_triangle(const std::array<Uv, 3>& p, const Metric_2& metric) : p_(p), metric_(metric) {
    for (int i = 0; i < 3; ++i)
      squared_lengths_[i] = metric.squared_norm(p[(i + 2) % 3] - p[(i + 1) % 3]);
    area_ = metric.area_factor() * cross(p[1] - p[0], p[2] - p[0]) / 2;
  }

  // Of the edge opposite to corner i.
  double squared_length(int i) const { return squared_lengths_[i]; }
  int shortest_edge() const {
    return static_cast<int>(std::min_element(squared_lengths_.begin(), squared_lengths_.end()) -
                            squared_lengths_.begin());
  }
  double area() const { return area_; }
  // Infinite or not a number for triangles without area.
  double squared_circumradius() const {
    return squared_lengths_[0] * squared_lengths_[1] * squared_lengths_[2] / (16 * area_ * area_);
  }
  Uv circumcenter() const {
    // x - p0 has the products |b|²/2 and |c|²/2 with the edges b and c from p0.
    const Uv b = p_[1] - p_[0], c = p_[2] - p_[0];
    const double d = cross(b, c), k = squared_lengths_[2] / 2, l = squared_lengths_[1] / 2;
    const Uv y{(k * c.y - l * b.y) / d, (l * b.x - k * c.x) / d}; // the metric times (x - p0)
    const double det = metric_.determinant();
    return p_[0] +
           Uv{(metric_.G * y.x - metric_.F * y.y) / det, (metric_.E * y.y - metric_.F * y.x) / det};
  }

private:
  std::array<Uv, 3> p_;
  Metric_2 metric_;
  std::array<double, 3> squared_lengths_;
  double area_;
};

// Whether a triangle asks for a point inside: it is too large to have edges of about length 1, or
// so sharp that refinement can do better.
inline bool is_too_large_or_sharp(const Metric_triangle& t) {
  // Of triangles with edges of length 1 it is 0.58.
  constexpr double max_circumradius = 0.74;
  // The ratio of circumradius and shortest edge where the sharpest angle is 20.7 degrees.
  constexpr double max_ratio = 1.4143;
  const double square = t.squared_circumradius();
  return !(square <= max_circumradius * max_circumradius) ||
         square > max_ratio * max_ratio * t.squared_length(t.shortest_edge());
}

// Whether a triangle ought to be smoothed: it has an angle below 32 degrees.
inline bool is_sharp(const Metric_triangle& t) {
  constexpr double max_squared_ratio = 0.89; // of circumradius and shortest edge
  return t.squared_circumradius() > max_squared_ratio * t.squared_length(t.shortest_edge());
}

// Whether the quadrilateral a, b, c, d, counterclockwise, is better divided by b d than by a c: its
// angles at b and d, opposite to a c, are larger than π together.
inline bool prefers_other_diagonal(const Uv& a, const Uv& b, const Uv& c, const Uv& d,
                                   const Metric_2& metric) {
  const Uv ba = a - b, bc = c - b, da = a - d, dc = c - d;
  const double cos_b = metric.dot(ba, bc), cos_d = metric.dot(da, dc);
  const double factor = metric.area_factor();
  const double sin_b = factor * cross(bc, ba), sin_d = factor * cross(da, dc);
  // The slack keeps rounding from flipping back and forth.
  const double sine = cos_b * sin_d + sin_b * cos_d;
  return sine < -1e-12 * (std::abs(cos_b * sin_d) + std::abs(sin_b * cos_d));
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_2_H
