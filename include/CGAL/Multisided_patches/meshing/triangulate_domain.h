// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_TRIANGULATE_DOMAIN_H
#define CGAL_MULTISIDED_PATCHES_TRIANGULATE_DOMAIN_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/internal/Interior_lattice.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <string>
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

// The constrained Delaunay triangulation behind `triangulate_domain()`.
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
    triangulate();
    constrain_boundary();
    collect_interior();
    return std::move(mesh_);
  }

private:
  using Vertex_base = Triangulation_vertex_base_with_info_2<std::size_t, Traits>;
  using Face_base =
      Triangulation_face_base_with_info_2<bool, Traits,
                                          Constrained_triangulation_face_base_2<Traits>>;
  using Triangulation =
      Constrained_Delaunay_triangulation_2<Traits,
                                           Triangulation_data_structure_2<Vertex_base, Face_base>,
                                           No_constraint_intersection_requiring_constructions_tag>;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;

  void add_point(const Point_2& p, const Location& location) {
    mesh_.points.push_back(p);
    mesh_.locations.push_back(location);
  }

  void sample_boundary(const std::vector<std::size_t>& segments) {
    for (std::size_t i = 0; i < domain_.size(); ++i) {
      side_begins_.push_back(mesh_.points.size());
      add_point(domain_.vertex(i), Location::on_vertex(i));
      for (std::size_t k = 1; k < segments[i]; ++k) {
        const FT s(sample_parameter(k, segments[i]));
        add_point(domain_.point_on_side(i, s), Location::on_side(i, s));
      }
    }
    mesh_.number_of_boundary_points = mesh_.points.size();
  }

  void triangulate() {
    std::vector<std::pair<Point_2, std::size_t>> points;
    points.reserve(mesh_.points.size());
    for (std::size_t i = 0; i < mesh_.points.size(); ++i)
      points.emplace_back(mesh_.points[i], i);
    triangulation_.insert(points.begin(), points.end());
    if (triangulation_.number_of_vertices() != points.size())
      throw Numerical_error("samples of the domain's boundary coincide: its sides are too close to "
                            "each other, or too short, for the precision of the coordinates");
  }

  void constrain_boundary() {
    std::vector<Vertex_handle> handles(mesh_.number_of_boundary_points);
    for (auto v = triangulation_.finite_vertices_begin(); v != triangulation_.finite_vertices_end();
         ++v)
      if (v->info() < handles.size())
        handles[v->info()] = v;
    try {
      for (std::size_t i = 0; i < domain_.size(); ++i) {
        const std::size_t end = i + 1 < domain_.size() ? side_begins_[i + 1] : handles.size();
        for (std::size_t k = side_begins_[i]; k + 1 < end; ++k)
          triangulation_.insert_constraint(handles[k], handles[k + 1]);
        triangulation_.insert_constraint(handles[end - 1], handles[side_begins_[domain_.next(i)]]);
      }
    } catch (const typename Triangulation::Intersection_of_constraints_exception&) {
      throw Numerical_error(
          "samples of the domain's boundary cross: its sides are too close to each "
          "other for the precision of the coordinates");
    }
    first_ = handles[0];
    second_ = handles[1];
  }

  // The interior is what can be reached from the left of the first boundary edge without crossing a
  // constraint.
  void collect_interior() {
    for (auto f = triangulation_.all_faces_begin(); f != triangulation_.all_faces_end(); ++f)
      f->info() = false;
    Face_handle seed;
    int opposite = 0;
    const bool is_edge = triangulation_.is_edge(first_, second_, seed, opposite);
    CGAL_assertion(is_edge);
    CGAL_USE(is_edge);
    if (seed->vertex(Triangulation::ccw(opposite)) != first_)
      seed = seed->neighbor(opposite);
    std::vector<Face_handle> stack{seed};
    seed->info() = true;
    while (!stack.empty()) {
      const Face_handle f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Face_handle g = f->neighbor(i);
        if (f->is_constrained(i) || g->info())
          continue;
        g->info() = true;
        stack.push_back(g);
      }
    }
    for (auto f = triangulation_.finite_faces_begin(); f != triangulation_.finite_faces_end(); ++f)
      if (f->info())
        mesh_.triangles.push_back(
            {f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }

  const Domain& domain_;
  Mesh mesh_;
  Triangulation triangulation_;
  std::vector<std::size_t> side_begins_; // in the points of the mesh
  Vertex_handle first_, second_;
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
