// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_SURFACE_DERIVATIVES_H
#define CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_SURFACE_DERIVATIVES_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A point of a surface with its partial derivatives by two parameters.
struct Surface_derivatives {
  Vec3 point, u, v, uu, uv, vv;
};

template <typename FT>
Surface_derivatives to_surface_derivatives(const std::array<Jet_2<FT, 2>, 3>& surface) {
  const auto entry = [&](std::size_t k) {
    return Vec3{CGAL::to_double(surface[0][k]), CGAL::to_double(surface[1][k]),
                CGAL::to_double(surface[2][k])};
  };
  return {entry(0), entry(1), entry(2), entry(3), entry(4), entry(5)};
}

inline bool all_finite(const Surface_derivatives& s) {
  const auto finite = [](const Vec3& a) {
    return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
  };
  return finite(s.u) && finite(s.v) && finite(s.uu) && finite(s.uv) && finite(s.vv);
}

// The unit normal of the plane that two vectors span, or the zero vector if they span none.
inline Vec3 tangent_plane_normal(const Vec3& a, const Vec3& b) {
  // The sine of an angle below which two directions are the same line up to rounding, and a ratio
  // of lengths below which the shorter vector is a rounding error of the longer one.
  constexpr double smallest_sine = 1e-9, smallest_ratio = 1e-14;
  const double u = norm(a), v = norm(b);
  const Vec3 normal = cross(normalized(a), normalized(b));
  const bool spans_plane =
      norm(normal) > smallest_sine && u > smallest_ratio * v && v > smallest_ratio * u;
  return spans_plane ? normalized(normal) : Vec3{0, 0, 0};
}

inline Vec3 tangent_plane_normal(const Surface_derivatives& s) {
  return tangent_plane_normal(s.u, s.v);
}

// An orthonormal basis of a tangent plane, in which S_u = (a, 0) and S_v = (b, c); a > 0, and c has
// the sign of (S_u × S_v) · normal.
struct Tangent_frame {
  Vec3 e1, e2;
  double a, b, c;

  // pre: the derivatives span a plane that is perpendicular to the normal
  Tangent_frame(const Surface_derivatives& s, const Vec3& normal)
      : e1(normalized(s.u)), e2(normalized(cross(normal, e1))), a(norm(s.u)), b(dot(s.v, e1)),
        c(dot(s.v, e2)) {}
};

// The second fundamental form in an orthonormal basis of the tangent plane: the symmetric matrix
// of the shape operator. Its eigenvalues are the principal curvatures.
struct Shape_operator {
  double p, q, r; // (p q; q r)

  Shape_operator(const Surface_derivatives& s, const Vec3& normal, const Tangent_frame& frame) {
    const double slope = frame.b / frame.a;
    const double uu = dot(s.uu, normal), uv = dot(s.uv, normal), vv = dot(s.vv, normal);
    p = uu / frame.a / frame.a;
    q = (uv - slope * uu) / frame.a / frame.c;
    r = (vv - slope * (uv + uv - slope * uu)) / frame.c / frame.c;
  }

  // The normal curvature in the direction x e1 + y e2, which is not 0.
  double normal_curvature(double x, double y) const {
    const double length = std::hypot(x, y);
    x /= length;
    y /= length;
    return p * x * x + 2 * q * x * y + r * y * y;
  }
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_SURFACE_DERIVATIVES_H
