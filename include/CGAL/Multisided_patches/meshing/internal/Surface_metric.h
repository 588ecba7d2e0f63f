// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_METRIC_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_METRIC_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_2.h>
#include <CGAL/Multisided_patches/meshing/internal/Sampled_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A coarse mesh of a surface over its domain, which tells about lengths on the surface: a first
// fundamental form at every vertex, from the triangles around it, and linear in between. Divided by
// the square of the edge length that is wanted at the vertices it is the metric for Metric_refiner.
//
// Lengths on the surface are in any unit, the same everywhere.
class Surface_metric {
public:
  Surface_metric() = default;
  explicit Surface_metric(const Sampled_mesh& mesh)
      : uv_(mesh.uv), triangles_(mesh.triangles), forms_(uv_.size(), {0, 0, 0}),
        metrics_(uv_.size()), face_of_(uv_.size(), 0) {
    const std::vector<Vec3>& positions = mesh.positions;
    std::vector<double> weights(uv_.size(), 0);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& v = triangles_[t].vertices;
      area_ += norm(cross(difference(positions[v[1]], positions[v[0]]),
                          difference(positions[v[2]], positions[v[0]]))) /
               2;
      for (std::size_t i = 0; i < 3; ++i) {
        face_of_[v[i]] = t;
        if (triangles_[t].neighbors[i] == Linked_triangle::none)
          boundary_length_ +=
              norm(difference(positions[v[(i + 1) % 3]], positions[v[(i + 2) % 3]]));
      }
      // Sharp triangles say little about lengths across them.
      const double area = cross(uv_[v[1]] - uv_[v[0]], uv_[v[2]] - uv_[v[0]]);
      const double weight = area * quality(v);
      if (!(weight > 0))
        continue;
      const Metric_2 form = first_fundamental_form(v, positions);
      for (const std::size_t k : v) {
        forms_[k] = forms_[k] + weight * form;
        weights[k] += weight;
      }
    }
    for (std::size_t k = 0; k < uv_.size(); ++k)
      if (weights[k] > 0)
        forms_[k] = 1 / weights[k] * forms_[k];
    regularize();
    set_edge_length(1);
  }

  const Linked_triangles& triangles() const { return triangles_; }
  std::size_t number_of_vertices() const { return uv_.size(); }
  // Of the surface.
  double area() const { return area_; }
  double boundary_length() const { return boundary_length_; }

  // The edge lengths that are wanted at the vertices.
  void set_edge_lengths(const std::vector<double>& lengths) {
    for (std::size_t k = 0; k < uv_.size(); ++k)
      metrics_[k] = 1 / (lengths[k] * lengths[k]) * forms_[k];
  }
  void set_edge_length(double length) { set_edge_lengths(std::vector<double>(uv_.size(), length)); }

  // The area of the domain in the metric: that of the surface in units of the square of the local
  // edge length.
  double metric_area() const {
    double sum = 0;
    for (const Linked_triangle& t : triangles_) {
      const auto& v = t.vertices;
      const Metric_2 m = 1. / 3 * (metrics_[v[0]] + metrics_[v[1]] + metrics_[v[2]]);
      sum += m.area_factor() * cross(uv_[v[1]] - uv_[v[0]], uv_[v[2]] - uv_[v[0]]) / 2;
    }
    return sum;
  }

  // The metric at a point of the domain. The search starts at triangle `hint`, which is then the
  // one where it ended: the one with the point or, as rounding may have put it outside all of them,
  // one next to it. (It may also have given up far away, see search().)
  Metric_2 operator()(const Uv& p, std::size_t& hint) const {
    const std::size_t start = hint;
    if (!walk(hint, p) && !is_close(squared_distance(hint, p), hint, p))
      hint = search(start, hint, p);
    return interpolate(hint, p);
  }

  // A triangle with the vertex, to start searching from.
  std::size_t triangle_at(std::size_t vertex) const { return face_of_[vertex]; }

  // For each triangle whether lengths in it change so fast that a finer mesh needs to know them
  // better: squared ones by more than half from corner to corner. Where these abound, the steepest
  // ones.
  std::vector<char> steep_triangles() const {
    constexpr double steep = 0.5, max_share = 0.05;
    constexpr std::size_t few = 1000;
    std::vector<double> changes(triangles_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      changes[t] = change(triangles_[t].vertices);
    double least = steep;
    const auto most =
        (std::max)(few, static_cast<std::size_t>(max_share * static_cast<double>(changes.size())));
    if (most < changes.size()) {
      std::vector<double> sorted = changes;
      const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(most);
      std::nth_element(sorted.begin(), nth, sorted.end(), std::greater<double>());
      least = (std::max)(least, *nth);
    }
    std::vector<char> is_steep(changes.size());
    std::transform(changes.begin(), changes.end(), is_steep.begin(),
                   [&](double c) { return c > least; });
    return is_steep;
  }

  // A length of the surface between two vertices along an edge.
  double length(std::size_t v, std::size_t w) const {
    return (0.5 * (forms_[v] + forms_[w])).norm(uv_[w] - uv_[v]);
  }
  // The same in units of the edge length that is wanted there.
  double length_in_edges(std::size_t v, std::size_t w) const {
    return (0.5 * (metrics_[v] + metrics_[w])).norm(uv_[w] - uv_[v]);
  }

private:
  // By how much squared lengths differ at the corners of a triangle, relative to the shorter ones.
  double change(const Linked_triangle::Indices& v) const {
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Metric_2 &a = forms_[v[i]], &b = forms_[v[(i + 1) % 3]];
      const double difference = std::abs(a.E - b.E) + 2 * std::abs(a.F - b.F) + std::abs(a.G - b.G);
      largest = (std::max)(largest, difference / (std::min)(a.E + a.G, b.E + b.G));
    }
    return largest;
  }

  // 1 for equilateral triangles, 0 for flat ones.
  double quality(const Linked_triangle::Indices& v) const {
    const Metric_triangle t({uv_[v[0]], uv_[v[1]], uv_[v[2]]}, Metric_2{1, 0, 1});
    const double sum = t.squared_length(0) + t.squared_length(1) + t.squared_length(2);
    return sum > 0 ? 4 * std::sqrt(3.0) * t.area() / sum : 0;
  }

  // Of the linear map of the triangle from the domain to the surface.
  Metric_2 first_fundamental_form(const Linked_triangle::Indices& v,
                                  const std::vector<Vec3>& positions) const {
    const Uv a = uv_[v[1]] - uv_[v[0]], b = uv_[v[2]] - uv_[v[0]];
    const Vec3 p = difference(positions[v[1]], positions[v[0]]),
               q = difference(positions[v[2]], positions[v[0]]);
    const double d = cross(a, b);
    Vec3 along_u, along_v;
    for (int c = 0; c < 3; ++c) {
      along_u[c] = (b.y * p[c] - a.y * q[c]) / d;
      along_v[c] = (a.x * q[c] - b.x * p[c]) / d;
    }
    return {dot(along_u, along_u), dot(along_u, along_v), dot(along_v, along_v)};
  }

  // Where the surface is squeezed to a curve or a point, lengths across would vanish, and triangles
  // become infinitely many or infinitely long.
  void regularize() {
    constexpr double max_stretch = 20; // the largest ratio of lengths in two directions
    double mean = 0;
    for (const Metric_2& m : forms_)
      mean += (m.E + m.G) / 2 / static_cast<double>(forms_.size());
    for (Metric_2& m : forms_) {
      const double slack = ((m.E + m.G) / (max_stretch * max_stretch) + 1e-6 * mean);
      m = m + slack * Metric_2{1, 0, 1};
    }
  }

  // From triangle to triangle towards a point, as far as the boundary. Returns whether it came to
  // the triangle with the point.
  bool walk(std::size_t& triangle, const Uv& p) const {
    // The triangles need not be Delaunay, so that a walk that always looks at their edges in the
    // same order might go round in circles.
    for (std::size_t step = 0; step < triangles_.size(); ++step) {
      bool is_beyond = false;
      std::size_t next = Linked_triangle::none;
      for (std::size_t k = 0; k < 3 && next == Linked_triangle::none; ++k) {
        const std::size_t i = (step + k) % 3;
        if (is_beyond_edge(triangle, i, p)) {
          is_beyond = true;
          next = triangles_[triangle].neighbors[i];
        }
      }
      if (next == Linked_triangle::none)
        return !is_beyond;
      triangle = next;
    }
    return false;
  }

  bool is_beyond_edge(std::size_t triangle, std::size_t i, const Uv& p) const {
    const auto& v = triangles_[triangle].vertices;
    const Uv &a = uv_[v[(i + 1) % 3]], &b = uv_[v[(i + 2) % 3]];
    return cross(b - a, p - a) < 0;
  }

  // From a point to a triangle, about; 0 inside.
  double squared_distance(std::size_t triangle, const Uv& p) const {
    const auto& v = triangles_[triangle].vertices;
    const std::array<double, 3> weights = weights_in(triangle, p);
    return squared_length(weights[0] * uv_[v[0]] + weights[1] * uv_[v[1]] + weights[2] * uv_[v[2]] -
                          p);
  }

  // Whether a distance of a point from a triangle may be due to rounding, or does not matter.
  bool is_close(double squared, std::size_t triangle, const Uv& p) const {
    constexpr double relative = 1e-6, rounding = 1e-15; // to the longest edge, to coordinates
    const auto& v = triangles_[triangle].vertices;
    double longest = 0;
    for (int i = 0; i < 3; ++i)
      longest = (std::max)(longest, squared_length(uv_[v[(i + 1) % 3]] - uv_[v[i]]));
    const double close =
        relative * std::sqrt(longest) + rounding * (std::max)(std::abs(p.x), std::abs(p.y));
    return squared <= close * close;
  }

  // The triangle with a point, or a close one. Looks around corners of the domain, where a walk
  // ends at the boundary: always from the triangle that is the closest of those it has come to.
  // Gives up when it has seen too many, and takes the closest one.
  std::size_t search(std::size_t start, std::size_t end_of_walk, const Uv& p) const {
    constexpr std::size_t max_triangles = 10000;
    using Candidate = std::pair<double, std::size_t>; // squared distance, triangle
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue;
    std::unordered_set<std::size_t> seen;
    const auto add = [&](std::size_t t) {
      if (t != Linked_triangle::none && seen.insert(t).second)
        queue.push({squared_distance(t, p), t});
    };
    add(start);
    add(end_of_walk);
    Candidate closest = queue.top();
    while (!queue.empty() && seen.size() < max_triangles) {
      const Candidate now = queue.top();
      queue.pop();
      closest = (std::min)(closest, now);
      if (is_close(now.first, now.second, p))
        break;
      for (const std::size_t n : triangles_[now.second].neighbors)
        add(n);
    }
    return closest.second;
  }

  static double squared_length(const Uv& a) { return a.x * a.x + a.y * a.y; }

  // Barycentric coordinates of a point, of which negative ones are left out.
  std::array<double, 3> weights_in(std::size_t triangle, const Uv& p) const {
    const auto& v = triangles_[triangle].vertices;
    std::array<double, 3> weights;
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const Uv &a = uv_[v[(i + 1) % 3]], &b = uv_[v[(i + 2) % 3]];
      weights[i] = (std::max)(0.0, cross(b - a, p - a));
      sum += weights[i];
    }
    if (!(sum > 0))
      return {1, 0, 0};
    for (double& w : weights)
      w /= sum;
    return weights;
  }

  Metric_2 interpolate(std::size_t triangle, const Uv& p) const {
    const auto& v = triangles_[triangle].vertices;
    const std::array<double, 3> weights = weights_in(triangle, p);
    return weights[0] * metrics_[v[0]] + weights[1] * metrics_[v[1]] + weights[2] * metrics_[v[2]];
  }

  std::vector<Uv> uv_;
  Linked_triangles triangles_;
  std::vector<Metric_2> forms_; // by vertex
  std::vector<Metric_2> metrics_;
  std::vector<std::size_t> face_of_;
  double area_ = 0, boundary_length_ = 0;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_METRIC_H
