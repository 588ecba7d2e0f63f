// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CELL_LOCATOR_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CELL_LOCATOR_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Bisection_mesh.h>

#include <limits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// Finds the cell of a point: first the triangle of the initial triangulation, then down the tree of
// bisections, whose branches end as soon as they lie in one cell.
class Cell_locator {
public:
  Cell_locator() = default;
  Cell_locator(const Bisection_mesh& mesh, const std::vector<std::size_t>& cell_of) {
    for (std::size_t t = 0; t < mesh.number_of_roots(); ++t)
      roots_.push_back({mesh.corners(t), branch(mesh, cell_of, t)});
  }

  // Any point gets a cell: one that no triangle contains, through rounding, gets the nearest.
  std::size_t operator()(const Complex& z) const {
    std::ptrdiff_t b = root(z);
    while (b >= 0) {
      const Cut& cut = cuts_[b];
      b = cut.branch[turn(cut.apex, cut.midpoint, z) > 0];
    }
    return static_cast<std::size_t>(-1 - b);
  }

private:
  // A branch is the index of a cut or, if negative, -1 - the cell.
  struct Root {
    std::array<Complex, 3> corners;
    std::ptrdiff_t branch;
  };
  struct Cut {
    Complex apex, midpoint;
    std::ptrdiff_t branch[2]; // right and left of the line from the apex to the midpoint
  };

  std::ptrdiff_t branch(const Bisection_mesh& mesh, const std::vector<std::size_t>& cell_of,
                        std::size_t t) {
    const Bisection_mesh::Triangle& triangle = mesh.triangle(t);
    if (triangle.is_leaf())
      return -1 - static_cast<std::ptrdiff_t>(cell_of[t]);
    const std::ptrdiff_t right = branch(mesh, cell_of, triangle.child[0]),
                         left = branch(mesh, cell_of, triangle.child[1]);
    if (right == left && right < 0)
      return right;
    cuts_.push_back({mesh.point(triangle.apex), mesh.point(triangle.midpoint), {right, left}});
    return static_cast<std::ptrdiff_t>(cuts_.size()) - 1;
  }

  std::ptrdiff_t root(const Complex& z) const {
    for (const Root& r : roots_)
      if (turn(r.corners[0], r.corners[1], z) >= 0 && turn(r.corners[1], r.corners[2], z) >= 0 &&
          turn(r.corners[2], r.corners[0], z) >= 0)
        return r.branch;
    double nearest = std::numeric_limits<double>::infinity();
    std::ptrdiff_t result = roots_.front().branch;
    for (const Root& r : roots_)
      for (int i = 0; i < 3; ++i) {
        const double d = squared_distance(z, {r.corners[i], r.corners[(i + 1) % 3]});
        if (d < nearest) {
          nearest = d;
          result = r.branch;
        }
      }
    return result;
  }

  std::vector<Root> roots_;
  std::vector<Cut> cuts_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CELL_LOCATOR_H
