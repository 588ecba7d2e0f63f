// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_file.h"
#include "model_output.h"

#include <CGAL/Multisided_patches/ribbons/internal/net_quads.h>
#include <CGAL/Multisided_patches/ribbons/merge_loops.h>

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
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

// What a file says beyond ribbons. What patches of its type do not have, or a .gbp file cannot say,
// is missing: it contradicts nothing.
struct Given_options {
  std::optional<MP::Central_weight> central_weight;
  std::optional<MP::Domain_generator> generator;
  std::optional<double> clearance;
  std::optional<Coordinates_choice> coordinates;
  std::optional<double> parameter_dilation, reflex_weight;
  // what belongs to the place of one patch, and has none in the other
  bool central_point = false, corner_points = false, vertices = false;
};

class Collect_options {
public:
  explicit Collect_options(Model_format format) : format_(format) {}

  Given_options operator()(const Concave_model& m) const {
    Given_options given;
    given.central_weight = m.central_weight;
    given.parameter_dilation = m.parameter_dilation;
    given.reflex_weight = m.reflex_weight;
    given.central_point = m.central_point && m.central_weight != MP::Central_weight::none;
    given.corner_points = !m.corner_control_points.empty();
    set_plane(m, given);
    return given;
  }
  Given_options operator()(const Generalized_model& m) const {
    Given_options given;
    given.central_point =
        MP::internal::Middle_weights<double>(m.net.size(), m.net.degree()).central_point_matters();
    if (format_ != Model_format::gbp)
      set_plane(m, given);
    return given;
  }
  Given_options operator()(const S_patch_model& m) const {
    Given_options given;
    set_plane(m, given);
    return given;
  }
  Given_options operator()(const Tensor_product&) const { return {}; }
  Given_options operator()(const Triangle&) const { return {}; }

private:
  template <typename Description>
  static void set_plane(const Description& m, Given_options& given) {
    given.coordinates = m.coordinates;
    given.vertices = !m.domain_vertices.empty();
    if (given.vertices) // there is nothing to make
      return;
    given.generator = m.domain.generator;
    given.clearance = m.domain.clearance;
  }

  Model_format format_;
};

Given_options options_of(const Any_model& model, const std::string& file_name) {
  return std::visit(Collect_options(model_format(file_name)), model);
}

// The merged ribbons with the options that one patch gives, or on which both agree; the others get
// their defaults, and their names are collected.
class Merge_choices {
public:
  Merge_choices(Given_options a, Given_options b) : a_(std::move(a)), b_(std::move(b)) {}

  Concave_model model(const Loop& loop) {
    Concave_model result{MP::Concave_bezier_model_3<Kernel>(loop)};
    keep("the central weight", &Given_options::central_weight, result.central_weight);
    keep("the domain generator", &Given_options::generator, result.domain.generator);
    keep("the clearance", &Given_options::clearance, result.domain.clearance);
    keep("the coordinates", &Given_options::coordinates, result.coordinates);
    keep("the parameter dilation", &Given_options::parameter_dilation, result.parameter_dilation);
    keep("the reflex weight", &Given_options::reflex_weight, result.reflex_weight);
    if (result.coordinates == Coordinates_choice::wachspress && !has_convex_domain(result)) {
      result.coordinates = Coordinates_choice::harmonic;
      dropped_.emplace_back("wachspress coordinates, which need a convex domain");
    }
    return result;
  }

  // The options on which the patches do not agree.
  const std::vector<std::string>& disagreements() const { return lost_; }

  std::vector<std::string> dropped() const {
    std::vector<std::string> names = dropped_;
    if (a_.central_point || b_.central_point)
      names.emplace_back("central control points");
    if (a_.corner_points || b_.corner_points)
      names.emplace_back("corner control points");
    if (a_.vertices || b_.vertices)
      names.emplace_back("vertices of domains");
    return names;
  }

private:
  template <typename T>
  void keep(const char* name, std::optional<T> Given_options::*option, T& value) {
    const std::optional<T>&of_a = a_.*option, &of_b = b_.*option;
    if (of_a && of_b && *of_a != *of_b)
      lost_.emplace_back(name);
    else
      value = of_a.value_or(of_b.value_or(value));
  }

  static bool has_convex_domain(const Concave_model& model) {
    const Domain domain = make_domain(Any_model(model)).domain;
    for (std::size_t i = 0; i < domain.size(); ++i)
      if (domain.corner_type(i) != MP::Corner_type::convex)
        return false;
    return true;
  }

  Given_options a_, b_;
  std::vector<std::string> lost_, dropped_;
};

// The control points of an S-patch inside, which make its tangent planes, are not in its ribbons.
void warn_of_missing_tangent_planes(const std::string& input, const Any_model& model) {
  if (std::holds_alternative<S_patch_model>(model))
    std::fprintf(stderr,
                 "multipatch: warning: %s: the sides of an S-patch have one layer: its boundary "
                 "curves are taken over, and not its tangent planes\n",
                 input.c_str());
}

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
  Merge_choices choices(options_of(a, options.input_a), options_of(b, options.input_b));
  const Any_model model = choices.model(merged.loop);
  const std::string lost = joined(losses(model, model_format(options.output)));
  if (!lost.empty())
    throw MP::Input_error(options.output + ": a file with this name cannot hold " + lost +
                          "; a .patch.json file can");
  write_model_file(options.output, model);
  if (options.quiet)
    return;
  warn_of_losses(choices);
  warn_of_missing_tangent_planes(options.input_a, a);
  warn_of_missing_tangent_planes(options.input_b, b);
  for (const std::string& text : contact_shortfalls(model))
    std::fprintf(stderr, "multipatch: warning: %s\n", text.c_str());
  print_summary(options, merged);
}

} // namespace multipatch
