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

// How far the series of a cell converges: to the nearest singular point of a function with linear
// values on every side.
//
// Such a function goes on across a side by reflection (Schwarz), so only vertices are singular,
// seen from the centre directly or in the mirrors that the sides are. A path that is reflected is
// no shorter than the straight one to where it ends: no mirror image is nearer than the nearest
// vertex. What lies behind the cell's own sides is out of sight, however near it is; a thin slot on
// the other side of a wall costs nothing: a path would have to go round an end of the side, which
// is a vertex.
//
// A function of size 1 grows at most linearly with the number of reflections, which is as many as
// there are between two near sides. The number of terms takes no account of it; what it makes of
// the error is measured.

inline double squared_distance_in(const Half_plane& h, const Complex& z, const Segment& s) {
  const std::optional<Segment> seen = clip(s, h);
  return seen ? squared_distance(z, *seen) : std::numeric_limits<double>::infinity();
}

// around a vertex. It is singular itself, and sees itself in sides across from it.
inline double corner_radius(const Boundary& boundary, std::size_t k) {
  const std::size_t p = boundary.prev(k);
  const Complex& v = boundary.vertex(k);
  const Half_plane h = boundary.half_plane(k), g = boundary.half_plane(p);
  const bool convex = boundary.angle(k) < 1;
  const double own = (std::min)(boundary.length(k), boundary.length(p));
  double to_vertex = own * own, to_side = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < boundary.size(); ++e) {
    const Complex& w = boundary.vertex(e);
    // the wedge is the intersection of the two half-planes, or else their union
    if (e != k && (convex ? h.contains(w) && g.contains(w) : h.contains(w) || g.contains(w)))
      to_vertex = (std::min)(to_vertex, std::norm(w - v));
    if (e == k || e == p)
      continue;
    const Segment s = boundary.side(e);
    if (!convex) {
      to_side = (std::min)({to_side, squared_distance_in(h, v, s), squared_distance_in(g, v, s)});
    } else if (const std::optional<Segment> seen = clip(s, h)) {
      to_side = (std::min)(to_side, squared_distance_in(g, v, *seen));
    }
  }
  return std::sqrt((std::min)(to_vertex, 4 * to_side));
}

// around a point on side e
inline double side_radius(const Boundary& boundary, std::size_t e, const Complex& centre) {
  const Half_plane h = boundary.half_plane(e);
  const Segment own = boundary.side(e);
  double r = (std::min)(std::norm(centre - own.a), std::norm(centre - own.b));
  for (const Complex& v : boundary.vertices())
    if (h.contains(v))
      r = (std::min)(r, std::norm(centre - v));
  return std::sqrt(r);
}

// around a point inside
inline double interior_radius(const Boundary& boundary, const Complex& centre) {
  double r = std::numeric_limits<double>::infinity();
  for (const Complex& v : boundary.vertices())
    r = (std::min)(r, std::norm(centre - v));
  return std::sqrt(r);
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CONVERGENCE_RADII_H
