// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IS_VALID_DOMAIN_MESH_H
#define CGAL_MULTISIDED_PATCHES_IS_VALID_DOMAIN_MESH_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/internal/Domain_mesh_checker.h>

#include <iostream>
#include <string>

namespace CGAL {
namespace Multisided_patches {

/*!
 * tells what keeps a mesh from being a triangulation of a domain, as `triangulate_domain()` makes
 * it: in one sentence that names a vertex, edge or triangle by its number. Everything is decided
 * exactly. In a valid mesh
 *
 * - the points on the boundary are the domain's vertices and samples of its sides, in order, and
 *   exactly those that `Polygonal_domain_2::point_on_side()` gives for their locations; all other
 *   points have the location `interior`;
 * - every triangle is counterclockwise;
 * - the triangles triangulate the polygon of the samples, without any gap or overlap, and every
 *   point is a corner of one.
 *
 * Rounded samples of sides that nearly touch may cross; such a mesh is not valid.
 *
 * \return the description, empty if the mesh is valid
 *
 * Complexity: O(m log m) for m triangles, for boundary edges that are short as compared to the
 * domain or few as compared to m; 24 bytes of memory a triangle.
 */
template <typename Traits>
std::string domain_mesh_defect(const Polygonal_domain_2<Traits>& domain,
                               const Domain_mesh_2<Traits>& mesh) {
  return internal::Domain_mesh_checker<Traits>(domain, mesh).run();
}

/*!
 * tells whether a mesh is a triangulation of a domain; see `domain_mesh_defect()`.
 *
 * \param domain,mesh as there
 * \param verbose whether to say on `std::cerr` what is wrong
 */
template <typename Traits>
bool is_valid_domain_mesh(const Polygonal_domain_2<Traits>& domain,
                          const Domain_mesh_2<Traits>& mesh, bool verbose = false) {
  const std::string defect = domain_mesh_defect(domain, mesh);
  if (verbose && !defect.empty())
    std::cerr << "the mesh of the domain is not valid: " << defect << '\n';
  return defect.empty();
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IS_VALID_DOMAIN_MESH_H
