// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_ELEVATE_NET_H
#define CGAL_MULTISIDED_PATCHES_ELEVATE_NET_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/ribbons/Generalized_bezier_net_3.h>
#include <CGAL/Multisided_patches/ribbons/internal/degree_change.h>
#include <CGAL/Multisided_patches/ribbons/internal/net_quads.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

namespace internal {

template <typename Traits>
Generalized_bezier_net_3<Traits> elevated_by_one(const Generalized_bezier_net_3<Traits>& given) {
  using Point_3 = typename Traits::Point_3;
  // A central point without influence on the patch must not get any on the elevated one.
  const bool matters =
      Middle_weights<typename Traits::FT>(given.size(), given.degree()).central_point_matters();
  const Generalized_bezier_net_3<Traits> net =
      matters ? given : with_central_point(given, innermost_mean(given));
  const std::size_t d = net.degree() + 1;
  const auto in_row = [&](std::size_t corner, std::size_t a, std::size_t b) -> Point_3 {
    // In the middle of an even degree the two quads of a side meet.
    const auto at = [&](std::size_t a_old) -> const Point_3& {
      return 2 * a_old <= d - 1 ? quad_point(net, corner, a_old, b)
                                : net.control_point(corner, a_old, b);
    };
    return a == 0 ? at(0) : step_towards(at(a), at(a - 1), a, d);
  };
  const auto point = [&](std::size_t corner, std::size_t a, std::size_t b) -> Point_3 {
    const Point_3 at = in_row(corner, a, b);
    return b == 0 ? at : step_towards(at, in_row(corner, a, b - 1), b, d);
  };
  return with_middle_point(net_from_quads<Traits>(net.size(), d, point, net.central_point()),
                           middle_point(net));
}

template <typename Traits>
Generalized_bezier_net_3<Traits> reduced_by_one(const Generalized_bezier_net_3<Traits>& net) {
  using Point_3 = typename Traits::Point_3;
  const std::size_t n = net.size(), old_degree = net.degree(), d = old_degree - 1;
  const std::size_t width = d / 2 + 1; // of a quad
  // Point (a,b) of quad i as quads[i][b * width + a], lowered along a and then along b.
  std::vector<std::vector<Point_3>> quads;
  for (std::size_t i = 0; i < n; ++i) {
    const auto along_a = change_cross_degree(
        width, width, [&](std::size_t b, std::size_t a) { return quad_point(net, i, a, b); },
        old_degree, d);
    quads.push_back(change_cross_degree(
        width, width, [&](std::size_t a, std::size_t b) { return along_a[a * width + b]; },
        old_degree, d));
  }
  const auto point = [&](std::size_t i, std::size_t a, std::size_t b) -> Point_3 {
    const Point_3& p = quads[i][b * width + a];
    return 2 * a == d ? CGAL::midpoint(p, quads[net.next(i)][a * width + b]) : p;
  };
  return with_middle_point(net_from_quads<Traits>(n, d, point, net.central_point()),
                           middle_point(net));
}

} // namespace internal

/*!
 * raises the degree of a control net to `degree`.
 *
 * Rows along the sides and across them are elevated like Bézier curves: in each step to a degree D,
 * point (a,b) near a corner, a = 0..⌊D/2⌋ along the side that leaves it and b along the one that
 * arrives, is the bilinear combination of the former points (a,b), (a-1,b), (a,b-1) and (a-1,b-1),
 * with the share a/D of a-1 and b/D of b-1 (Várady, Salvi, Karikó, *A multi-sided Bézier patch with
 * a simple control structure*, Computer Graphics Forum 35, 2016). So the boundary curves stay, and
 * so do the derivatives across the sides that the l layers of `net` determine, up to order l - 1.
 * Layers that the higher degree has beyond those come from the layers of adjacent sides.
 *
 * The central point is the one with which the point of the patch in the middle of a regular domain
 * stays. Where the central point has no influence on the patch (degree 1, odd degrees on four
 * sides, degree 2 on three) it is the mean of the innermost row, before the elevation and after it.
 *
 * On four sides this is the degree elevation of a tensor product patch, and the patch stays. With
 * other numbers of sides it changes between its sides and its middle. Two nets that share a
 * boundary curve get the same points along it, bit for bit.
 *
 * \throws Input_error if the degree is lower than that of the net, or beyond the largest one
 *
 * Complexity: the number of degrees times that of control points.
 */
template <typename Traits>
Generalized_bezier_net_3<Traits> elevate_net(const Generalized_bezier_net_3<Traits>& net,
                                             std::size_t degree) {
  if (degree < net.degree())
    throw Input_error("a control net of degree " + std::to_string(net.degree()) +
                      " cannot be elevated to degree " + std::to_string(degree) +
                      "; reduce_net() lowers degrees");
  Generalized_bezier_net_3<Traits>::number_of_control_points(net.size(), degree); // if there is one
  Generalized_bezier_net_3<Traits> result = net;
  while (result.degree() < degree)
    result = internal::elevated_by_one(result);
  return result;
}

//! raises the degree by one
template <typename Traits>
Generalized_bezier_net_3<Traits> elevate_net(const Generalized_bezier_net_3<Traits>& net) {
  return elevate_net(net, net.degree() + 1);
}

/*!
 * lowers the degree of a control net to `degree`: the inverse of `elevate_net()` (Várady, Salvi and
 * Kovács, *Enhancement of a multi-sided Bézier surface representation*, Computer Aided Geometric
 * Design 55, 2017, reduce curves as it does rows).
 *
 * If the net is an elevation, then this is the net of which it is one, but for a central point
 * without influence on the patch. Otherwise it is an approximation, which from each corner on keeps
 * what the reduction of curves in `Bezier_ribbon_3::reduced()` keeps at their ends; boundary curves
 * and the rows next to them are reduced exactly as there. A middle column is the mean of what the
 * two corners say. The point of the patch in the middle of a regular domain stays.
 *
 * \throws Input_error if the degree is 0, or higher than that of the net
 *
 * Complexity: the number of degrees times that of control points.
 */
template <typename Traits>
Generalized_bezier_net_3<Traits> reduce_net(const Generalized_bezier_net_3<Traits>& net,
                                            std::size_t degree) {
  if (degree < 1 || degree > net.degree())
    throw Input_error("a control net of degree " + std::to_string(net.degree()) +
                      " cannot be reduced to degree " + std::to_string(degree) +
                      ", only to degrees from 1 to its own");
  Generalized_bezier_net_3<Traits> result = net;
  while (result.degree() > degree)
    result = internal::reduced_by_one(result);
  return result;
}

//! lowers the degree by one. \throws Input_error if it is 1
template <typename Traits>
Generalized_bezier_net_3<Traits> reduce_net(const Generalized_bezier_net_3<Traits>& net) {
  return reduce_net(net, net.degree() - 1);
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_ELEVATE_NET_H
