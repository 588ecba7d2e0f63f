// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINE_WHERE_STEEP_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINE_WHERE_STEEP_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/internal/Mesh_region.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_at_points.h>
#include <CGAL/Multisided_patches/meshing/internal/refine_where_needed.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Where a metric changes so fast that coarser triangles than those of the mesh could not tell it,
// such as next to reflex corners, where derivatives of the surface are unbounded. (The hints of the
// metric are triangles that its field was measured on.)
template <typename Field>
Mesh_region steep_region(const Metric_at_points<Field>& metric, const Linked_triangles& triangles) {
  constexpr int rings = 1;
  const std::vector<char> is_steep = metric.field().steep_triangles();
  if (std::find(is_steep.begin(), is_steep.end(), true) == is_steep.end())
    return Mesh_region({}, 0, {}, 0);
  std::vector<char> is_chosen(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& v = triangles[t].vertices;
    is_chosen[t] =
        std::any_of(v.begin(), v.end(), [&](std::size_t k) { return is_steep[metric.hint(k)]; });
  }
  return Mesh_region(triangles, metric.size(), std::move(is_chosen), rings);
}

// Some points of a mesh, with their locations; the mesh may lack those of points inside.
template <typename Traits>
Domain_mesh_2<Traits> select(const Domain_mesh_2<Traits>& mesh,
                             const std::vector<std::size_t>& numbers) {
  Domain_mesh_2<Traits> result;
  result.points = select(mesh.points, numbers);
  for (const std::size_t k : numbers)
    result.locations.push_back(k < mesh.locations.size()
                                   ? mesh.locations[k]
                                   : Domain_mesh_2<Traits>::Location::interior());
  return result;
}

// Measures a metric anew where it is steep, and refines the mesh there.
//
// `remeasure(part of the mesh without triangles, triangles)` returns an optional field that has
// one. Then `mend(part, triangles, number of points)` is called, which may flip edges and move
// points other than the first ones. Points on the boundary stay as they are; new ones are appended,
// up to `max_points` in all. Now and then it calls progress(number of points), which may throw.
//
// The mesh may lack the locations of points inside. The metric is as it was, without new points.
template <typename ConcurrencyTag, typename Traits, typename Field, typename Remeasure,
          typename Mend, typename Progress>
void refine_where_steep(Domain_mesh_2<Traits>& mesh, const Metric_at_points<Field>& metric,
                        Linked_triangles& triangles, const Remeasure& remeasure, const Mend& mend,
                        std::size_t max_points, const Progress& progress) {
  Mesh_region region = steep_region(metric, triangles);
  if (region.triangles().empty())
    return;
  Domain_mesh_2<Traits> part = select(mesh, region.points());
  const std::optional<Field> field = remeasure(part, region.triangles());
  CGAL_assertion(field.has_value());
  Mesh_to_refine<Traits, Field> refined{part.points, metric.with_field(*field), region.triangles()};
  for (std::size_t k = 0; k < part.points.size(); ++k)
    refined.metric.add(to_uv(part.points[k]), field->triangle_at(k));
  const std::size_t others = mesh.points.size() - part.points.size();
  refine_components<ConcurrencyTag>(refined, region.number_of_border_points(),
                                    (std::max)(max_points, others) - others,
                                    [&](std::size_t n) { progress(others + n); });
  part.points = std::move(refined.points);
  part.locations.resize(part.points.size(), Domain_mesh_2<Traits>::Location::interior());
  mend(part, refined.triangles, region.number_of_border_points());
  put_back(region, part.points, refined.triangles, mesh.points, triangles);
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINE_WHERE_STEEP_H
