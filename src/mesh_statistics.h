// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MESH_STATISTICS_H
#define MULTIPATCH_MESH_STATISTICS_H

#include "commands.h"
#include "joined_sides.h"

#include <CGAL/Multisided_patches/analysis/check_mesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace multipatch {

// What the program tells about every mesh.
struct Mesh_statistics : CGAL::Multisided_patches::Mesh_check {
  double mean_edge = 0; // model units
};

// Looks for the normals and the patches that `tessellate()` gives a mesh.
Mesh_statistics measure(const Mesh& mesh);

// The number of pairs of triangles that have more in common than vertices or edges. Triangles of
// patches that share no side may touch at a corner of both.
std::size_t self_intersections(const Mesh& mesh);

// A mesh that was looked at as a whole.
struct Checked_mesh {
  Mesh_statistics statistics;
  std::size_t self_intersections = 0;
};

// What it is like, in a line, and what is wrong with it, a phrase each.
std::string description(const Checked_mesh& mesh);
std::vector<std::string> defects(const Checked_mesh& mesh);

// "1 hole", "2 holes"
std::string counted(std::size_t count, const std::string& noun);

// "a; b; c"
std::string in_one_line(const std::vector<std::string>& phrases);

// Whether every patch is a disk, and the mesh closed if no side is free.
bool is_as_joined(const Mesh_statistics& mesh, const Joined_sides& sides);

} // namespace multipatch

#endif // MULTIPATCH_MESH_STATISTICS_H
