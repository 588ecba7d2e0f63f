// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_DISC_CENTRING_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_DISC_CENTRING_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Candidate_finder.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// Moves the disc of an interior cell or one on a side to where its series converges fastest on the
// triangles that the cell got, which were chosen for the centre it had.
//
// A pattern search: in steps of a fixed length while these gain, then of half that length. Hooke
// and Jeeves, "'Direct search' solution of numerical and statistical problems", J. ACM 8 (1961).
class Disc_centring {
public:
  Disc_centring(const Boundary& boundary, const std::vector<Triangle_points>& triangles)
      : boundary_(boundary), triangles_(triangles) {}

  void improve(Candidate& c) const {
    constexpr int halvings = 3;
    double step = farthest(triangles_, c.centre) / 4;
    for (int i = 0; i < halvings; step /= 2, ++i)
      while (make_step(c, step)) {
      }
  }

private:
  // whether a step in some direction gains
  bool make_step(Candidate& c, double step) const {
    const bool on_side = c.kind == Candidate::Kind::side;
    const Complex d = on_side ? boundary_.direction(c.index) : 1;
    const std::array<Complex, 4> directions{d, -d, Complex(0, 1), Complex(0, -1)};
    const double ratio = farthest(triangles_, c.centre) / c.radius;
    for (int i = 0; i < (on_side ? 2 : 4); ++i) {
      const Complex centre = c.centre + step * directions[i];
      if (!(on_side ? is_on_side(c.index, centre) : is_inside(centre)))
        continue;
      const double radius =
          on_side ? side_radius(boundary_, c.index, centre) : interior_radius(boundary_, centre);
      if (farthest(triangles_, centre) < ratio * radius) {
        c.centre = centre;
        c.radius = radius;
        return true;
      }
    }
    return false;
  }

  bool is_on_side(std::size_t e, const Complex& z) const {
    const double x = dot(z - boundary_.vertex(e), boundary_.direction(e));
    return 0 < x && x < boundary_.length(e);
  }

  bool is_inside(const Complex& z) const {
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const Triangle_points& t) {
      return turn(t[0], t[1], z) >= 0 && turn(t[1], t[2], z) >= 0 && turn(t[2], t[0], z) >= 0;
    });
  }

  const Boundary& boundary_;
  const std::vector<Triangle_points>& triangles_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_DISC_CENTRING_H
