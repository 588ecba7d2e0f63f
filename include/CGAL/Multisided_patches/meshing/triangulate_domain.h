// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_TRIANGULATE_DOMAIN_H
#define CGAL_MULTISIDED_PATCHES_TRIANGULATE_DOMAIN_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/internal/Boundary_triangulation.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/internal/Interior_lattice.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

namespace internal {

// Parameters k/m in (0,1), such that the one of k and that of m - k sum to 1 exactly: a curve that
// is sampled from its other end gets the same points.
inline double sample_parameter(std::size_t k, std::size_t m) {
  if (2 * k > m)
    return 1 - sample_parameter(m - k, m);
  // Subtracting from 1 twice leaves a multiple of 2^-53, whose complement is exact.
  const double complement = 1 - static_cast<double>(k) / static_cast<double>(m);
  return 1 - complement;
}

// The work behind `triangulate_domain()`: gathers the points, then triangulates them.
template <typename Traits>
class Domain_triangulator {
public:
  using Domain = Polygonal_domain_2<Traits>;
  using Mesh = Domain_mesh_2<Traits>;
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;
  using Location = typename Domain::Location;

  explicit Domain_triangulator(const Domain& domain) : domain_(domain) {}

  Mesh run(const std::vector<std::size_t>& segments, double spacing) {
    sample_boundary(segments);
    Interior_lattice<Traits>(domain_, spacing).for_each_point([this](double x, double y) {
      add_point(Point_2(FT(x), FT(y)), Location::interior());
    });
    const Boundary_triangulation<Traits> triangulation(mesh_.points, next_);
    mesh_.triangles.reserve(triangulation.triangles().size());
    for (const auto& t : triangulation.triangles())
      mesh_.triangles.push_back(t.vertices);
    return std::move(mesh_);
  }

private:
  void add_point(const Point_2& p, const Location& location) {
    mesh_.points.push_back(p);
    mesh_.locations.push_back(location);
  }

  void sample_boundary(const std::vector<std::size_t>& segments) {
    for (std::size_t loop = 0; loop < domain_.number_of_loops(); ++loop) {
      const std::size_t first = mesh_.points.size();
      for (std::size_t i = domain_.loop_begin(loop); i < domain_.loop_begin(loop + 1); ++i)
        sample_side(i, segments[i]);
      next_.back() = first;
    }
    mesh_.number_of_boundary_points = mesh_.points.size();
  }

  void sample_side(std::size_t i, std::size_t segments) {
    for (std::size_t k = 0; k < segments; ++k) {
      const FT s(sample_parameter(k, segments));
      if (k == 0)
        add_point(domain_.vertex(i), Location::on_vertex(i));
      else
        add_point(domain_.point_on_side(i, s), Location::on_side(i, s));
      next_.push_back(mesh_.points.size());
    }
  }

  const Domain& domain_;
  Mesh mesh_;
  std::vector<std::size_t> next_; // on the boundary, for each of its points
};

} // namespace internal

/*!
 * triangulates a domain: samples on its sides as they are asked for, a triangular lattice inside,
 * and the constrained Delaunay triangulation of both. No point is ever added on a side.
 *
 * \param domain the domain
 * \param segments for each side, into how many segments of equal length it is divided, at least 1
 * \param spacing the distance of neighbouring points inside (domain units), greater than 0
 *
 * \throws Numerical_error if sides are so close to each other, or so short, that rounded samples
 * coincide or cross
 *
 * Complexity: O(m log m) for m points, plus O(n/spacing) for the n sides.
 */
template <typename Traits>
Domain_mesh_2<Traits> triangulate_domain(const Polygonal_domain_2<Traits>& domain,
                                         const std::vector<std::size_t>& segments, double spacing) {
  CGAL_precondition(segments.size() == domain.size() && spacing > 0);
  return internal::Domain_triangulator<Traits>(domain).run(segments, spacing);
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_TRIANGULATE_DOMAIN_H
