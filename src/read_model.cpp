// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include <CGAL/Multisided_patches/IO/CGB.h>

namespace multipatch {

const char* to_string(Coordinates_choice choice) {
  switch (choice) {
  case Coordinates_choice::harmonic:
    return "harmonic";
  case Coordinates_choice::mean_value:
    return "mean-value";
  case Coordinates_choice::wachspress:
    return "wachspress";
  }
  return "";
}

Model read_model(const Patch_options& options) {
  Model model = CGAL::Multisided_patches::IO::read_CGB<Kernel>(options.input);
  model.domain.generator = options.domain.value_or(model.domain.generator);
  model.domain.clearance = options.clearance.value_or(model.domain.clearance);
  model.central_weight = options.central_weight.value_or(model.central_weight);
  return model;
}

} // namespace multipatch
