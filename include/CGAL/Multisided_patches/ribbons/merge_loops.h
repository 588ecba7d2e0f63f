// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MERGE_LOOPS_H
#define CGAL_MULTISIDED_PATCHES_MERGE_LOOPS_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>
#include <CGAL/Multisided_patches/ribbons/internal/Loop_merger.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! Options of `merge_loops()`.
struct Merge_options {
  //! the largest `relative_tolerance`
  static constexpr double max_relative_tolerance = 0.01;

  //! how far control points of curves that should be the same may be apart, as a fraction of the
  //! larger of the diagonals of the two loops, from 0 to `max_relative_tolerance`; `float` needs a
  //! larger one than the default
  double relative_tolerance = 1e-9;
  //! whether two ribbons that meet at an end of the shared chain become one side, if they are
  //! pieces of one ribbon
  bool join_sides = true;
};

/*!
 * What `merge_loops()` makes: a loop, and where its sides come from.
 *
 * \tparam Traits a CGAL kernel
 */
template <typename Traits>
struct Merged_loop_3 {
  //! a side of one of the loops that were merged, or a part of it
  struct Source {
    std::size_t loop;               //!< 0 for the first loop, 1 for the second
    std::size_t side;               //!< its index there
    typename Traits::FT begin, end; //!< the part of it, in its parameter s: all of it from 0 to 1
  };

  Ribbon_loop_3<Traits> loop;
  //! for each side of `loop` the side or sides, in order, of which it is made
  std::vector<std::vector<Source>> sources;
};

/*!
 * merges the loops of two adjacent patches into the loop around both.
 *
 * The loops share a chain of boundary curves: each of them runs along it in its own direction, with
 * the surface on its left. Shared curves are equal as polynomials, up to a linear change of the
 * parameter and up to degree elevation. A curve may also be a part of one of the other loop, at one
 * of its ends or in its middle, or overlap with the end of one; the rest of such a side becomes a
 * side of its own, with the same surface piece as ribbon (de Casteljau's algorithm on each row).
 * All sides that are not shared keep their ribbons: first come those of `first`, from the end of
 * the shared chain on, and then those of `second`. So two loops of 4 sides with one curve in common
 * become one of 6, two of 9 with a chain of two in common one of 14, and there may be reflex
 * corners that no loop had before.
 *
 * In exact arithmetic all of this is exact where curves are exactly the same, if a side has to be
 * cut at a fraction with a denominator of at most 4096; else a cut is exact to the last bits of a
 * double.
 *
 * At each end of the chain two ribbons meet. If they are the pieces of one ribbon, of the same
 * degree and with as many layers, then they become one side again, unless
 * `Merge_options::join_sides` is off or only 3 sides are left. The whole ribbon is extrapolated
 * from the longer piece, which amplifies rounding errors exponentially with the degree d, by up to
 * 3^d. In double, with the default tolerance, halves of a ribbon join up to a degree of about 16,
 * and longer pieces up to higher ones; beyond that they stay two sides. In exact arithmetic there
 * is no limit.
 *
 * The merged loop must not touch itself: a corner of one loop may lie on the other one, within the
 * tolerance, on the shared chain only. Whether sides cross or touch each other in their insides is
 * not looked for.
 *
 * \throws Input_error if the relative tolerance is out of range; if the loops share no curve; if
 * they share two or more separate chains, so that the merged surface would have a hole; if a corner
 * of one lies on the other apart from the shared chain; if two sides of one lie on the same part of
 * a side of the other; or if fewer than 3 sides would be left
 *
 * Complexity: for each pair of sides whose boundary curves have overlapping bounding boxes, cubic
 * in their degree, plus the size of the loops.
 */
template <typename Traits>
Merged_loop_3<Traits> merge_loops(const Ribbon_loop_3<Traits>& first,
                                  const Ribbon_loop_3<Traits>& second,
                                  const Merge_options& options = {}) {
  const double tolerance = options.relative_tolerance;
  if (!(0 <= tolerance && tolerance <= Merge_options::max_relative_tolerance))
    throw Input_error("the relative tolerance for merging loops is " +
                      internal::to_short_text(tolerance) + ", not between 0 and " +
                      internal::to_short_text(Merge_options::max_relative_tolerance));
  const double size = (std::max)(first.diagonal(), second.diagonal());
  return internal::Loop_merger<Merged_loop_3<Traits>>(first, second, tolerance * size,
                                                      options.join_sides)();
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MERGE_LOOPS_H
