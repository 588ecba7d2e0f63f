// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_DISC_CENTRING_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_DISC_CENTRING_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Candidate_finder.h>

#include <algorithm>
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
// What counts as a gain is far above rounding, so that no steps lead back and forth.
//
// The triangles stay on this side of all sides that cross the disc (see Candidate_finder): inside,
// the centre stays in one of them; on a side, a side that came between would also have been between
// them and the centre before the step, which is shorter than the radius.
class Disc_centring {
public:
  Disc_centring(const Boundary& boundary, const std::vector<Triangle_points>& triangles)
      : boundary_(boundary), triangles_(triangles) {}

  void improve(Candidate& c) const {
    constexpr int halvings = 3;
    double step = farthest(triangles_, c.centre) / 4;
    for (int i = 0; i < halvings; step /= 2, ++i)
      while (c.kind == Candidate::Kind::side ? step_along_side(c, step) : step_inside(c, step)) {
      }
  }

private:
  // whether a step in some direction gains

  bool step_along_side(Candidate& c, double step) const {
    const Complex &source = boundary_.vertex(c.index), &d = boundary_.direction(c.index);
    for (const double s : {step, -step}) {
      const double x = dot(c.centre - source, d) + s;
      if (0 < x && x < boundary_.length(c.index) &&
          gains(c, source + x * d, side_radius(boundary_, c.index, source + x * d)))
        return true;
    }
    return false;
  }

  bool step_inside(Candidate& c, double step) const {
    for (const Complex& d : {Complex(1, 0), Complex(-1, 0), Complex(0, 1), Complex(0, -1)}) {
      const Complex centre = c.centre + step * d;
      if (is_inside(centre) && gains(c, centre, interior_radius(boundary_, centre)))
        return true;
    }
    return false;
  }

  // replaces the centre if the series converges faster around another
  bool gains(Candidate& c, const Complex& centre, double radius) const {
    constexpr double worthwhile = 0.999;
    if (!(farthest(triangles_, centre) * c.radius <
          worthwhile * farthest(triangles_, c.centre) * radius))
      return false;
    c.centre = centre;
    c.radius = radius;
    return true;
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
