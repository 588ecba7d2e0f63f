// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINEMENT_OUTLOOK_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINEMENT_OUTLOOK_H

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Tells whether refining a mesh will bring its deviations from a surface within their bounds.
//
// A triangle whose edges are too long by a factor, its excess, has to give way to about the square
// of that many. While a smooth surface is refined, the number of triangles to which this adds up
// settles. Along a crease or a fold the excess of the triangles stays the same, but their number
// grows without end.
class Refinement_outlook {
public:
  // `excess` has that of all triangles of the present mesh that are not within their bounds, at
  // least.
  void update(std::size_t triangles, const std::vector<double>& excess) {
    double needed = static_cast<double>(triangles);
    for (const double e : excess)
      if (e > 1)
        needed += e * e;
    is_hopeless_ = needed > max_growth * least_needed_ + slack;
    least_needed_ = (std::min)(least_needed_, needed);
  }
  bool is_hopeless() const { return is_hopeless_; }

private:
  // Small features show only when the mesh has become fine, and then ask for more triangles.
  static constexpr double max_growth = 4, slack = 2000;

  double least_needed_ = std::numeric_limits<double>::infinity();
  bool is_hopeless_ = false;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINEMENT_OUTLOOK_H
