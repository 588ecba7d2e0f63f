// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CLOSEST_PARAMETERS_H
#define CGAL_MULTISIDED_PATCHES_CLOSEST_PARAMETERS_H

#include <CGAL/Multisided_patches/errors.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/squared_distance_3.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

namespace internal {

// One step of Gauss and Newton from uv towards the closest point of the patch, shortened until the
// distance gets smaller. Returns whether there was such a step.
template <typename Patch>
bool step_closer(const Patch& patch, const typename Patch::Point_3& target,
                 typename Patch::Point_2& uv, double& distance) {
  using Point_2 = typename Patch::Point_2;
  const auto surface = patch.template evaluate<1>(uv);
  double uu = 0, uv_product = 0, vv = 0, u = 0, v = 0;
  for (int c = 0; c < 3; ++c) {
    const auto& x = surface[static_cast<std::size_t>(c)];
    const double error = target[c] - x[0];
    uu += x[1] * x[1];
    uv_product += x[1] * x[2];
    vv += x[2] * x[2];
    u += x[1] * error;
    v += x[2] * error;
  }
  const double determinant = uu * vv - uv_product * uv_product;
  if (!(determinant > 0))
    return false;
  const double du = (vv * u - uv_product * v) / determinant,
               dv = (uu * v - uv_product * u) / determinant;
  for (double length = 1; length > 1e-3; length /= 2) {
    const Point_2 p(uv.x() + length * du, uv.y() + length * dv);
    const auto location = patch.domain().locate(p);
    if (location.kind == decltype(location)::Kind::outside)
      continue;
    const double at_p = CGAL::squared_distance(patch.point(p, location), target);
    if (at_p < distance) {
      const bool far = at_p < distance * (1 - 1e-12);
      uv = p;
      distance = at_p;
      return far;
    }
  }
  return false;
}

} // namespace internal

/*!
 * the places in the domain where a patch is closest to given points, found locally: from the
 * closest of the samples of a lattice, by steps of the method of Gauss and Newton. On a patch that
 * comes close to itself, or to a point outside of its boundary, it may be a place that is close and
 * not the closest; it is never farther than the closest sample.
 *
 * \tparam Patch a patch in `double`, a model of `MultisidedPatch_3`
 *
 * \param patch the patch
 * \param points a random access range of `Point_3` (model units)
 * \param lattice the number of rows and columns of the lattice in the bounding box of the domain
 *
 * \return a `Point_2` for each point, in order
 *
 * \throws Input_error if no point of the lattice is inside the domain; or, with its index, if a
 * point is not finite or so far away that no sample has a finite squared distance
 *
 * Complexity: linear in the product of the number of points and that of samples.
 */
template <typename Patch, typename PointRange>
std::vector<typename Patch::Point_2>
closest_parameters(const Patch& patch, const PointRange& points, std::size_t lattice = 24) {
  static_assert(std::is_same_v<typename Patch::FT, double>, "distances are compared in double");
  using Point_2 = typename Patch::Point_2;
  using Point_3 = typename Patch::Point_3;
  constexpr int max_steps = 30;
  const Bbox_2 box = patch.domain().bbox();
  std::vector<std::pair<Point_2, Point_3>> samples;
  const auto place = [&](double low, double high, std::size_t cell) {
    return low + (high - low) * (static_cast<double>(cell) + 0.5) / static_cast<double>(lattice);
  };
  for (std::size_t row = 0; row < lattice; ++row)
    for (std::size_t column = 0; column < lattice; ++column) {
      const Point_2 p(place(box.xmin(), box.xmax(), column), place(box.ymin(), box.ymax(), row));
      const auto location = patch.domain().locate(p);
      if (location.kind == decltype(location)::Kind::interior)
        samples.emplace_back(p, patch.point(p, location));
    }
  if (samples.empty())
    throw Input_error("no point of the lattice is inside the domain; take a finer one");

  std::vector<Point_2> result;
  for (std::size_t k = 0; k < points.size(); ++k) {
    double distance = std::numeric_limits<double>::infinity();
    Point_2 uv = samples.front().first;
    for (const auto& [p, point] : samples) {
      const double at_p = CGAL::squared_distance(point, points[k]);
      if (at_p < distance) {
        distance = at_p;
        uv = p;
      }
    }
    if (!std::isfinite(distance))
      throw Input_error("point " + std::to_string(k) +
                        " has no finite distance to the patch: it is not finite, or too far away");
    for (int step = 0; step < max_steps && internal::step_closer(patch, points[k], uv, distance);)
      ++step;
    result.push_back(uv);
  }
  return result;
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CLOSEST_PARAMETERS_H
