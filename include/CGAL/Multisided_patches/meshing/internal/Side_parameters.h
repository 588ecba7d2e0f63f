// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SIDE_PARAMETERS_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SIDE_PARAMETERS_H

#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// For each side of a domain the parameters of its samples, increasing in (0,1).
using Side_parameters = std::vector<std::vector<double>>;

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SIDE_PARAMETERS_H
