// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_VECTOR_UTILS_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_VECTOR_UTILS_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

inline constexpr double pi = CGAL_PI;

// Directions, lengths and angles need square roots and trigonometry, so they are computed in double
// whatever the kernel is.
using Vec3 = std::array<double, 3>;

template <typename Vector_3>
Vec3 to_vec3(const Vector_3& v) {
  return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
}

inline double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Vec3 sum(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Vec3 difference(const Vec3& a, const Vec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// std::hypot neither overflows nor underflows, so that vectors of any size have a length.
inline double norm(const Vec3& a) {
  return std::hypot(a[0], a[1], a[2]);
}

// The unit vector, or the zero vector if `a` has no direction.
inline Vec3 normalized(const Vec3& a) {
  const double length = norm(a);
  if (!(length > 0) || !std::isfinite(length))
    return {0, 0, 0};
  return {a[0] / length, a[1] / length, a[2] / length};
}

// The angle between two vectors in [0,π], accurate also near 0 and π.
inline double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

// The distance of `p` from the segment ab.
inline double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = difference(b, a), e = difference(p, a);
  const double length = norm(d);
  if (!(length > 0))
    return norm(e);
  const Vec3 along = {d[0] / length, d[1] / length, d[2] / length};
  const double x = (std::min)((std::max)(dot(e, along), 0.0), length);
  return norm({e[0] - x * along[0], e[1] - x * along[1], e[2] - x * along[2]});
}

// The rounding error of the largest coordinate of a loop (model units): what far from the origin
// the differences of its points are uncertain by, whatever their lengths.
template <typename Loop>
double coordinate_rounding(const Loop& loop) {
  const auto& box = loop.bbox();
  double largest = 0;
  for (int c = 0; c < 3; ++c)
    largest = (std::max)({largest, std::abs((box.min)(c)), std::abs((box.max)(c))});
  // Points in exact arithmetic have mostly been rounded before.
  const double epsilon = CGAL::to_double(std::numeric_limits<typename Loop::FT>::epsilon());
  return (std::max)(epsilon, std::numeric_limits<double>::epsilon()) * largest;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_VECTOR_UTILS_H
