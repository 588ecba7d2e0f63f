// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_COVER_MESH_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_COVER_MESH_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Bisection_mesh.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Candidate_finder.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Cell.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Disc_centring.h>

#include <algorithm>
#include <queue>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The mesh, cut until every leaf fits into some cell, and a cover of the leaves by few cells.
struct Cover {
  std::vector<Cell> cells;
  std::vector<std::size_t> cell_of; // per triangle of the mesh; Bisection_mesh::none if it is cut
};

// Builds a Cover. Corners and channels take all they can, as nothing else does as well there; the
// rest goes, greedily, to the cell that covers the largest area.
class Cover_builder {
public:
  Cover_builder(const Boundary& boundary, double tau, Bisection_mesh& mesh)
      : boundary_(boundary), finder_(boundary, tau), mesh_(mesh) {}

  Cover build() {
    refine();
    cover_.cell_of.assign(mesh_.size(), Bisection_mesh::none);
    assign_fixed_cells();
    assign_greedily();
    return std::move(cover_);
  }

private:
  void refine() {
    std::vector<std::size_t> stack;
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      stack.push_back(t);
    while (!stack.empty()) {
      const std::size_t t = stack.back();
      stack.pop_back();
      if (!mesh_.triangle(t).is_leaf())
        continue;
      candidates_.resize(mesh_.size());
      candidates_[t] = finder_.find(mesh_.leaf(t));
      if (candidates_[t])
        continue;
      const std::size_t first_new = mesh_.size();
      mesh_.bisect(t);
      for (std::size_t u = first_new; u < mesh_.size(); ++u)
        stack.push_back(u);
    }
  }

  bool is_free(std::size_t t) const {
    return mesh_.triangle(t).is_leaf() && cover_.cell_of[t] == Bisection_mesh::none;
  }

  void assign_fixed_cells() {
    std::map<std::pair<Candidate::Kind, std::size_t>, std::vector<std::size_t>> members;
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      if (mesh_.triangle(t).is_leaf()) {
        const Candidate& c = *candidates_[t];
        if (c.kind == Candidate::Kind::corner || c.kind == Candidate::Kind::channel)
          members[{c.kind, c.index}].push_back(t);
      }
    for (const auto& member : members)
      add_cell(*candidates_[member.second.front()], member.second);
  }

  // The area that a candidate would cover only shrinks as others are chosen, so an outdated entry
  // of the queue is an upper bound, and is worth a look only when it comes first.
  void assign_greedily() {
    std::priority_queue<std::pair<double, std::size_t>> queue;
    for (std::size_t t = 0; t < mesh_.size(); ++t)
      if (is_free(t))
        queue.push({area(reachable(t)), t});
    while (!queue.empty()) {
      const std::size_t t = queue.top().second;
      queue.pop();
      const std::vector<std::size_t> triangles = reachable(t);
      const double covered = area(triangles);
      if (triangles.empty())
        continue;
      if (!queue.empty() && covered < queue.top().first)
        queue.push({covered, t});
      else
        add_cell(*candidates_[t], triangles);
    }
  }

  // the free triangles that the candidate of t admits, connected with t or, if t is taken, with a
  // neighbour of it; `visited_` holds the stamps of the walk
  std::vector<std::size_t> reachable(std::size_t t) {
    visited_.resize(mesh_.size(), 0);
    ++stamp_;
    std::vector<std::size_t> walk{t}, result;
    visited_[t] = stamp_;
    for (std::size_t i = 0; i < walk.size(); ++i) {
      const std::size_t u = walk[i];
      if (is_free(u))
        result.push_back(u);
      for (const std::size_t n : mesh_.triangle(u).neighbor)
        if (n != Bisection_mesh::none && visited_[n] != stamp_) {
          visited_[n] = stamp_;
          if (finder_.admits(*candidates_[t], mesh_.leaf(n)))
            walk.push_back(n);
        }
    }
    return result;
  }

  double area(const std::vector<std::size_t>& triangles) const {
    double sum = 0;
    for (const std::size_t t : triangles) {
      const Triangle_points c = mesh_.corners(t);
      sum += std::abs(turn(c[1], c[2], c[0])) / 2;
    }
    return sum;
  }

  void add_cell(const Candidate& c, const std::vector<std::size_t>& triangles) {
    for (const std::size_t t : triangles)
      cover_.cell_of[t] = cover_.cells.size();
    cover_.cells.push_back(c.kind == Candidate::Kind::channel ? channel_cell(c, triangles)
                                                              : disc_cell(c, triangles));
  }

  // The error of the series after p terms is about (radius of the cell / of convergence)^p.
  Cell disc_cell(Candidate c, const std::vector<std::size_t>& triangles) const {
    std::vector<Triangle_points> points;
    for (const std::size_t t : triangles)
      points.push_back(mesh_.corners(t));
    if (c.kind != Candidate::Kind::corner)
      Disc_centring(boundary_, points).improve(c);
    const double radius = farthest(points, c.centre);
    const double safety = c.kind == Candidate::Kind::side ? 1.2 : 1; // in experience
    // In a sharp corner there are few, as the angle comes in below.
    const double terms = (std::min)(1e8, safety * finder_.decay() / std::log(c.radius / radius));
    const int degree = (std::max)(4, static_cast<int>(std::ceil(terms)));
    switch (c.kind) {
    case Candidate::Kind::corner:
      return Corner_cell(
          boundary_, c.index, radius,
          (std::max)(3, static_cast<int>(std::ceil(terms * boundary_.angle(c.index)))));
    case Candidate::Kind::side:
      return Side_cell(boundary_, c.index, c.centre, radius, degree);
    default:
      return Interior_cell(c.centre, radius, degree);
    }
  }

  Cell channel_cell(const Candidate& c, const std::vector<std::size_t>& triangles) const {
    const Channel& channel = finder_.channel(c.index);
    Interval range{channel.free.high, channel.free.low};
    for (const std::size_t t : triangles)
      for (int i = 0; i < 3; ++i) {
        const Triangle_points z = mesh_.corners(t);
        const Interval edge = channel.map.range({z[i], z[(i + 1) % 3]});
        range.low = (std::min)(range.low, edge.low);
        range.high = (std::max)(range.high, edge.high);
      }
    const double margin = (std::min)(range.low - channel.free.low, channel.free.high - range.high);
    const int degree = (std::max)(4, static_cast<int>(std::ceil(1.3 * finder_.decay() / margin)));
    return Channel_cell(boundary_, channel.e1, channel.e2, channel.map, channel.origin, range,
                        degree);
  }

  const Boundary& boundary_;
  Candidate_finder finder_;
  Bisection_mesh& mesh_;
  std::vector<std::optional<Candidate>> candidates_; // per triangle of the mesh
  Cover cover_;
  std::vector<std::size_t> visited_;
  std::size_t stamp_ = 0;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_COVER_MESH_H
