// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MAKE_PATCHES_H
#define MULTIPATCH_MAKE_PATCHES_H

#include "any_model.h"
#include "any_patch.h"

#include <string>
#include <vector>

namespace multipatch {

// Makes a patch with its domain and coordinates.
Any_patch make_patch(const Any_model& model);

// Makes patches, in parallel. Errors begin with the name of the input; of several, that of the
// first input is thrown.
std::vector<Any_patch> make_patches(const std::vector<Any_model>& models,
                                    const std::vector<std::string>& inputs);

} // namespace multipatch

#endif // MULTIPATCH_MAKE_PATCHES_H
