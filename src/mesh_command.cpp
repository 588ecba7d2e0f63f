// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "mesh_report.h"
#include "stage_clock.h"

#include <CGAL/Multisided_patches/IO/surface_mesh.h>
#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

MP::Mesh_density density(const Mesh_options& options) {
  constexpr std::size_t default_triangles = 10000;
  if (options.edge_length)
    return MP::Mesh_density::edge_length(*options.edge_length);
  return MP::Mesh_density::triangles(options.triangles.value_or(default_triangles));
}

std::optional<double> error_bound(const MP::Harmonic_coordinates_2<Kernel>& coordinates) {
  return coordinates.error_bound();
}
template <typename Coordinates>
std::optional<double> error_bound(const Coordinates&) {
  return std::nullopt;
}

template <typename Coordinates>
void run(const Mesh_options& options, const MP::Mesh_density& density, const Model& model,
         Stage_clock& clock) {
  using Patch = MP::Concave_bezier_patch_3<Kernel, Coordinates>;
  const Patch patch = clock.run("domain and coordinates", [&] { return Patch(model); });
  const auto domain_mesh = clock.run("meshing", [&] { return MP::mesh_domain(patch, density); });
  Mesh mesh;
  clock.run("evaluation", [&] { MP::tessellate(patch, domain_mesh, mesh); });

  Mesh_report report;
  clock.run("checks", [&] {
    report.domain = patch.domain_report();
    report.coordinates_error_bound = error_bound(patch.coordinates());
    report.topology = MP::mesh_topology(mesh);
    report.boundary = MP::boundary_deviation(model.loop, domain_mesh, mesh);
    report.vertices = mesh.number_of_vertices();
    report.boundary_vertices = domain_mesh.number_of_boundary_points;
    report.triangles = mesh.number_of_faces();
    measure_edges(mesh, report);
  });
  if (!report.topology.is_disk())
    throw MP::Numerical_error(options.patch.input + ": the mesh came out torn; this is a defect of "
                                                    "the program, please report it");
  clock.run("writing", [&] { MP::IO::write_mesh(options.output, mesh); });
  if (!options.report.empty())
    write_report(options, model, report, clock);
  if (!options.quiet)
    print_report(options, model, report, clock);
}

} // namespace

void mesh_command(const Mesh_options& options) {
  // What cannot succeed fails before the work, not after it.
  const MP::Mesh_density wanted = density(options);
  MP::IO::mesh_format(options.output);
  Stage_clock clock(options.quiet);
  const Model model = clock.run("reading", [&] { return read_model(options.patch); });
  if (!options.quiet)
    warn_of_mismatches(model);
  MP::internal::check_different(options.output, options.patch.input);
  if (!options.report.empty()) {
    MP::internal::check_different(options.report, options.patch.input);
    MP::internal::check_different(options.report, options.output);
  }
  MP::internal::check_writable(options.output);
  if (!options.report.empty())
    MP::internal::check_writable(options.report);

  switch (options.patch.coordinates) {
  case Coordinates_choice::harmonic:
    return run<MP::Harmonic_coordinates_2<Kernel>>(options, wanted, model, clock);
  case Coordinates_choice::mean_value:
    return run<MP::Mean_value_coordinates_2<Kernel>>(options, wanted, model, clock);
  case Coordinates_choice::wachspress:
    return run<MP::Wachspress_coordinates_2<Kernel>>(options, wanted, model, clock);
  }
}

} // namespace multipatch
