// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "any_model.h"
#include "model_file.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <system_error>
#include <type_traits>
#include <variant>

#include <unistd.h>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// Says on standard error where no surface can meet both ribbons of a corner.
void warn_of_mismatches(const Any_model& model, const std::string& prefix) {
  constexpr double tolerable = 1; // degree
  const auto* concave = std::get_if<Concave_model>(&model);
  if (concave == nullptr) // ribbons that come from one net agree
    return;
  for (std::size_t i = 0; i < concave->loop.size(); ++i) {
    const double mismatch = degrees(concave->loop.corner_normal_mismatch(i));
    if (mismatch <= tolerable)
      continue;
    char angle[40];
    std::snprintf(angle, sizeof angle, "%.1f", mismatch);
    warn(prefix + "the tangent planes of sides " + std::to_string(concave->loop.prev(i)) + " and " +
         std::to_string(i) + " differ by " + angle + " degrees at corner " + std::to_string(i) +
         (mismatch > 90 ? "; does one of them lead out of the hole?" : ""));
  }
}

// The same patch twice has sides in common with itself, which looks as if one of the two were
// inside out.
void refuse_duplicates(const std::vector<std::string>& inputs) {
  std::map<std::filesystem::path, std::string> seen;
  for (const std::string& input : inputs) {
    std::error_code error;
    const auto path = std::filesystem::canonical(input, error);
    const auto [first, is_new] = seen.emplace(error ? std::filesystem::path(input) : path, input);
    if (!is_new)
      throw Usage_error(input + ": the file is given twice" +
                        (first->second == input ? "" : ", first as " + first->second));
  }
}

// Lets the options override what the file says; an option without effect is a misunderstanding,
// which is better cleared up than passed over.
class Override {
public:
  explicit Override(const Patch_options& options) : options_(options) {}

  void operator()(Concave_model& model) const {
    set_plane(model);
    model.central_weight = options_.central_weight.value_or(model.central_weight);
    if (options_.elevate)
      model.loop = MP::elevated_for_contact(model.loop, model.central_weight);
  }
  template <typename Net>
  void operator()(MP::IO::Net_description_3<Kernel, Net>& model) const {
    refuse_concave_options();
    set_plane(model);
  }
  void operator()(Tensor_product&) const { refuse_all("a tensor product patch"); }
  void operator()(Triangle&) const { refuse_all("a Bezier triangle"); }

private:
  template <typename Description>
  void set_plane(Description& model) const {
    const bool has_vertices = !model.domain_vertices.empty();
    refuse(options_.clearance.has_value() && has_vertices && !options_.domain, "--clearance",
           "is for domains that are made; this one is given by its vertices");
    if (options_.domain)
      model.domain_vertices.clear();
    model.domain.generator = options_.domain.value_or(model.domain.generator);
    model.domain.clearance = options_.clearance.value_or(model.domain.clearance);
    model.coordinates = options_.coordinates.value_or(model.coordinates);
  }

  void refuse_concave_options() const {
    const char* reason = "is for concave generalized Bezier patches only";
    refuse(options_.central_weight.has_value(), "--central-weight", reason);
    refuse(options_.elevate, "--elevate", reason);
  }
  void refuse_all(const std::string& type) const {
    refuse_concave_options();
    const std::string reason = "does not apply to " + type;
    refuse(options_.domain.has_value(), "--domain", reason);
    refuse(options_.clearance.has_value(), "--clearance", reason);
    refuse(options_.coordinates.has_value(), "--coordinates", reason);
  }
  void refuse(bool given, const std::string& option, const std::string& reason) const {
    if (given)
      throw MP::Input_error(options_.input + ": " + option + ' ' + reason);
  }

  const Patch_options& options_;
};

} // namespace

Any_model read_model(const Patch_options& options) {
  Any_model model = read_model_file(options.input);
  std::visit(Override(options), model);
  return model;
}

std::vector<Any_model> read_models(Patch_options options, const std::vector<std::string>& inputs,
                                   bool quiet) {
  refuse_duplicates(inputs);
  std::vector<Any_model> models;
  for (const std::string& input : inputs) {
    options.input = input;
    models.push_back(read_model(options));
    if (!quiet)
      warn_of_mismatches(models.back(), inputs.size() > 1 ? input + ": " : "");
  }
  return models;
}

void warn(const std::string& text) {
  // Over the line on which a Stage_clock shows what is running.
  std::fprintf(stderr, "%smultipatch: warning: %s\n", isatty(STDERR_FILENO) ? "\r\033[K" : "",
               text.c_str());
}

void check_different(const std::string& output, const std::vector<std::string>& others) {
  try {
    for (const std::string& other : others)
      MP::internal::check_different(output, other);
  } catch (const MP::Input_error& error) {
    throw Usage_error(error.what());
  }
}

double degrees(double radians) {
  return radians * 180 / CGAL_PI;
}

void check_index(std::size_t index, std::size_t n, const std::string& option) {
  if (index >= n)
    throw MP::Input_error(option + " must be less than " + std::to_string(n) +
                          ", the number of sides, not " + std::to_string(index));
}

const char* domain_name(const MP::Domain_report& report) {
  // Where a generator is asked for, the report tells which one was used in the end.
  return report.used == MP::Domain_generator::automatic ? "given" : to_string(report.used);
}

std::string clearance_text(const MP::Domain_report& report) {
  if (!std::isfinite(report.clearance))
    return "clearance unlimited";
  char text[40];
  std::snprintf(text, sizeof text, "clearance %.3g", report.clearance);
  return text;
}

std::vector<std::string> remarks(const MP::Domain_report& report) {
  std::vector<std::string> texts;
  for (const auto& remark : report.remarks)
    texts.push_back(std::string("domain ") + to_string(remark.generator) + ": " + remark.reason);
  return texts;
}

void warn_of_remarks(const MP::Domain_report& report, const std::string& prefix) {
  for (const std::string& remark : remarks(report))
    warn(prefix + remark);
}

} // namespace multipatch
