// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "svg.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/meshing/triangulate_domain.h>
#include <CGAL/Multisided_patches/parameters/barycentric_side_parameters.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

using Domain = MP::Polygonal_domain_2<Kernel>;
using Domain_mesh = MP::Domain_mesh_2<Kernel>;

// The functions that are drawn, at the vertices of a mesh of the domain.
struct Samples {
  std::vector<double> s, h, lambda;
};

Domain_mesh picture_mesh(const Domain& domain) {
  const double spacing = domain.diameter() / 100;
  std::vector<std::size_t> segments;
  for (std::size_t i = 0; i < domain.size(); ++i)
    segments.push_back(1 + static_cast<std::size_t>(domain.side_length(i) / spacing));
  return MP::triangulate_domain(domain, segments, spacing);
}

template <typename Coordinates>
Samples sample(const Coordinates& coordinates, const Domain_mesh& mesh, double dilation,
               const Domain_picture_options& options) {
  using Jet = MP::Jet_2<double, 0>;
  const Domain& domain = coordinates.domain();
  std::vector<Jet> lambda(domain.size());
  std::vector<MP::Side_parameter<Jet>> parameters(domain.size());
  Samples samples;
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    coordinates.template evaluate<0>(mesh.points[k], mesh.locations[k], lambda.data());
    MP::compute_side_parameters(domain, lambda.data(), dilation, parameters);
    // Where neither end of the side has any weight, s is not defined and no line is drawn.
    const std::size_t i = options.side;
    const bool defined = lambda[i].value() + lambda[domain.next(i)].value() > 0;
    samples.s.push_back(defined ? parameters[i].s.value() : std::nan(""));
    samples.h.push_back(parameters[i].h.value());
    samples.lambda.push_back(lambda[options.coordinate].value());
  }
  return samples;
}

Samples sample(const Domain& domain, const Domain_mesh& mesh, double dilation,
               const Domain_picture_options& options) {
  switch (options.patch.coordinates) {
  case Coordinates_choice::mean_value:
    return sample(MP::Mean_value_coordinates_2<Kernel>(domain), mesh, dilation, options);
  case Coordinates_choice::wachspress:
    return sample(MP::Wachspress_coordinates_2<Kernel>(domain), mesh, dilation, options);
  default:
    return sample(MP::Harmonic_coordinates_2<Kernel>(domain), mesh, dilation, options);
  }
}

void check_index(std::size_t index, std::size_t n, const std::string& option) {
  if (index >= n)
    throw MP::Input_error(option + " must be less than " + std::to_string(n) +
                          ", the number of sides, not " + std::to_string(index));
}

} // namespace

void domain_command(const Domain_picture_options& options) {
  if (std::filesystem::path(options.output).extension() != ".svg")
    throw MP::Input_error(options.output + ": expected a name that ends in .svg");
  const Model model = read_model(options.patch);
  check_index(options.side, model.loop.size(), "--side");
  check_index(options.coordinate, model.loop.size(), "--coordinate");
  MP::internal::check_different(options.output, options.patch.input);
  MP::internal::check_writable(options.output);

  const auto [domain, report] = MP::make_domain(model.loop, model.domain);
  const Domain_mesh mesh = picture_mesh(domain);
  const Samples samples = sample(domain, mesh, model.parameter_dilation, options);

  MP::internal::Atomic_file file(options.output);
  std::ostream& out = file.stream();
  constexpr double step = 0.1;
  begin_svg(out, 3);

  Svg_panel shape(out, domain, 0);
  shape.title(std::string(to_string(report.used)) + " domain: blue convex, red reflex corners");
  shape.outline();
  shape.corners();
  shape.side_numbers();

  Svg_panel parameters(out, domain, 1);
  parameters.title("side " + std::to_string(options.side) +
                   ": s (green, where defined), h (orange)");
  parameters.outline();
  parameters.isolines(mesh, samples.s, step, "#2a8f4d");
  parameters.isolines(mesh, samples.h, step, "#d98218");
  parameters.side(options.side, "black");

  Svg_panel coordinate(out, domain, 2);
  coordinate.title(std::string(to_string(options.patch.coordinates)) + " coordinate of vertex " +
                   std::to_string(options.coordinate) + ", step 0.1");
  coordinate.outline();
  coordinate.isolines(mesh, samples.lambda, step, "#7a3fa0");
  coordinate.corners();
  end_svg(out);
  file.commit();
  std::printf("%s: domain %s, clearance %.3g\n", options.output.c_str(), to_string(report.used),
              report.clearance);
  print_remarks(report);
}

} // namespace multipatch
