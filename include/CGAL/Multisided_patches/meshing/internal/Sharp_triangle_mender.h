// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SHARP_TRIANGLE_MENDER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SHARP_TRIANGLE_MENDER_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/internal/Sampled_mesh.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Flips edges and moves vertices of triangles that are sharp on the surface, whatever a metric made
// of them, as long as the deviations from the surface stay within their bounds and no triangle
// turns over, in the domain or on the surface.
template <typename Surface, typename Meter>
class Sharp_triangle_mender {
public:
  using Point_2 = typename Surface::Point_2;

  // `points` are those of the domain that the mesh is sampled at. The first ones, those on the
  // boundary, stay where they are.
  Sharp_triangle_mender(const Surface& surface, const Meter& meter, Sampled_mesh& mesh,
                        std::vector<Point_2>& points, std::size_t number_of_boundary_vertices)
      : surface_(surface), meter_(meter), mesh_(mesh), points_(points),
        number_of_boundary_vertices_(number_of_boundary_vertices),
        triangle_of_(mesh.uv.size(), Linked_triangle::none) {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const std::size_t v : mesh_.triangles[t].vertices)
        triangle_of_[v] = t;
  }

  // Every flip or move that is tried costs some hundred points of the surface; so a triangle or a
  // vertex is tried again only if something around it has changed, and where sharp triangles abound
  // not all are tried. Calls progress(), which may throw, now and then.
  template <typename Progress>
  void mend(const Progress& progress) {
    constexpr int sweeps = 10;
    constexpr std::size_t max_tries = 100000;
    tries_ = (std::min)(max_tries, 100 + mesh_.triangles.size() / 5);
    is_vertex_settled_.assign(triangle_of_.size(), false);
    std::fill_n(is_vertex_settled_.begin(), number_of_boundary_vertices_, true);
    is_triangle_settled_.assign(mesh_.triangles.size(), false);
    for (int k = 0; k < sweeps; ++k)
      for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
        if (smallest_angle(mesh_.triangles[t]) < sharp) {
          progress();
          if (!try_flips(t))
            try_moves(t);
        }
  }

private:
  // Up to here deviations between the samples hardly ever are larger than at them by more than the
  // reserve.
  static constexpr double safe_excess = 0.95;

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
    return orientation(points_[t.vertices[0]], points_[t.vertices[1]], points_[t.vertices[2]]) ==
           LEFT_TURN;
  }
  // On the surface, twice as long as its area.
  Vec3 normal(const Linked_triangle& t) const {
    const Vec3& p = mesh_.positions[t.vertices[0]];
    return cross(difference(mesh_.positions[t.vertices[1]], p),
                 difference(mesh_.positions[t.vertices[2]], p));
  }
  bool is_on_boundary(std::size_t v) const { return v < number_of_boundary_vertices_; }

  // Something has changed there.
  void unsettle(std::size_t t) {
    is_triangle_settled_[t] = false;
    for (const std::size_t v : mesh_.triangles[t].vertices)
      is_vertex_settled_[v] = is_on_boundary(v);
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
      largest = (std::max)(largest, meter_.excess(meter_(mesh_, mesh_.triangles[t])));
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

  // Flips an edge of triangle t if that makes the sharpest angle there less sharp. Returns whether
  // it did.
  bool try_flips(std::size_t t) {
    for (int i = 0; i < 3 && !is_triangle_settled_[t]; ++i) {
      const std::size_t n = mesh_.triangles[t].neighbors[i];
      if (n != Linked_triangle::none && flip_if_better(t, i)) {
        unsettle(t);
        unsettle(n);
        return true;
      }
    }
    is_triangle_settled_[t] = true;
    return false;
  }

  // Of the edge opposite to corner i of triangle t.
  bool flip_if_better(std::size_t t, int i) {
    const std::size_t n = mesh_.triangles[t].neighbors[i];
    const std::array<Linked_triangle, 2> old{mesh_.triangles[t], mesh_.triangles[n]},
        flipped = flipped_pair(t, i);
    if (!is_flip_allowed(old, flipped) || !(smallest_angle(flipped) > smallest_angle(old)) ||
        tries_ == 0)
      return false;
    --tries_;
    const double allowed = (std::max)(safe_excess, largest_excess({t, n}));
    replace_pair(t, n, flipped);
    if (largest_excess({t, n}) <= allowed)
      return true;
    replace_pair(t, n, old);
    return false;
  }

  // Three corners on the boundary may be on one side of the domain, which has no area there.
  bool is_flip_allowed(const std::array<Linked_triangle, 2>& old,
                       const std::array<Linked_triangle, 2>& flipped) const {
    const Vec3 before = sum(normal(old[0]), normal(old[1]));
    return std::all_of(flipped.begin(), flipped.end(), [&](const Linked_triangle& t) {
      return is_positive(t) && dot(normal(t), before) >= 0 &&
             !(is_on_boundary(t.vertices[0]) && is_on_boundary(t.vertices[1]) &&
               is_on_boundary(t.vertices[2]));
    });
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

  // Moves vertices of triangle t.
  void try_moves(std::size_t t) {
    const auto vertices = mesh_.triangles[t].vertices;
    for (const std::size_t v : vertices) {
      if (is_vertex_settled_[v] || tries_ == 0)
        continue;
      --tries_;
      is_vertex_settled_[v] = true;
      const std::vector<std::size_t> star = triangles_around(v);
      if (nudge(v, star))
        for (const std::size_t s : star)
          unsettle(s);
    }
  }

  struct Move {
    Point_2 point;
    Vec3 position;
    double angle; // the smallest one around the vertex then
  };

  void apply(std::size_t v, const Move& move) {
    points_[v] = move.point;
    mesh_.uv[v] = to_uv(move.point);
    mesh_.positions[v] = move.position;
  }

  // Where a vertex would be in the domain, if that leaves all triangles around it positive.
  std::optional<Point_2> moved_point(std::size_t v, const Uv& uv,
                                     const std::vector<std::size_t>& star) {
    using FT = typename Surface::FT;
    const Point_2 old = points_[v], moved(FT(uv.x), FT(uv.y));
    points_[v] = moved;
    const bool is_valid = std::all_of(
        star.begin(), star.end(), [&](std::size_t s) { return is_positive(mesh_.triangles[s]); });
    points_[v] = old;
    return is_valid ? std::make_optional(moved) : std::nullopt;
  }

  Vec3 sum_of_normals(const std::vector<std::size_t>& star) const {
    Vec3 result{0, 0, 0};
    for (const std::size_t t : star)
      result = sum(result, normal(mesh_.triangles[t]));
    return result;
  }

  // How many triangles are turned away from a direction.
  std::size_t count_inverted(const std::vector<std::size_t>& star, const Vec3& direction) const {
    return static_cast<std::size_t>(std::count_if(star.begin(), star.end(), [&](std::size_t t) {
      return dot(normal(mesh_.triangles[t]), direction) < 0;
    }));
  }

  // Moves of a vertex a little towards or away from one of its neighbours, after which no angle
  // around it is as small as the smallest one now. The best one comes first.
  std::vector<Move> find_moves(std::size_t v, const std::vector<std::size_t>& star) {
    const Move now{points_[v], mesh_.positions[v], smallest_angle(star)};
    const Uv uv = mesh_.uv[v];
    const Vec3 direction = sum_of_normals(star);
    const std::size_t inverted = count_inverted(star, direction);
    std::vector<Move> moves;
    for (const double step : {0.25, -0.25, 0.1, -0.1, 0.04, -0.04})
      for (const std::size_t t : star) {
        const auto& vertices = mesh_.triangles[t].vertices;
        const auto i = std::find(vertices.begin(), vertices.end(), v) - vertices.begin();
        const std::optional<Point_2> point =
            moved_point(v, uv + step * (mesh_.uv[vertices[(i + 1) % 3]] - uv), star);
        if (!point)
          continue;
        apply(v, {*point, surface_.position(to_uv(*point)), 0});
        const double angle = smallest_angle(star);
        if (angle > now.angle && count_inverted(star, direction) <= inverted)
          moves.push_back({*point, mesh_.positions[v], angle});
        apply(v, now);
      }
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
    const Move now{points_[v], mesh_.positions[v], 0};
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
  std::vector<Point_2>& points_;
  std::size_t number_of_boundary_vertices_;
  std::vector<std::size_t> triangle_of_; // one, by vertex
  // Since they were tried nothing has changed around them.
  std::vector<char> is_vertex_settled_, is_triangle_settled_;
  std::size_t tries_ = 0; // that are left
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SHARP_TRIANGLE_MENDER_H
