// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_file.h"
#include "model_output.h"

#include <CGAL/Multisided_patches/IO/internal/patch_json_format.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>
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

// Raises the degree of a model, and the number of its layers, to at least what is asked for; what
// has as much already stays.
class Elevate {
public:
  explicit Elevate(const Elevate_options& options) : options_(options) {}

  // Each ribbon for itself.
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
    model.net = MP::elevate_net(model.net, (std::max)(wanted_degree(), model.net.degree()));
    return model;
  }
  Any_model operator()(S_patch_model model) const {
    refuse_layers("an S-patch has none");
    const std::size_t n = model.net.size(), limit = MP::IO::Patch_json_limits::max_control_points;
    if (wanted_degree() > model.net.depth() &&
        S_patch_model::Net::number_of_control_points(n, wanted_degree()) > limit)
      fail("an S-patch with " + std::to_string(n) + " sides and depth " +
           std::to_string(wanted_degree()) + " would have more than " + std::to_string(limit) +
           " control points");
    while (model.net.depth() < wanted_degree())
      model.net = model.net.elevated();
    return model;
  }
  Any_model operator()(const Tensor_product& patch) const {
    refuse_layers("a tensor product patch has none");
    return patch.elevated_to((std::max)(wanted_degree(), patch.degree_u()),
                             (std::max)(wanted_degree(), patch.degree_v()));
  }
  Any_model operator()(const Triangle& patch) const {
    refuse_layers("a Bezier triangle has none");
    return patch.elevated_to((std::max)(wanted_degree(), patch.degree()));
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

  const Elevate_options& options_;
};

// All degrees and numbers of layers.
struct Sizes {
  using Numbers = std::vector<std::size_t>;
  Numbers operator()(const Concave_model& model) const {
    Numbers numbers;
    for (const auto& ribbon : model.loop.ribbons()) {
      numbers.push_back(ribbon.degree());
      numbers.push_back(ribbon.layers());
    }
    return numbers;
  }
  Numbers operator()(const Generalized_model& model) const { return {model.net.degree()}; }
  Numbers operator()(const S_patch_model& model) const { return {model.net.depth()}; }
  Numbers operator()(const Tensor_product& patch) const {
    return {patch.degree_u(), patch.degree_v()};
  }
  Numbers operator()(const Triangle& patch) const { return {patch.degree()}; }
};

// More layers are of little use without the degrees that they need.
void warn_of_shortfalls(const Any_model& model) {
  const std::vector<std::string> texts = contact_shortfalls(model);
  for (const std::string& text : texts)
    std::fprintf(stderr, "multipatch: warning: %s\n", text.c_str());
  const auto* concave = std::get_if<Concave_model>(&model);
  if (texts.empty() || concave == nullptr)
    return;
  const auto needed = MP::degrees_for_contact(concave->loop, concave->central_weight);
  bool helps = false;
  for (std::size_t i = 0; i < needed.size(); ++i)
    helps = helps || needed[i] > concave->loop[i].degree();
  if (helps)
    std::fprintf(stderr, "multipatch: with --degree %zu no degree is missing\n",
                 *std::max_element(needed.begin(), needed.end()));
}

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
  if (options.quiet)
    return;
  print_summary(options.output, result);
  if (std::visit(Sizes(), result) == std::visit(Sizes(), model))
    std::printf("  nothing was raised: the patch has as much already\n");
  if (options.layers)
    warn_of_shortfalls(result);
}

} // namespace multipatch
