// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_SAMPLE_SIDE_H
#define CGAL_MULTISIDED_PATCHES_SAMPLE_SIDE_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/internal/Canonical_curve.h>
#include <CGAL/Multisided_patches/meshing/internal/Curve_spacing.h>
#include <CGAL/Multisided_patches/meshing/internal/Curve_table.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! How densely a boundary curve is sampled: the segments between samples keep to all bounds that
//! are there.
struct Side_sampling {
  //! the largest length of the curve between two samples (model units), to 1e-3 of it
  std::optional<double> max_edge_length;
  //! the largest distance of the curve from its segments (model units)
  std::optional<double> max_chordal_deviation;
  //! about the largest angle by which the tangent turns between two samples (degrees); bends of a
  //! radius below 1e-4 of the curve's length count as corners, between samples or not
  std::optional<double> max_turn;
};

namespace internal {

inline double bound_or_infinity(const std::optional<double>& bound, const char* what) {
  if (!bound)
    return std::numeric_limits<double>::infinity();
  if (!(*bound > 0) || !std::isfinite(*bound))
    throw Input_error(std::string(what) + " of a side's segments must be a positive number, not " +
                      to_short_text(*bound));
  return *bound;
}

inline Segment_bounds segment_bounds(const Canonical_curve& curve, const Side_sampling& rule) {
  return {curve.scaled(bound_or_infinity(rule.max_edge_length, "the largest length")),
          curve.scaled(bound_or_infinity(rule.max_chordal_deviation, "the largest deviation")),
          bound_or_infinity(rule.max_turn, "the largest turn") * pi / 180};
}

// The next larger integer; the slack absorbs the errors of the lengths, which are below it for
// regular curves.
inline std::size_t number_of_segments(const Curve_spacing& spacing, const std::string& name) {
  const double count = std::ceil(spacing.count() * (1 - 1e-6));
  if (!(count <= static_cast<double>(Mesh_density::max_triangles)))
    throw Input_error(name + " would need about " + to_short_text(count) +
                      " segments, to be as fine as asked for; the limit is " +
                      std::to_string(Mesh_density::max_triangles));
  return count > 1 ? static_cast<std::size_t>(count) : 1;
}

// How often samples are added where a curve is too far from its segments, at most. Mostly once is
// enough, if at all, and adds a few; when their number multiplies, none will do.
constexpr int max_sampling_rounds = 30;
constexpr std::size_t max_sampling_growth = 16;

// What `sample_side()` does, for a curve given by its points. `name` begins the texts of errors.
inline std::vector<double> sample_curve(Curve_3 point, const Side_sampling& rule,
                                        const std::string& name) {
  const Canonical_curve curve(std::move(point), name);
  const Segment_bounds bounds = segment_bounds(curve, rule);
  const Curve_table table(curve);
  if (curve.is_a_point() || table.size() < 2)
    return {};
  Curve_spacing spacing(curve, table, bounds);
  const std::size_t first = number_of_segments(spacing, name);
  double reached = std::numeric_limits<double>::infinity();
  for (int round = 0; round < max_sampling_rounds; ++round) {
    const std::size_t segments = number_of_segments(spacing, name);
    if (segments > max_sampling_growth * (first + 100))
      break;
    const std::vector<double> samples = spacing.divide(segments);
    if (!rule.max_chordal_deviation)
      return curve.parameters(samples);
    reached = (std::min)(reached, spacing.shorten(samples));
    if (reached <= spacing.largest_accepted())
      return curve.parameters(samples);
    if (bounds.deviation < curve.rounding())
      break;
  }
  reached = curve.unscaled(reached);
  throw Accuracy_error(name + " deviates from its segments by " + to_short_text(reached) +
                           ", and more samples do not bring this down to " +
                           to_short_text(*rule.max_chordal_deviation),
                       reached);
}

} // namespace internal

/*!
 * samples side `i` of a patch: returns the parameters of the samples strictly inside (0,1),
 * strictly increasing.
 *
 * The samples are a matter of the curve alone. Patches that share a curve, whichever way each runs
 * along it, get the same points, bit for bit: if one runs along it as s and the other as 1 - s,
 * then so do the parameters, which are multiples of 2^-53. This rests on the points of the patches:
 * where 1 - s is exact, they must be bitwise equal.
 *
 * With a largest edge length alone, the samples are evenly spaced along the curve, to 1e-3 of the
 * spacing for regular curves. Other bounds space them by the curvature; the spacing changes
 * gradually. As a straight side tells nothing about how the surface bends, a curve of length L
 * counts as bent like an arc of radius L at least: its edges are no longer than sqrt(8 d L) for a
 * deviation d, and than L t for a turn t (radians). A curve that runs back the way it came has a
 * sample where it turns.
 *
 * \param patch the patch
 * \param i the side
 * \param rule how dense; without any bound, a curve is one segment
 *
 * \tparam Patch a model of `MultisidedPatch_3`
 *
 * \throws Input_error if a bound is not a positive number, or asks for more than
 * `Mesh_density::max_triangles` segments
 * \throws Accuracy_error if the chordal deviation cannot be reached, such as one below the rounding
 * of the points
 * \throws Numerical_error if a point of the curve is not finite
 *
 * Complexity: some hundreds of points of the curve, and some thousands if it is wild; for a chordal
 * deviation, 8 more for each sample, a few times over where samples have to be added.
 */
template <typename Patch>
std::vector<double> sample_side(const Patch& patch, std::size_t i, const Side_sampling& rule) {
  using FT = typename Patch::Geom_traits::FT;
  const auto& domain = patch.domain();
  const auto point = [&](double s) {
    const FT t(s);
    return internal::to_vec3(
        patch.point(domain.point_on_side(i, t), domain.location_on_side(i, t)));
  };
  return internal::sample_curve(point, rule, "side " + std::to_string(i));
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_SAMPLE_SIDE_H
