// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_PATCH_COMPLEX_H
#define CGAL_MULTISIDED_PATCHES_PATCH_COMPLEX_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/meshing/internal/Shared_sides.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! A side that two patches of a complex have in common. They run along it in opposite directions,
//! so that their normals point to the same side.
struct Shared_side {
  std::size_t patch_a, side_a; //!< the one that comes first
  std::size_t patch_b, side_b;
};

/*!
 * Patches that are neighbours of each other: they have sides in common, and together are meshed to
 * one surface without gaps, closed if no side is left over.
 *
 * Two sides are one if their curves are the same, from either end: points at 33 evenly spaced
 * parameters agree up to a tolerance. The mesh then has the points of the first of them for both.
 * Nothing is done about sides that have only a part in common: where a corner of one patch lies on
 * a side of another, the other needs a corner there, too (a straight one, if the side goes on).
 *
 * \tparam Patch a model of `MultisidedPatch_3`
 */
template <typename Patch>
class Patch_complex {
public:
  /*!
   * takes the patches and finds out which sides they share.
   *
   * \param patches any number of patches
   * \param names what error messages call them; by default "patch 0", "patch 1", ...
   * \param relative_tolerance how far apart points of the same side may be, as a fraction of the
   * diagonal of the bounding box of all corners
   *
   * \throws Numerical_error if a point of a side is not finite
   *
   * Complexity: O(n log n) for n sides in all, if not many of their midpoints are close together;
   * 33 points of each.
   */
  explicit Patch_complex(std::vector<Patch> patches, std::vector<std::string> names = {},
                         double relative_tolerance = 1e-9)
      : patches_(std::move(patches)), names_(std::move(names)) {
    for (std::size_t k = names_.size(); k < patches_.size(); ++k)
      names_.push_back("patch " + std::to_string(k));
    internal::Side_matches matches =
        internal::match_sides(internal::sample_all_sides(patches_, names_), relative_tolerance);
    for (const auto& [a, b] : matches.shared)
      shared_sides_.push_back({a.patch, a.side, b.patch, b.side});
    for (const auto& [a, b] : matches.conflicts)
      remarks_.push_back(
          name(a) + " and " + name(b) + " have the same curve, but are not joined: " +
          (matches.runs_alike(a, b)
               ? "they run along it in the same direction, so that one of the patches "
                 "is inside out"
               : "one of them is joined to a third side"));
  }

  const std::vector<Patch>& patches() const { return patches_; }
  const std::vector<std::string>& names() const { return names_; }

  //! the sides that are joined, in the order of the patches
  const std::vector<Shared_side>& shared_sides() const { return shared_sides_; }
  //! the number of sides that are not
  std::size_t number_of_free_sides() const {
    std::size_t count = 0;
    for (const Patch& patch : patches_)
      count += patch.domain().size();
    return count - 2 * shared_sides_.size();
  }
  //! what keeps sides with the same curve from being joined, a sentence for each pair
  const std::vector<std::string>& remarks() const { return remarks_; }

private:
  std::string name(const internal::Side_id& id) const {
    return names_[id.patch] + " side " + std::to_string(id.side);
  }

  std::vector<Patch> patches_;
  std::vector<std::string> names_;
  std::vector<Shared_side> shared_sides_;
  std::vector<std::string> remarks_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_PATCH_COMPLEX_H
