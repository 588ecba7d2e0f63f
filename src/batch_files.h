// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_BATCH_FILES_H
#define MULTIPATCH_BATCH_FILES_H

#include "commands.h"

#include <string>
#include <vector>

namespace multipatch {

// A file of a batch, and the mesh that is made of it.
struct Batch_file {
  std::string input, output;
};

// The name of the input, without the extensions of patches, in the directory and format that the
// options ask for.
std::string batch_output(const std::string& input, const Batch_options& options);

// The inputs in the order in which they are given; of a directory, the patches directly in it,
// sorted by name. Throws Input_error if there are none, if one is missing and the options do not
// say to keep going, or if an output or the report would be that of two inputs, an input itself or
// the manifest.
std::vector<Batch_file> batch_files(const Mesh_options& options);

} // namespace multipatch

#endif // MULTIPATCH_BATCH_FILES_H
