// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SHARP_TRIANGLE_MENDER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SHARP_TRIANGLE_MENDER_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/internal/Sampled_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Flips edges and moves vertices of triangles that are sharp on the surface, whatever a metric made
// of them, as long as the deviations from the surface stay within their bounds.
template <typename Surface, typename Meter>
class Sharp_triangle_mender {
public:
  // The first vertices, those on the boundary, stay where they are.
  Sharp_triangle_mender(const Surface& surface, const Meter& meter, Sampled_mesh& mesh,
                        std::size_t number_of_boundary_vertices)
      : surface_(surface), meter_(meter), mesh_(mesh),
        number_of_boundary_vertices_(number_of_boundary_vertices),
        triangle_of_(mesh.uv.size(), Linked_triangle::none) {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const std::size_t v : mesh_.triangles[t].vertices)
        triangle_of_[v] = t;
  }

  // Returns the vertices that were moved.
  //
  // Every flip or move that is tried costs some hundred points of the surface; so a triangle or a
  // vertex is tried again only if something around it has changed, and where sharp triangles abound
  // not all are tried.
  std::vector<std::size_t> mend() {
    constexpr int sweeps = 3;
    tries_ = 100 + mesh_.triangles.size() / 5;
    std::vector<std::size_t> moved;
    std::vector<char> is_settled(triangle_of_.size(), false),
        is_triangle_settled(mesh_.triangles.size(), false);
    std::fill_n(is_settled.begin(), number_of_boundary_vertices_, true);
    const auto unsettle = [&](std::size_t t) {
      is_triangle_settled[t] = false;
      for (const std::size_t v : mesh_.triangles[t].vertices)
        is_settled[v] = v < number_of_boundary_vertices_;
    };
    for (int k = 0; k < sweeps; ++k)
      for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
        if (!(smallest_angle(mesh_.triangles[t]) < sharp))
          continue;
        const std::size_t n = is_triangle_settled[t] ? Linked_triangle::none : flip_an_edge(t);
        is_triangle_settled[t] = true;
        if (n != Linked_triangle::none) {
          unsettle(t);
          unsettle(n);
          continue;
        }
        for (const std::size_t v : mesh_.triangles[t].vertices) {
          if (is_settled[v] || tries_ == 0)
            continue;
          --tries_;
          is_settled[v] = true;
          const std::vector<std::size_t> star = triangles_around(v);
          if (!nudge(v, star))
            continue;
          moved.push_back(v);
          std::for_each(star.begin(), star.end(), unsettle);
        }
      }
    return moved;
  }

private:
  // Up to here deviations between the samples hardly ever are larger than at them by more than the
  // reserve.
  static constexpr double safe_excess = 0.95;

  using Kernel = Exact_predicates_inexact_constructions_kernel;

  static constexpr double sharp = 24 * pi / 180;

  double smallest_angle(const Linked_triangle& t) const {
    double smallest = pi;
    for (int i = 0; i < 3; ++i) {
      const Vec3& p = mesh_.positions[t.vertices[i]];
      const Vec3 a = difference(mesh_.positions[t.vertices[(i + 1) % 3]], p),
                 b = difference(mesh_.positions[t.vertices[(i + 2) % 3]], p);
      smallest = (std::min)(smallest, angle_between(a, b));
    }
    return smallest;
  }

  bool is_positive(const Linked_triangle& t) const {
    const auto point = [&](int i) {
      const Uv& p = mesh_.uv[t.vertices[i]];
      return Kernel::Point_2(p.x, p.y);
    };
    return orientation(point(0), point(1), point(2)) == LEFT_TURN;
  }

  std::vector<std::size_t> triangles_around(std::size_t v) const {
    std::vector<std::size_t> star;
    std::size_t t = triangle_of_[v];
    do {
      star.push_back(t);
      const auto& vertices = mesh_.triangles[t].vertices;
      const auto i = std::find(vertices.begin(), vertices.end(), v) - vertices.begin();
      t = mesh_.triangles[t].neighbors[(i + 1) % 3];
    } while (t != star.front());
    return star;
  }

  double smallest_angle(const std::vector<std::size_t>& star) const {
    double smallest = pi;
    for (const std::size_t t : star)
      smallest = (std::min)(smallest, smallest_angle(mesh_.triangles[t]));
    return smallest;
  }

  // Of some triangles and, as their distances are measured from these, too, their neighbours.
  double largest_excess(const std::vector<std::size_t>& star) const {
    double largest = 0;
    const auto include = [&](std::size_t t) {
      const double excess = meter_.excess(meter_(mesh_, mesh_.triangles[t]));
      largest = std::isnan(excess) ? std::numeric_limits<double>::infinity()
                                   : (std::max)(largest, excess);
    };
    for (const std::size_t t : star) {
      include(t);
      for (const std::size_t n : mesh_.triangles[t].neighbors)
        if (n != Linked_triangle::none && std::find(star.begin(), star.end(), n) == star.end())
          include(n);
    }
    return largest;
  }

  // --------------------------------------------------------------------------------------- flips

  // Flips an edge of triangle t if that makes the sharpest angle there less sharp. Returns the
  // triangle behind it, or `none` if there is no such edge.
  std::size_t flip_an_edge(std::size_t t) {
    for (int i = 0; i < 3; ++i) {
      const std::size_t n = mesh_.triangles[t].neighbors[i];
      if (n != Linked_triangle::none && flip_if_better(t, i))
        return n;
    }
    return Linked_triangle::none;
  }

  // Of the edge opposite to corner i of triangle t.
  bool flip_if_better(std::size_t t, int i) {
    const std::size_t n = mesh_.triangles[t].neighbors[i];
    const std::array<Linked_triangle, 2> old{mesh_.triangles[t], mesh_.triangles[n]},
        flipped = flipped_pair(t, i);
    if (!is_positive(flipped[0]) || !is_positive(flipped[1]) ||
        !(smallest_angle(flipped) > smallest_angle(old)) || tries_ == 0)
      return false;
    --tries_;
    const double allowed = (std::max)(safe_excess, largest_excess({t, n}));
    replace_pair(t, n, flipped);
    if (largest_excess({t, n}) <= allowed)
      return true;
    replace_pair(t, n, old);
    return false;
  }

  // What the triangles on both sides of an edge become if it is flipped.
  std::array<Linked_triangle, 2> flipped_pair(std::size_t t, int i) const {
    const std::size_t n = mesh_.triangles[t].neighbors[i];
    const Linked_triangle &a = mesh_.triangles[t], &b = mesh_.triangles[n];
    const auto j = std::find(b.neighbors.begin(), b.neighbors.end(), t) - b.neighbors.begin();
    // The quadrilateral is v, p, w, q; the edge from p to q gives way to that from v to w.
    const auto v = a.vertices[i], p = a.vertices[(i + 1) % 3], q = a.vertices[(i + 2) % 3],
               w = b.vertices[j];
    Linked_triangle first, second;
    first.vertices = {v, p, w};
    first.neighbors = {b.neighbors[(j + 1) % 3], static_cast<Linked_triangle::Index>(n),
                       a.neighbors[(i + 2) % 3]};
    second.vertices = {v, w, q};
    second.neighbors = {b.neighbors[(j + 2) % 3], a.neighbors[(i + 1) % 3],
                        static_cast<Linked_triangle::Index>(t)};
    return {first, second};
  }

  // Puts two triangles in the places of others with the same border.
  void replace_pair(std::size_t t, std::size_t n, const std::array<Linked_triangle, 2>& pair) {
    const std::array<std::size_t, 2> numbers{t, n};
    for (int k = 0; k < 2; ++k) {
      mesh_.triangles[numbers[k]] = pair[k];
      for (int i = 0; i < 3; ++i) {
        triangle_of_[pair[k].vertices[i]] = numbers[k];
        link(pair[k].neighbors[i], pair[k].vertices[(i + 2) % 3], numbers[k]);
      }
    }
  }
  // Makes a triangle the neighbour of another one, if there is one, across the edge that starts at
  // a vertex.
  void link(std::size_t other, std::size_t start_of_edge, std::size_t triangle) {
    if (other == Linked_triangle::none)
      return;
    Linked_triangle& t = mesh_.triangles[other];
    for (int i = 0; i < 3; ++i)
      if (t.vertices[(i + 1) % 3] == start_of_edge)
        t.neighbors[i] = static_cast<Linked_triangle::Index>(triangle);
  }

  double smallest_angle(const std::array<Linked_triangle, 2>& pair) const {
    return (std::min)(smallest_angle(pair[0]), smallest_angle(pair[1]));
  }

  // --------------------------------------------------------------------------------------- moves

  struct Move {
    Uv uv;
    Vec3 position;
    double angle; // the smallest one around the vertex then
  };

  void apply(std::size_t v, const Move& move) {
    mesh_.uv[v] = move.uv;
    mesh_.positions[v] = move.position;
  }

  // Moves of a vertex a little towards or away from one of its neighbours, after which no angle
  // around it is as small as the smallest one now. The best one comes first.
  std::vector<Move> find_moves(std::size_t v, const std::vector<std::size_t>& star) {
    const Move now{mesh_.uv[v], mesh_.positions[v], smallest_angle(star)};
    std::vector<Move> moves;
    for (const double step : {0.25, -0.25, 0.1, -0.1, 0.04, -0.04})
      for (const std::size_t t : star) {
        const auto& vertices = mesh_.triangles[t].vertices;
        const auto i = std::find(vertices.begin(), vertices.end(), v) - vertices.begin();
        mesh_.uv[v] = now.uv + step * (mesh_.uv[vertices[(i + 1) % 3]] - now.uv);
        if (!std::all_of(star.begin(), star.end(),
                         [&](std::size_t s) { return is_positive(mesh_.triangles[s]); }))
          continue;
        mesh_.positions[v] = surface_.position(mesh_.uv[v]);
        const double angle = smallest_angle(star);
        if (angle > now.angle)
          moves.push_back({mesh_.uv[v], mesh_.positions[v], angle});
        apply(v, now);
      }
    apply(v, now);
    std::stable_sort(moves.begin(), moves.end(),
                     [](const Move& a, const Move& b) { return a.angle > b.angle; });
    return moves;
  }

  // Returns whether there is a move that helps; then the vertex has moved.
  bool nudge(std::size_t v, const std::vector<std::size_t>& star) {
    constexpr std::size_t max_moves = 4;
    std::vector<Move> moves = find_moves(v, star);
    if (moves.empty())
      return false;
    const Move now{mesh_.uv[v], mesh_.positions[v], 0};
    const double allowed = (std::max)(safe_excess, largest_excess(star));
    moves.resize((std::min)(moves.size(), max_moves));
    for (const Move& move : moves) {
      apply(v, move);
      if (largest_excess(star) <= allowed)
        return true;
    }
    apply(v, now);
    return false;
  }

  const Surface& surface_;
  const Meter& meter_;
  Sampled_mesh& mesh_;
  std::size_t number_of_boundary_vertices_;
  std::vector<std::size_t> triangle_of_; // one, by vertex
  std::size_t tries_ = 0;                // that are left
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SHARP_TRIANGLE_MENDER_H
