// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MAKE_CIRCULAR_DOMAIN_H
#define CGAL_MULTISIDED_PATCHES_MAKE_CIRCULAR_DOMAIN_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/domains/internal/polygon_shape.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * makes a polygon with its corners on a circle, for loops without reflex corners. The central angle
 * of side i is proportional to t_i + t_{i+1}, where t_i = π - α_i is the turn at corner i, because
 * a polygon on a circle turns at a corner by half the central angles of the two sides that meet
 * there.
 *
 * \return the domain, in the unit square
 * \throws Input_error if the loop has a reflex corner
 */
template <typename Traits>
Polygonal_domain_2<Traits> make_circular_domain(const Ribbon_loop_3<Traits>& loop) {
  std::vector<double> turns;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop.corner_type(i) == Corner_type::reflex)
      throw Input_error("corner " + std::to_string(i) +
                        " is reflex, and the corners of a polygon on a circle are all convex");
    turns.push_back((std::max)(internal::pi - loop.corner_angle(i), 0.0));
  }
  // A share of the mean turn for every corner keeps sides between straight corners from vanishing.
  const double total = std::accumulate(turns.begin(), turns.end(), 0.0);
  const double floor = (total > 0 ? total : 1) / static_cast<double>(loop.size()) / 10;
  for (double& turn : turns)
    turn += floor;
  const double sum = std::accumulate(turns.begin(), turns.end(), 0.0);

  internal::Polygon polygon;
  double angle = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    polygon.push_back({std::cos(angle), std::sin(angle)});
    angle += internal::pi * (turns[i] + turns[loop.next(i)]) / sum;
  }
  return Polygonal_domain_2<Traits>(internal::to_unit_box<Traits>(polygon));
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MAKE_CIRCULAR_DOMAIN_H
