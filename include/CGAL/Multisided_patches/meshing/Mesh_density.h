// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESH_DENSITY_H
#define CGAL_MULTISIDED_PATCHES_MESH_DENSITY_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Multisided_patches {

/*!
 * How fine a surface is to be meshed: a target edge length in model units, or a target number of
 * triangles. A plain number converts to an edge length.
 */
class Mesh_density {
public:
  //! the largest number of triangles of a mesh; denser meshes are refused rather than attempted
  static constexpr std::size_t max_triangles = 100'000'000;

  //! \throws Input_error if `length` is not a positive, finite number
  Mesh_density(double length) : edge_length_(length) {
    if (!(length > 0) || !std::isfinite(length))
      throw Input_error("the target edge length must be a positive number, not " +
                        internal::to_short_text(length));
  }

  //! a target edge length (model units). \throws Input_error if it is not positive and finite
  static Mesh_density edge_length(double length) { return Mesh_density(length); }

  //! a target number of triangles. \throws Input_error if it is 0 or more than `max_triangles`
  static Mesh_density triangles(std::size_t count) {
    if (count < 1 || count > max_triangles)
      throw Input_error("the target number of triangles must be between 1 and " +
                        std::to_string(max_triangles) + ", not " + std::to_string(count));
    Mesh_density density(1);
    density.triangles_ = count;
    return density;
  }

  bool is_triangle_count() const { return triangles_ > 0; }
  //! \pre `!is_triangle_count()`
  double target_edge_length() const { return edge_length_; }
  //! \pre `is_triangle_count()`
  std::size_t target_triangles() const { return triangles_; }

private:
  double edge_length_;
  std::size_t triangles_ = 0;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESH_DENSITY_H
