// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "complex_report.h"

#include "report_json.h"

#include <cstdio>
#include <string>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

Json patch_json(const Mesh_job& job, const Complex_report& report, std::size_t k) {
  return {{"input", job.options.inputs[k]},
          {"model", model_json(job.models[k], report.patches[k])},
          {"domain", domain_json(report.patches[k].origin().domain)},
          {"coordinates", coordinates_json(report.patches[k].origin())},
          {"triangles", report.mesh.patches[k].faces},
          {"is_disk", report.mesh.patches[k].is_disk()}};
}

} // namespace

void print_report(const Mesh_job& job, const Complex_report& report) {
  std::printf("%s: %zu patches, %zu shared sides, %zu free sides; %zu triangles, %zu vertices, "
              "%s; %.2f s\n",
              job.options.output.c_str(), job.models.size(), report.sides.shared.size(),
              report.sides.free.size(), report.mesh.triangles, report.mesh.vertices,
              report.mesh.is_closed() ? "closed" : "not closed", job.clock.total_seconds());
  for (const std::string& remark : report.sides.remarks)
    warn(remark);
  std::vector<std::string> prefixes;
  for (std::size_t k = 0; k < job.models.size(); ++k) {
    prefixes.push_back(job.options.inputs[k] + ": ");
    warn_of_remarks(report.patches[k].origin().domain, prefixes[k]);
  }
  warn_of_contact_shortfalls(job.models, prefixes);
}

void write_report(const Mesh_job& job, const Complex_report& report) {
  const std::vector<std::string>& inputs = job.options.inputs;
  Json patches = Json::array();
  for (std::size_t k = 0; k < inputs.size(); ++k)
    patches.push_back(patch_json(job, report, k));
  write_json(job.options.report, {{"inputs", inputs},
                                  {"output", job.options.output},
                                  {"patches", patches},
                                  {"shared_sides", shared_sides_json(report.sides, inputs)},
                                  {"free_sides", free_sides_json(report.sides, inputs)},
                                  {"remarks", report.sides.remarks},
                                  {"density", density_json(job.density)},
                                  {"mesh", statistics_json(report.mesh)},
                                  {"seconds", seconds_json(job.clock)}});
}

} // namespace multipatch
