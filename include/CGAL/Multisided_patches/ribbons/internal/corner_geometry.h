// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_CORNER_GEOMETRY_H
#define CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_CORNER_GEOMETRY_H

#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/ribbons/Corner_type.h>

#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Corners that turn by less than this (radians, 1 degree) count as straight.
inline constexpr double straight_turn = pi / 180;

// The direction in which the boundary curve leaves its first (or arrives at its last) point:
// towards the nearest control point that differs from it. The zero vector if all points coincide.
template <typename Ribbon>
Vec3 start_direction(const Ribbon& r) {
  std::size_t j = 1;
  while (j < r.degree() && r.control_point(j, 0) == r.control_point(0, 0))
    ++j;
  return normalized(to_vec3(r.control_point(j, 0) - r.control_point(0, 0)));
}

template <typename Ribbon>
Vec3 end_direction(const Ribbon& r) {
  const std::size_t d = r.degree();
  std::size_t j = 1;
  while (j < d && r.control_point(d - j, 0) == r.control_point(d, 0))
    ++j;
  return normalized(to_vec3(r.control_point(d, 0) - r.control_point(d - j, 0)));
}

// The unit normal of the tangent plane that a ribbon gives at column j, whose boundary tangent is
// known; zero where the ribbon does not tell.
template <typename Ribbon>
Vec3 ribbon_normal(const Ribbon& r, std::size_t j, const Vec3& tangent) {
  if (r.layers() < 2)
    return {0, 0, 0};
  const Vec3 inwards = normalized(to_vec3(r.control_point(j, 1) - r.control_point(j, 0)));
  const Vec3 normal = cross(tangent, inwards);
  // Below this the two directions are the same line up to rounding.
  return norm(normal) > 1e-9 ? normalized(normal) : Vec3{0, 0, 0};
}

// What the corner between ribbon `in`, which ends there, and ribbon `out`, which starts there,
// looks like from the surface.
struct Corner_geometry {
  Corner_type type;
  double angle;           // interior, in [0,2π]
  Vec3 normal;            // unit, or zero if the ribbons give none
  double normal_mismatch; // between the two ribbons' tangent planes, in [0,π]
};

// `fallback_normal` decides where neither ribbon fixes a tangent plane.
template <typename Ribbon>
Corner_geometry corner_geometry(const Ribbon& in, const Ribbon& out, const Vec3& fallback_normal) {
  const Vec3 arriving = end_direction(in), leaving = start_direction(out);
  const Vec3 n_in = ribbon_normal(in, in.degree(), arriving);
  const Vec3 n_out = ribbon_normal(out, 0, leaving);

  Corner_geometry corner;
  corner.normal = normalized(sum(n_in, n_out));
  const bool both = norm(n_in) > 0 && norm(n_out) > 0;
  corner.normal_mismatch = both ? angle_between(n_in, n_out) : 0;

  const double turn = angle_between(arriving, leaving);
  const Vec3 up = norm(corner.normal) > 0 ? corner.normal : fallback_normal;
  const bool left = dot(up, cross(arriving, leaving)) >= 0;
  corner.angle = left ? pi - turn : pi + turn;
  corner.type = turn < straight_turn ? Corner_type::straight
                : left               ? Corner_type::convex
                                     : Corner_type::reflex;
  return corner;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_CORNER_GEOMETRY_H
