// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_report.h"

#include "report_json.h"

#include <cstdio>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

Json mesh_json(const Mesh_report& report) {
  Json json = statistics_json(report.mesh);
  json["boundary_vertices"] = report.boundary_vertices;
  json["is_disk"] = report.mesh.is_disk();
  return json;
}

Json boundary_json(const MP::Boundary_deviation& boundary, double diagonal) {
  return {{"vertex_deviation", boundary.vertices},
          {"vertex_deviation_relative", boundary.vertices / diagonal},
          {"edge_deviation", boundary.edges},
          {"edge_deviation_relative", boundary.edges / diagonal}};
}

} // namespace

void print_report(const Mesh_job& job, const Mesh_report& report) {
  const MP::Domain_report& domain = report.patch->origin().domain;
  std::printf("%s: %zu triangles, %zu vertices; domain %s, %s; %.2f s\n",
              job.options.output.c_str(), report.mesh.triangles, report.mesh.vertices,
              domain_name(domain), clearance_text(domain).c_str(), job.clock.total_seconds());
  warn_of_remarks(domain);
  warn_of_contact_shortfalls(job.models, {""});
}

void write_report(const Mesh_job& job, const Mesh_report& report) {
  const Any_patch& patch = *report.patch;
  write_json(job.options.report,
             {{"input", job.options.inputs.front()},
              {"output", job.options.output},
              {"model", model_json(job.models.front(), patch)},
              {"domain", domain_json(patch.origin().domain)},
              {"coordinates", coordinates_json(patch.origin())},
              {"density", density_json(job.density)},
              {"mesh", mesh_json(report)},
              {"boundary", boundary_json(report.boundary, patch.loop().diagonal())},
              {"seconds", seconds_json(job.clock)}});
}

} // namespace multipatch
