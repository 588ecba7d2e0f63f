// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_LIGHTNING_EXTERIOR_CIRCLES_H
#define MULTISIDED_PATCHES_TEST_LIGHTNING_EXTERIOR_CIRCLES_H

#include "Polygon.h"
#include "numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Circles on the medial axis of the outside: where poles for the smooth part of a solution go.
namespace fixtures {
namespace lightning {

// A circle that touches a side from outside.
struct Circle {
  Complex centre;
  double radius;
  std::size_t side;
  bool in_use; // neither inside by rounding, nor so close to a corner that this has its own poles
};

// The largest circle that touches the boundary in a given point and does not cross it (its centre
// is on the medial axis), but no larger than the distance of the nearest singular corner: up to
// there, by reflection, the solution is analytic. Found by shrinking (Ma, Bae and Choi 2012).
inline Circle exterior_circle(const Polygon& polygon, const Boundary_point& b, Complex normal) {
  const Complex p = polygon.at(b.place);
  double radius = polygon.diameter();
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (!polygon.is_regular(k))
      radius = (std::min)(radius, std::abs(polygon.difference(b.place, k)));
  Complex q = polygon.nearest_on_boundary(p + radius * normal);
  for (int step = 0; step < 100 && std::abs(p + radius * normal - q) < (1 - 1e-6) * radius;
       ++step) {
    radius = std::norm(q - p) / (2 * (std::conj(q - p) * normal).real());
    q = polygon.nearest_on_boundary(p + radius * normal);
  }
  const bool left_to_corner =
      !polygon.is_regular(b.place.vertex) &&
      std::abs(b.place.offset) < 0.15 * std::abs(polygon.reach(b.place.vertex));
  const Complex centre = p + radius * normal;
  return {centre, radius, b.side, !left_to_corner && polygon.is_outside(centre)};
}

// Adds circles between two others, by bisection, until their centres are close to each other.
template <typename Circle_at>
void add_circles(const Circle_at& circle_at, double t0, const Circle& c0, double t1,
                 const Circle& c1, double spacing, std::vector<Circle>& circles) {
  const bool close = std::abs(c0.centre - c1.centre) <= spacing * (std::min)(c0.radius, c1.radius);
  const bool unused = !c0.in_use && !c1.in_use;
  if (t1 - t0 < 1e-3 || (t1 - t0 < 0.5 && (close || unused)))
    return;
  const double t = (t0 + t1) / 2;
  const Circle c = circle_at(t);
  add_circles(circle_at, t0, c0, t, c, spacing, circles);
  circles.push_back(c);
  add_circles(circle_at, t, c, t1, c1, spacing, circles);
}

// Those in use whose centres are not too close to each other.
inline std::vector<Circle> thinned(const std::vector<Circle>& circles, double spacing) {
  std::vector<Circle> kept;
  for (const Circle& c : circles)
    if (c.in_use && std::none_of(kept.begin(), kept.end(), [&](const Circle& other) {
          return std::abs(c.centre - other.centre) < spacing * (std::min)(c.radius, other.radius);
        }))
      kept.push_back(c);
  return kept;
}

// Circles along the boundary, and around the corners where the solution is regular. (Others have
// poles of their own.) `spacing` is in units of the radius.
inline std::vector<Circle> exterior_circles(const Polygon& polygon, double spacing) {
  std::vector<Circle> circles;
  const auto add = [&](const auto& circle_at) {
    circles.push_back(circle_at(0));
    const Circle first = circles.back();
    add_circles(circle_at, 0, first, 1, circle_at(1), spacing, circles);
  };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Complex normal = polygon.exterior_normal(k);
    const double turn = MP::internal::pi * (1 - polygon.angle(k));
    if (polygon.is_regular(k))
      add([&](double t) {
        return exterior_circle(polygon, polygon.on_side(k, 0),
                               normal * std::polar(1., (t - 1) * turn));
      });
    add([&](double t) { return exterior_circle(polygon, polygon.on_side(k, t), normal); });
  }
  return thinned(circles, 0.6 * spacing);
}

} // namespace lightning
} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_LIGHTNING_EXTERIOR_CIRCLES_H
