// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CENTRAL_CONTROL_POINT_H
#define CGAL_MULTISIDED_PATCHES_CENTRAL_CONTROL_POINT_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_model_3.h>
#include <CGAL/Multisided_patches/ribbons/Generalized_bezier_net_3.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! The smallest weight of the central control point (of 1, the sum of all weights) at a point of
//! the domain at which `central_point_for()` can choose the point of the patch: with a smaller one
//! the central control point were nothing but magnified rounding errors.
inline constexpr double min_central_weight = 1e-8;

/*!
 * the weight that the central control point of a patch has at `uv`; all weights together are 1.
 * 0 on the boundary.
 *
 * \tparam Patch a patch with `domain()`, `coordinates()` and `basis()`, such as
 * `Concave_bezier_patch_3`; its basis has a `central_index()`
 *
 * \throws Outside_domain_error if `uv` lies outside the domain
 *
 * Complexity: that of the coordinates and of the basis.
 */
template <typename Patch>
typename Patch::FT central_weight_at(const Patch& patch, const typename Patch::Point_2& uv) {
  using FT = typename Patch::FT;
  const auto location = patch.domain().locate_inside(uv);
  if (location.is_on_boundary())
    return FT(0);
  std::vector<Jet_2<FT, 0>> lambda(patch.domain().size()), weights(patch.basis().size());
  patch.coordinates().template evaluate<0>(uv, location, lambda.data());
  patch.basis().evaluate(patch.domain(), lambda.data(), weights.data());
  return weights[patch.basis().central_index()].value();
}

/*!
 * the central control point with which a patch goes through a given point: at `uv` the patch with
 * that central control point, and all else as it is, has the point `point`.
 *
 * \tparam Patch as for `central_weight_at()`; its surface is a linear function of the central
 * control point
 * \param patch the patch
 * \param central_point the central control point that `patch` has now (model units)
 * \param uv a point of the domain, somewhere in the middle
 * \param point where the patch should be there (model units)
 *
 * \throws Input_error if the central control point has hardly any weight at `uv`, less than
 * `min_central_weight`: on the boundary and close to it, and everywhere if the patch gives it none
 * \throws Outside_domain_error if `uv` lies outside the domain
 *
 * Complexity: that of the coordinates and of the basis.
 */
template <typename Patch>
typename Patch::Point_3
central_point_for(const Patch& patch, const typename Patch::Point_3& central_point,
                  const typename Patch::Point_2& uv, const typename Patch::Point_3& point) {
  const typename Patch::FT weight = central_weight_at(patch, uv);
  if (!(std::abs(CGAL::to_double(weight)) >= min_central_weight))
    throw Input_error("the patch cannot be moved to a given point at (" +
                      internal::to_short_text(CGAL::to_double(uv.x())) + ", " +
                      internal::to_short_text(CGAL::to_double(uv.y())) +
                      ") of its domain: the weight of its central control point there is " +
                      internal::to_short_text(CGAL::to_double(weight)) +
                      ", and should be further from 0");
  return central_point + (point - patch(uv)) / weight;
}

//! the same for a patch that was made from `model`
template <typename Patch, typename Traits>
typename Patch::Point_3
central_point_for(const Patch& patch, const Concave_bezier_model_3<Traits>& model,
                  const typename Patch::Point_2& uv, const typename Patch::Point_3& point) {
  // Where the model leaves it to the patch, only the patch knows.
  return central_point_for(
      patch, model.central_point.value_or(patch.control_point(patch.basis().central_index())), uv,
      point);
}

//! the same for a patch that was made from `net`
template <typename Patch, typename Traits>
typename Patch::Point_3
central_point_for(const Patch& patch, const Generalized_bezier_net_3<Traits>& net,
                  const typename Patch::Point_2& uv, const typename Patch::Point_3& point) {
  return central_point_for(patch, net.central_point(), uv, point);
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CENTRAL_CONTROL_POINT_H
