// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_patches.h"
#include "mesh_job.h"
#include "mesh_report.h"
#include "progress_visitor.h"

#include <CGAL/Multisided_patches/IO/surface_mesh.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

void run(Mesh_job& job, Mesh& mesh, Mesh_report& report) {
  Progress_visitor visitor{&job.clock};
  report.patch = job.clock.run("domain and coordinates", [&] {
    return make_patches(job.models, job.options.inputs).front();
  });
  const Any_patch& patch = *report.patch;
  const auto domain_mesh =
      job.clock.run("meshing", [&] { return MP::mesh_domain(patch, job.density, visitor); });
  job.clock.run("evaluation",
                [&] { MP::tessellate(patch, domain_mesh, mesh, MP::Default_maps(), visitor); });
  job.clock.run("checks", [&] {
    report.mesh = measure(mesh);
    report.boundary = MP::boundary_deviation(patch.loop(), domain_mesh, mesh);
    report.boundary_vertices = domain_mesh.number_of_boundary_points;
  });
}

} // namespace

void mesh_patch(Mesh_job& job) {
  Mesh mesh;
  Mesh_report report;
  run(job, mesh, report);
  require_sound(report.mesh.is_disk(), job.options);
  job.clock.run("writing", [&] { MP::IO::write_mesh(job.options.output, mesh); });
  if (!job.options.report.empty())
    write_report(job, report);
  if (!job.options.quiet)
    print_report(job, report);
}

} // namespace multipatch
