// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BOUNDARY_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BOUNDARY_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/plane_geometry.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The sides of a polygon with holes, in doubles, at unit size. The domain is on the left of every
// side; side k runs from vertex k to vertex next(k), as in Polygonal_domain_2.
class Boundary {
public:
  Boundary(std::vector<Complex> vertices, std::vector<std::size_t> next)
      : vertices_(std::move(vertices)), next_(std::move(next)), prev_(next_.size()),
        directions_(next_.size()), lengths_(next_.size()) {
    for (std::size_t k = 0; k < size(); ++k) {
      const Complex d = vertices_[next_[k]] - vertices_[k];
      prev_[next_[k]] = k;
      lengths_[k] = std::abs(d);
      directions_[k] = d / lengths_[k];
    }
  }

  std::size_t size() const { return vertices_.size(); }
  std::size_t next(std::size_t k) const { return next_[k]; }
  std::size_t prev(std::size_t k) const { return prev_[k]; }

  const std::vector<Complex>& vertices() const { return vertices_; }
  const Complex& vertex(std::size_t k) const { return vertices_[k]; }
  // the unit vector along side k
  const Complex& direction(std::size_t k) const { return directions_[k]; }
  double length(std::size_t k) const { return lengths_[k]; }
  Segment side(std::size_t k) const { return {vertices_[k], vertices_[next_[k]]}; }
  Half_plane half_plane(std::size_t k) const { return {vertices_[k], directions_[k]}; }

  // the interior angle at vertex k as a multiple of pi, in (0,2)
  double angle(std::size_t k) const {
    const Complex &d = directions_[k], back = -directions_[prev_[k]];
    const double angle = std::atan2(cross(d, back), dot(d, back)) / pi;
    return angle <= 0 ? angle + 2 : angle;
  }

private:
  std::vector<Complex> vertices_;
  std::vector<std::size_t> next_, prev_;
  std::vector<Complex> directions_;
  std::vector<double> lengths_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BOUNDARY_H
