// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_DOMAIN_INPUT_H
#define MULTIPATCH_DOMAIN_INPUT_H

#include "commands.h"

#include <CGAL/Multisided_patches/domains/make_domain.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace multipatch {

// A domain as an input file gives it: a polygon file as it is, that of a patch as it is made.
struct Domain_input {
  Domain domain;
  // Vertex i of the user is vertex vertices[i] of the domain.
  std::vector<std::size_t> vertices;
  Coordinates_choice coordinates; // the ones that are asked for
  // how the domain of a patch was made
  std::optional<CGAL::Multisided_patches::Domain_report> report;
};

// The options about domains are for patches only; with a polygon file they are errors.
Domain_input read_domain(const Patch_options& options);

} // namespace multipatch

#endif // MULTIPATCH_DOMAIN_INPUT_H
