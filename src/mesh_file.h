// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MESH_FILE_H
#define MULTIPATCH_MESH_FILE_H

#include "commands.h"

#include <string>
#include <vector>

namespace multipatch {

// The mesh of a file, or why its triangles make none.
struct Mesh_file {
  Mesh mesh; // with "v:normal" and "f:patch", if the file has them
  std::string defect = {};
};

// Whether the name of a file is that of a mesh.
bool is_mesh_file(const std::string& file_name);

// The same for the names of all files, if there are any; throws Usage_error if it is that of some.
bool are_mesh_files(const std::vector<std::string>& file_names);

// Reads a file of any format in which meshes are written. Throws Input_error, which names the file.
Mesh_file read_mesh_file(const std::string& file_name);

} // namespace multipatch

#endif // MULTIPATCH_MESH_FILE_H
