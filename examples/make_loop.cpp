// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds the ribbons of an L-shaped hole by hand, fills it, looks at a point, and writes the loop
// and the mesh.

#include <CGAL/Multisided_patches.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;

// The surface around the hole is a saddle. It is straight along the sides and across them, so
// control points on it make ribbons that lie on it.
Point_3 lifted(double x, double y) {
  return Point_3(x, y, 0.3 * x * y);
}

int main() try {
  // Counterclockwise as seen from above, the corner at (1,1) is reflex.
  const std::vector<std::array<double, 2>> plan{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const std::size_t n = plan.size();

  std::vector<MP::Bezier_ribbon_3<Kernel>> ribbons;
  for (std::size_t i = 0; i < n; ++i) {
    const auto &a = plan[i], &b = plan[(i + 1) % n];
    const double dx = (b[0] - a[0]) / 3, dy = (b[1] - a[1]) / 3;
    const double inwards = 0.2 / std::hypot(dx, dy); // row 1 lies to the left of row 0
    std::vector<Point_3> points;                     // row by row, the boundary first
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 4; ++j)
        points.push_back(
            lifted(a[0] + j * dx - k * inwards * dy, a[1] + j * dy + k * inwards * dx));
    ribbons.emplace_back(/* degree */ 3, /* layers */ 2, points);
  }
  const MP::Ribbon_loop_3<Kernel> loop(ribbons);
  MP::IO::write_CGB("l_loop.cgb", loop); // for the program multipatch

  //! [evaluate]
  const MP::Concave_bezier_patch_3<Kernel> patch(loop);
  // Somewhere inside: close to corner 0, which is convex.
  const auto& corner = patch.domain().vertices();
  const Point_2 uv = CGAL::centroid(corner[0], corner[1], corner[5]);
  const auto s = patch.evaluate<1>(uv); // s[c][k]: c = x, y, z; k = value, d/du, d/dv
  std::cout << "point " << patch(uv) << ", d/du " << Vector_3(s[0][1], s[1][1], s[2][1])
            << ", normal " << patch.normal(uv) << '\n';
  // Along side 2, with the location: a rounded point on a side may be outside.
  for (const double t : {0.0, 0.5, 1.0})
    std::cout << "side 2 at " << t << ": " << patch.point_on_side(2, t) << ", normal "
              << patch.normal_on_side(2, t) << '\n';
  //! [evaluate]

  CGAL::Surface_mesh<Point_3> mesh;
  MP::tessellate(patch, mesh, MP::Mesh_density::triangles(5000));
  std::cout << mesh.number_of_faces() << " triangles in l_loop.ply\n";
  return CGAL::IO::write_PLY("l_loop.ply", mesh) ? 0 : 1;
} catch (const MP::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
