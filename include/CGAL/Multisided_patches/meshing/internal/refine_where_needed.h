// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINE_WHERE_NEEDED_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINE_WHERE_NEEDED_H

#include <CGAL/Multisided_patches/internal/Boundary_triangulation.h>
#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/meshing/internal/Mesh_region.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_at_points.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_refiner.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// For each triangle whether there is something to be done about it or about one of its edges.
template <typename ConcurrencyTag, typename Point_2, typename Field>
std::vector<char> find_bad_triangles(const std::vector<Point_2>& points,
                                     const Metric_at_points<Field>& metric,
                                     const Linked_triangles& triangles) {
  const auto wants_flip = [&](std::size_t t, int i) {
    const std::size_t n = triangles[t].neighbors[i];
    if (n == Linked_triangle::none || n < t)
      return false;
    const auto& neighbors = triangles[n].neighbors;
    const auto j = std::find(neighbors.begin(), neighbors.end(), t) - neighbors.begin();
    const std::size_t v = triangles[t].vertices[i], a = triangles[t].vertices[(i + 1) % 3],
                      w = triangles[n].vertices[j], c = triangles[t].vertices[(i + 2) % 3];
    return prefers_other_diagonal(to_uv(points[a]), to_uv(points[w]), to_uv(points[c]),
                                  to_uv(points[v]),
                                  0.25 * (metric[a] + metric[c] + metric[v] + metric[w]));
  };
  std::vector<char> is_bad(triangles.size());
  for_each_index<ConcurrencyTag>(triangles.size(), [&](std::size_t t) {
    const Metric_triangle triangle = metric.triangle(points, triangles[t].vertices);
    is_bad[t] = is_too_large_or_sharp(triangle) || is_sharp(triangle) || wants_flip(t, 0) ||
                wants_flip(t, 1) || wants_flip(t, 2);
  });
  return is_bad;
}

// Refines and smooths a mesh, but looks at no more of it than the surroundings of bad triangles.
// Points on the boundary stay as they are; new ones are appended, up to `max_points` in all. Now
// and then it calls progress(number of points), which may throw.
template <typename ConcurrencyTag, typename Traits, typename Field, typename Progress>
void refine_where_needed(std::vector<typename Traits::Point_2>& points,
                         Metric_at_points<Field>& metric, Linked_triangles& triangles,
                         std::size_t max_points, const Progress& progress) {
  // Points of sharp triangles are moved, and those around them.
  constexpr int rings = 3, sweeps = 5;
  Mesh_region region(triangles, points.size(),
                     find_bad_triangles<ConcurrencyTag>(points, metric, triangles), rings);
  if (region.triangles().empty())
    return;
  std::vector<typename Traits::Point_2> region_points;
  region_points.reserve(region.points().size());
  for (const std::size_t k : region.points())
    region_points.push_back(points[k]);
  Metric_at_points<Field> region_metric = metric.part(region.points());

  const std::size_t others = points.size() - region_points.size();
  const auto region_progress = [&](std::size_t n) { progress(others + n); };
  Boundary_triangulation<Traits> triangulation(region_points, region.triangles());
  Metric_refiner<Traits, Field> refiner(triangulation, region_points, region_metric,
                                        region.number_of_border_points());
  refiner.smooth_where_sharp(sweeps, region_progress);
  refiner.refine((std::max)(max_points, others) - others, region_progress);
  refiner.smooth_where_sharp(sweeps, region_progress);

  region.replace(triangulation.triangles(), points.size(), triangles);
  for (std::size_t k = 0; k < region_points.size(); ++k)
    if (k < region.points().size()) {
      points[region.points()[k]] = region_points[k];
    } else {
      points.push_back(region_points[k]);
      metric.copy(region_metric, k);
    }
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINE_WHERE_NEEDED_H
