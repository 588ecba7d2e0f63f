// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MESH_REPORT_H
#define MULTIPATCH_MESH_REPORT_H

#include "commands.h"
#include "stage_clock.h"

#include <CGAL/Multisided_patches/analysis/boundary_deviation.h>
#include <CGAL/Multisided_patches/analysis/mesh_topology.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>

#include <CGAL/Surface_mesh/Surface_mesh.h>

#include <optional>
#include <string>

namespace multipatch {

// What is worth knowing about a finished mesh.
struct Mesh_report {
  CGAL::Multisided_patches::Domain_report domain;
  std::optional<double> coordinates_error_bound;
  CGAL::Multisided_patches::Mesh_topology topology;
  CGAL::Multisided_patches::Boundary_deviation boundary;
  std::size_t vertices = 0, boundary_vertices = 0, triangles = 0;
  double shortest_edge = 0, mean_edge = 0, longest_edge = 0;
};

void measure_edges(const CGAL::Surface_mesh<Kernel::Point_3>& mesh, Mesh_report& report);

// Prints a summary to standard output.
void print_report(const Mesh_options& options, const Model& model, const Mesh_report& report,
                  const Stage_clock& clock);

// Writes everything to options.report, whole or not at all.
void write_report(const Mesh_options& options, const Model& model, const Mesh_report& report,
                  const Stage_clock& clock);

} // namespace multipatch

#endif // MULTIPATCH_MESH_REPORT_H
