// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BISECTION_MESH_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BISECTION_MESH_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/plane_geometry.h>

#include <CGAL/Multisided_patches/errors.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

using Triangle_points = std::array<Complex, 3>;

// A triangle of the mesh, and the sides of the polygon that its corners lie on.
struct Leaf {
  Triangle_points corners;          // counterclockwise
  std::array<std::size_t, 3> sides; // at a vertex the one that begins there, inside none
};

// A conforming triangulation that is refined by longest-edge bisection, and remembers how: every
// triangle that was cut knows its two halves, so that a point is located by descending.
//
// Rivara, "New longest-edge algorithms for the refinement and/or improvement of unstructured
// triangulations", Int. J. Numer. Methods Eng. 40 (1997): to cut a triangle, follow the longest
// edges until one is the longest of both its triangles, cut these two, and start again.
class Bisection_mesh {
public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  struct Triangle {
    std::array<std::size_t, 3> vertex;   // counterclockwise
    std::array<std::size_t, 3> neighbor; // across the edge opposite to the vertex, or none
    std::array<std::size_t, 2> child{none, none};
    // The half child[0] is on the right, child[1] on the left of the cut from apex to midpoint.
    std::size_t apex = none, midpoint = none;

    bool is_leaf() const { return child[0] == none; }
  };

  // All points are on the boundary: `sides` says on which side of the polygon each lies, or which
  // begins there.
  Bisection_mesh(std::vector<Complex> points, std::vector<std::size_t> sides,
                 std::vector<Triangle> triangles)
      : points_(std::move(points)), sides_(std::move(sides)), triangles_(std::move(triangles)),
        number_of_roots_(triangles_.size()) {}

  std::size_t number_of_roots() const { return number_of_roots_; }
  // of all triangles, cut or not
  std::size_t size() const { return triangles_.size(); }
  const Triangle& triangle(std::size_t t) const { return triangles_[t]; }
  const Complex& point(std::size_t v) const { return points_[v]; }

  Triangle_points corners(std::size_t t) const {
    const std::array<std::size_t, 3>& v = triangles_[t].vertex;
    return {points_[v[0]], points_[v[1]], points_[v[2]]};
  }
  Leaf leaf(std::size_t t) const {
    const std::array<std::size_t, 3>& v = triangles_[t].vertex;
    return {corners(t), {sides_[v[0]], sides_[v[1]], sides_[v[2]]}};
  }

  // cuts a leaf, and whatever must be cut before it
  void bisect(std::size_t t) {
    while (triangles_[t].is_leaf()) {
      std::size_t u = t;
      for (;;) {
        const int edge = longest_edge(u);
        const std::size_t n = triangles_[u].neighbor[edge];
        if (n == none || squared_length(n, longest_edge(n)) <= squared_length(u, edge)) {
          cut_edge(u, edge);
          break;
        }
        u = n;
      }
    }
  }

private:
  // More than any polygon needed: a guard against endless refinement.
  std::size_t max_size() const { return 120000 + 1000 * number_of_roots_; }

  double squared_length(std::size_t t, int edge) const {
    const std::array<std::size_t, 3>& v = triangles_[t].vertex;
    return std::norm(points_[v[(edge + 1) % 3]] - points_[v[(edge + 2) % 3]]);
  }

  int longest_edge(std::size_t t) const {
    const double l0 = squared_length(t, 0), l1 = squared_length(t, 1), l2 = squared_length(t, 2);
    return l0 >= l1 && l0 >= l2 ? 0 : l1 >= l2 ? 1 : 2;
  }

  int index_of_neighbor(std::size_t t, std::size_t n) const {
    const std::array<std::size_t, 3>& neighbor = triangles_[t].neighbor;
    return neighbor[0] == n ? 0 : neighbor[1] == n ? 1 : 2;
  }

  void cut_edge(std::size_t t, int edge) {
    if (triangles_.size() > max_size())
      throw Numerical_error("the domain has too much detail: no subdivision "
                            "of it into cells was found with " +
                            std::to_string(max_size()) + " triangles");
    const Triangle& old = triangles_[t];
    const std::size_t n = old.neighbor[edge], midpoint = points_.size();
    points_.push_back((points_[old.vertex[(edge + 1) % 3]] + points_[old.vertex[(edge + 2) % 3]]) /
                      2.);
    // The domain is on the left of its sides, so the edge begins on the one that it lies on.
    sides_.push_back(n == none ? sides_[old.vertex[(edge + 1) % 3]] : none);
    const int other_edge = n == none ? 0 : index_of_neighbor(n, t);
    cut_triangle(t, edge, midpoint);
    if (n == none)
      return;
    cut_triangle(n, other_edge, midpoint);
    // Both are counterclockwise, so the first half of one lies across from the second of the other.
    for (const int i : {0, 1}) {
      const std::size_t a = triangles_[t].child[i], b = triangles_[n].child[1 - i];
      triangles_[a].neighbor[0] = b;
      triangles_[b].neighbor[0] = a;
    }
  }

  // Each half has its vertex 0 opposite to its part of the cut edge, which is the apex.
  void cut_triangle(std::size_t t, int edge, std::size_t midpoint) {
    const Triangle old = triangles_[t];
    const std::size_t apex = old.vertex[edge], a = old.vertex[(edge + 1) % 3],
                      b = old.vertex[(edge + 2) % 3];
    const std::size_t at_b = old.neighbor[(edge + 1) % 3], at_a = old.neighbor[(edge + 2) % 3];
    const std::size_t first = triangles_.size(), second = first + 1;
    Triangle half;
    half.vertex = {apex, a, midpoint};
    half.neighbor = {none, second, at_a};
    triangles_.push_back(half);
    half.vertex = {apex, midpoint, b};
    half.neighbor = {none, at_b, first};
    triangles_.push_back(half);
    replace_neighbor(at_a, t, first);
    replace_neighbor(at_b, t, second);
    triangles_[t].child = {first, second};
    triangles_[t].apex = apex;
    triangles_[t].midpoint = midpoint;
  }

  void replace_neighbor(std::size_t t, std::size_t from, std::size_t to) {
    if (t != none)
      triangles_[t].neighbor[index_of_neighbor(t, from)] = to;
  }

  std::vector<Complex> points_;
  std::vector<std::size_t> sides_; // of every point
  std::vector<Triangle> triangles_;
  std::size_t number_of_roots_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_BISECTION_MESH_H
