// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "any_model.h"
#include "commands.h"
#include "patch_coordinates.h"
#include "sample_domain.h"
#include "svg.h"
#include "with_file_name.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/parameters/barycentric_side_parameters.h>

#include <cmath>
#include <cstdio>
#include <variant>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// The functions that are drawn, at the vertices of a mesh of the domain.
struct Samples {
  std::vector<double> s, h, lambda;
};

Samples sample(const Patch_coordinates& coordinates, const Domain_mesh& mesh,
               const MP::Side_parameter_options& side_options,
               const Domain_picture_options& options) {
  using Jet = MP::Jet_2<double, 0>;
  const Domain& domain = coordinates.domain();
  std::vector<Jet> lambda(domain.size());
  std::vector<MP::Side_parameter<Jet>> parameters(domain.size());
  Samples samples;
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    coordinates.evaluate<0>(mesh.points[k], mesh.locations[k], lambda.data());
    MP::compute_side_parameters(domain, lambda.data(), side_options, parameters);
    // Where neither end of the side has any weight, s is not defined and no line is drawn.
    const std::size_t i = options.side;
    const bool defined = lambda[i].value() + lambda[domain.next(i)].value() > 0;
    samples.s.push_back(defined ? parameters[i].s.value() : std::nan(""));
    samples.h.push_back(parameters[i].h.value());
    samples.lambda.push_back(lambda[options.coordinate].value());
  }
  return samples;
}

MP::Side_parameter_options side_parameter_options(const Any_model& model) {
  const auto* concave = std::get_if<Concave_model>(&model);
  return concave != nullptr
             ? MP::Side_parameter_options(concave->parameter_dilation, concave->reflex_weight)
             : MP::Side_parameter_options();
}

void draw(std::ostream& out, const MP::Generated_domain<Kernel>& generated, const Domain_mesh& mesh,
          const Samples& samples, Coordinates_choice choice,
          const Domain_picture_options& options) {
  const Domain& domain = generated.domain;
  const std::vector<double> levels = multiples(0.1, -20, 20);
  begin_svg(out, domain, 3);

  Svg_panel shape(out, domain, 0);
  shape.title(std::string(domain_name(generated.report)) +
              " domain: blue convex, red reflex corners");
  shape.area();
  shape.outline();
  shape.corners();
  shape.side_numbers();

  Svg_panel parameters(out, domain, 1);
  parameters.title("side " + std::to_string(options.side) +
                   ": s (green, where defined), h (orange)");
  parameters.area();
  parameters.isolines(mesh, samples.s, levels, "#2a8f4d");
  parameters.isolines(mesh, samples.h, levels, "#d98218");
  parameters.outline();
  parameters.side(options.side, "black");

  Svg_panel coordinate(out, domain, 2);
  coordinate.title(std::string(to_string(choice)) + " coordinate of vertex " +
                   std::to_string(options.coordinate) + ", step 0.1");
  coordinate.area();
  coordinate.isolines(mesh, samples.lambda, levels, "#7a3fa0");
  coordinate.outline();
  coordinate.corners();
  end_svg(out);
}

void write_picture(const Any_model& model, const Domain_picture_options& options) {
  const MP::Generated_domain<Kernel> generated = make_domain(model);
  const Domain_mesh mesh = sample_domain(generated.domain, picture_points);
  const Coordinates_choice choice = coordinates(model).value_or(own_coordinates);
  const Samples samples = sample(Patch_coordinates(choice, generated.domain), mesh,
                                 side_parameter_options(model), options);
  MP::internal::Atomic_file file(options.output);
  draw(file.stream(), generated, mesh, samples, choice, options);
  file.commit();
  std::printf("%s: domain %s, %s\n", options.output.c_str(), domain_name(generated.report),
              clearance_text(generated.report).c_str());
  warn_of_remarks(generated.report);
}

} // namespace

void domain_command(const Domain_picture_options& options) {
  check_different(options.output, {options.patch.input});
  const Any_model model = read_model(options.patch);
  check_index(options.side, number_of_sides(model), "--side");
  check_index(options.coordinate, number_of_sides(model), "--coordinate");
  MP::internal::check_writable(options.output);
  with_file_name(options.patch.input, [&] { write_picture(model, options); });
}

} // namespace multipatch
