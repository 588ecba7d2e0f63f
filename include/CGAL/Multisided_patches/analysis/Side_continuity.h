// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_SIDE_CONTINUITY_H
#define CGAL_MULTISIDED_PATCHES_SIDE_CONTINUITY_H

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! Where a side is sampled; a number converts to that many evenly spaced samples. All samples lie
//! strictly inside the side.
struct Side_samples {
  //! \param number how many evenly spaced samples: in the middle of as many equal pieces
  Side_samples(std::size_t number = 32) : even(number) {}

  //! the number of evenly spaced samples
  std::size_t even;
  //! besides, the side is sampled at 1/10, 1/100, …, 10^-decades of its parameter range from both
  //! corners, where patches are hardest to evaluate; at most 15
  std::size_t decades = 6;
};

//! In one respect, how far apart two surfaces are along a side.
struct Deviation {
  double max = 0;  //!< the largest deviation of all samples
  double mean = 0; //!< the mean over the evenly spaced samples
  double s = 0;    //!< the parameter along the side, in [0,1], of the largest deviation
};

//! How two surfaces meet along a side.
struct Continuity {
  //! the distance between points (model units)
  Deviation position = {};
  //! the angle between the normals (degrees, at most 180), if tangent planes are prescribed
  std::optional<Deviation> tangent_plane = {};
  /*!
   * the difference of the normal curvatures across the side, relative to the larger one (at most
   * 2), if curvatures are prescribed
   */
  std::optional<Deviation> normal_curvature = {};
};

//! How a patch meets a ribbon.
struct Side_continuity : Continuity {
  std::size_t side = 0; //!< the number of the side
};

//! How two patches meet along a common side. Parameters are those of the first patch's side.
struct Seam_continuity : Continuity {
  std::size_t side_a = 0, side_b = 0; //!< the numbers of the sides
  bool reversed = true; //!< whether the second patch runs along the curve in the opposite direction
};

//! How a patch meets its ribbons.
struct Continuity_report {
  //! one element for each side, in order
  std::vector<Side_continuity> sides;

  //! A deviation, and where it is.
  struct Located {
    double value = 0;
    std::size_t side = 0;
    double s = 0;
  };

  //! the largest deviations of all sides; 0 where no side prescribes anything
  Located largest_position() const {
    return largest([](const Side_continuity& c) { return std::optional<Deviation>(c.position); });
  }
  Located largest_tangent_plane() const {
    return largest([](const Side_continuity& c) { return c.tangent_plane; });
  }
  Located largest_normal_curvature() const {
    return largest([](const Side_continuity& c) { return c.normal_curvature; });
  }

private:
  template <typename Select>
  Located largest(const Select& select) const {
    Located result;
    for (const Side_continuity& c : sides) {
      const std::optional<Deviation> d = select(c);
      if (d && d->max > result.value)
        result = {d->max, c.side, d->s};
    }
    return result;
  }
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_SIDE_CONTINUITY_H
