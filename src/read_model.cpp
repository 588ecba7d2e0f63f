// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>

#include <cstdio>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

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
  if (options.elevate)
    model.loop = MP::elevated_for_contact(model.loop, model.central_weight);
  return model;
}

double degrees(double radians) {
  return radians * 180 / CGAL_PI;
}

void warn_of_mismatches(const Model& model) {
  constexpr double tolerable = 1; // degree
  for (std::size_t i = 0; i < model.loop.size(); ++i) {
    const double mismatch = degrees(model.loop.corner_normal_mismatch(i));
    if (mismatch > tolerable)
      std::fprintf(stderr,
                   "multipatch: warning: the tangent planes of sides %zu and %zu differ by %.1f "
                   "degrees at corner %zu%s\n",
                   model.loop.prev(i), i, mismatch, i,
                   mismatch > 90 ? "; does one of them lead out of the hole?" : "");
  }
}

void print_contact_shortfalls(const Model& model) {
  for (std::size_t i = 0; i < model.loop.size(); ++i) {
    const std::string shortfall = MP::contact_shortfall(model.loop, i, model.central_weight);
    if (!shortfall.empty())
      std::printf("  %s\n", shortfall.c_str());
  }
  const auto degrees = MP::degrees_for_contact(model.loop, model.central_weight);
  for (std::size_t i = 0; i < model.loop.size(); ++i)
    if (model.loop[i].degree() < degrees[i]) {
      std::printf("  multipatch mesh --elevate raises degrees where that helps\n");
      return;
    }
}

void check_index(std::size_t index, std::size_t n, const std::string& option) {
  if (index >= n)
    throw CGAL::Multisided_patches::Input_error(option + " must be less than " + std::to_string(n) +
                                                ", the number of sides, not " +
                                                std::to_string(index));
}

void print_remarks(const CGAL::Multisided_patches::Domain_report& report) {
  for (const auto& remark : report.remarks)
    std::printf("  domain %s: %s\n", to_string(remark.generator), remark.reason.c_str());
}

} // namespace multipatch
