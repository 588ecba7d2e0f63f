// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_DOMAIN_MESH_2_H
#define CGAL_MULTISIDED_PATCHES_DOMAIN_MESH_2_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * A triangulation of a `Polygonal_domain_2`. Every triangle is counterclockwise by exact
 * predicates.
 *
 * \tparam Traits a CGAL kernel with exact predicates
 */
template <typename Traits>
struct Domain_mesh_2 {
  using Point_2 = typename Traits::Point_2;
  using Location = typename Polygonal_domain_2<Traits>::Location;

  //! the vertices (domain units): first those on the boundary, side after side, each with the
  //! domain's vertex first, then those inside
  std::vector<Point_2> points;
  //! where each vertex lies; on a side, `s` is exact, whatever the rounding of the point
  std::vector<Location> locations;
  //! three indices of `points`, counterclockwise
  std::vector<std::array<std::size_t, 3>> triangles;
  std::size_t number_of_boundary_points = 0;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_DOMAIN_MESH_2_H
