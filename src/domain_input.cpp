// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "domain_input.h"

#include "any_model.h"

#include <CGAL/Multisided_patches/IO/polygon_file.h>

#include <numeric>
#include <utility>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

Domain_input patch_domain(const Patch_options& options) {
  const Any_model model = read_model(options);
  auto [domain, report] = make_domain(model);
  std::vector<std::size_t> vertices(domain.size());
  std::iota(vertices.begin(), vertices.end(), std::size_t(0));
  return {std::move(domain), std::move(vertices), coordinates(model).value_or(own_coordinates),
          std::move(report)};
}

Domain_input polygon_domain(const Patch_options& options) {
  for (const auto& [given, option] : {std::pair(options.domain.has_value(), "--domain"),
                                      std::pair(options.clearance.has_value(), "--clearance")})
    if (given)
      throw Usage_error(options.input + ": " + option +
                        " is for patches, not for polygon files; a polygon is taken as it is");
  auto polygon = MP::IO::read_polygon_file<Kernel>(options.input);
  return {std::move(polygon.domain), std::move(polygon.vertices),
          options.coordinates.value_or(Coordinates_choice::harmonic), std::nullopt};
}

} // namespace

Domain_input read_domain(const Patch_options& options) {
  return is_patch_file(options.input) ? patch_domain(options) : polygon_domain(options);
}

} // namespace multipatch
