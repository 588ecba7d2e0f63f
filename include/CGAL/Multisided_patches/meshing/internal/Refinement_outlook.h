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
// settles, and round by round the excess falls. Along a crease or a fold it stays the same, and the
// number of triangles grows without end.
class Refinement_outlook {
public:
  // `excess` has that of all triangles of the present mesh that are not within their bounds, at
  // least.
  void update(std::size_t triangles, const std::vector<double>& excess) {
    Round now;
    double capped = 0;
    for (const double e : excess)
      if (e > 1) {
        now.missing += e * e;
        capped += (std::min)(e * e, most_for_one);
        ++now.failing;
      }
    if (now.failing <= few)
      now.missing = capped;
    const double needed = static_cast<double>(triangles) + now.missing;
    is_hopeless_ = needed > max_growth * least_needed_ + slack;
    least_needed_ = (std::min)(least_needed_, needed);
    rounds_.push_back(now);
    is_stuck_ =
        rounds_.size() > patience && has_no_progress(rounds_[rounds_.size() - 1 - patience]);
  }
  bool is_hopeless() const { return is_hopeless_; }
  // Whether the triangles that are divided give way to ones that fail as much as they did, or to so
  // many more that there is more to do than before.
  bool is_stuck() const { return is_stuck_; }

private:
  struct Round {
    double missing = 0, failing = 0;
    double mean() const { return missing / failing; }
  };

  // Small features show only when the mesh has become fine, and then ask for more triangles.
  static constexpr double max_growth = 4, slack = 2000;
  // If few triangles fail, some of them may be turned over, which says nothing about how many it
  // will take.
  static constexpr double most_for_one = 100;
  // A few triangles that fail round after round cost little.
  static constexpr double few = 300;
  static constexpr std::size_t patience = 4;

  bool has_no_progress(const Round& before) const {
    const Round& now = rounds_.back();
    const bool have_multiplied = now.failing > 2 * before.failing && now.missing > before.missing,
               are_as_bad = now.failing > 0.75 * before.failing && now.mean() > before.mean() / 2;
    return now.failing > few && (have_multiplied || are_as_bad);
  }

  std::vector<Round> rounds_;
  double least_needed_ = std::numeric_limits<double>::infinity();
  bool is_hopeless_ = false, is_stuck_ = false;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINEMENT_OUTLOOK_H
