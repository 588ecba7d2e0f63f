// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_file.h"
#include "model_output.h"

#include <CGAL/Multisided_patches/IO/internal/patch_json_format.h>
#include <CGAL/Multisided_patches/ribbons/elevate_net.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// Raises the degree of a model, and the number of its layers, to at least what is asked for.
class Elevate {
public:
  explicit Elevate(const Elevate_options& options) : options_(options) {}

  // Each ribbon for itself; those that have as much already stay.
  Any_model operator()(Concave_model model) const {
    std::vector<MP::Bezier_ribbon_3<Kernel>> ribbons;
    for (const auto& ribbon : model.loop.ribbons()) {
      const auto elevated = ribbon.elevated((std::max)(wanted_degree(), ribbon.degree()));
      const std::size_t layers = options_.layers.value_or(ribbon.layers());
      ribbons.push_back(layers > ribbon.layers() ? elevated.with_layers(layers) : elevated);
    }
    model.loop = Loop(std::move(ribbons));
    return model;
  }
  Any_model operator()(Generalized_model model) const {
    refuse_layers("the number of layers follows from the degree");
    require_at_least(model.net.degree(), "degree");
    model.net = MP::elevate_net(model.net, wanted_degree());
    return model;
  }
  Any_model operator()(S_patch_model model) const {
    refuse_layers("an S-patch has none");
    require_at_least(model.net.depth(), "depth");
    const std::size_t n = model.net.size(), limit = MP::IO::Patch_json_limits::max_control_points;
    if (S_patch_model::Net::number_of_control_points(n, wanted_degree()) > limit)
      fail("an S-patch with " + std::to_string(n) + " sides and depth " +
           std::to_string(wanted_degree()) + " would have more than " + std::to_string(limit) +
           " control points");
    while (model.net.depth() < wanted_degree())
      model.net = model.net.elevated();
    return model;
  }
  Any_model operator()(const Tensor_product& patch) const {
    refuse_layers("a tensor product patch has none");
    require_at_least((std::min)(patch.degree_u(), patch.degree_v()), "degree");
    return patch.elevated_to((std::max)(wanted_degree(), patch.degree_u()),
                             (std::max)(wanted_degree(), patch.degree_v()));
  }
  Any_model operator()(const Triangle& patch) const {
    refuse_layers("a Bezier triangle has none");
    require_at_least(patch.degree(), "degree");
    return patch.elevated_to(wanted_degree());
  }

private:
  std::size_t wanted_degree() const { return options_.degree.value_or(1); }

  [[noreturn]] void fail(const std::string& message) const {
    throw MP::Input_error(options_.input + ": " + message);
  }
  void refuse_layers(const std::string& reason) const {
    if (options_.layers)
      fail("--layers is for concave generalized Bezier patches; " + reason);
  }
  void require_at_least(std::size_t degree, const std::string& what) const {
    if (!options_.degree || *options_.degree < degree)
      fail("--degree must be at least " + std::to_string(degree) + ", the " + what +
           " of the patch");
  }

  const Elevate_options& options_;
};

// "degree 5" or "degrees 3 to 5"
std::string range(const std::string& noun, std::size_t low, std::size_t high) {
  return low == high ? noun + ' ' + std::to_string(low)
                     : noun + "s " + std::to_string(low) + " to " + std::to_string(high);
}

void print_summary(const std::string& output, const Any_model& model) {
  std::printf("%s: %s, %zu sides", output.c_str(), type_name(model).c_str(),
              number_of_sides(model));
  if (const auto* concave = std::get_if<Concave_model>(&model)) {
    const auto& ribbons = concave->loop.ribbons();
    const auto [low, high] =
        std::minmax_element(ribbons.begin(), ribbons.end(),
                            [](const auto& a, const auto& b) { return a.degree() < b.degree(); });
    std::printf(", %s", range("degree", low->degree(), high->degree()).c_str());
  }
  std::printf("\n");
}

} // namespace

void elevate_command(const Elevate_options& options) {
  if (!options.degree && !options.layers)
    throw MP::Input_error("--degree or --layers is required");
  check_model_output(options.output, {options.input});
  const Any_model model = read_model_file(options.input);
  if (fitted(model, options.output).index() != model.index())
    throw MP::Input_error(options.output + ": the type of the patch would change; the command "
                                           "convert does that");
  const Any_model result = std::visit(Elevate(options), model);
  const std::string lost = joined(losses(result, model_format(options.output)));
  if (!lost.empty())
    throw MP::Input_error(options.output + ": a file with this name cannot hold " + lost +
                          "; a .patch.json file can");
  write_model_file(options.output, result);
  if (!options.quiet)
    print_summary(options.output, result);
}

} // namespace multipatch
