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
#include <CGAL/Multisided_patches/meshing/internal/split_mesh.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
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

// Points, what the metric is there, and triangles, of a mesh that is refined.
template <typename Traits, typename Field>
struct Mesh_to_refine {
  std::vector<typename Traits::Point_2> points; // those on the border first
  Metric_at_points<Field> metric;
  Linked_triangles triangles;
};

template <typename Point_2>
std::vector<Point_2> select(const std::vector<Point_2>& points,
                            const std::vector<std::size_t>& numbers) {
  std::vector<Point_2> result;
  result.reserve(numbers.size());
  for (const std::size_t k : numbers)
    result.push_back(points[k]);
  return result;
}

// Refines a mesh and smooths it before and after; its first points, those on the border, stay as
// they are. New points are appended, up to `max_points` in all. Now and then it calls
// progress(number of points), which may throw.
template <typename Traits, typename Field, typename Progress>
void refine_and_smooth(Mesh_to_refine<Traits, Field>& mesh, std::size_t number_of_border_points,
                       std::size_t max_points, const Progress& progress) {
  constexpr int sweeps = 5;
  Boundary_triangulation<Traits> triangulation(mesh.points, mesh.triangles);
  Metric_refiner<Traits, Field> refiner(triangulation, mesh.points, mesh.metric,
                                        number_of_border_points);
  refiner.smooth_where_sharp(sweeps, progress);
  refiner.refine(max_points, progress);
  refiner.smooth_where_sharp(sweeps, progress);
  mesh.triangles = triangulation.triangles();
}

// Does the same to a mesh whose connected components have no points in common, in parallel.
template <typename ConcurrencyTag, typename Traits, typename Field, typename Progress>
void refine_components(Mesh_to_refine<Traits, Field>& mesh, std::size_t number_of_border_points,
                       std::size_t max_points, const Progress& progress) {
  constexpr std::size_t least = 300; // triangles that are worth a task
  const std::size_t old = mesh.points.size();
  const std::vector<Mesh_part> parts = split_mesh(mesh.triangles, old, least);
  std::vector<Mesh_to_refine<Traits, Field>> refined;
  refined.reserve(parts.size());
  for (const Mesh_part& part : parts)
    refined.push_back(
        {select(mesh.points, part.points), mesh.metric.part(part.points), part.triangles});
  std::mutex mutex;
  for_each_index<ConcurrencyTag>(
      parts.size(),
      [&](std::size_t k) {
        const std::vector<std::size_t>& points = parts[k].points;
        const auto border = static_cast<std::size_t>(
            std::lower_bound(points.begin(), points.end(), number_of_border_points) -
            points.begin());
        const std::size_t others = old - points.size();
        refine_and_smooth(refined[k], border, (std::max)(max_points, others) - others,
                          [&](std::size_t n) {
                            const std::lock_guard<std::mutex> lock(mutex);
                            progress(others + n);
                          });
      },
      1);

  mesh.triangles.clear();
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::vector<std::size_t>& points = parts[k].points;
    const std::size_t first_new = mesh.points.size(), first_triangle = mesh.triangles.size();
    for (std::size_t i = 0; i < refined[k].points.size(); ++i)
      if (i < points.size()) {
        mesh.points[points[i]] = refined[k].points[i];
      } else {
        mesh.points.push_back(refined[k].points[i]);
        mesh.metric.copy(refined[k].metric, i);
      }
    for (Linked_triangle t : refined[k].triangles) {
      for (auto& v : t.vertices)
        v = static_cast<Linked_triangle::Index>(v < points.size() ? points[v]
                                                                  : first_new + v - points.size());
      for (auto& n : t.neighbors)
        n = n == Linked_triangle::none ? n
                                       : static_cast<Linked_triangle::Index>(first_triangle + n);
      mesh.triangles.push_back(t);
    }
  }
}

// Puts a region back into the mesh that it is from, once it has other triangles, its points have
// moved, and new ones have been appended.
template <typename Point_2>
void put_back(Mesh_region& region, const std::vector<Point_2>& region_points,
              const Linked_triangles& region_triangles, std::vector<Point_2>& points,
              Linked_triangles& triangles) {
  region.replace(region_triangles, points.size(), triangles);
  const std::size_t old = region.points().size();
  for (std::size_t k = 0; k < old; ++k)
    points[region.points()[k]] = region_points[k];
  points.insert(points.end(), region_points.begin() + static_cast<std::ptrdiff_t>(old),
                region_points.end());
}

// Refines and smooths a mesh, but looks at no more of it than the surroundings of bad triangles.
// Points on the boundary stay as they are; new ones are appended, up to `max_points` in all. Now
// and then it calls progress(number of points), which may throw.
template <typename ConcurrencyTag, typename Traits, typename Field, typename Progress>
void refine_where_needed(std::vector<typename Traits::Point_2>& points,
                         Metric_at_points<Field>& metric, Linked_triangles& triangles,
                         std::size_t max_points, const Progress& progress) {
  // Points of sharp triangles are moved, and those around them.
  constexpr int rings = 3;
  Mesh_region region(triangles, points.size(),
                     find_bad_triangles<ConcurrencyTag>(points, metric, triangles), rings);
  if (region.triangles().empty())
    return;
  Mesh_to_refine<Traits, Field> part{select(points, region.points()), metric.part(region.points()),
                                     region.triangles()};
  const std::size_t others = points.size() - part.points.size();
  refine_components<ConcurrencyTag>(part, region.number_of_border_points(),
                                    (std::max)(max_points, others) - others,
                                    [&](std::size_t n) { progress(others + n); });
  put_back(region, part.points, part.triangles, points, triangles);
  for (std::size_t k = region.points().size(); k < part.points.size(); ++k)
    metric.copy(part.metric, k);
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINE_WHERE_NEEDED_H
