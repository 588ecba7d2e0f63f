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
#include <optional>
#include <utility>
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

// Puts a part of a mesh back, once it has been refined. `triangles` are those of the parts before.
template <typename Traits, typename Field>
void append(const Mesh_part& part, const Mesh_to_refine<Traits, Field>& refined,
            Mesh_to_refine<Traits, Field>& mesh, Linked_triangles& triangles) {
  using Index = Linked_triangle::Index;
  const std::size_t old = part.points.size(), first_new = mesh.points.size(),
                    first_triangle = triangles.size();
  check_number_of_indices(
      (std::max)(first_new + refined.points.size(), first_triangle + refined.triangles.size()));
  for (std::size_t i = 0; i < old; ++i)
    mesh.points[part.points[i]] = refined.points[i];
  for (std::size_t i = old; i < refined.points.size(); ++i) {
    mesh.points.push_back(refined.points[i]);
    mesh.metric.copy(refined.metric, i);
  }
  for (Linked_triangle t : refined.triangles) {
    for (auto& v : t.vertices)
      v = static_cast<Index>(v < old ? part.points[v] : first_new + v - old);
    for (auto& n : t.neighbors)
      if (n != Linked_triangle::none)
        n = static_cast<Index>(first_triangle + n);
    triangles.push_back(t);
  }
}

// Refines and smooths a mesh as refine_and_smooth() does, but its connected components, which have
// no points in common, in parallel; each gets its share of the new points that there may be.
//
// Progress is reported by the thread that calls this, and not while others work: what a visitor
// does must not run into tasks that report, too.
template <typename ConcurrencyTag, typename Traits, typename Field, typename Progress>
void refine_components(Mesh_to_refine<Traits, Field>& mesh, std::size_t number_of_border_points,
                       std::size_t max_points, const Progress& progress) {
  constexpr std::size_t least = 300;     // triangles that are worth a task
  constexpr std::size_t block = 1 << 13; // points between reports
  const std::size_t old = mesh.points.size(), slack = (std::max)(max_points, old) - old,
                    all_triangles = mesh.triangles.size();
  const std::vector<Mesh_part> parts = split_mesh(mesh.triangles, old, least);
  std::vector<std::optional<Mesh_to_refine<Traits, Field>>> refined(parts.size());
  const auto refine_part = [&](std::size_t k, const auto& part_progress) {
    const std::vector<std::size_t>& points = parts[k].points;
    const auto border = std::lower_bound(points.begin(), points.end(), number_of_border_points);
    const double share =
        static_cast<double>(parts[k].triangles.size()) / static_cast<double>(all_triangles);
    refined[k].emplace(Mesh_to_refine<Traits, Field>{select(mesh.points, points),
                                                     mesh.metric.part(points), parts[k].triangles});
    refine_and_smooth(*refined[k], static_cast<std::size_t>(border - points.begin()),
                      points.size() + static_cast<std::size_t>(share * static_cast<double>(slack)),
                      part_progress);
  };
  std::size_t done = old;
  for (std::size_t first = 0, end = 0; first < parts.size(); first = end) {
    for (std::size_t size = 0; end < parts.size() && size < block; ++end)
      size += parts[end].points.size();
    if (end == first + 1) // perhaps a large one
      refine_part(first, [&](std::size_t n) { progress(done - parts[first].points.size() + n); });
    else
      for_each_index<ConcurrencyTag>(
          end - first, [&](std::size_t k) { refine_part(first + k, [](std::size_t) {}); }, 1);
    for (std::size_t k = first; k < end; ++k)
      done += refined[k]->points.size() - parts[k].points.size();
    progress(done);
  }
  Linked_triangles triangles;
  triangles.reserve(all_triangles + 2 * (done - old));
  for (std::size_t k = 0; k < parts.size(); ++k)
    append(parts[k], *refined[k], mesh, triangles);
  mesh.triangles = std::move(triangles);
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
