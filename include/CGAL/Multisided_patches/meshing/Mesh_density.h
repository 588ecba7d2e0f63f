// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESH_DENSITY_H
#define CGAL_MULTISIDED_PATCHES_MESH_DENSITY_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace CGAL {
namespace Multisided_patches {

/*!
 * How fine a surface is to be meshed: edges of a target length, a target number of triangles, a
 * bound on the distance between surface and mesh, a bound on the angle between their normals, or
 * several of these (but no number of triangles together with others):
 *
 * \code
 * Mesh_density::chordal_deviation(0.01) & Mesh_density::normal_deviation(5)
 * \endcode
 *
 * A plain number converts to an edge length.
 */
class Mesh_density {
public:
  //! the largest number of triangles of a mesh; denser meshes are refused rather than attempted
  static constexpr std::size_t max_triangles = 100'000'000;

  //! \throws Input_error if `length` is not a positive, finite number
  Mesh_density(double length) : edge_length_(checked(length, "the target edge length")) {}

  //! a target edge length (model units). \throws Input_error if it is not positive and finite
  static Mesh_density edge_length(double length) { return Mesh_density(length); }

  //! a target number of triangles. \throws Input_error if it is 0 or more than `max_triangles`
  static Mesh_density triangles(std::size_t count) {
    if (count < 1 || count > max_triangles)
      throw Input_error("the target number of triangles must be between 1 and " +
                        std::to_string(max_triangles) + ", not " + std::to_string(count));
    Mesh_density density;
    density.triangles_ = count;
    return density;
  }

  //! the largest distance of the surface from its triangles (model units). \throws Input_error if
  //! it is not positive and finite
  static Mesh_density chordal_deviation(double distance) {
    Mesh_density density;
    density.chordal_deviation_ = checked(distance, "the largest chordal deviation");
    return density;
  }

  //! the largest angle between the normals of the surface and those of its triangles (degrees).
  //! \throws Input_error if it is not in (0,90]
  static Mesh_density normal_deviation(double angle) {
    if (!(angle <= 90))
      throw Input_error("the largest normal deviation must be at most 90 degrees, not " +
                        internal::to_short_text(angle));
    Mesh_density density;
    density.normal_deviation_ = checked(angle, "the largest normal deviation");
    return density;
  }

  //! what is as fine as both ask for. \throws Input_error if one is a number of triangles, which
  //! leaves nothing to ask for
  friend Mesh_density operator&(const Mesh_density& a, const Mesh_density& b) {
    if (a.triangles_ || b.triangles_)
      throw Input_error("a target number of triangles cannot be combined with other densities");
    Mesh_density density;
    density.edge_length_ = finer(a.edge_length_, b.edge_length_);
    density.chordal_deviation_ = finer(a.chordal_deviation_, b.chordal_deviation_);
    density.normal_deviation_ = finer(a.normal_deviation_, b.normal_deviation_);
    return density;
  }

  //! the target edge length (model units), if there is one
  const std::optional<double>& target_edge_length() const { return edge_length_; }
  //! the target number of triangles, if there is one
  const std::optional<std::size_t>& target_triangles() const { return triangles_; }
  //! the largest chordal deviation (model units), if there is one
  const std::optional<double>& max_chordal_deviation() const { return chordal_deviation_; }
  //! the largest normal deviation (degrees), if there is one
  const std::optional<double>& max_normal_deviation() const { return normal_deviation_; }

private:
  Mesh_density() = default;

  static double checked(double x, const char* what) {
    if (!(x > 0) || !std::isfinite(x))
      throw Input_error(std::string(what) + " must be a positive number, not " +
                        internal::to_short_text(x));
    return x;
  }

  static std::optional<double> finer(const std::optional<double>& a,
                                     const std::optional<double>& b) {
    return a && b ? (std::min)(*a, *b) : a ? a : b;
  }

  std::optional<double> edge_length_, chordal_deviation_, normal_deviation_;
  std::optional<std::size_t> triangles_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESH_DENSITY_H
