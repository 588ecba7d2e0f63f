// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MAKE_GENERALIZED_BEZIER_NET_H
#define CGAL_MULTISIDED_PATCHES_MAKE_GENERALIZED_BEZIER_NET_H

#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/ribbons/Generalized_bezier_net_3.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>
#include <CGAL/Multisided_patches/ribbons/elevate_net.h>
#include <CGAL/Multisided_patches/ribbons/internal/degree_change.h>
#include <CGAL/Multisided_patches/ribbons/internal/net_quads.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

namespace internal {

// The first rows of a net of degree d that a ribbon determines: rows[k][j] is C_{j,k}. There are as
// many as the ribbon has layers, or as the net has if that is fewer.
template <typename Traits>
std::vector<std::vector<typename Traits::Point_3>> net_rows(const Bezier_ribbon_3<Traits>& ribbon,
                                                            std::size_t d) {
  const Bezier_ribbon_3<Traits> along =
      d < ribbon.degree() ? ribbon.reduced(d) : ribbon.elevated(d);
  const std::size_t count = (std::min)(ribbon.layers(), (d + 1) / 2);
  const auto points = change_cross_degree(
      d + 1, count, [&](std::size_t j, std::size_t k) { return along.control_point(j, k); },
      ribbon.cross_degree(), d);
  std::vector<std::vector<typename Traits::Point_3>> rows;
  for (auto row = points.begin(); row != points.end(); row += d + 1)
    rows.emplace_back(row, row + d + 1);
  return rows;
}

// The net with the points that the ribbons determine; the others are kept.
template <typename Traits>
Generalized_bezier_net_3<Traits> with_ribbons(const Generalized_bezier_net_3<Traits>& net,
                                              const Ribbon_loop_3<Traits>& loop) {
  using Point_3 = typename Traits::Point_3;
  const std::size_t d = net.degree(), l = net.layers();
  std::vector<std::vector<std::vector<Point_3>>> rows;
  for (const Bezier_ribbon_3<Traits>& ribbon : loop.ribbons())
    rows.push_back(net_rows(ribbon, d));
  std::vector<Point_3> points = net.control_points();
  for (std::size_t k = 0; k < l; ++k)
    for (std::size_t i = 0; i < net.size(); ++i)
      for (std::size_t j = k; j < d - k; ++j) {
        // The side itself, and the one that shares the point, of which it is in an inner row.
        const auto *own = k < rows[i].size() ? &rows[i][k][j] : nullptr, *shared = own;
        const auto &before = rows[net.prev(i)], &after = rows[net.next(i)];
        if (k > 0 && j < l)
          shared = j < before.size() ? &before[j][d - k] : nullptr;
        else if (k > 0 && j > d - l)
          shared = d - j < after.size() ? &after[d - j][k] : nullptr;
        if (own != nullptr || shared != nullptr)
          points[net.index(i, j, k)] = own == nullptr      ? *shared
                                       : shared == nullptr ? *own
                                                           : CGAL::midpoint(*own, *shared);
      }
  return net.with_control_points(std::move(points));
}

} // namespace internal

/*!
 * the lowest degree of a control net that has the degrees of all ribbons of a loop, and at least as
 * many layers: the largest degree along, or the largest degree across. Complexity: linear in the
 * number of sides.
 */
template <typename Traits>
std::size_t smallest_net_degree(const Ribbon_loop_3<Traits>& loop) {
  std::size_t degree = 1;
  for (const Bezier_ribbon_3<Traits>& ribbon : loop.ribbons())
    degree = (std::max)({degree, ribbon.degree(), ribbon.cross_degree()});
  return degree;
}

/*!
 * how much the two ribbons at corner `i` of a loop contradict each other: the largest distance
 * (model units) between two points that they give for the same control point of a net of degree
 * `smallest_net_degree(loop)`. It is 0, but for rounding, if each ribbon starts in the directions
 * of the other one's boundary curve and they have the same twist vectors; only then can a
 * generalized Bézier patch meet both all along. Complexity: that of elevating the two ribbons.
 */
template <typename Traits>
double ribbon_mismatch(const Ribbon_loop_3<Traits>& loop, std::size_t i) {
  CGAL_precondition(i < loop.size());
  const std::size_t d = smallest_net_degree(loop);
  const auto arriving = internal::net_rows(loop[loop.prev(i)], d),
             leaving = internal::net_rows(loop[i], d);
  double mismatch = 0;
  for (std::size_t a = 0; a < arriving.size(); ++a)
    for (std::size_t b = 0; b < leaving.size(); ++b)
      mismatch = (std::max)(mismatch,
                            internal::norm(internal::to_vec3(leaving[b][a] - arriving[a][d - b])));
  return mismatch;
}

/*!
 * makes a control net of degree `degree` from the ribbons around it.
 *
 * The net has the boundary curves of the ribbons, and for each layer of a ribbon the row that gives
 * the patch the ribbon's derivatives across the side. Near a corner, ribbons of adjacent sides
 * determine some control points twice. Where they contradict each other, see `ribbon_mismatch()`,
 * the boundary curves come first; other points are the mean of the two, and the patch meets neither
 * ribbon close to that corner.
 *
 * All other points come from nets of lower degree (Várady, Salvi, Karikó, *A multi-sided Bézier
 * patch with a simple control structure*, Computer Graphics Forum 35, 2016). The first one has as
 * many layers as the ribbon with the fewest, so that the ribbons, reduced to its degree, determine
 * all of it; its central point is the mean of the innermost row. Then, degree by degree, the net is
 * elevated by `elevate_net()` and gets the rows that the ribbons, reduced to that degree,
 * determine. So if the ribbons are those of a tensor product patch of the degree of the first net,
 * or of its elevations, then the result is that patch.
 *
 * \throws Input_error if the degree is beyond the largest one
 *
 * Complexity: the degree times the number of control points, for each degree. \pre `degree >=
 * smallest_net_degree(loop)`
 */
template <typename Traits>
Generalized_bezier_net_3<Traits> make_generalized_bezier_net(const Ribbon_loop_3<Traits>& loop,
                                                             std::size_t degree) {
  using Net = Generalized_bezier_net_3<Traits>;
  CGAL_precondition(degree >= smallest_net_degree(loop));
  std::size_t first_degree = degree;
  for (const Bezier_ribbon_3<Traits>& ribbon : loop.ribbons())
    first_degree = (std::min)(first_degree, ribbon.cross_degree());

  // All points of this net are replaced.
  Net net(loop.size(), first_degree,
          std::vector<typename Traits::Point_3>(
              Net::number_of_control_points(loop.size(), first_degree), loop.corner_point(0)));
  net = internal::with_ribbons(net, loop);
  net = internal::with_central_point(net, internal::innermost_mean(net));
  while (net.degree() < degree)
    net = internal::with_ribbons(elevate_net(net), loop);
  return net;
}

//! makes the net with the lowest degree, `smallest_net_degree(loop)`
template <typename Traits>
Generalized_bezier_net_3<Traits> make_generalized_bezier_net(const Ribbon_loop_3<Traits>& loop) {
  return make_generalized_bezier_net(loop, smallest_net_degree(loop));
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MAKE_GENERALIZED_BEZIER_NET_H
