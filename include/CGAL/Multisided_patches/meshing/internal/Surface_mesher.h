// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_MESHER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_MESHER_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/internal/Deviation_mesher.h>
#include <CGAL/Multisided_patches/meshing/internal/Domain_mesher.h>
#include <CGAL/Multisided_patches/meshing/internal/Sampled_mesh.h>
#include <CGAL/Multisided_patches/meshing/internal/Surface_metric.h>
#include <CGAL/Multisided_patches/meshing/internal/Surface_sampler.h>
#include <CGAL/Multisided_patches/meshing/internal/Uniform_metric.h>
#include <CGAL/Multisided_patches/meshing/internal/even_parameters.h>
#include <CGAL/Multisided_patches/meshing/internal/expected_triangles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Meshes the domain of a patch so that its image on the surface is as fine as asked for.
//
// At first there is a coarse mesh, evenly spaced in the domain. It tells how lengths on the surface
// relate to those in the domain, which is enough for edges of a given length; bounds on deviations
// take more.
template <typename Patch, typename ConcurrencyTag, typename Visitor>
class Surface_mesher {
public:
  using Traits = typename Patch::Geom_traits;
  using Domain = Polygonal_domain_2<Traits>;
  using Mesh = Domain_mesh_2<Traits>;

  Surface_mesher(const Patch& patch, Visitor& visitor) : sampler_(patch, visitor) {
    make_coarse_mesh();
  }

  // Of the surface (squared model units).
  double area() const { return coarse_lengths_.metric.area() * unit() * unit(); }
  // (model units)
  double boundary_length() const { return coarse_lengths_.metric.boundary_length() * unit(); }

  // Begins a mesh with edges of a length (model units) on the average. Returns about how many
  // triangles it will have.
  std::size_t start(Side_parameters sides, double length) {
    sides_ = std::move(sides);
    metric_ = coarse_lengths_.metric;
    length_ = length / unit();
    metric_.set_edge_length(length_);
    const double expected = expected_triangles(metric_, sides_);
    check_number_of_triangles(expected, "an edge length of " + to_short_text(length));
    mesher_.emplace(domain(), sides_, metric_, coarse_lengths_.hints,
                    Mesher::possible_halvings(sides_, expected));
    sampler_.refine(*mesher_, expected_points(metric_, sides_));
    return mesher_->expected_triangles();
  }
  // Finishes it.
  Mesh finish(Keep keep) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const typename Sampler::Meter no_bounds(sampler_.surface(), infinity, infinity, 1);
    const auto remeasure = [&](const Mesh& mesh, const Linked_triangles& triangles) {
      Sampled_mesh sampled;
      sampler_.sample(mesh, triangles, sampled);
      Surface_metric metric(sampled);
      metric.set_edge_length(length_);
      return std::make_optional(std::move(metric));
    };
    const auto mend = [&](Mesh& part, Linked_triangles& triangles, std::size_t fixed_points) {
      Sampled_mesh sampled;
      sampler_.sample(part, std::move(triangles), sampled);
      sampler_.mend_sharp_triangles(part.points, fixed_points, sampled, no_bounds);
      triangles = std::move(sampled.triangles);
    };
    sampler_.with_limit(*mesher_, expected_points(metric_, sides_),
                        [&](std::size_t limit, const auto& progress) {
                          mesher_->halve_edges(limit, progress, remeasure, keep);
                          mesher_->refine_where_steep(limit, progress, remeasure, mend);
                        });
    return mesher_->finish();
  }

  // No deviation larger than the density says, and edges no longer, if it says so.
  Mesh with_deviations(const Side_parameters& sides, Sides finality, const Mesh_density& density) {
    return Deviation_mesher<Patch, ConcurrencyTag, Visitor>(sampler_, sides, finality, density)
        .mesh(coarse_, coarse_lengths_);
  }

private:
  using Sampler = Surface_sampler<Patch, ConcurrencyTag, Visitor>;
  using Mesher = Domain_mesher<Traits, Surface_metric, ConcurrencyTag>;

  const Domain& domain() const { return sampler_.surface().domain(); }
  double unit() const { return sampler_.surface().unit(); }

  void make_coarse_mesh() {
    constexpr double triangles = 3000;
    // In a very thin domain there would be too many samples on the sides.
    constexpr double max_samples = 3000;
    double perimeter = 0;
    for (std::size_t i = 0; i < domain().size(); ++i)
      perimeter += domain().side_length(i);
    const double area = (std::max)(0.0, CGAL::to_double(domain().area()));
    const double spacing =
        (std::max)(std::sqrt(area / triangles * 4 / std::sqrt(3.0)), perimeter / max_samples);
    Side_parameters sides;
    for (std::size_t i = 0; i < domain().size(); ++i)
      sides.push_back(even_parameters(
          static_cast<std::size_t>(std::ceil((std::max)(1.0, domain().side_length(i) / spacing)))));
    const Uniform_metric metric(spacing);
    Domain_mesher<Traits, Uniform_metric, ConcurrencyTag> mesher(
        domain(), sides, metric, std::vector<std::size_t>(domain().size(), 0));
    sampler_.refine(mesher, static_cast<std::size_t>(triangles));
    sampler_.sample(mesher, coarse_);
    coarse_lengths_ = Surface_lengths(coarse_, sides);
  }

  Sampler sampler_;
  Sampled_mesh coarse_;
  Surface_lengths coarse_lengths_;
  // The mesh that was begun last.
  Side_parameters sides_;
  double length_ = 0;
  Surface_metric metric_;
  std::optional<Mesher> mesher_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_MESHER_H
