// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CONTINUITY_REPORT_H
#define CGAL_MULTISIDED_PATCHES_CONTINUITY_REPORT_H

#include <CGAL/Multisided_patches/analysis/Side_continuity.h>
#include <CGAL/Multisided_patches/analysis/internal/contact.h>
#include <CGAL/Multisided_patches/analysis/internal/ribbon_derivatives.h>
#include <CGAL/Multisided_patches/patches/internal/surface_derivatives.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Multisided_patches {

namespace internal {

// By the formula of the patch, which is what is to be checked, and not by its members for points of
// the boundary, which ask the ribbons.
template <typename Patch>
Surface_derivatives derivatives_on_side(const Patch& patch, std::size_t i, double s) {
  const typename Patch::FT t(s);
  return to_surface_derivatives(patch.template evaluate<2>(patch.domain().point_on_side(i, t),
                                                           patch.domain().location_on_side(i, t)));
}

template <typename Ribbon>
bool run_opposite_ways(const Ribbon& a, const Ribbon& b) {
  double same = 0, opposite = 0;
  // A closed curve needs more than its ends.
  for (const double s : {0.0, 0.25, 0.75, 1.0}) {
    const Vec3 p = ribbon_derivatives(a, s).point;
    same += norm(difference(p, ribbon_derivatives(b, s).point));
    opposite += norm(difference(p, ribbon_derivatives(b, 1 - s).point));
  }
  return opposite <= same;
}

} // namespace internal

/*!
 * measures how a patch meets its ribbons: along every side the deviation of
 *   - the position, as the distance between the two points of one parameter (model units);
 *   - if the ribbon has at least 2 layers, the tangent plane, as the angle between the normals
 *     (degrees);
 *   - if it has at least 3, the normal curvature κ of both surfaces in the direction of the tangent
 *     plane that is perpendicular to the boundary curve, as |κ - κ'| / max(|κ|, |κ'|, 1/D).
 *
 * D is the diagonal of the loop's bounding box: what bends less than a sphere of this radius is
 * practically flat.
 *
 * Surfaces with a common curve and common tangent planes along it have the same curvatures in all
 * directions if they have the same in a single one across the curve (Pegna and Wolter, *Geometrical
 * criteria to guarantee curvature continuity of blend surfaces*, Journal of Mechanical Design 114,
 * 1992).
 *
 * The patch is evaluated on the boundary by the formula that it has inside, with derivatives; that
 * its members for points on the boundary return those of the ribbon has no influence. Where a
 * ribbon determines no tangent plane (its derivatives along and across the side are parallel),
 * tangent plane and curvature are not compared; where only the patch has none, they count as 180
 * degrees and 2.
 *
 * \tparam Patch a class with the members `domain()`, `loop()` and `evaluate<2>()` of
 * `Concave_bezier_patch_3`
 *
 * \param patch the patch
 * \param samples where each side is sampled, or how many evenly spaced samples it has
 *
 * Complexity: one evaluation of second derivatives for each sample.
 */
template <typename Patch>
Continuity_report continuity_report(const Patch& patch,
                                    const Side_samples& samples = Side_samples()) {
  Continuity_report report;
  for (std::size_t i = 0; i < patch.loop().size(); ++i) {
    const auto& ribbon = patch.loop()[i];
    const internal::Contact_rule rule{ribbon.layers(), false, 1 / patch.loop().diagonal()};
    const auto contact_at = [&](double s) {
      const internal::Surface_derivatives wanted = internal::ribbon_derivatives(ribbon, s);
      return internal::measure_contact(internal::derivatives_on_side(patch, i, s), wanted, wanted.u,
                                       rule);
    };
    report.sides.push_back({internal::measure_continuity(samples, contact_at), i});
  }
  return report;
}

/*!
 * measures in the same way how two patches meet along a common boundary curve, at equal parameters
 * of the curve. Which of the two directions the second patch takes along it is found from the
 * curves. If it is that of the first one, the normals of the two are expected to be opposite.
 *
 * What is compared follows from the smaller number of layers of the two ribbons, and D is the
 * larger diagonal.
 *
 * \param patch_a, patch_b the patches; they may be one
 * \param side_a, side_b the numbers of the sides at which they meet
 * \param samples as above; parameters are those of `side_a`
 *
 * \pre the sides exist
 */
template <typename Patch_a, typename Patch_b>
Seam_continuity continuity_report(const Patch_a& patch_a, std::size_t side_a,
                                  const Patch_b& patch_b, std::size_t side_b,
                                  const Side_samples& samples = Side_samples()) {
  CGAL_precondition(side_a < patch_a.loop().size() && side_b < patch_b.loop().size());
  const auto &a = patch_a.loop()[side_a], &b = patch_b.loop()[side_b];
  const bool reversed = internal::run_opposite_ways(a, b);
  const internal::Contact_rule rule{
      (std::min)(a.layers(), b.layers()), !reversed,
      1 / (std::max)(patch_a.loop().diagonal(), patch_b.loop().diagonal()), true};
  const auto contact_at = [&](double s) {
    return internal::measure_contact(
        internal::derivatives_on_side(patch_a, side_a, s),
        internal::derivatives_on_side(patch_b, side_b, reversed ? 1 - s : s),
        internal::ribbon_derivatives(a, s).u, rule);
  };
  return {internal::measure_continuity(samples, contact_at), side_a, side_b, reversed};
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CONTINUITY_REPORT_H
