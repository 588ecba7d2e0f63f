// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "patch_coordinates.h"

#include "any_coordinates.h"

#include <variant>

namespace multipatch {

struct Patch_coordinates::Implementation {
  Any_coordinates coordinates;

  template <int Order>
  void evaluate(const Point_2& p, const Location& location, Jet<Order>* lambda) const {
    std::visit([&](const auto& c) { c.template evaluate<Order>(p, location, lambda); },
               coordinates);
  }
};

Patch_coordinates::Patch_coordinates(Coordinates_choice choice, const Domain& domain) {
  // A patch meets its boundary however inaccurate the coordinates are inside; so a domain that is
  // too narrow for full accuracy is no reason to give up.
  constexpr double acceptable_error = 1e-3;
  implementation_ = std::make_shared<const Implementation>(
      Implementation{make_coordinates(choice, domain, default_target_error, acceptable_error)});
}

const Domain& Patch_coordinates::domain() const {
  return std::visit([](const auto& c) -> const Domain& { return c.domain(); },
                    implementation_->coordinates);
}

std::optional<double> Patch_coordinates::error_bound() const {
  return multipatch::error_bound(implementation_->coordinates);
}

void Patch_coordinates::compute(const Point_2& p, const Location& location, Jet<0>* lambda) const {
  implementation_->evaluate(p, location, lambda);
}
void Patch_coordinates::compute(const Point_2& p, const Location& location, Jet<1>* lambda) const {
  implementation_->evaluate(p, location, lambda);
}
void Patch_coordinates::compute(const Point_2& p, const Location& location, Jet<2>* lambda) const {
  implementation_->evaluate(p, location, lambda);
}

} // namespace multipatch
