// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_DOMAINS_INTERNAL_POLYGON_CHECKS_H
#define CGAL_MULTISIDED_PATCHES_DOMAINS_INTERNAL_POLYGON_CHECKS_H

#include <CGAL/Multisided_patches/errors.h>

#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/intersections.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The loops of a polygon with holes as they are stored: loop k has the vertices
// [begins[k], begins[k + 1]).
template <typename Traits>
struct Loops {
  using Point_2 = typename Traits::Point_2;
  using Segment_2 = typename Traits::Segment_2;

  const std::vector<Point_2>& vertices;
  const std::vector<std::size_t>& begins;

  auto begin(std::size_t loop) const { return vertices.begin() + begins[loop]; }
  auto end(std::size_t loop) const { return vertices.begin() + begins[loop + 1]; }
  Segment_2 side(std::size_t loop, std::size_t i) const {
    const std::size_t next = i + 1 == begins[loop + 1] ? begins[loop] : i + 1;
    return Segment_2(vertices[i], vertices[next]);
  }
};

template <typename Traits>
void check_vertices(const Loops<Traits>& loops, std::size_t loop, const std::string& name) {
  const std::size_t first = loops.begins[loop], last = loops.begins[loop + 1];
  if (last - first < 3)
    throw Input_error(name + " has " + std::to_string(last - first) +
                      " vertices; at least 3 are needed");
  for (std::size_t i = first; i < last; ++i)
    if (!is_finite(loops.vertices[i].x()) || !is_finite(loops.vertices[i].y()))
      throw Input_error("vertex " + std::to_string(i) + " of the domain is not finite");
  for (std::size_t i = first; i < last; ++i)
    if (loops.side(loop, i).is_degenerate())
      throw Input_error("side " + std::to_string(i) + " of the domain has length zero");
}

// Only called when a loop is known not to be simple: names two sides that say why.
template <typename Traits>
std::string crossing_sides(const Loops<Traits>& loops, std::size_t loop) {
  const std::size_t first = loops.begins[loop], last = loops.begins[loop + 1];
  for (std::size_t i = first; i < last; ++i)
    for (std::size_t j = i + 1; j < last; ++j) {
      const auto a = loops.side(loop, i), b = loops.side(loop, j);
      const bool adjacent = a.target() == b.source() || b.target() == a.source();
      // Adjacent sides meet in their common vertex, and in more only if one contains the other.
      const bool touch = adjacent ? (a.has_on(b.source()) && a.has_on(b.target())) ||
                                        (b.has_on(a.source()) && b.has_on(a.target()))
                                  : do_intersect(a, b);
      if (touch)
        return "sides " + std::to_string(i) + " and " + std::to_string(j) +
               " of the domain cross or touch";
    }
  return "the boundary of the domain crosses itself";
}

template <typename Traits>
void check_simple(const Loops<Traits>& loops, std::size_t loop) {
  if (!is_simple_2(loops.begin(loop), loops.end(loop), Traits()))
    throw Input_error(crossing_sides(loops, loop));
}

// Whether the interior of the domain is on the left of a simple loop.
template <typename Traits>
bool is_well_oriented(const Loops<Traits>& loops, std::size_t loop) {
  const Orientation expected = loop == 0 ? COUNTERCLOCKWISE : CLOCKWISE;
  return orientation_2(loops.begin(loop), loops.end(loop), Traits()) == expected;
}

template <typename Traits>
void check_orientation(const Loops<Traits>& loops, std::size_t loop) {
  if (!is_well_oriented(loops, loop))
    throw Input_error(loop == 0 ? "the outer loop of the domain must run counterclockwise"
                                : "hole " + std::to_string(loop - 1) +
                                      " of the domain must run clockwise");
}

template <typename Traits>
void check_apart(const Loops<Traits>& loops, std::size_t k, std::size_t l) {
  for (std::size_t i = loops.begins[k]; i < loops.begins[k + 1]; ++i)
    for (std::size_t j = loops.begins[l]; j < loops.begins[l + 1]; ++j)
      if (do_intersect(loops.side(k, i), loops.side(l, j)))
        throw Input_error("sides " + std::to_string(i) + " and " + std::to_string(j) +
                          " of two loops of the domain cross or touch");
  // The loops do not meet, so one vertex tells for all.
  const Traits traits;
  const auto in = [&](std::size_t inner, std::size_t outer) {
    return bounded_side_2(loops.begin(outer), loops.end(outer), *loops.begin(inner), traits) ==
           ON_BOUNDED_SIDE;
  };
  if (k == 0 && !in(l, k))
    throw Input_error("hole " + std::to_string(l - 1) + " lies outside the domain");
  if (k != 0 && (in(k, l) || in(l, k)))
    throw Input_error("holes " + std::to_string(k - 1) + " and " + std::to_string(l - 1) +
                      " of the domain lie in each other");
}

// All that makes loops a polygon with holes but their orientations.
template <typename Traits>
void check_unoriented_loops(const Loops<Traits>& loops) {
  const std::size_t n = loops.begins.size() - 1;
  for (std::size_t k = 0; k < n; ++k) {
    check_vertices(loops, k, k == 0 ? "the outer loop" : "hole " + std::to_string(k - 1));
    check_simple(loops, k);
  }
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t l = k + 1; l < n; ++l)
      check_apart(loops, k, l);
}

template <typename Traits>
void check_polygon_with_holes(const std::vector<typename Traits::Point_2>& vertices,
                              const std::vector<std::size_t>& begins) {
  const Loops<Traits> loops{vertices, begins};
  check_unoriented_loops(loops);
  for (std::size_t k = 0; k + 1 < begins.size(); ++k)
    check_orientation(loops, k);
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_DOMAINS_INTERNAL_POLYGON_CHECKS_H
