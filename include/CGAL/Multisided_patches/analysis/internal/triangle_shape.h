// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_ANALYSIS_INTERNAL_TRIANGLE_SHAPE_H
#define CGAL_MULTISIDED_PATCHES_ANALYSIS_INTERNAL_TRIANGLE_SHAPE_H

#include <CGAL/Multisided_patches/internal/vector_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

struct Triangle_shape {
  Vec3 normal;                  // of unit length
  std::array<double, 3> angles; // degrees
};

// The shape of a triangle of any size from its sides, which are vectors with the sum zero. The
// angle k is the one at the start of side k.
inline Triangle_shape triangle_shape(std::array<Vec3, 3> sides) {
  // Without this, products of small or large sides would leave the range of double.
  double scale = 0;
  for (const Vec3& side : sides)
    for (const double x : side)
      scale = (std::max)(scale, std::abs(x));
  for (Vec3& side : sides)
    for (double& x : side)
      x /= scale;

  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (norm(sides[k]) > norm(sides[longest]))
      longest = k;
  // All pairs of sides have the same cross product; that of the shorter ones is rounded least.
  const Vec3 area = cross(sides[(longest + 1) % 3], sides[(longest + 2) % 3]);
  Triangle_shape shape{normalized(area), {}};
  for (std::size_t k = 0; k < 3; ++k)
    shape.angles[k] = std::atan2(norm(area), -dot(sides[k], sides[(k + 2) % 3])) * 180 / pi;
  return shape;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_ANALYSIS_INTERNAL_TRIANGLE_SHAPE_H
