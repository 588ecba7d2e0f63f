// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MESH_REPORT_H
#define MULTIPATCH_MESH_REPORT_H

#include "mesh_job.h"
#include "mesh_statistics.h"

#include <CGAL/Multisided_patches/analysis/boundary_deviation.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>

#include <optional>

namespace multipatch {

// How a patch came about.
struct Patch_report {
  CGAL::Multisided_patches::Domain_report domain;
  std::optional<double> coordinates_error_bound;
};

// What is worth knowing about the finished mesh of a patch.
struct Mesh_report {
  Patch_report patch;
  Mesh_statistics mesh;
  CGAL::Multisided_patches::Boundary_deviation boundary;
  std::size_t boundary_vertices = 0;
};

// Prints a summary to standard output.
void print_report(const Mesh_job& job, const Mesh_report& report);

// Writes everything to the file that the user has named, whole or not at all.
void write_report(const Mesh_job& job, const Mesh_report& report);

} // namespace multipatch

#endif // MULTIPATCH_MESH_REPORT_H
