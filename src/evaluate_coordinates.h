// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_EVALUATE_COORDINATES_H
#define MULTIPATCH_EVALUATE_COORDINATES_H

#include "any_coordinates.h"

#include <cstddef>
#include <vector>

namespace multipatch {

struct Located_point {
  Kernel::Point_2 point;
  Domain::Location location;
};

// A coordinate with its derivatives up to an order: value, u, v, uu, uv, vv.
constexpr std::size_t number_of_parts(int derivatives) {
  return derivatives == 0 ? 1 : derivatives == 1 ? 3 : 6;
}

// All parts of the coordinates of some vertices of the domain, point after point, vertex after
// vertex. Not a number outside the domain, and where there is no derivative. Throws
// Numerical_error if the computation breaks down at a point inside.
std::vector<double> evaluate(const Any_coordinates& coordinates,
                             const std::vector<std::size_t>& vertices, int derivatives,
                             const std::vector<Located_point>& points);

} // namespace multipatch

#endif // MULTIPATCH_EVALUATE_COORDINATES_H
