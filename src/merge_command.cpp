// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_file.h"
#include "model_output.h"

#include <CGAL/Multisided_patches/ribbons/merge_loops.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <variant>
#include <vector>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

using Merged = MP::Merged_loop_3<Kernel>;

std::string source_text(const Merge_options& options, const Merged::Source& source) {
  const std::string& input = source.loop == 0 ? options.input_a : options.input_b;
  std::string text = input + " side " + std::to_string(source.side);
  if (source.begin != 0 || source.end != 1) {
    char part[80];
    std::snprintf(part, sizeof part, " from s = %g to %g", source.begin, source.end);
    text += part;
  }
  return text;
}

void print_summary(const Merge_options& options, const Merged& merged) {
  const Loop& loop = merged.loop;
  std::printf("%s: %zu sides; corners: %zu convex, %zu reflex, %zu straight\n",
              options.output.c_str(), loop.size(), loop.number_of_corners(MP::Corner_type::convex),
              loop.number_of_corners(MP::Corner_type::reflex),
              loop.number_of_corners(MP::Corner_type::straight));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    std::printf("  side %zu: ", i);
    const char* separator = "";
    for (const Merged::Source& source : merged.sources[i]) {
      std::printf("%s%s", separator, source_text(options, source).c_str());
      separator = " and ";
    }
    std::printf("\n");
  }
}

// What a model says beyond its ribbons; patches of other types have none of it.
const Concave_model* options_of(const Any_model& model) {
  return std::get_if<Concave_model>(&model);
}

// The merged ribbons with the options on which both patches agree; the others get their defaults,
// and their names are collected.
class Merge_choices {
public:
  Merge_choices(const Any_model& a, const Any_model& b) : a_(options_of(a)), b_(options_of(b)) {}

  Concave_model model(const Loop& loop) {
    Concave_model result{MP::Concave_bezier_model_3<Kernel>(loop)};
    const Concave_model defaults = result;
    const auto keep = [&](const char* name, auto member) {
      const auto& of_a = member(a_ == nullptr ? defaults : *a_);
      const auto& of_b = member(b_ == nullptr ? defaults : *b_);
      if (of_a == of_b)
        member(result) = of_a;
      else
        lost_.emplace_back(name);
    };
    keep(
        "the central weight", [](auto& m) -> auto& { return m.central_weight; });
    keep(
        "the domain generator", [](auto& m) -> auto& { return m.domain.generator; });
    keep(
        "the clearance", [](auto& m) -> auto& { return m.domain.clearance; });
    keep(
        "the coordinates", [](auto& m) -> auto& { return m.coordinates; });
    keep(
        "the parameter dilation", [](auto& m) -> auto& { return m.parameter_dilation; });
    keep(
        "the reflex weight", [](auto& m) -> auto& { return m.reflex_weight; });
    return result;
  }

  // The options on which the patches do not agree.
  const std::vector<std::string>& disagreements() const { return lost_; }

  // What belongs to the place of one patch, and has none in the other.
  std::vector<std::string> dropped() const {
    std::vector<std::string> names;
    const auto any = [&](const auto& has) {
      return (a_ != nullptr && has(*a_)) || (b_ != nullptr && has(*b_));
    };
    if (any([](const Concave_model& m) {
          return m.central_point && m.central_weight != MP::Central_weight::none;
        }))
      names.emplace_back("central control points");
    if (any([](const Concave_model& m) { return !m.corner_control_points.empty(); }))
      names.emplace_back("corner control points");
    if (any([](const Concave_model& m) { return !m.domain_vertices.empty(); }))
      names.emplace_back("vertices of domains");
    return names;
  }

private:
  const Concave_model *a_, *b_;
  std::vector<std::string> lost_;
};

void warn_of_losses(const Merge_choices& choices) {
  const std::string lost = joined(choices.disagreements()), dropped = joined(choices.dropped());
  if (!lost.empty())
    std::fprintf(stderr,
                 "multipatch: warning: the patches do not agree on %s; the merged patch has the "
                 "default\n",
                 lost.c_str());
  if (!dropped.empty())
    std::fprintf(stderr, "multipatch: warning: not taken over: %s\n", dropped.c_str());
}

} // namespace

void merge_command(const Merge_options& options) {
  check_model_output(options.output, {options.input_a, options.input_b});
  if (model_format(options.output) == Model_format::gbp)
    throw MP::Input_error(options.output + ": expected a name that ends in .cgb or .patch.json");
  const Any_model a = read_model_file(options.input_a), b = read_model_file(options.input_b);
  const Merged merged = MP::merge_loops(loop(a), loop(b));
  Merge_choices choices(a, b);
  const Any_model model = choices.model(merged.loop);
  const std::string lost = joined(losses(model, model_format(options.output)));
  if (!lost.empty())
    throw MP::Input_error(options.output + ": a file with this name cannot hold " + lost +
                          "; a .patch.json file can");
  write_model_file(options.output, model);
  if (options.quiet)
    return;
  warn_of_losses(choices);
  print_summary(options, merged);
}

} // namespace multipatch
