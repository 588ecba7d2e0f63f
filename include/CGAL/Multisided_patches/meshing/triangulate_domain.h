// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_TRIANGULATE_DOMAIN_H
#define CGAL_MULTISIDED_PATCHES_TRIANGULATE_DOMAIN_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/internal/Domain_mesher.h>
#include <CGAL/Multisided_patches/meshing/internal/Uniform_metric.h>
#include <CGAL/Multisided_patches/meshing/internal/even_parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * triangulates a domain: samples on its sides as they are asked for, and points inside that make
 * triangles about as large as asked for, and as well shaped as the samples allow. No point is ever
 * added on a side.
 *
 * All angles are at least 20.7 degrees, except where the boundary forces smaller ones: at a sharp
 * corner, in a slot that is narrower than the samples on its sides are apart, or where short and
 * long segments of the boundary meet. Where neither is the case they are at least 30 degrees in
 * practice.
 *
 * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the
 * result is the same, bit for bit
 *
 * \param domain the domain
 * \param segments for each side, into how many segments of equal length it is divided, at least 1
 * \param spacing the length that edges inside are to have on the average (domain units), greater
 * than 0
 * \param smoothing_sweeps how many times every point inside is moved towards the centroid of the
 * triangles around it, where that makes them better; 2 raise the smallest angles by about 5 degrees
 *
 * \throws Input_error if there would be more than `Mesh_density::max_triangles` triangles, or the
 * diameter of the domain is not between 1e-70 and 1e70
 * \throws Numerical_error if sides are so close to each other, or so short, that rounded samples
 * coincide or cross
 *
 * Complexity: O(m log m) for m points in practice.
 */
template <typename ConcurrencyTag = Parallel_if_available_tag, typename Traits>
Domain_mesh_2<Traits> triangulate_domain(const Polygonal_domain_2<Traits>& domain,
                                         const std::vector<std::size_t>& segments, double spacing,
                                         int smoothing_sweeps = 0) {
  CGAL_precondition(segments.size() == domain.size() && spacing > 0);
  CGAL_precondition(std::find(segments.begin(), segments.end(), 0) == segments.end());
  const double triangles =
      CGAL::to_double(domain.area()) / (spacing * spacing * std::sqrt(3.0) / 4) +
      std::accumulate(segments.begin(), segments.end(), 0.0);
  if (!(triangles <= static_cast<double>(Mesh_density::max_triangles)))
    throw Input_error("a spacing of " + internal::to_short_text(spacing) +
                      ", with these segments, would need about " +
                      internal::to_short_text(triangles) + " triangles; the limit is " +
                      std::to_string(Mesh_density::max_triangles));
  internal::Side_parameters sides;
  for (const std::size_t m : segments)
    sides.push_back(internal::even_parameters(m));
  using Mesher = internal::Domain_mesher<Traits, internal::Uniform_metric, ConcurrencyTag>;
  const internal::Uniform_metric metric(spacing);
  Mesher mesher(domain, sides, metric, std::vector<std::size_t>(domain.size(), 0),
                Mesher::possible_halvings(sides, triangles));
  constexpr std::size_t max_points = Mesh_density::max_triangles / 2;
  const auto ignore_progress = [](std::size_t) {};
  mesher.refine(max_points, ignore_progress);
  // The metric is known exactly.
  const auto do_not_remeasure = [](const auto&, const auto&) {
    return std::optional<internal::Uniform_metric>();
  };
  mesher.halve_edges(max_points, ignore_progress, do_not_remeasure, internal::Keep::edge_length);
  mesher.smooth(smoothing_sweeps);
  return mesher.finish();
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_TRIANGULATE_DOMAIN_H
