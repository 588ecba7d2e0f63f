// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_TRIANGLE_PATTERNS_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_TRIANGLE_PATTERNS_H

#include <array>
#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// How a triangle is divided when some of its edges are halved. Corners are numbered 0, 1, 2; edges
// by the corners opposite to them; the middle of edge i is corner 3 + i of the children.
struct Triangle_pattern {
  struct Edge {
    int sibling = -1;         // the child behind it, or
    int parent = 0, half = 0; // the edge of the parent that it is, or which half of it
  };
  struct Child {
    std::array<int, 3> corners; // counterclockwise
    std::array<Edge, 3> edges;  // opposite to the corners
  };

  std::size_t number_of_children = 0;
  std::array<Child, 4> children;
  // The child with edge i of the parent, or with the first and the second half of it.
  std::array<std::array<std::size_t, 2>, 3> child_on_edge;
};

// The children of a triangle whose edges are halved as in `is_halved`, without their neighbours.
inline Triangle_pattern children_of_triangle(const std::array<bool, 3>& is_halved) {
  Triangle_pattern pattern;
  const auto add = [&](int a, int b, int c) {
    pattern.children[pattern.number_of_children++].corners = {a, b, c};
  };
  const int count = is_halved[0] + is_halved[1] + is_halved[2];
  // The edge that is different from the others.
  int k = 0;
  while (k < 2 && is_halved[k] != (count == 1))
    ++k;
  const int l = (k + 1) % 3, m = (k + 2) % 3;
  if (count == 0) {
    add(0, 1, 2);
  } else if (count == 1) {
    add(k, l, 3 + k);
    add(k, 3 + k, m);
  } else if (count == 2) {
    add(k, 3 + m, 3 + l);
    add(3 + m, l, m);
    add(3 + m, m, 3 + l);
  } else {
    for (int i = 0; i < 3; ++i)
      add(i, 3 + (i + 2) % 3, 3 + (i + 1) % 3);
    add(3, 4, 5);
  }
  return pattern;
}

// Finds out what is behind the edge from corner p to corner q of a child.
inline Triangle_pattern::Edge edge_of_child(const Triangle_pattern& pattern, int p, int q) {
  Triangle_pattern::Edge edge;
  for (std::size_t c = 0; c < pattern.number_of_children; ++c)
    for (int i = 0; i < 3; ++i)
      if (pattern.children[c].corners[i] == q && pattern.children[c].corners[(i + 1) % 3] == p) {
        edge.sibling = static_cast<int>(c);
        return edge;
      }
  for (int i = 0; i < 3; ++i) {
    const int start = (i + 1) % 3, middle = 3 + i, end = (i + 2) % 3;
    if ((p == start && (q == middle || q == end)) || (p == middle && q == end)) {
      edge.parent = i;
      edge.half = p == middle ? 1 : 0;
    }
  }
  return edge;
}

inline Triangle_pattern make_triangle_pattern(const std::array<bool, 3>& is_halved) {
  Triangle_pattern pattern = children_of_triangle(is_halved);
  for (std::size_t c = 0; c < pattern.number_of_children; ++c) {
    Triangle_pattern::Child& child = pattern.children[c];
    for (int i = 0; i < 3; ++i) {
      child.edges[i] =
          edge_of_child(pattern, child.corners[(i + 1) % 3], child.corners[(i + 2) % 3]);
      if (child.edges[i].sibling < 0)
        pattern.child_on_edge[child.edges[i].parent][child.edges[i].half] = c;
    }
  }
  return pattern;
}

inline const Triangle_pattern& triangle_pattern(bool first, bool second, bool third) {
  static const std::array<Triangle_pattern, 8> patterns = [] {
    std::array<Triangle_pattern, 8> result;
    for (std::size_t mask = 0; mask < 8; ++mask)
      result[mask] = make_triangle_pattern({(mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0});
    return result;
  }();
  return patterns[std::size_t(first) + 2 * std::size_t(second) + 4 * std::size_t(third)];
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_TRIANGLE_PATTERNS_H
