// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_COORDINATES_SVG_H
#define MULTIPATCH_COORDINATES_SVG_H

#include "domain_input.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace multipatch {

// Draws isolines of coordinates, a panel for each of the vertices in `drawn`, which are numbered as
// the user does. `values` has those of the first point of the mesh, a number for each of `drawn`,
// then those of the second point, and so on. `name` is that of the coordinates.
void write_coordinates_svg(std::ostream& out, const Domain_input& input, const Domain_mesh& mesh,
                           const std::vector<std::size_t>& drawn, const std::vector<double>& values,
                           const std::string& name);

} // namespace multipatch

#endif // MULTIPATCH_COORDINATES_SVG_H
