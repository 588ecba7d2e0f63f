// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MESH_REPORT_H
#define MULTIPATCH_MESH_REPORT_H

#include "any_patch.h"
#include "mesh_job.h"
#include "mesh_statistics.h"

#include <CGAL/Multisided_patches/analysis/boundary_deviation.h>

#include <cstddef>
#include <optional>

namespace multipatch {

// What is worth knowing about the finished mesh of a patch.
struct Mesh_report {
  std::optional<Any_patch> patch; // none before it is made
  Mesh_statistics mesh;
  CGAL::Multisided_patches::Boundary_deviation boundary;
  std::size_t boundary_vertices = 0;
};

// Prints a summary to standard output, and warns of what is not as one may expect.
void print_report(const Mesh_job& job, const Mesh_report& report);

// Writes everything to the file that the user has named, whole or not at all.
void write_report(const Mesh_job& job, const Mesh_report& report);

} // namespace multipatch

#endif // MULTIPATCH_MESH_REPORT_H
