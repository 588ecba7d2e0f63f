// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINEMENT_OUTLOOK_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINEMENT_OUTLOOK_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Tells whether refining a mesh will bring its deviations from a surface within their bounds.
//
// A triangle whose edges are too long by a factor, its excess, has to give way to about the square
// of that many. While a smooth surface is refined, the number of triangles to which this adds up
// settles, and those that fail get fewer once they are small. Along a crease or a fold the excess
// of the triangles stays the same, but their number grows without end.
class Refinement_outlook {
public:
  // `excess` has that of all triangles of the present mesh that are not within their bounds, at
  // least.
  void update(std::size_t triangles, const std::vector<double>& excess) {
    double missing = 0, failing = 0;
    for (const double e : excess)
      if (e > 1) {
        missing += e * e;
        ++failing;
      }
    const double needed = static_cast<double>(triangles) + missing;
    if (rounds_++ == 0) {
      least_needed_ = needed;
      first_missing_ = missing;
      first_failing_ = failing;
    }
    is_hopeless_ = needed > max_growth * least_needed_ + slack;
    least_needed_ = (std::min)(least_needed_, needed);
    const bool grows =
        missing > max_growth * first_missing_ + slack / 2 && failing > max_growth * first_failing_;
    const bool stays = rounds_ > patience && failing > first_failing_ / 2 && failing > few;
    is_stuck_ = grows || stays;
  }
  bool is_hopeless() const { return is_hopeless_; }
  // Whether triangles that are divided give way to as many that fail, or more.
  bool is_stuck() const { return is_stuck_; }

private:
  // Small features show only when the mesh has become fine, and then ask for more triangles.
  static constexpr double max_growth = 4, slack = 2000;
  // A few triangles that fail round after round cost little.
  static constexpr int patience = 10;
  static constexpr double few = 500;

  int rounds_ = 0;
  double least_needed_ = 0, first_missing_ = 0, first_failing_ = 0;
  bool is_hopeless_ = false, is_stuck_ = false;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINEMENT_OUTLOOK_H
