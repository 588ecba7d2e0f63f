// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DOMAIN_MESH_CHECKER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DOMAIN_MESH_CHECKER_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/internal/boundary_crossing.h>

#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

/*
 * The work behind `domain_mesh_defect()`. Why its checks suffice:
 *
 * All triangles are positive, so the number of them that cover a point is the sum of the winding
 * numbers of their boundaries. Edges with a triangle on either side cancel in this sum, and what
 * remains are the loops of samples. These are simple, do not meet, the first is counterclockwise
 * and all others clockwise, so the sum is at most 1. As it is never negative, the holes lie in the
 * outer loop and not in each other: every point between the loops is covered once, and no other.
 *
 * The triangles around a vertex follow each other across edges, all the way round or from one
 * boundary edge to the other. So they fill the neighbourhood of the vertex, or what the loops
 * leave of it, and no other triangle reaches there: no vertex lies on a triangle that it is not a
 * corner of, no two vertices coincide, and the triangles at a vertex are a single fan. That is a
 * triangulation; Euler's formula, triangles = 2 points - boundary points + 2 loops - 4, follows.
 */
template <typename Traits>
class Domain_mesh_checker {
public:
  using Domain = Polygonal_domain_2<Traits>;
  using Mesh = Domain_mesh_2<Traits>;
  using FT = typename Traits::FT;
  using Kind = typename Domain::Location::Kind;

  Domain_mesh_checker(const Domain& domain, const Mesh& mesh) : domain_(domain), mesh_(mesh) {}

  // what is wrong; empty if nothing is
  std::string run() {
    using Self = Domain_mesh_checker;
    std::string defect;
    for (const auto check :
         {&Self::check_points, &Self::check_samples, &Self::check_interior, &Self::check_triangles,
          &Self::check_edges, &Self::check_boundary, &Self::check_loops})
      if (defect.empty())
        defect = (this->*check)();
    return defect;
  }

private:
  static std::string vertex(std::size_t k) { return "vertex " + std::to_string(k); }
  static std::string edge(std::size_t a, std::size_t b) {
    return "the edge from " + vertex(a) + " to " + vertex(b);
  }

  std::string check_points() {
    const std::size_t n = mesh_.points.size();
    if (mesh_.locations.size() != n)
      return std::to_string(n) + " points have " + std::to_string(mesh_.locations.size()) +
             " locations";
    if (mesh_.number_of_boundary_points > n)
      return std::to_string(mesh_.number_of_boundary_points) + " of " + std::to_string(n) +
             " points are said to be on the boundary";
    for (std::size_t k = 0; k < n; ++k)
      if (!CGAL::is_finite(mesh_.points[k].x()) || !CGAL::is_finite(mesh_.points[k].y()))
        return vertex(k) + " is not finite";
    return {};
  }

  // The points on the boundary, loop by loop and side by side.
  std::string check_samples() {
    for (std::size_t loop = 0; loop < domain_.number_of_loops(); ++loop) {
      loop_begins_.push_back(next_.size());
      for (std::size_t i = domain_.loop_begin(loop); i < domain_.loop_begin(loop + 1); ++i) {
        const std::string defect = check_side(i);
        if (!defect.empty())
          return defect;
      }
      next_.back() = loop_begins_.back();
    }
    loop_begins_.push_back(next_.size());
    return next_.size() == mesh_.number_of_boundary_points
               ? std::string()
               : vertex(next_.size()) + " is not the next sample of any side";
  }

  std::string check_side(std::size_t i) {
    const std::size_t first = next_.size();
    if (first == mesh_.number_of_boundary_points || mesh_.locations[first].kind != Kind::vertex ||
        mesh_.locations[first].index != i || mesh_.points[first] != domain_.vertex(i))
      return vertex(first) + " is not vertex " + std::to_string(i) + " of the domain";
    next_.push_back(first + 1);
    FT previous(0);
    for (std::size_t k = first + 1; is_said_to_be_on(k, i); ++k) {
      const FT& s = mesh_.locations[k].s;
      if (!(previous < s && s < FT(1)))
        return vertex(k) + " is not behind the sample before it on side " + std::to_string(i);
      if (mesh_.points[k] != domain_.point_on_side(i, s))
        return vertex(k) + " is not the point of side " + std::to_string(i) + " that it stands for";
      next_.push_back(k + 1);
      previous = s;
    }
    return {};
  }

  bool is_said_to_be_on(std::size_t k, std::size_t side) const {
    return k < mesh_.number_of_boundary_points && mesh_.locations[k].kind == Kind::side &&
           mesh_.locations[k].index == side;
  }

  std::string check_interior() {
    for (std::size_t k = mesh_.number_of_boundary_points; k < mesh_.points.size(); ++k)
      if (mesh_.locations[k].kind != Kind::interior)
        return vertex(k) + " comes after those on the boundary, but its location is not inside";
    return {};
  }

  std::string check_triangles() {
    const auto& p = mesh_.points;
    for (std::size_t k = 0; k < mesh_.triangles.size(); ++k) {
      const auto& t = mesh_.triangles[k];
      for (const std::size_t v : t)
        if (v >= p.size())
          return "triangle " + std::to_string(k) + " refers to " + vertex(v) + " of " +
                 std::to_string(p.size());
      if (orientation(p[t[0]], p[t[1]], p[t[2]]) != LEFT_TURN)
        return "triangle " + std::to_string(k) + " is not counterclockwise";
    }
    return {};
  }

  // The directed edges, each at most once; all but those of the boundary in both directions.
  std::string check_edges() {
    gather_edges();
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      const auto first = edges_begin(v), last = edges_begin(v + 1);
      if (first == last)
        return vertex(v) + " is not used by any triangle";
      const auto twice = std::adjacent_find(first, last);
      if (twice != last)
        return edge(v, *twice) + " has two triangles on its left";
      for (auto w = first; w != last; ++w)
        if (!has_edge(*w, v) && !(v < next_.size() && next_[v] == *w))
          return edge(v, *w) + " has no triangle on its right, and is not on the boundary";
    }
    return {};
  }

  std::string check_boundary() {
    for (std::size_t k = 0; k < next_.size(); ++k) {
      if (!has_edge(k, next_[k]))
        return edge(k, next_[k]) + " is on the boundary, but has no triangle on its left";
      if (has_edge(next_[k], k))
        return edge(k, next_[k]) + " is on the boundary, but has a triangle on its right";
    }
    return {};
  }

  std::string check_loops() {
    const auto crossing = find_boundary_crossing<Traits>(mesh_.points, next_);
    if (crossing)
      return edge(crossing->first, next_[crossing->first]) + " and " +
             edge(crossing->second, next_[crossing->second]) +
             " are on the boundary, and cross or touch";
    const auto point = [this](std::size_t k) {
      return mesh_.points.begin() + static_cast<std::ptrdiff_t>(loop_begins_[k]);
    };
    for (std::size_t loop = 0; loop < domain_.number_of_loops(); ++loop)
      if (orientation_2(point(loop), point(loop + 1), Traits()) !=
          (loop == 0 ? COUNTERCLOCKWISE : CLOCKWISE))
        return "the samples of loop " + std::to_string(loop) + " run the wrong way round";
    return {};
  }

  // Counting sort by source, and a sorted list of targets for each.
  void gather_edges() {
    edge_begins_.assign(mesh_.points.size() + 1, 0);
    targets_.resize(3 * mesh_.triangles.size());
    for (const auto& t : mesh_.triangles)
      for (const std::size_t v : t)
        ++edge_begins_[v];
    for (std::size_t v = 1; v < edge_begins_.size(); ++v)
      edge_begins_[v] += edge_begins_[v - 1];
    for (const auto& t : mesh_.triangles)
      for (std::size_t e = 0; e < 3; ++e)
        targets_[--edge_begins_[t[e]]] = t[(e + 1) % 3];
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      std::sort(edges_begin(v), edges_begin(v + 1));
  }
  auto edges_begin(std::size_t v) {
    return targets_.begin() + static_cast<std::ptrdiff_t>(edge_begins_[v]);
  }
  bool has_edge(std::size_t a, std::size_t b) {
    return std::binary_search(edges_begin(a), edges_begin(a + 1), b);
  }

  const Domain& domain_;
  const Mesh& mesh_;
  std::vector<std::size_t> next_;        // on the boundary, for each of its points
  std::vector<std::size_t> loop_begins_; // the first sample of each loop, and one past the last
  std::vector<std::size_t> edge_begins_; // of each vertex in `targets_`, and one past the last
  std::vector<std::size_t> targets_;     // of the edges from vertex 0, from vertex 1, ...
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DOMAIN_MESH_CHECKER_H
