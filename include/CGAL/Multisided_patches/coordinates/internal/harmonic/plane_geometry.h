// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_PLANE_GEOMETRY_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_PLANE_GEOMETRY_H

#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <algorithm>
#include <cmath>

#include <complex>
#include <optional>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// A point or a vector of the (u,v) plane, z = u + iv. Harmonic functions are real parts of analytic
// functions of z, so the whole solver speaks complex.
using Complex = std::complex<double>;

// The product without the recovery from NaN and infinity that std::complex must offer; it inlines.
template <typename Real>
std::complex<Real> product(const std::complex<Real>& a, const std::complex<Real>& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

inline double dot(const Complex& a, const Complex& b) {
  return a.real() * b.real() + a.imag() * b.imag();
}

inline double cross(const Complex& a, const Complex& b) {
  return a.real() * b.imag() - a.imag() * b.real();
}

// Twice the signed area of the triangle (a, b, z), from differences to z: the cancellation, if any,
// is that of the input coordinates. A line in coefficient form loses its sign on tiny triangles.
inline double turn(const Complex& a, const Complex& b, const Complex& z) {
  return cross(a - z, b - z);
}

// Coordinates have unit size; a point that was constructed on a line is off by a few roundings.
inline constexpr double on_line_tolerance = 1e-14;

struct Segment {
  Complex a, b;
};

// whether two segments cross each other in points inside both
inline bool cross_each_other(const Segment& s, const Segment& t) {
  return (turn(s.a, s.b, t.a) > 0) != (turn(s.a, s.b, t.b) > 0) &&
         (turn(t.a, t.b, s.a) > 0) != (turn(t.a, t.b, s.b) > 0);
}

inline double squared_distance(const Complex& z, const Segment& s) {
  const Complex d = s.b - s.a;
  const double t = dot(z - s.a, d) / std::norm(d);
  if (!(t > 0)) // also for a segment that is a point
    return std::norm(z - s.a);
  return t < 1 ? std::norm(z - s.a - t * d) : std::norm(z - s.b);
}

// A half-plane: the left side of a line.
struct Half_plane {
  Complex origin, direction; // a unit vector

  double signed_distance(const Complex& z) const { return cross(direction, z - origin); }
  bool contains(const Complex& z) const { return signed_distance(z) >= -on_line_tolerance; }
};

inline std::optional<Segment> clip(const Segment& s, const Half_plane& h) {
  const double da = h.signed_distance(s.a), db = h.signed_distance(s.b);
  if (da < 0 && db < 0)
    return std::nullopt;
  if (da >= 0 && db >= 0)
    return s;
  const Complex z = s.a + (da / (da - db)) * (s.b - s.a);
  return da < 0 ? Segment{z, s.b} : Segment{s.a, z};
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_PLANE_GEOMETRY_H
