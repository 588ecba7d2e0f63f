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

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Measures a metric anew where it changes so fast that coarser triangles than those of the mesh
// could not tell it, such as next to reflex corners, where derivatives of the surface are
// unbounded; and refines the mesh there.
//
// `remeasure(part of the mesh without triangles, triangles)` returns a field. Then
// `mend(part, triangles, number of points)` is called, which may flip edges and move points other
// than the first ones. Points on the boundary stay as they are; new ones are appended, up to
// `max_points` in all. Now and then it calls progress(number of points), which may throw.
template <typename ConcurrencyTag, typename Traits, typename Field, typename Remeasure,
          typename Mend, typename Progress>
void refine_where_steep(Domain_mesh_2<Traits>& mesh, Metric_at_points<Field>& metric,
                        Linked_triangles& triangles, const Remeasure& remeasure, const Mend& mend,
                        std::size_t max_points, const Progress& progress) {
  using Location = typename Domain_mesh_2<Traits>::Location;
  const std::vector<char> is_steep = metric.field().steep_triangles();
  if (std::find(is_steep.begin(), is_steep.end(), true) == is_steep.end())
    return;
  std::vector<char> is_chosen(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& v = triangles[t].vertices;
    is_chosen[t] =
        std::any_of(v.begin(), v.end(), [&](std::size_t k) { return is_steep[metric.hint(k)]; });
  }
  constexpr int rings = 1;
  Mesh_region region(triangles, mesh.points.size(), std::move(is_chosen), rings);
  if (region.triangles().empty())
    return;

  Domain_mesh_2<Traits> part;
  part.points = select(mesh.points, region.points());
  for (const std::size_t k : region.points())
    part.locations.push_back(k < mesh.locations.size() ? mesh.locations[k] : Location::interior());
  const Field field = *remeasure(part, region.triangles());
  Mesh_to_refine<Traits, Field> refined{part.points, metric.with_field(field), region.triangles()};
  for (std::size_t k = 0; k < part.points.size(); ++k)
    refined.metric.add(to_uv(part.points[k]), field.triangle_at(k));
  const std::size_t others = mesh.points.size() - part.points.size(),
                    border = region.number_of_border_points();
  refine_components<ConcurrencyTag>(refined, border, (std::max)(max_points, others) - others,
                                    [&](std::size_t n) { progress(others + n); });
  part.points = std::move(refined.points);
  part.locations.resize(part.points.size(), Location::interior());
  mend(part, refined.triangles, border);

  put_back(region, part.points, refined.triangles, mesh.points, triangles);
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_REFINE_WHERE_STEEP_H
