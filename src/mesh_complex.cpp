// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "complex_report.h"
#include "make_patches.h"
#include "mesh_job.h"

#include <CGAL/Multisided_patches/IO/surface_mesh.h>
#include <CGAL/Multisided_patches/meshing/tessellate_complex.h>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

void run(Mesh_job& job, Mesh& mesh, Complex_report& report) {
  report.patches = job.clock.run("domain and coordinates",
                                 [&] { return make_patches(job.models, job.options.inputs); });
  const auto complex = job.clock.run(
      "joining", [&] { return MP::Patch_complex<Any_patch>(report.patches, job.options.inputs); });
  report.sides = joined_sides(complex);
  // No progress is shown: each patch would report its own.
  job.clock.run("meshing", [&] { MP::tessellate(complex, mesh, job.density); });
  job.clock.run("checks", [&] { report.mesh = measure(mesh); });
}

} // namespace

void mesh_complex(Mesh_job& job) {
  Mesh mesh;
  Complex_report report;
  run(job, mesh, report);
  require_sound(report.mesh.patches.size() == job.models.size() &&
                    is_as_joined(report.mesh, report.sides),
                job.options);
  job.clock.run("writing", [&] { MP::IO::write_mesh(job.options.output, mesh); });
  if (!job.options.report.empty())
    write_report(job, report);
  if (!job.options.quiet)
    print_report(job, report);
}

} // namespace multipatch
