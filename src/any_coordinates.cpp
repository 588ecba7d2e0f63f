// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "any_coordinates.h"

namespace multipatch {

namespace {

namespace MP = CGAL::Multisided_patches;

using Harmonic = MP::Harmonic_coordinates_2<Kernel>;
using Mean_value = MP::Mean_value_coordinates_2<Kernel>;
using Wachspress = MP::Wachspress_coordinates_2<Kernel>;

} // namespace

Any_coordinates make_coordinates(Coordinates_choice choice, const Domain& domain,
                                 double target_error, double acceptable_error) {
  switch (choice) {
  case Coordinates_choice::mean_value:
    return Any_coordinates(std::in_place_type<Mean_value>, domain);
  case Coordinates_choice::wachspress:
    return Any_coordinates(std::in_place_type<Wachspress>, domain);
  default:
    return Any_coordinates(std::in_place_type<Harmonic>, domain, target_error, acceptable_error);
  }
}

std::optional<double> error_bound(const Any_coordinates& coordinates) {
  if (const auto* harmonic = std::get_if<Harmonic>(&coordinates))
    return harmonic->error_bound();
  return std::nullopt;
}

} // namespace multipatch
