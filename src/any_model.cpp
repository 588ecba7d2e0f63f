// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "any_model.h"

#include <CGAL/Multisided_patches/IO/visit_patch.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// How each type of patch answers.
struct Number_of_sides {
  std::size_t operator()(const Concave_model& m) const { return m.loop.size(); }
  std::size_t operator()(const Generalized_model& m) const { return m.net.size(); }
  std::size_t operator()(const S_patch_model& m) const { return m.net.size(); }
  std::size_t operator()(const Tensor_product&) const { return 4; }
  std::size_t operator()(const Triangle&) const { return 3; }
};

struct Ribbons {
  Loop operator()(const Concave_model& m) const { return m.loop; }
  Loop operator()(const Generalized_model& m) const { return m.net.loop(); }
  Loop operator()(const S_patch_model& m) const { return m.net.loop(); }
  Loop operator()(const Tensor_product& patch) const { return patch.loop(); }
  Loop operator()(const Triangle& patch) const { return patch.loop(); }
};

struct Type_name {
  std::string operator()(const Concave_model&) const { return "concave generalized Bezier patch"; }
  std::string operator()(const Generalized_model& m) const {
    return "generalized Bezier patch of degree " + std::to_string(m.net.degree());
  }
  std::string operator()(const S_patch_model& m) const {
    return "S-patch of depth " + std::to_string(m.net.depth());
  }
  std::string operator()(const Tensor_product& patch) const {
    return "tensor product patch of degree " + std::to_string(patch.degree_u()) + " by " +
           std::to_string(patch.degree_v());
  }
  std::string operator()(const Triangle& patch) const {
    return "Bezier triangle of degree " + std::to_string(patch.degree());
  }
};

struct Coordinates_of {
  using Choice = std::optional<Coordinates_choice>;
  template <typename Description>
  Choice operator()(const Description& m) const {
    return m.coordinates;
  }
  Choice operator()(const Tensor_product&) const { return std::nullopt; }
  Choice operator()(const Triangle&) const { return std::nullopt; }
};

bool elevation_helps(const Any_model& model) {
  const auto* concave = std::get_if<Concave_model>(&model);
  if (concave == nullptr)
    return false;
  const auto degrees = MP::degrees_for_contact(concave->loop, concave->central_weight);
  for (std::size_t i = 0; i < degrees.size(); ++i)
    if (concave->loop[i].degree() < degrees[i])
      return true;
  return false;
}

} // namespace

std::string type_name(const Any_model& model) {
  return std::visit(Type_name(), model);
}

std::size_t number_of_sides(const Any_model& model) {
  return std::visit(Number_of_sides(), model);
}

Loop loop(const Any_model& model) {
  return std::visit(Ribbons(), model);
}

MP::Generated_domain<Kernel> make_domain(const Any_model& model) {
  return MP::IO::make_domain(model);
}

std::optional<Coordinates_choice> coordinates(const Any_model& model) {
  return std::visit(Coordinates_of(), model);
}

// Only the ribbons of concave patches are given; those of others follow from their control points,
// and promise what the patch has.
std::vector<std::string> contact_shortfalls(const Any_model& model) {
  std::vector<std::string> texts;
  if (const auto* concave = std::get_if<Concave_model>(&model))
    for (std::size_t i = 0; i < concave->loop.size(); ++i) {
      std::string text = MP::contact_shortfall(concave->loop, i, concave->central_weight);
      if (!text.empty())
        texts.push_back(std::move(text));
    }
  return texts;
}

std::string contact_advice(const std::vector<Any_model>& models) {
  return std::any_of(models.begin(), models.end(), elevation_helps)
             ? "the option --elevate of the command mesh raises degrees where that helps"
             : "";
}

void warn_of_contact_shortfalls(const std::vector<Any_model>& models,
                                const std::vector<std::string>& prefixes) {
  for (std::size_t k = 0; k < models.size(); ++k)
    for (const std::string& text : contact_shortfalls(models[k]))
      warn(prefixes[k] + text);
  const std::string advice = contact_advice(models);
  if (!advice.empty())
    warn(advice);
}

} // namespace multipatch
