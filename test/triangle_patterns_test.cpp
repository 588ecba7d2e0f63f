// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"

#include <CGAL/Multisided_patches/meshing/internal/triangle_patterns.h>

#include <array>

namespace {

namespace MP = CGAL::Multisided_patches;
using MP::internal::Triangle_pattern;
using Point = std::array<int, 2>;

// The corners of a triangle, and the middles of its edges.
constexpr std::array<Point, 6> points{{{0, 0}, {4, 0}, {0, 4}, {2, 2}, {0, 2}, {2, 0}}};

int twice_area(const Triangle_pattern::Child& child) {
  const Point &a = points[child.corners[0]], &b = points[child.corners[1]],
              &c = points[child.corners[2]];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The corners at the ends of an edge of a child, in its direction.
std::array<int, 2> ends(const Triangle_pattern::Child& child, int i) {
  return {child.corners[(i + 1) % 3], child.corners[(i + 2) % 3]};
}

const Triangle_pattern& pattern(int mask) {
  return MP::internal::triangle_pattern((mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0);
}

bool is_halved(int mask, int edge) {
  return (mask >> edge & 1) != 0;
}

} // namespace

TEST_CASE("The children of a triangle fill it, one more than edges are halved") {
  for (int mask = 0; mask < 8; ++mask) {
    CAPTURE(mask);
    const Triangle_pattern& p = pattern(mask);
    CHECK(p.number_of_children == std::size_t(1 + (mask & 1) + (mask >> 1 & 1) + (mask >> 2 & 1)));
    int sum = 0;
    for (std::size_t c = 0; c < p.number_of_children; ++c) {
      CHECK(twice_area(p.children[c]) > 0);
      sum += twice_area(p.children[c]);
    }
    CHECK(sum == 16);
  }
}

TEST_CASE("Siblings share edges, and other edges are those of the parent, or halves of them") {
  for (int mask = 0; mask < 8; ++mask) {
    const Triangle_pattern& p = pattern(mask);
    for (std::size_t c = 0; c < p.number_of_children; ++c)
      for (int i = 0; i < 3; ++i) {
        CAPTURE(mask, c, i);
        const auto& edge = p.children[c].edges[i];
        const std::array<int, 2> own = ends(p.children[c], i);
        if (edge.sibling >= 0) {
          const auto& sibling = p.children[edge.sibling];
          bool is_shared = false;
          for (int j = 0; j < 3; ++j)
            is_shared = is_shared || (sibling.edges[j].sibling == static_cast<int>(c) &&
                                      ends(sibling, j) == std::array<int, 2>{own[1], own[0]});
          CHECK(is_shared);
        } else {
          const int k = edge.parent, start = (k + 1) % 3, middle = 3 + k, end = (k + 2) % 3;
          CHECK(own[0] == (edge.half == 0 ? start : middle));
          CHECK(own[1] == (edge.half == 0 && is_halved(mask, k) ? middle : end));
          CHECK(p.child_on_edge[k][edge.half] == c);
        }
      }
  }
}
