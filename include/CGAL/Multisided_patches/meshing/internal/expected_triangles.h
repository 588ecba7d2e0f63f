// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EXPECTED_TRIANGLES_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EXPECTED_TRIANGLES_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/internal/Side_parameters.h>
#include <CGAL/Multisided_patches/meshing/internal/Surface_metric.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// About how many triangles a mesh will have that is made with a metric and samples on the sides.
inline double expected_triangles(const Surface_metric& metric, const Side_parameters& sides) {
  // The mean area of triangles that Metric_refiner makes, relative to that of equilateral ones with
  // edges of length 1; measured on large meshes.
  constexpr double mean_area = 0.945;
  double count = metric.metric_area() / (mean_area * std::sqrt(3.0) / 4);
  for (const std::vector<double>& side : sides)
    count += static_cast<double>(side.size());
  return count;
}

inline std::size_t expected_points(const Surface_metric& metric, const Side_parameters& sides) {
  return static_cast<std::size_t>(expected_triangles(metric, sides) / 2) + 1;
}

// Refuses densities beyond the limit before anything large is computed.
inline void check_number_of_triangles(double expected, const std::string& density) {
  if (!(expected <= static_cast<double>(Mesh_density::max_triangles)))
    throw Input_error(density + " would need about " + to_short_text(expected) +
                      " triangles; the limit is " + std::to_string(Mesh_density::max_triangles));
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EXPECTED_TRIANGLES_H
