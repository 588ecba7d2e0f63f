// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EDGE_HALVER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EDGE_HALVER_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_at_points.h>
#include <CGAL/Multisided_patches/meshing/internal/triangle_patterns.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Makes a fine mesh of a domain from a coarse one by halving edges, all at the same time: far
// faster than by points that are looked for one by one. Triangles keep their shapes, but for those
// on sides, where the samples are not in the middles of the edges.
//
// The result does not depend on the number of threads.
template <typename Traits, typename Field, typename ConcurrencyTag>
class Edge_halver {
public:
  using Point_2 = typename Traits::Point_2;

  // New points are appended to `points`; triangles are replaced. For an edge on a side that starts
  // at point k, and ends at point k + m or, at the end of a loop, at the loop's first point,
  // segments[k] is m: points k + 1 to k + m - 1 are samples on it that the triangles do not have
  // yet.
  Edge_halver(std::vector<Point_2>& points, Metric_at_points<Field>& metric,
              Linked_triangles& triangles, std::vector<std::size_t>& segments)
      : points_(points), metric_(metric), triangles_(triangles), segments_(segments) {}

  // Halves the edges whose length in the metric is 2 or not much less, and those on sides if they
  // have more than `max_segments`. If there would be fewer than `least` triangles then, shorter
  // ones are halved, too, down to 1.2. Returns false, and has left the mesh in disorder, if
  // rounding has put points where triangles are not positively oriented. Now and then it calls
  // progress(number of points).
  template <typename Progress>
  bool halve(std::size_t max_segments, std::size_t least, const Progress& progress) {
    find_long_edges(least, progress);
    add_middles(max_segments, progress);
    find_children();
    check_number_of_indices((std::max)(points_.size(), first_child_.back()));
    Linked_triangles children;
    children.reserve(first_child_.back() + first_child_.back() / 32); // for those added later
    children.resize(first_child_.back(), boost::container::default_init);
    std::atomic<bool> is_valid(true);
    for_each_triangle(progress, [&](std::size_t t) {
      if (!divide(t, children.data() + first_child_[t]))
        is_valid.store(false, std::memory_order_relaxed);
    });
    triangles_ = std::move(children);
    return is_valid.load();
  }

private:
  static constexpr std::size_t none = Linked_triangle::none;

  // Calls f(t) for each triangle, in parallel, and progress(number of points) in between.
  template <typename Progress, typename Function>
  void for_each_triangle(const Progress& progress, const Function& f) const {
    constexpr std::size_t block = 1 << 16, grain = 512;
    for (std::size_t first = 0; first < triangles_.size(); first += block) {
      progress(points_.size());
      for_each_index<ConcurrencyTag>((std::min)(block, triangles_.size() - first),
                                     [&](std::size_t k) { f(first + k); }, grain);
    }
  }

  static int opposite(const Linked_triangle& t, std::size_t neighbor) {
    return static_cast<int>(std::find(t.neighbors.begin(), t.neighbors.end(), neighbor) -
                            t.neighbors.begin());
  }

  // Edges between two triangles are the business of the first one, and so are their middles.
  static bool is_edge_of(std::size_t t, std::size_t neighbor) { return neighbor > t; }

  // The edges inside that are to be halved. Up to the geometric mean of 1 and 2 they are nearer to
  // 1.
  template <typename Progress>
  void find_long_edges(std::size_t least, const Progress& progress) {
    constexpr float max_squared_length = 2, least_squared_length = 1.44F;
    std::vector<std::array<float, 3>> lengths = squared_lengths(progress);
    float longest = max_squared_length;
    if (least > triangles_.size()) { // every edge that is halved makes two triangles more
      longest = (std::min)(longest, limit(lengths, (least - triangles_.size()) / 2));
      longest = (std::max)(longest, least_squared_length);
    }
    is_long_.resize(triangles_.size());
    for_each_triangle(progress, [&](std::size_t t) {
      for (int i = 0; i < 3; ++i)
        is_long_[t][i] = lengths[t][i] > longest;
    });
  }

  // The squared lengths of edges that may be halved, by triangle; 0 for others.
  template <typename Progress>
  std::vector<std::array<float, 3>> squared_lengths(const Progress& progress) {
    is_narrow_.resize(triangles_.size());
    for_each_triangle(progress,
                      [&](std::size_t t) { is_narrow_[t] = this->is_narrow(triangles_[t]); });
    std::vector<std::array<float, 3>> lengths(triangles_.size());
    for_each_triangle(progress, [&](std::size_t t) {
      const auto& v = triangles_[t].vertices;
      for (int i = 0; i < 3; ++i) {
        const std::size_t neighbor = triangles_[t].neighbors[i];
        const bool may_be_halved =
            neighbor != none && is_edge_of(t, neighbor) && !is_narrow_[t] && !is_narrow_[neighbor];
        lengths[t][i] =
            may_be_halved ? static_cast<float>(squared_length(v[(i + 1) % 3], v[(i + 2) % 3])) : 0;
      }
    });
    return lengths;
  }

  // A length that `count` edges exceed; 0 if there are not so many.
  static float limit(const std::vector<std::array<float, 3>>& lengths, std::size_t count) {
    std::vector<float> all;
    all.reserve(3 * lengths.size() / 2);
    for (const std::array<float, 3>& of_triangle : lengths)
      for (const float length : of_triangle)
        if (length > 0)
          all.push_back(length);
    if (count >= all.size())
      return 0;
    const auto at = all.begin() + static_cast<std::ptrdiff_t>(count);
    std::nth_element(all.begin(), at, all.end(), std::greater<float>());
    return *at;
  }

  // Appends the middles of the long edges, and finds those of the edges on sides.
  template <typename Progress>
  void add_middles(std::size_t max_segments, const Progress& progress) {
    std::vector<std::size_t> first_middle{points_.size()}; // of each triangle
    first_middle.reserve(triangles_.size() + 1);
    for (const std::array<bool, 3>& is_long : is_long_)
      first_middle.push_back(first_middle.back() + is_long[0] + is_long[1] + is_long[2]);
    points_.resize(first_middle.back());
    metric_.resize(first_middle.back());
    middles_.resize(triangles_.size());
    for_each_triangle(progress, [&](std::size_t t) {
      const auto& v = triangles_[t].vertices;
      std::size_t next = first_middle[t];
      for (int i = 0; i < 3; ++i)
        if (triangles_[t].neighbors[i] == none)
          middles_[t][i] = middle_of_side(v[(i + 1) % 3], max_segments);
        else if (is_long_[t][i])
          set_middle(middles_[t][i] = next++, v[(i + 1) % 3], v[(i + 2) % 3]);
        else
          middles_[t][i] = none;
    });
    for_each_triangle(progress, [&](std::size_t t) {
      for (int i = 0; i < 3; ++i) {
        const std::size_t neighbor = triangles_[t].neighbors[i];
        if (!is_edge_of(t, neighbor))
          middles_[t][i] = middles_[neighbor][opposite(triangles_[neighbor], t)];
      }
    });
  }

  std::size_t middle_of_side(std::size_t a, std::size_t max_segments) {
    const std::size_t all = segments_[a], half = all / 2;
    if (all <= max_segments)
      return none;
    segments_[a] = half;
    segments_[a + half] = all - half;
    return a + half;
  }

  // Whether the middles of edges would be too close to the other sides of a triangle.
  bool is_narrow(const Linked_triangle& t) const {
    constexpr double least_height = 0.9;
    const Metric_triangle triangle = metric_.triangle(points_, t.vertices);
    const double longest = (std::max)(
        {triangle.squared_length(0), triangle.squared_length(1), triangle.squared_length(2)});
    return 4 * triangle.area() * triangle.area() < least_height * least_height * longest;
  }

  double squared_length(std::size_t a, std::size_t b) const {
    const Metric_2 m = 0.5 * (metric_[a] + metric_[b]);
    return m.squared_norm(to_uv(points_[b]) - to_uv(points_[a]));
  }

  void set_middle(std::size_t middle, std::size_t a, std::size_t b) {
    const Uv p = 0.5 * (to_uv(points_[a]) + to_uv(points_[b]));
    points_[middle] = Point_2(typename Traits::FT(p.x), typename Traits::FT(p.y));
    metric_.set(middle, p, metric_.hint(a));
  }

  void find_children() {
    first_child_.assign(1, 0);
    first_child_.reserve(triangles_.size() + 1);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      first_child_.push_back(first_child_.back() + pattern(t).number_of_children);
  }

  const Triangle_pattern& pattern(std::size_t t) const {
    const auto& m = middles_[t];
    return triangle_pattern(m[0] != none, m[1] != none, m[2] != none);
  }

  bool divide(std::size_t t, Linked_triangle* children) const {
    const Triangle_pattern& pattern = this->pattern(t);
    const auto& v = triangles_[t].vertices;
    const auto& m = middles_[t];
    const std::array<std::size_t, 6> corners{v[0], v[1], v[2], m[0], m[1], m[2]};
    for (std::size_t c = 0; c < pattern.number_of_children; ++c) {
      const Triangle_pattern::Child& child = pattern.children[c];
      for (int i = 0; i < 3; ++i) {
        children[c].vertices[i] = corners[child.corners[i]];
        children[c].neighbors[i] = neighbor(t, child.edges[i]);
      }
      const auto& w = children[c].vertices;
      if (orientation(points_[w[0]], points_[w[1]], points_[w[2]]) != LEFT_TURN)
        return false;
    }
    return true;
  }

  // The triangle behind an edge of a child of triangle t.
  std::size_t neighbor(std::size_t t, const Triangle_pattern::Edge& edge) const {
    if (edge.sibling >= 0)
      return first_child_[t] + static_cast<std::size_t>(edge.sibling);
    const std::size_t n = triangles_[t].neighbors[edge.parent];
    if (n == none)
      return none;
    const int j = opposite(triangles_[n], t);
    const bool is_halved = middles_[t][edge.parent] != none;
    // The neighbour runs along the edge the other way.
    return first_child_[n] + pattern(n).child_on_edge[j][is_halved ? 1 - edge.half : 0];
  }

  std::vector<Point_2>& points_;
  Metric_at_points<Field>& metric_;
  Linked_triangles& triangles_;
  std::vector<std::size_t>& segments_;
  // By triangle, while edges are halved.
  std::vector<char> is_narrow_;
  std::vector<std::array<bool, 3>> is_long_;
  std::vector<Linked_triangle::Indices> middles_;
  std::vector<std::size_t> first_child_; // and one past the last child
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_EDGE_HALVER_H
