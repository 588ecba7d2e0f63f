// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_BATCH_ARGUMENTS_H
#define MULTIPATCH_BATCH_ARGUMENTS_H

#include "commands.h"

#include <CLI/CLI.hpp>

namespace multipatch {

// Adds the options of the command mesh for meshes in a directory, which exclude its option for a
// single output.
void add_batch_options(CLI::App& command, Batch_options& options, CLI::Option& output);

// Throws CLI::RequiredError if there are neither inputs nor a list, or nowhere to write to.
void require_mesh_arguments(const Mesh_options& options);

} // namespace multipatch

#endif // MULTIPATCH_BATCH_ARGUMENTS_H
