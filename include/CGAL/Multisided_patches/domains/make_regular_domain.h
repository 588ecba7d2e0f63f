// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MAKE_REGULAR_DOMAIN_H
#define CGAL_MULTISIDED_PATCHES_MAKE_REGULAR_DOMAIN_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/domains/internal/polygon_shape.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

namespace internal {

// `start` is the angle at which vertex 0 is seen from the centre.
inline Polygon regular_polygon(std::size_t n, double start = 0) {
  Polygon polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = start + 2 * pi * static_cast<double>(i) / static_cast<double>(n);
    polygon.push_back({std::cos(angle), std::sin(angle)});
  }
  return polygon;
}

// How deep a run of reflex corners dents the side of the regular polygon that it replaces, as a
// fraction of the distance of that side from the centre. Up to 1/2 the dent stays inside the
// triangle of the side and the centre, so that dents never meet.
inline constexpr double dent_depth = 0.4;

// The non-reflex corners are the vertices of a regular polygon; the reflex corners between two of
// them lie on a parabola that dents the side between these. The result is simple and has reflex
// corners exactly where they are asked for. Fewer than 3 other corners admit no such polygon.
inline Polygon dented_regular_polygon(const std::vector<bool>& is_reflex) {
  const std::size_t n = is_reflex.size();
  const std::size_t outer = std::count(is_reflex.begin(), is_reflex.end(), false);
  if (outer < 3)
    throw Input_error("a polygon needs 3 corners that are not reflex; the loop has " +
                      std::to_string(outer));
  const Polygon hull = regular_polygon(outer);
  const std::size_t first =
      std::find(is_reflex.begin(), is_reflex.end(), false) - is_reflex.begin();

  Polygon polygon(n);
  std::size_t hull_index = 0;
  for (std::size_t k = 0; k < n;) {
    std::size_t run = 0; // of reflex corners after this outer one
    while (run + 1 < n && is_reflex[(first + k + run + 1) % n])
      ++run;
    const Vec2 &a = hull[hull_index % outer], &b = hull[(hull_index + 1) % outer];
    for (std::size_t j = 0; j <= run; ++j) {
      const double x = static_cast<double>(j) / static_cast<double>(run + 1);
      const double shrink = 4 * x * (1 - x) * dent_depth;
      // Moving towards the centre of the polygon by the height of the parabola over the chord's
      // middle: the chord's point plus a multiple of its inward normal, -(a + b)/2.
      polygon[(first + k + j) % n] = {(1 - x) * a[0] + x * b[0] - shrink * (a[0] + b[0]) / 2,
                                      (1 - x) * a[1] + x * b[1] - shrink * (a[1] + b[1]) / 2};
    }
    k += run + 1;
    ++hull_index;
  }
  return polygon;
}

template <typename Traits>
Polygon dented_regular_polygon(const Ribbon_loop_3<Traits>& loop) {
  std::vector<bool> is_reflex;
  for (std::size_t i = 0; i < loop.size(); ++i)
    is_reflex.push_back(loop.corner_type(i) == Corner_type::reflex);
  return dented_regular_polygon(is_reflex);
}

} // namespace internal

/*!
 * makes a regular polygon with one side for each ribbon or, where the loop has reflex corners, a
 * regular polygon of its other corners whose sides are dented inwards at the reflex ones. The
 * result depends on nothing but the corner types, and always is a valid domain.
 *
 * \return the domain, in the unit square
 * \throws Input_error if fewer than 3 corners are not reflex: no polygon has such corners
 */
template <typename Traits>
Polygonal_domain_2<Traits> make_regular_domain(const Ribbon_loop_3<Traits>& loop) {
  return Polygonal_domain_2<Traits>(
      internal::to_unit_box<Traits>(internal::dented_regular_polygon(loop)));
}

/*!
 * makes a regular polygon whose side 0 is at the bottom; with 4 sides it is exactly the unit
 * square.
 *
 * \param n the number of sides
 *
 * \return the domain, in the unit square
 * \throws Input_error if `n` is less than 3
 */
template <typename Traits>
Polygonal_domain_2<Traits> make_regular_domain(std::size_t n) {
  if (n < 3)
    throw Input_error("a polygon needs at least 3 sides, not " + std::to_string(n));
  if (n == 4) { // where sines and cosines are rounded
    using Point_2 = typename Traits::Point_2;
    return Polygonal_domain_2<Traits>({Point_2(0, 0), Point_2(1, 0), Point_2(1, 1), Point_2(0, 1)});
  }
  constexpr double quarter = internal::pi / 2;
  return Polygonal_domain_2<Traits>(internal::to_unit_box<Traits>(
      internal::regular_polygon(n, -quarter - internal::pi / static_cast<double>(n))));
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MAKE_REGULAR_DOMAIN_H
