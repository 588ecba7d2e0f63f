// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_SAMPLER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_SAMPLER_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/Tessellation_visitor.h>
#include <CGAL/Multisided_patches/meshing/internal/Deviation_meter.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_2.h>
#include <CGAL/Multisided_patches/meshing/internal/Sampled_mesh.h>
#include <CGAL/Multisided_patches/meshing/internal/Scaled_surface.h>
#include <CGAL/Multisided_patches/meshing/internal/Sharp_triangle_mender.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// What is done with a patch for the meshes that are made of its domain: it is evaluated, their
// deviations from it are measured, and their sharp triangles mended. A visitor hears of that, and
// of how far a mesher has come.
template <typename Patch, typename ConcurrencyTag, typename Visitor>
class Surface_sampler {
public:
  using Traits = typename Patch::Geom_traits;
  using Mesh = Domain_mesh_2<Traits>;
  using Surface = Scaled_surface<Patch>;
  using Meter = Deviation_meter<Surface>;
  using Effort = typename Meter::Effort;
  using Point_2 = typename Traits::Point_2;

  Surface_sampler(const Patch& patch, Visitor& visitor) : surface_(patch), visitor_(visitor) {}

  const Surface& surface() const { return surface_; }

  // Refines a mesh in the making, which is expected to get so many points.
  template <typename Mesher>
  void refine(Mesher& mesher, std::size_t expected) {
    with_limit(mesher, expected,
               [&](std::size_t limit, const auto& progress) { mesher.refine(limit, progress); });
  }

  // Calls f(limit, progress) with a limit for the number of points that a mesher makes, and a
  // function that reports how many there are.
  template <typename Mesher, typename Function>
  void with_limit(const Mesher& mesher, std::size_t expected, const Function& f) {
    const auto progress = [&](std::size_t done) {
      report_progress(visitor_, Tessellation_stage::meshing, done, (std::max)(done, expected));
    };
    const std::size_t points = mesher.mesh().points.size();
    progress(points);
    // Triangles between short and long segments of the boundary add to what is expected.
    f(4 * expected + 20 * points + 1000, progress);
  }

  // Brings a sampled mesh up to date with the mesh in the making, of which it was a part.
  template <typename Mesher>
  void sample(const Mesher& mesher, Sampled_mesh& sampled) {
    sample(mesher.mesh(), mesher.triangles(), sampled);
  }
  void sample(const Mesh& mesh, Linked_triangles triangles, Sampled_mesh& sampled) {
    const std::size_t old = sampled.uv.size(), n = mesh.points.size();
    sampled.positions.resize(n);
    for (std::size_t k = old; k < n; ++k)
      sampled.uv.push_back(to_uv(mesh.points[k]));
    in_blocks(n - old, [&](std::size_t k) {
      sampled.positions[old + k] = surface_.position(mesh.points[old + k], mesh.locations[old + k]);
    });
    for (std::size_t k = old; k < n; ++k) {
      surface_.check_finite(sampled.positions[k], mesh.points[k]);
      if (is_reflex_corner(mesh.locations[k]))
        sampled.singular_vertices.push_back(k);
    }
    sampled.triangles = std::move(triangles);
  }

  // The excess of each of some triangles, given by their numbers.
  std::vector<double> measure(const Meter& meter, const Sampled_mesh& mesh,
                              const std::vector<std::size_t>& triangles,
                              Effort effort = Effort::verification) {
    std::vector<double> excess(triangles.size());
    in_blocks(triangles.size(), [&](std::size_t k) {
      excess[k] = meter.excess(meter(mesh, mesh.triangles[triangles[k]], effort));
    });
    return excess;
  }
  std::vector<double> measure(const Meter& meter, const Sampled_mesh& mesh,
                              Effort effort = Effort::verification) {
    std::vector<std::size_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    return measure(meter, mesh, all, effort);
  }

  // Mends the sharp triangles of a mesh that was sampled. The first points stay where they are.
  void mend_sharp_triangles(std::vector<Point_2>& points, std::size_t fixed_points,
                            Sampled_mesh& sampled, const Meter& meter) {
    Sharp_triangle_mender<Surface, Meter>(surface_, meter, sampled, points, fixed_points).mend([&] {
      report_progress(visitor_, Tessellation_stage::meshing, points.size(), points.size());
    });
  }

private:
  using Location = typename Surface::Location;

  bool is_reflex_corner(const Location& location) const {
    return location.kind == Location::Kind::vertex &&
           surface_.domain().corner_type(location.index) == Corner_type::reflex;
  }

  // Calls f(k) for k < n, and tells the visitor in between.
  template <typename Function>
  void in_blocks(std::size_t n, const Function& f) {
    constexpr std::size_t block = 1 << 14, grain = 64;
    for (std::size_t first = 0; first < n; first += block) {
      report_progress(visitor_, Tessellation_stage::evaluation, first, n);
      for_each_index<ConcurrencyTag>((std::min)(block, n - first),
                                     [&](std::size_t k) { f(first + k); }, grain);
    }
  }

  Surface surface_;
  Visitor& visitor_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_SAMPLER_H
