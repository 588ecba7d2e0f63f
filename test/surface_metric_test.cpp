// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "linked_mesh_fixtures.h"

#include <CGAL/Multisided_patches/meshing/internal/Surface_metric.h>

#include <cstddef>
#include <vector>

using namespace fixtures;
using namespace MP::internal;

namespace {

// A comb: columns of squares, which are joined along the lowest row only. The surface is the domain
// itself.
Sampled_mesh comb(std::size_t n) {
  const Bordered_grid all(n);
  constexpr std::size_t none = Linked_triangle::none;
  const auto is_kept = [&](std::size_t t) { // every second column, and the lowest row
    const std::size_t square = t / 2;
    return square % n % 2 == 0 || square / n == 0;
  };
  std::vector<std::size_t> number(all.triangles.size(), none);
  std::size_t count = 0;
  for (std::size_t t = 0; t < number.size(); ++t)
    if (is_kept(t))
      number[t] = count++;
  Sampled_mesh mesh;
  for (std::size_t t = 0; t < number.size(); ++t) {
    if (!is_kept(t))
      continue;
    Linked_triangle triangle = all.triangles[t];
    for (auto& other : triangle.neighbors)
      if (other != none)
        other = static_cast<Linked_triangle::Index>(number[other]);
    mesh.triangles.push_back(triangle);
  }
  for (const auto& [i, j] : all.vertices) {
    mesh.uv.push_back({static_cast<double>(i), static_cast<double>(j)});
    mesh.positions.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  }
  return mesh;
}

} // namespace

TEST_CASE("The metric at a point is that of the triangle with it, wherever the search starts") {
  const Sampled_mesh mesh = comb(9);
  Surface_metric metric(mesh);
  // Another length at every vertex.
  std::vector<double> lengths;
  for (std::size_t k = 0; k < mesh.uv.size(); ++k)
    lengths.push_back(1 + 0.1 * static_cast<double>(k));
  metric.set_edge_lengths(lengths);
  REQUIRE(is_linked_well(mesh.triangles));
  for (std::size_t to = 0; to < mesh.triangles.size(); ++to) {
    const auto& v = mesh.triangles[to].vertices;
    const Uv p = 0.5 * mesh.uv[v[0]] + 0.3 * mesh.uv[v[1]] + 0.2 * mesh.uv[v[2]];
    std::size_t hint = to;
    const Metric_2 expected = metric(p, hint);
    REQUIRE(hint == to);
    for (std::size_t from = 0; from < mesh.triangles.size(); ++from) {
      CAPTURE(from, to);
      hint = from;
      const Metric_2 found = metric(p, hint);
      CHECK(hint == to);
      CHECK((found.E == expected.E && found.F == expected.F && found.G == expected.G));
    }
  }
}

TEST_CASE("The metric at a point that rounding has put outside is that next to it") {
  const Sampled_mesh mesh = comb(9);
  const Surface_metric metric(mesh);
  for (std::size_t from = 0; from < mesh.triangles.size(); ++from) {
    CAPTURE(from);
    std::size_t hint = from;
    metric({3 + 1e-14, 4.25}, hint); // the third column ends at 3
    const auto& v = mesh.triangles[hint].vertices;
    const Uv centroid = 1. / 3 * (mesh.uv[v[0]] + mesh.uv[v[1]] + mesh.uv[v[2]]);
    CHECK((centroid.x > 2 && centroid.x < 3 && centroid.y > 4 && centroid.y < 5));
  }
}
