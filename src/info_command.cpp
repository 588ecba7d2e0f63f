// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include <CGAL/Multisided_patches/bases/contact_order.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>

#include <cmath>
#include <cstdio>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

double degrees(double radians) {
  return radians * 180 / MP::internal::pi;
}

// "G1", or "G1 of G2" where the layers of the ribbon promise more than the patch has.
std::string contact(const Model& model, std::size_t i) {
  const std::size_t order = MP::contact_order(model.loop, i, model.central_weight);
  const std::size_t promised = model.loop[i].layers() - 1;
  const std::string text = 'G' + std::to_string(order);
  return order == promised ? text : text + " of G" + std::to_string(promised);
}

void print_ribbons(const Model& model) {
  std::printf("%4s %7s %7s %14s   %-9s %10s %15s   %s\n", "side", "degree", "layers", "length",
              "corner", "angle", "plane mismatch", "contact");
  for (std::size_t i = 0; i < model.loop.size(); ++i) {
    const auto& ribbon = model.loop[i];
    std::printf("%4zu %7zu %7zu %14.6g   %-9s %10.2f %15.2f   %s\n", i, ribbon.degree(),
                ribbon.layers(), ribbon.arc_length(), to_string(model.loop.corner_type(i)),
                degrees(model.loop.corner_angle(i)), degrees(model.loop.corner_normal_mismatch(i)),
                contact(model, i).c_str());
  }
  std::printf(
      "Corner i is where side i starts; angles are interior, in degrees. The mismatch is "
      "the\nangle between the tangent planes of the two ribbons at the corner. Contact is "
      "what the patch\nhas in common with the ribbon along the side: G0 the curve, G1 tangent "
      "planes, G2 curvatures.\n");
  print_contact_shortfalls({model}, {"  "});
}

void print_domain(const MP::Domain_report& report) {
  std::printf("Domain: %s, clearance %.4g (wanted %.4g)\n", to_string(report.used),
              report.clearance, report.wanted_clearance);
  print_remarks(report);
}

} // namespace

void info_command(const std::string& input) {
  Patch_options options;
  options.input = input;
  const Model model = read_model(options);
  const auto generated = MP::make_domain(model.loop, model.domain);

  const CGAL::Bbox_3& box = model.loop.bbox();
  std::printf("%s: %zu sides; corners: %zu convex, %zu reflex, %zu straight\n", input.c_str(),
              model.loop.size(), model.loop.number_of_corners(MP::Corner_type::convex),
              model.loop.number_of_corners(MP::Corner_type::reflex),
              model.loop.number_of_corners(MP::Corner_type::straight));
  std::printf("Control points within (%g, %g, %g) and (%g, %g, %g), diagonal %g\n", box.xmin(),
              box.ymin(), box.zmin(), box.xmax(), box.ymax(), box.zmax(), model.loop.diagonal());
  std::printf("Central weight: %s; domain asked for: %s; parameter dilation: %g\n",
              to_string(model.central_weight), to_string(model.domain.generator),
              model.parameter_dilation);
  if (!model.corner_control_points.empty())
    std::printf("Extra corner control points: %zu (kept in files, not used by the patch)\n",
                model.corner_control_points.size());
  print_ribbons(model);
  print_domain(generated.report);
}

} // namespace multipatch
