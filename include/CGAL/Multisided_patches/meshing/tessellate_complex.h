// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_TESSELLATE_COMPLEX_H
#define CGAL_MULTISIDED_PATCHES_TESSELLATE_COMPLEX_H

#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/Mesh_maps.h>
#include <CGAL/Multisided_patches/meshing/Patch_complex.h>
#include <CGAL/Multisided_patches/meshing/Tessellation_visitor.h>
#include <CGAL/Multisided_patches/meshing/internal/Complex_mesher.h>
#include <CGAL/Multisided_patches/meshing/internal/Linked_elements.h>
#include <CGAL/Multisided_patches/meshing/internal/Property_writer.h>
#include <CGAL/Multisided_patches/meshing/internal/default_maps.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Multisided_patches {

/*!
 * meshes all patches of a complex to one mesh, which is closed where patches share sides.
 *
 * Shared sides are sampled once, and both patches get the samples. With a number of triangles, that
 * is the number of all of them together, and edges are about equally long in all patches.
 *
 * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: patches
 * are meshed in parallel; the result is the same, bit for bit
 * \tparam FaceGraph a model of `MutableFaceGraph` with a vertex point map
 *
 * \param complex the patches
 * \param mesh receives the triangles, in addition to those that it has, patch after patch
 * \param density how fine: a target edge length (model units), or a `Mesh_density`
 * \param maps what else is written, and where to: a `Mesh_maps`, or the `Default_maps`
 * \param visitor hears of the progress and can cancel, see `Tessellation_visitor`
 *
 * \throws Error as the function for a single patch does; the message begins with the name of the
 * patch, and `mesh` is unchanged
 */
template <typename ConcurrencyTag = Parallel_if_available_tag, typename Patch, typename FaceGraph,
          typename Maps = Default_maps, typename Visitor = Tessellation_visitor>
void tessellate(const Patch_complex<Patch>& complex, FaceGraph& mesh, const Mesh_density& density,
                const Maps& maps = Maps(), Visitor&& visitor = Visitor()) {
  internal::Complex_mesher<Patch, ConcurrencyTag, std::remove_reference_t<Visitor>> mesher(complex,
                                                                                           visitor);
  mesher.run(density);
  internal::report_progress(visitor, Tessellation_stage::assembly, 0, mesher.number_of_vertices());
  const auto all_maps = internal::maps_or_default_of_complex<Patch>(maps, mesh);
  internal::Linked_elements<ConcurrencyTag, FaceGraph> elements(mesh, mesher.connectivity());
  elements.keep();
  internal::Property_writer(elements, mesher.connectivity(), all_maps).write(mesh, mesher.meshes());
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_TESSELLATE_COMPLEX_H
