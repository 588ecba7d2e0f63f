// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_CHECK_FINITE_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_CHECK_FINITE_H

#include <CGAL/Multisided_patches/errors.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

template <typename Point_3>
bool has_finite_coordinates(const Point_3& p) {
  return CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()) && CGAL::is_finite(p.z());
}

// Throws an Input_error that names the first control point with a coordinate that is not finite;
// `owner` is what the points belong to.
template <typename Point_3>
void check_finite(const std::vector<Point_3>& points, const std::string& owner) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!has_finite_coordinates(points[i]))
      throw Input_error("control point " + std::to_string(i) + " of " + owner + " is not finite");
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_CHECK_FINITE_H
