// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DOMAIN_MESHER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DOMAIN_MESHER_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/Boundary_triangulation.h>
#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_refiner.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// For each side the parameters of its samples, increasing in (0,1).
using Side_parameters = std::vector<std::vector<double>>;

// A mesh of a domain in the making: samples on the sides, which stay as they are, triangulated at
// its construction, and points inside, as many as a metric asks for.
template <typename Traits, typename Field>
class Domain_mesher {
public:
  using Domain = Polygonal_domain_2<Traits>;
  using Mesh = Domain_mesh_2<Traits>;
  using Location = typename Domain::Location;
  using FT = typename Traits::FT;

  // The hints are those with which the field is asked at the vertices of the domain.
  Domain_mesher(const Domain& domain, const Side_parameters& sides, const Field& field,
                const std::vector<std::size_t>& hints)
      : mesh_(sample_boundary(domain, sides)), triangulation_(mesh_.points, next(domain, sides)),
        refiner_(triangulation_, mesh_.points, field, point_hints(sides, hints)) {}
  Domain_mesher(const Domain_mesher&) = delete;
  Domain_mesher& operator=(const Domain_mesher&) = delete;

  template <typename Progress>
  void refine(std::size_t max_points, const Progress& progress) {
    refiner_.refine(max_points, progress);
    mesh_.locations.resize(mesh_.points.size(), Location::interior());
  }
  void keep_off_sides(double share_of_length) { refiner_.keep_off_sides(share_of_length); }
  void smooth(int sweeps) { refiner_.smooth(sweeps); }
  // Divides triangles, given by their numbers in triangles().
  void divide(const std::vector<std::size_t>& triangles) {
    refiner_.divide(triangles);
    mesh_.locations.resize(mesh_.points.size(), Location::interior());
  }

  // Without triangles.
  const Mesh& mesh() const { return mesh_; }
  std::vector<Linked_triangle> triangles() const { return triangulation_.triangles(); }

  // The finished mesh. Ends the use of this object.
  Mesh finish() {
    const std::vector<Linked_triangle> triangles = triangulation_.triangles();
    triangulation_.triangulation().clear();
    mesh_.triangles.reserve(triangles.size());
    for (const Linked_triangle& t : triangles)
      mesh_.triangles.push_back(t.vertices);
    return std::move(mesh_);
  }

private:
  // The sizes of domains in which products of four lengths neither vanish nor overflow.
  static void check_size(const Domain& domain) {
    constexpr double smallest = 1e-70, largest = 1e70;
    const double diameter = domain.diameter();
    if (!(diameter > smallest && diameter < largest))
      throw Input_error("the domain is too large or too small for meshing: its diameter is " +
                        to_short_text(diameter) + ", not between 1e-70 and 1e70");
  }

  static Mesh sample_boundary(const Domain& domain, const Side_parameters& sides) {
    check_size(domain);
    Mesh mesh;
    for (std::size_t i = 0; i < domain.size(); ++i) {
      mesh.points.push_back(domain.vertex(i));
      mesh.locations.push_back(Location::on_vertex(i));
      for (const double s : sides[i]) {
        mesh.points.push_back(domain.point_on_side(i, FT(s)));
        mesh.locations.push_back(Location::on_side(i, FT(s)));
      }
    }
    mesh.number_of_boundary_points = mesh.points.size();
    return mesh;
  }

  // The point that follows each on the boundary.
  static std::vector<std::size_t> next(const Domain& domain, const Side_parameters& sides) {
    std::vector<std::size_t> next;
    for (std::size_t loop = 0; loop < domain.number_of_loops(); ++loop) {
      const std::size_t first = next.size();
      for (std::size_t i = domain.loop_begin(loop); i < domain.loop_begin(loop + 1); ++i)
        for (std::size_t k = 0; k <= sides[i].size(); ++k)
          next.push_back(next.size() + 1);
      next.back() = first;
    }
    return next;
  }

  static std::vector<std::size_t> point_hints(const Side_parameters& sides,
                                              const std::vector<std::size_t>& hints) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < sides.size(); ++i)
      result.insert(result.end(), sides[i].size() + 1, hints[i]);
    return result;
  }

  Mesh mesh_;
  Boundary_triangulation<Traits> triangulation_;
  Metric_refiner<Traits, Field> refiner_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DOMAIN_MESHER_H
