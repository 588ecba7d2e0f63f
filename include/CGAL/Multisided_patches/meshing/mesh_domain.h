// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESH_DOMAIN_H
#define CGAL_MULTISIDED_PATCHES_MESH_DOMAIN_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/triangulate_domain.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

namespace internal {

// Turns a density on the surface into samples on the sides and a spacing in the domain.
template <typename Patch>
class Domain_sizing {
public:
  using Traits = typename Patch::Geom_traits;
  using Mesh = Domain_mesh_2<Traits>;

  explicit Domain_sizing(const Patch& patch) : patch_(patch) {
    double perimeter = 0, domain_perimeter = 0;
    for (std::size_t i = 0; i < patch.domain().size(); ++i) {
      side_lengths_.push_back(patch.side_length(i));
      perimeter += side_lengths_.back();
      domain_perimeter += patch.domain().side_length(i);
    }
    if (!(perimeter > 0) || !std::isfinite(perimeter))
      throw Numerical_error("the boundary of the patch has no length that could be divided");
    domain_area_ = CGAL::to_double(patch.domain().area());
    // A coarse mesh, scaled by the perimeters, tells how much larger the surface is than the
    // domain.
    scale_ = domain_perimeter / perimeter;
    const double coarse = edge_length_for_area(domain_area_ / (scale_ * scale_) / 1000);
    const double area = surface_area(triangulate(coarse));
    if (area > 0 && std::isfinite(area))
      scale_ = std::sqrt(domain_area_ / area);
  }

  Mesh triangulate(double edge_length) const {
    return triangulate_domain(patch_.domain(), segments(edge_length), scale_ * edge_length);
  }

  // The number of triangles of `triangulate(edge_length)`: by Euler's formula a disk with V
  // vertices, B of them on the boundary, and H holes has 2V - B - 2 + 2H triangles.
  std::size_t number_of_triangles(double edge_length) const {
    const Interior_lattice<Traits> lattice(patch_.domain(), scale_ * edge_length);
    std::size_t count = 2 * lattice.count();
    for (const std::size_t m : segments(edge_length))
      count += m;
    return count + 2 * patch_.domain().number_of_loops() - 4;
  }

  // Refuses densities beyond the limit before anything large is computed.
  void check(double edge_length) const {
    double count = triangles_of_area(edge_length);
    for (const double length : side_lengths_)
      count += length / edge_length;
    if (!(count <= static_cast<double>(Mesh_density::max_triangles)))
      throw Input_error("an edge length of " + to_short_text(edge_length) + " would need about " +
                        to_short_text(count) + " triangles; the limit is " +
                        std::to_string(Mesh_density::max_triangles));
  }

  // The edge length at which there are about `target` triangles, by bisection.
  double edge_length_for(std::size_t target) const {
    const double guess = edge_length_for_area(surface_area() / static_cast<double>(target));
    double fine = guess, coarse = guess;
    for (int k = 0; k < max_steps && number_of_triangles(fine) < target; ++k)
      fine *= 0.8;
    for (int k = 0; k < max_steps && number_of_triangles(coarse) > target; ++k)
      coarse *= 1.25;
    // 1 in 1000, or what the lattice allows
    const std::size_t tolerance = target / 1000;
    for (int k = 0; k < max_steps; ++k) {
      const double middle = (fine + coarse) / 2;
      const std::size_t count = number_of_triangles(middle);
      if (count > target)
        fine = middle;
      else
        coarse = middle;
      if ((std::max)(count, target) - (std::min)(count, target) <= tolerance)
        return middle;
    }
    return coarse;
  }

private:
  // Of searches that take much fewer on any sensible input.
  static constexpr int max_steps = 40;

  static double edge_length_for_area(double triangle_area) {
    return std::sqrt(triangle_area * 4 / std::sqrt(3.0));
  }
  double surface_area() const { return domain_area_ / (scale_ * scale_); }
  double triangles_of_area(double edge_length) const {
    return surface_area() / (edge_length * edge_length * std::sqrt(3.0) / 4);
  }

  // Rounding up keeps the edges below the target; the slack absorbs the rounding of the lengths.
  std::vector<std::size_t> segments(double edge_length) const {
    std::vector<std::size_t> result;
    for (const double length : side_lengths_)
      result.push_back(
          static_cast<std::size_t>((std::max)(1.0, std::ceil(length / edge_length * (1 - 1e-9)))));
    return result;
  }

  double surface_area(const Mesh& mesh) const {
    std::vector<typename Patch::Point_3> points;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      points.push_back(patch_.point_and_normal(mesh.points[i], mesh.locations[i]).first);
    double area = 0;
    for (const auto& t : mesh.triangles)
      area +=
          norm(cross(to_vec3(points[t[1]] - points[t[0]]), to_vec3(points[t[2]] - points[t[0]])));
    return area / 2;
  }

  const Patch& patch_;
  std::vector<double> side_lengths_;
  double domain_area_, scale_; // domain units per model unit
};

} // namespace internal

/*!
 * meshes the domain of a patch so that the mesh of the surface has a given density: edges of about
 * the target length on the average, or about the target number of triangles. The sides are divided
 * evenly in the parameters of their curves, according to the lengths of these; inside, the spacing
 * is uniform in the domain.
 *
 * \tparam Patch a model of `MultisidedPatch_3`
 *
 * \throws Input_error if the density asks for more than `Mesh_density::max_triangles` triangles
 * \throws Numerical_error if the boundary curves have no length, or as `triangulate_domain()` does
 */
template <typename Patch>
Domain_mesh_2<typename Patch::Geom_traits> mesh_domain(const Patch& patch,
                                                       const Mesh_density& density) {
  const internal::Domain_sizing<Patch> sizing(patch);
  const double edge_length = density.is_triangle_count()
                                 ? sizing.edge_length_for(density.target_triangles())
                                 : density.target_edge_length();
  sizing.check(edge_length);
  return sizing.triangulate(edge_length);
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESH_DOMAIN_H
