// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESH_DOMAIN_H
#define CGAL_MULTISIDED_PATCHES_MESH_DOMAIN_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/Tessellation_visitor.h>
#include <CGAL/Multisided_patches/meshing/internal/Surface_mesher.h>
#include <CGAL/Multisided_patches/meshing/sample_side.h>

#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

namespace internal {

// How the sides are sampled for a density that is not a number of triangles. The curve takes a half
// of the chordal deviation, so that something is left for the triangles next to it.
inline Side_sampling side_sampling(const Mesh_density& density, double share_of_turn) {
  Side_sampling rule;
  rule.max_edge_length = density.target_edge_length();
  if (density.max_chordal_deviation())
    rule.max_chordal_deviation = *density.max_chordal_deviation() / 2;
  if (density.max_normal_deviation())
    rule.max_turn = share_of_turn * *density.max_normal_deviation();
  return rule;
}

template <typename Patch>
Side_parameters sample_sides(const Patch& patch, const Mesh_density& density,
                             double share_of_turn = 1) {
  Side_parameters sides;
  for (std::size_t i = 0; i < patch.domain().size(); ++i)
    sides.push_back(sample_side(patch, i, side_sampling(density, share_of_turn)));
  return sides;
}

// Returns mesh(sides, finality of the sides) with the sides that sample(share_of_turn) returns, at
// first for 1. Where the surface twists along a side whose curve does not turn, no triangles inside
// bring the normal deviation within its bound, or only slivers do; then the sides need more
// samples.
template <typename Sample, typename Function>
auto mesh_with_share_of_turn(const Mesh_density& density, const Sample& sample,
                             const Function& mesh) {
  constexpr double least = 1. / 8;
  double share = density.max_normal_deviation() ? 1 : least;
  decltype(sample(share)) coarse;
  for (; share > least; share /= 2) {
    auto sides = sample(share);
    if (sides == coarse) // other bounds ask for more samples
      continue;
    try {
      return mesh(sides, Sides::may_get_finer);
    } catch (const Coarse_sides_error&) {
      coarse = std::move(sides);
    }
  }
  return mesh(sample(share), Sides::are_final);
}

// Calls start(edge_length), which returns a number of triangles, until that is the target up to a
// tolerance that the counts of small meshes scatter more than; the last call is the best one. Of
// the surface, which is made of `disks` patches, its area and the length of their boundaries (model
// units) tell where to begin.
template <typename Function>
void find_edge_length(std::size_t target, double area, double boundary_length, std::size_t disks,
                      const Function& start) {
  constexpr int max_rounds = 6;
  constexpr double tolerance = 0.025;
  // Of equilateral triangles, with edges of the length asked for; measured on many patches.
  constexpr double mean_triangle_area = 0.87;
  const double wanted = static_cast<double>(target);
  // A disk has at most two edges more on its boundary than triangles. Where a surface has hardly
  // any area, a length from that alone would divide the boundary into millions of edges.
  double length = (std::max)(std::sqrt(area / (mean_triangle_area * wanted) * 4 / std::sqrt(3.0)),
                             boundary_length / (wanted + 2 * static_cast<double>(disks)));
  double best_length = length, best_error = std::numeric_limits<double>::infinity();
  for (int round = 0; round < max_rounds; ++round) {
    const double count = static_cast<double>(start(length));
    const double error = std::abs(count - wanted) / wanted;
    if (error <= tolerance)
      return;
    if (error < best_error) {
      best_error = error;
      best_length = length;
    }
    length *= std::sqrt(count / wanted);
  }
  start(best_length);
}

} // namespace internal

/*!
 * meshes the domain of a patch so that the mesh of the surface is as fine as asked for. Triangles
 * are well shaped on the surface, not in the domain: lengths are measured by the first fundamental
 * form.
 *
 * Sides are sampled by `sample_side()`, and so patches that share a curve get the same points on
 * it, if they are meshed with the same density: with a target edge length, evenly along the curve;
 * with a chordal deviation, by half of it; with a normal deviation, by the turn of the tangent.
 * (For a number of triangles, patches find edge lengths of their own. `Patch_complex` finds a
 * common one.) Inside, edges have about the target length on the average, or are as long as the
 * deviations allow, and change gradually. The deviations of all triangles are measured in each of
 * them, distances at 7 to 10 samples and normals at 7, and triangles refined, until none exceeds
 * the bounds. (Where a bound on normals asks for it, all sides get more samples, up to 8 times as
 * many.)
 *
 * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: how
 * points of the surface are evaluated; the result is the same, bit for bit
 * \tparam Patch a model of `MultisidedPatch_3`
 *
 * \param patch the patch
 * \param density how fine
 * \param visitor hears of the progress and can cancel, see `Tessellation_visitor`
 *
 * \throws Input_error if the density asks for more than `Mesh_density::max_triangles` triangles
 * \throws Accuracy_error if the deviations cannot be reached, because the surface has a crease or a
 * pole
 * \throws Numerical_error if the boundary curves have no length, a point of the surface is not
 * finite, or as `triangulate_domain()` does
 * \throws Cancelled if the visitor wants so
 *
 * Complexity: O(m log m) in practice for m triangles, and some thousands and m / 24 points of the
 * surface, at which lengths are measured; with deviations, the samples of each triangle, a few
 * times over.
 */
template <typename ConcurrencyTag = Parallel_if_available_tag, typename Patch,
          typename Visitor = Tessellation_visitor>
Domain_mesh_2<typename Patch::Geom_traits>
mesh_domain(const Patch& patch, const Mesh_density& density, Visitor&& visitor = Visitor()) {
  internal::Surface_mesher<Patch, ConcurrencyTag, std::remove_reference_t<Visitor>> mesher(patch,
                                                                                           visitor);
  if (density.max_chordal_deviation() || density.max_normal_deviation())
    return internal::mesh_with_share_of_turn(
        density, [&](double share) { return internal::sample_sides(patch, density, share); },
        [&](const internal::Side_parameters& sides, internal::Sides finality) {
          return mesher.with_deviations(sides, finality, density);
        });
  const auto start = [&](double length) {
    return mesher.start(internal::sample_sides(patch, length), length);
  };
  if (density.target_triangles()) {
    internal::find_edge_length(*density.target_triangles(), mesher.area(), mesher.boundary_length(),
                               1, start);
    return mesher.finish(internal::Keep::number_of_triangles);
  }
  start(*density.target_edge_length());
  return mesher.finish(internal::Keep::edge_length);
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESH_DOMAIN_H
