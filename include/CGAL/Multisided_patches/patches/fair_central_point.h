// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_FAIR_CENTRAL_POINT_H
#define CGAL_MULTISIDED_PATCHES_FAIR_CENTRAL_POINT_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/bases/automatic_central_weight.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

namespace internal {

// As the function below; `control_points` are in the order of the basis.
template <typename Coordinates, typename Basis, typename Point_3>
Point_3 fair_central_point(const Coordinates& coordinates, const Basis& basis,
                           const std::vector<Point_3>& control_points) {
  using Jet = Jet_2<double, 2>;
  using FT = typename Coordinates::Geom_traits::FT;
  std::vector<std::array<double, 3>> net;
  for (const Point_3& p : control_points)
    net.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  std::vector<Jet> weights(basis.size());
  // The surface is S + W (C - C0) if the central control point moves from C0 to C; each coordinate
  // of C is a least-squares solution.
  double squares = 0;
  std::array<double, 3> products{};
  for_each_lattice_point<2>(coordinates, [&](double, double, const Jet* lambda) {
    basis.evaluate(coordinates.domain(), lambda, weights.data());
    const Jet& central = weights[basis.central_index()];
    if (!(central.value() > 0))
      return;
    const auto surface = basis.combine(coordinates.domain(), lambda, net);
    for (const std::size_t k : {3, 4, 5}) { // uu, uv, vv, of which uv counts twice
      const double factor = central.value() * (k == 4 ? 2 : 1) * central[k];
      squares += factor * central[k];
      for (std::size_t c = 0; c < 3; ++c)
        products[c] += factor * surface[c][k];
    }
  });
  std::array<double, 3> point = net[basis.central_index()];
  for (std::size_t c = 0; c < 3; ++c)
    point[c] -= products[c] / squares;
  if (!(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2])))
    return control_points[basis.central_index()];
  return Point_3(FT(point[0]), FT(point[1]), FT(point[2]));
}

} // namespace internal

/*!
 * the central control point with which a patch bends least around its middle, where that has
 * weight (model units): it minimizes the sum of w (|S_uu|² + 2 |S_uv|² + |S_vv|²) over the points
 * of the lattice of `automatic_central_weight()`, where w is the weight of the central control
 * point. The patch's own if that has no weight.
 *
 * Where the shape in the middle is known, a point on it is better; this is for when it is not.
 * Computed in `double`, apart from the coordinates.
 *
 * \tparam Patch a patch with `coordinates()` and `basis()`, such as `Concave_bezier_patch_3`; its
 * basis has a `central_index()`
 *
 * Complexity: that of at most 256 evaluations with second derivatives.
 */
template <typename Patch>
typename Patch::Point_3 fair_central_point(const Patch& patch) {
  std::vector<typename Patch::Point_3> points;
  for (std::size_t c = 0; c < patch.basis().size(); ++c)
    points.push_back(patch.control_point(c));
  return internal::fair_central_point(patch.coordinates(), patch.basis(), points);
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_FAIR_CENTRAL_POINT_H
