// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CONVERGENCE_RADII_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CONVERGENCE_RADII_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Boundary.h>

#include <limits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// How far the series of a cell converges: to the nearest piece of the boundary that the cell can
// see. What lies behind the cell's own sides is out of sight, however near it is; a thin slot on
// the other side of a wall costs nothing.

inline double squared_distance_in(const Half_plane& h, const Complex& z, const Segment& s) {
  const std::optional<Segment> seen = clip(s, h);
  return seen ? squared_distance(z, *seen) : std::numeric_limits<double>::infinity();
}

// around a vertex
inline double corner_radius(const Boundary& boundary, std::size_t k) {
  const std::size_t p = boundary.prev(k);
  const Complex& v = boundary.vertex(k);
  const Half_plane h = boundary.half_plane(k), g = boundary.half_plane(p);
  const bool convex = boundary.angle(k) < 1;
  double r = (std::min)(boundary.length(k), boundary.length(p));
  r *= r;
  for (std::size_t e = 0; e < boundary.size(); ++e) {
    if (e == k || e == p)
      continue;
    const Segment s = boundary.side(e);
    if (!convex) { // the wedge is the union of the two half-planes, otherwise their intersection
      r = (std::min)({r, squared_distance_in(h, v, s), squared_distance_in(g, v, s)});
    } else if (const std::optional<Segment> seen = clip(s, h)) {
      r = (std::min)(r, squared_distance_in(g, v, *seen));
    }
  }
  return std::sqrt(r);
}

// around a point on side e
inline double side_radius(const Boundary& boundary, std::size_t e, const Complex& centre) {
  const Half_plane h = boundary.half_plane(e);
  const Segment own = boundary.side(e);
  double r = (std::min)(std::norm(centre - own.a), std::norm(centre - own.b));
  for (std::size_t f = 0; f < boundary.size(); ++f)
    if (f != e)
      r = (std::min)(r, squared_distance_in(h, centre, boundary.side(f)));
  return std::sqrt(r);
}

// around a point inside
inline double interior_radius(const Boundary& boundary, const Complex& centre) {
  double r = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < boundary.size(); ++f)
    r = (std::min)(r, squared_distance(centre, boundary.side(f)));
  return std::sqrt(r);
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CONVERGENCE_RADII_H
