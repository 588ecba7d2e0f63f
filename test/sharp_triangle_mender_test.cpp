// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "linked_mesh_fixtures.h"
#include "meshing_fixtures.h"

#include <CGAL/Multisided_patches/meshing/internal/Deviation_meter.h>
#include <CGAL/Multisided_patches/meshing/internal/Scaled_surface.h>
#include <CGAL/Multisided_patches/meshing/internal/Sharp_triangle_mender.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

using namespace fixtures;
using namespace MP::internal;

namespace {

// A parabolic cylinder over the unit square, sheared.
auto sheared_cylinder(double shear) {
  return Formula_patch(Domain({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), [shear](auto u, auto v) {
    return std::array{u + shear * v, 1.5 * v, 0.7 * v * v};
  });
}

// A grid of n x n squares over the unit square, with points inside that are off their places at
// random. The vertices on the boundary come first.
template <typename Surface>
Sampled_mesh random_grid(const Surface& surface, std::size_t n, Random& random) {
  const Bordered_grid grid(n);
  Sampled_mesh mesh;
  mesh.triangles = grid.triangles;
  const double h = 1 / static_cast<double>(n);
  for (std::size_t k = 0; k < grid.vertices.size(); ++k) {
    const auto off = [&] { return k < grid.border ? 0. : random.in(-0.3, 0.3); };
    mesh.uv.push_back({h * (static_cast<double>(grid.vertices[k][0]) + off()),
                       h * (static_cast<double>(grid.vertices[k][1]) + off())});
    mesh.positions.push_back(surface.position(mesh.uv[k]));
  }
  return mesh;
}

std::vector<double> sorted_smallest_angles(const Sampled_mesh& mesh) {
  std::vector<double> angles;
  for (const Linked_triangle& t : mesh.triangles) {
    double smallest = 180;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = mesh.positions[t.vertices[i]];
      const Vec3 a = difference(mesh.positions[t.vertices[(i + 1) % 3]], p),
                 b = difference(mesh.positions[t.vertices[(i + 2) % 3]], p);
      smallest = (std::min)(smallest, angle_between(a, b) * 180 / pi);
    }
    angles.push_back(smallest);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

bool has_positive_triangles(const Sampled_mesh& mesh) {
  const auto point = [&](std::size_t v) { return Point_2(mesh.uv[v].x, mesh.uv[v].y); };
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Linked_triangle& t) {
    return CGAL::orientation(point(t.vertices[0]), point(t.vertices[1]), point(t.vertices[2])) ==
           CGAL::LEFT_TURN;
  });
}

} // namespace

TEST_CASE("Mended meshes are less sharp, linked well, and the same along the boundary") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::size_t n = 12, boundary = 4 * n;
  const unsigned int seed = 20261123;
  CAPTURE(seed);
  Random random(seed);
  for (int k = 0; k < 20; ++k) {
    const auto patch = sheared_cylinder(random.in(-1, 1));
    using Surface = Scaled_surface<std::decay_t<decltype(patch)>>;
    const Surface surface(patch);
    // Half of the times deviations are bounded, too, by what they are at first or a little more.
    Sampled_mesh mesh = random_grid(surface, n, random);
    const Deviation_meter<Surface> free_meter(surface, 1, 180, 1);
    double chordal = 0;
    for (const Linked_triangle& t : mesh.triangles)
      chordal = (std::max)(chordal, free_meter(mesh, t).chordal);
    const double bound = k % 2 == 0 ? infinity : chordal / 0.95;
    const Deviation_meter<Surface> meter(surface, bound, infinity, 1);

    const Sampled_mesh old = mesh;
    std::vector<Point_2> points;
    for (const Uv& p : mesh.uv)
      points.emplace_back(p.x, p.y);
    Sharp_triangle_mender<Surface, Deviation_meter<Surface>>(surface, meter, mesh, points, boundary)
        .mend([] {});
    CAPTURE(k, bound);
    CHECK(is_linked_well(mesh.triangles));
    CHECK(has_positive_triangles(mesh));
    for (std::size_t v = 0; v < mesh.uv.size(); ++v) {
      const bool is_same = mesh.uv[v].x == old.uv[v].x && mesh.uv[v].y == old.uv[v].y;
      CHECK((is_same || v >= boundary));
      CHECK(mesh.positions[v] == (is_same ? old.positions[v] : surface.position(mesh.uv[v])));
      CHECK(points[v] == Point_2(mesh.uv[v].x, mesh.uv[v].y));
    }
    for (const Linked_triangle& t : mesh.triangles)
      CHECK(free_meter(mesh, t).chordal <= bound);
    const std::vector<double> before = sorted_smallest_angles(old),
                              after = sorted_smallest_angles(mesh);
    REQUIRE(before.front() < 20);
    CHECK(after.front() >= before.front());
    // Of those below 15 degrees no more than half are left.
    const auto sharp = [](const std::vector<double>& angles) {
      return std::lower_bound(angles.begin(), angles.end(), 15) - angles.begin();
    };
    CHECK(2 * sharp(after) <= sharp(before));
  }
}
