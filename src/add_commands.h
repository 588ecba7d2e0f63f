// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_ADD_COMMANDS_H
#define MULTIPATCH_ADD_COMMANDS_H

#include "commands.h"

#include <CLI/CLI.hpp>

#include <string>

namespace multipatch {

// The options of all commands, of which one is run.
struct Command_options {
  Mesh_options mesh;
  std::string info_input;
  Domain_picture_options domain;
  Coordinates_options coordinates;
  Check_options check;
  Exact_options exact;
  Convert_options convert;
  Elevate_options elevate;
  Merge_options merge;
};

// Makes the program take its commands, which are run when it has parsed the command line.
void add_commands(CLI::App& app, Command_options& options);

} // namespace multipatch

#endif // MULTIPATCH_ADD_COMMANDS_H
