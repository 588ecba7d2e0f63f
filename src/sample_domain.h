// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_SAMPLE_DOMAIN_H
#define MULTIPATCH_SAMPLE_DOMAIN_H

#include "commands.h"

#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>

#include <cstddef>

namespace multipatch {

// enough for a picture of a domain
constexpr std::size_t picture_points = 6000;

// A mesh of the domain with about so many points, all vertices of the domain among them. Throws
// Error if the size of the domain is beyond what can be computed with.
CGAL::Multisided_patches::Domain_mesh_2<Kernel> sample_domain(const Domain& domain,
                                                              std::size_t points);

} // namespace multipatch

#endif // MULTIPATCH_SAMPLE_DOMAIN_H
