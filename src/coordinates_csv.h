// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_COORDINATES_CSV_H
#define MULTIPATCH_COORDINATES_CSV_H

#include "evaluate_coordinates.h"
#include "stage_clock.h"

#include <cstddef>
#include <functional>
#include <ostream>
#include <vector>

namespace multipatch {

// Gives the next point, or returns false if there is none.
using Point_source = std::function<bool(Located_point&)>;

// Writes a table with the columns u,v,lambda_0,lambda_1,... and then the derivatives up to an
// order: lambda_0_u,lambda_0_v,...,lambda_1_u,... `vertices` are those of the domain in the order
// of the columns. Rows are computed and written block by block, so that large tables need little
// memory. Returns the number of rows.
std::size_t write_coordinates_csv(std::ostream& out, const Any_coordinates& coordinates,
                                  const std::vector<std::size_t>& vertices, int derivatives,
                                  const Point_source& next, Stage_clock& clock);

} // namespace multipatch

#endif // MULTIPATCH_COORDINATES_CSV_H
