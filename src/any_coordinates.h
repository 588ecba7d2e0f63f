// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_ANY_COORDINATES_H
#define MULTIPATCH_ANY_COORDINATES_H

#include "commands.h"

#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>

#include <optional>
#include <variant>

namespace multipatch {

// The coordinates that a user has chosen.
using Any_coordinates = std::variant<CGAL::Multisided_patches::Harmonic_coordinates_2<Kernel>,
                                     CGAL::Multisided_patches::Mean_value_coordinates_2<Kernel>,
                                     CGAL::Multisided_patches::Wachspress_coordinates_2<Kernel>>;

constexpr double default_target_error = 1e-8;

// The errors are those of harmonic coordinates, what is wanted and, if it is larger, what will do;
// others are as exact as their formulas.
Any_coordinates make_coordinates(Coordinates_choice choice, const Domain& domain,
                                 double target_error = default_target_error,
                                 double acceptable_error = 0);

// That of harmonic coordinates; others have none.
std::optional<double> error_bound(const Any_coordinates& coordinates);

} // namespace multipatch

#endif // MULTIPATCH_ANY_COORDINATES_H
