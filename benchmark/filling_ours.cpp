// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filling.h"

#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/Surface_mesh.h>

// Our own fillings, and the measure of those that are meshes.

namespace bench {

namespace {

using Patch = MP::Concave_bezier_patch_3<Kernel>;

// For each segment of the boundary, from one sample to the next, the third corner of its triangle.
std::vector<Point_3> opposite_corners(const Filling_mesh& mesh, std::size_t samples) {
  std::vector<Point_3> corners(samples);
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = t[k], to = t[(k + 1) % 3];
      if (from < samples && to == (from + 1) % samples)
        corners[from] = mesh.points[t[(k + 2) % 3]];
    }
  return corners;
}

// The segment that a point of the boundary lies on.
std::size_t segment_at(const Hole& hole, std::size_t side, double s) {
  const auto after = std::upper_bound(
      hole.boundary.begin(), hole.boundary.end(), s, [&](double x, const Hole::Sample& sample) {
        return sample.side > side || (sample.side == side && sample.s > x);
      });
  return static_cast<std::size_t>(after - hole.boundary.begin()) - 1;
}

} // namespace

void measure_boundary(const Filling_mesh& mesh, const Hole& hole, Filling_outcome& outcome) {
  const std::size_t samples = hole.boundary.size();
  const std::vector<Point_3> corners = opposite_corners(mesh, samples);
  const auto evaluate = [&](std::size_t side, double s) {
    const std::size_t k = segment_at(hole, side, s), next = (k + 1) % samples;
    const double begin = hole.boundary[k].s,
                 end = next == 0 || hole.boundary[next].side != side ? 1 : hole.boundary[next].s;
    const Kernel::Vector_3 along = mesh.points[next] - mesh.points[k];
    return plane(mesh.points[k] + (s - begin) / (end - begin) * along, along,
                 corners[k] - mesh.points[k]);
  };
  measure_boundary(Boundary_surface(hole.model.loop, evaluate), outcome);
}

Hole make_hole(const Model& model, double edge_length) {
  const Patch patch(model);
  Hole hole{model, edge_length, {}};
  for (std::size_t i = 0; i < model.loop.size(); ++i) {
    MP::Side_sampling rule;
    rule.max_edge_length = edge_length;
    hole.boundary.push_back({i, 0});
    for (const double parameter : MP::sample_side(patch, i, rule))
      hole.boundary.push_back({i, parameter});
  }
  return hole;
}

Filling_outcome fill_with_patch(const Hole& hole) {
  const double begin = cpu_seconds();
  const Patch patch(hole.model);
  Filling_outcome outcome;
  outcome.seconds = cpu_seconds() - begin;
  measure_boundary(patch, outcome);
  return outcome;
}

Filling_outcome fill_with_patch_mesh(const Hole& hole) {
  const double begin = cpu_seconds();
  const Patch patch(hole.model);
  const auto domain_mesh = MP::mesh_domain<CGAL::Sequential_tag>(patch, hole.edge_length);
  CGAL::Surface_mesh<Point_3> surface_mesh;
  MP::tessellate<CGAL::Sequential_tag>(patch, domain_mesh, surface_mesh);
  Filling_outcome outcome;
  outcome.seconds = cpu_seconds() - begin;
  outcome.triangles = double(surface_mesh.number_of_faces());
  Filling_mesh mesh{{}, domain_mesh.triangles};
  for (std::size_t j = 0; j < domain_mesh.points.size(); ++j)
    mesh.points.push_back(patch.point(domain_mesh.points[j], domain_mesh.locations[j]));
  measure_boundary(mesh, hole, outcome);
  return outcome;
}

} // namespace bench
