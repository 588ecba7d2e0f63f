// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EDGE_LENGTHS_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EDGE_LENGTHS_H

#include <CGAL/Multisided_patches/meshing/internal/Surface_metric.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Makes edge lengths change gradually: from one vertex to the next by no more than a fraction of
// the distance.
inline void limit_growth(const Surface_metric& metric, std::vector<double>& lengths) {
  constexpr double growth = 0.35;
  constexpr int max_sweeps = 100; // what is left then does no harm
  bool changed = true;
  for (int sweep = 0; changed && sweep < max_sweeps; ++sweep) {
    changed = false;
    for (const Linked_triangle& t : metric.triangles())
      for (int i = 0; i < 3; ++i) {
        double &a = lengths[t.vertices[i]], &b = lengths[t.vertices[(i + 1) % 3]];
        const double step = growth * metric.length(t.vertices[i], t.vertices[(i + 1) % 3]);
        changed = changed || a > 1.01 * (b + step) || b > 1.01 * (a + step);
        a = (std::min)(a, b + step);
        b = (std::min)(b, a + step);
      }
  }
}

// The edge lengths at the vertices with which the triangles of a new mesh are within their bounds,
// where the edges of those of the present one are too long by a factor, their excess.
inline std::vector<double> edge_lengths_for_excess(const Surface_metric& metric,
                                                   const std::vector<double>& excess,
                                                   double longest) {
  // Deviations scatter around what is aimed at. What is measured on a coarse mesh tells little
  // about much finer ones. Coarser ones are limited by the growth of lengths and by `longest`.
  constexpr double aim = 0.8, max_shortening = 0.4;
  std::vector<double> lengths(metric.number_of_vertices(), longest);
  for (std::size_t t = 0; t < excess.size(); ++t) {
    if (!(excess[t] > 0))
      continue;
    const auto& v = metric.triangles()[t].vertices;
    const double length =
        (metric.length(v[0], v[1]) + metric.length(v[1], v[2]) + metric.length(v[2], v[0])) / 3;
    const double wanted = (std::max)(aim / excess[t], max_shortening) * length;
    for (const std::size_t k : v)
      lengths[k] = (std::min)(lengths[k], wanted);
  }
  limit_growth(metric, lengths);
  return lengths;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EDGE_LENGTHS_H
