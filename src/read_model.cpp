// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>

#include <algorithm>
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

namespace {

// Says on standard error where no surface can meet both ribbons of a corner.
void warn_of_mismatches(const Model& model, const std::string& prefix) {
  constexpr double tolerable = 1; // degree
  for (std::size_t i = 0; i < model.loop.size(); ++i) {
    const double mismatch = degrees(model.loop.corner_normal_mismatch(i));
    if (mismatch > tolerable)
      std::fprintf(stderr,
                   "multipatch: warning: %sthe tangent planes of sides %zu and %zu differ by %.1f "
                   "degrees at corner %zu%s\n",
                   prefix.c_str(), model.loop.prev(i), i, mismatch, i,
                   mismatch > 90 ? "; does one of them lead out of the hole?" : "");
  }
}

bool elevation_helps(const Model& model) {
  const auto degrees = MP::degrees_for_contact(model.loop, model.central_weight);
  for (std::size_t i = 0; i < model.loop.size(); ++i)
    if (model.loop[i].degree() < degrees[i])
      return true;
  return false;
}

} // namespace

Model read_model(const Patch_options& options) {
  Model model = CGAL::Multisided_patches::IO::read_CGB<Kernel>(options.input);
  model.domain.generator = options.domain.value_or(model.domain.generator);
  model.domain.clearance = options.clearance.value_or(model.domain.clearance);
  model.central_weight = options.central_weight.value_or(model.central_weight);
  if (options.elevate)
    model.loop = MP::elevated_for_contact(model.loop, model.central_weight);
  return model;
}

std::vector<Model> read_models(Patch_options options, const std::vector<std::string>& inputs,
                               bool quiet) {
  std::vector<Model> models;
  for (const std::string& input : inputs) {
    options.input = input;
    models.push_back(read_model(options));
    if (!quiet)
      warn_of_mismatches(models.back(), inputs.size() > 1 ? input + ": " : "");
  }
  return models;
}

double degrees(double radians) {
  return radians * 180 / CGAL_PI;
}

std::vector<std::string> contact_shortfalls(const Model& model) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < model.loop.size(); ++i) {
    const std::string text = MP::contact_shortfall(model.loop, i, model.central_weight);
    if (!text.empty())
      texts.push_back(text);
  }
  return texts;
}

void print_contact_shortfalls(const std::vector<Model>& models,
                              const std::vector<std::string>& prefixes) {
  for (std::size_t k = 0; k < models.size(); ++k)
    for (const std::string& text : contact_shortfalls(models[k]))
      std::printf("%s%s\n", prefixes[k].c_str(), text.c_str());
  if (std::any_of(models.begin(), models.end(), elevation_helps))
    std::printf("  multipatch mesh --elevate raises degrees where that helps\n");
}

void check_index(std::size_t index, std::size_t n, const std::string& option) {
  if (index >= n)
    throw CGAL::Multisided_patches::Input_error(option + " must be less than " + std::to_string(n) +
                                                ", the number of sides, not " +
                                                std::to_string(index));
}

void print_remarks(const CGAL::Multisided_patches::Domain_report& report,
                   const std::string& prefix) {
  for (const auto& remark : report.remarks)
    std::printf("%sdomain %s: %s\n", prefix.c_str(), to_string(remark.generator),
                remark.reason.c_str());
}

} // namespace multipatch
