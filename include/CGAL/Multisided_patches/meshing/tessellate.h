// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_TESSELLATE_H
#define CGAL_MULTISIDED_PATCHES_TESSELLATE_H

#include <CGAL/Multisided_patches/internal/run_both.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/Mesh_maps.h>
#include <CGAL/Multisided_patches/meshing/Tessellation_visitor.h>
#include <CGAL/Multisided_patches/meshing/internal/Linked_elements.h>
#include <CGAL/Multisided_patches/meshing/internal/Mesh_connectivity.h>
#include <CGAL/Multisided_patches/meshing/internal/Property_writer.h>
#include <CGAL/Multisided_patches/meshing/internal/default_maps.h>
#include <CGAL/Multisided_patches/meshing/mesh_domain.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * evaluates a patch at the vertices of a mesh of its domain, and adds the surface mesh to `mesh`.
 * Vertices on the boundary of the domain get the points of the boundary curves themselves.
 *
 * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the
 * result is the same, bit for bit
 * \tparam Patch a model of `MultisidedPatch_3`
 * \tparam FaceGraph a model of `MutableFaceGraph` with a vertex point map, such as `Surface_mesh`
 * or `Polyhedron_3`
 *
 * \param patch the patch
 * \param domain_mesh the mesh of its domain
 * \param mesh receives the triangles, in addition to those that it has
 * \param maps what else is written, and where to: a `Mesh_maps`, or the `Default_maps`
 * \param visitor hears of the progress and can cancel, see `Tessellation_visitor`; it must not look
 * at `mesh`
 *
 * \pre `domain_mesh` is valid, see `is_valid_domain_mesh()`
 *
 * \throws Numerical_error if a point of the surface is not finite
 * \throws Input_error if there are more than 7e8 triangles
 * \throws Cancelled if the visitor wants so; `mesh` is unchanged in all these cases, but for the
 * capacity of its arrays
 *
 * Complexity: one evaluation of the patch with first derivatives for each vertex.
 */
template <typename ConcurrencyTag = Parallel_if_available_tag, typename Patch, typename FaceGraph,
          typename Maps = Default_maps, typename Visitor = Tessellation_visitor>
void tessellate(const Patch& patch, const Domain_mesh_2<typename Patch::Geom_traits>& domain_mesh,
                FaceGraph& mesh, const Maps& maps = Maps(), Visitor&& visitor = Visitor()) {
  const std::size_t n = domain_mesh.points.size();
  std::vector<std::vector<std::size_t>> numbers{std::vector<std::size_t>(n)};
  std::iota(numbers[0].begin(), numbers[0].end(), std::size_t(0));
  using Elements = internal::Linked_elements<ConcurrencyTag, FaceGraph>;
  std::optional<internal::Mesh_connectivity> connectivity;
  std::optional<Elements> elements;
  std::vector<internal::Patch_mesh<Patch>> patch_mesh(1);
  internal::run_both<ConcurrencyTag>(
      [&] {
        patch_mesh[0] = internal::evaluate_vertices<ConcurrencyTag>(patch, domain_mesh, visitor);
        internal::fill_missing_normals(patch_mesh[0]);
      },
      [&] {
        connectivity.emplace(std::vector{&domain_mesh}, std::move(numbers), ConcurrencyTag());
        if constexpr (Elements::are_removable)
          elements.emplace(mesh, *connectivity);
      });
  internal::report_progress(visitor, Tessellation_stage::assembly, 0, n);
  if constexpr (!Elements::are_removable)
    elements.emplace(mesh, *connectivity);
  const auto all_maps = internal::maps_or_default<Patch>(maps, mesh);
  elements->keep();
  internal::Property_writer(*elements, *connectivity, all_maps).write(mesh, patch_mesh);
}

/*!
 * meshes a patch: a disk of triangles, counterclockwise as seen from the side to which the normals
 * point. This is `mesh_domain()`, followed by the function above.
 *
 * \param patch the patch
 * \param mesh receives the triangles, in addition to those that it has
 * \param density how fine: a target edge length (model units), or a `Mesh_density`
 * \param maps,visitor as above
 *
 * \throws Input_error if the density asks for too many triangles
 * \throws Accuracy_error if the deviations of the density cannot be reached
 * \throws Numerical_error if a point of the surface is not finite
 * \throws Cancelled if the visitor wants so; `mesh` is unchanged in all these cases
 */
template <typename ConcurrencyTag = Parallel_if_available_tag, typename Patch, typename FaceGraph,
          typename Maps = Default_maps, typename Visitor = Tessellation_visitor>
void tessellate(const Patch& patch, FaceGraph& mesh, const Mesh_density& density,
                const Maps& maps = Maps(), Visitor&& visitor = Visitor()) {
  tessellate<ConcurrencyTag>(patch, mesh_domain<ConcurrencyTag>(patch, density, visitor), mesh,
                             maps, visitor);
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_TESSELLATE_H
