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
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Moves vertices of triangles that are sharp on the surface, whatever a metric made of them, as
// long as the deviations from the surface stay within their bounds.
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
  // Every try costs some hundred points of the surface; so a vertex is tried again only if
  // something around it has changed, and where sharp triangles abound not all are tried.
  std::vector<std::size_t> mend() {
    constexpr int sweeps = 3;
    std::size_t tries = 100 + mesh_.triangles.size() / 5;
    std::vector<std::size_t> moved;
    std::vector<char> is_settled(triangle_of_.size(), false);
    std::fill_n(is_settled.begin(), number_of_boundary_vertices_, true);
    for (int k = 0; k < sweeps; ++k)
      for (const Linked_triangle& t : mesh_.triangles)
        if (smallest_angle(t) < sharp)
          for (const std::size_t v : t.vertices) {
            if (is_settled[v] || tries == 0)
              continue;
            --tries;
            is_settled[v] = true;
            const std::vector<std::size_t> star = triangles_around(v);
            if (!nudge(v, star))
              continue;
            moved.push_back(v);
            for (const std::size_t s : star)
              for (const std::size_t w : mesh_.triangles[s].vertices)
                is_settled[w] = w < number_of_boundary_vertices_;
          }
    return moved;
  }

private:
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
    // Up to here deviations between the samples hardly ever are larger than at them by more than
    // the reserve.
    constexpr double safe = 0.95;
    std::vector<Move> moves = find_moves(v, star);
    if (moves.empty())
      return false;
    const Move now{mesh_.uv[v], mesh_.positions[v], 0};
    const double allowed = (std::max)(safe, largest_excess(star));
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
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SHARP_TRIANGLE_MENDER_H
