// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "any_model.h"
#include "make_patches.h"

#include <CGAL/Multisided_patches/bases/contact_order.h>

#include <cstdio>
#include <string>
#include <variant>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// "G1", or "G1 of G2" where the layers of the ribbon promise more than the patch has. Ribbons that
// come from the control points of a patch promise what it has.
std::string contact(const Any_model& model, const Loop& ribbons, std::size_t i) {
  const std::size_t promised = ribbons[i].layers() - 1;
  const auto* concave = std::get_if<Concave_model>(&model);
  const std::size_t order =
      concave == nullptr ? promised : MP::contact_order(ribbons, i, concave->central_weight);
  const std::string text = 'G' + std::to_string(order);
  return order == promised ? text : text + " of G" + std::to_string(promised);
}

void print_ribbons(const Any_model& model, const Loop& ribbons) {
  std::printf("%4s %7s %7s %14s   %-9s %10s %15s   %s\n", "side", "degree", "layers", "length",
              "corner", "angle", "plane mismatch", "contact");
  for (std::size_t i = 0; i < ribbons.size(); ++i)
    std::printf("%4zu %7zu %7zu %14.6g   %-9s %10.2f %15.2f   %s\n", i, ribbons[i].degree(),
                ribbons[i].layers(), ribbons[i].arc_length(), to_string(ribbons.corner_type(i)),
                degrees(ribbons.corner_angle(i)), degrees(ribbons.corner_normal_mismatch(i)),
                contact(model, ribbons, i).c_str());
  std::printf(
      "Corner i is where side i starts; angles are interior, in degrees. The mismatch is "
      "the\nangle between the tangent planes of the two ribbons at the corner. Contact is "
      "what the patch\nhas in common with the ribbon along the side: G0 the curve, G1 tangent "
      "planes, G2 curvatures.\n");
  for (const std::string& text : contact_shortfalls(model))
    std::printf("  %s\n", text.c_str());
  const std::string advice = contact_advice({model});
  if (!advice.empty())
    std::printf("  %s\n", advice.c_str());
}

template <typename Description>
std::string domain_asked_for(const Description& model) {
  return model.domain_vertices.empty() ? to_string(model.domain.generator) : "by its vertices";
}

// "none", or "automatic (none)".
std::string central_weight(const Concave_model& model) {
  const std::string name = to_string(model.central_weight);
  if (model.central_weight != MP::Central_weight::automatic)
    return name;
  const auto chosen = make_patch(Any_model(model)).origin().central_weight;
  return name + " (" + to_string(*chosen) + ')';
}

// What the file says beyond control points.
struct Print_options {
  void operator()(const Concave_model& model) const {
    std::printf("Central weight: %s; domain asked for: %s; parameter dilation: %g\n",
                central_weight(model).c_str(), domain_asked_for(model).c_str(),
                model.parameter_dilation);
    if (model.coordinates != Coordinates_choice::harmonic)
      std::printf("Coordinates: %s\n", to_string(model.coordinates));
    if (model.reflex_weight != 1)
      std::printf("Reflex weight: %g\n", model.reflex_weight);
    if (!model.corner_control_points.empty())
      std::printf("Extra corner control points: %zu\n", model.corner_control_points.size());
  }
  template <typename Net>
  void operator()(const MP::IO::Net_description_3<Kernel, Net>& model) const {
    print_type(model);
    std::printf("Domain asked for: %s; coordinates: %s\n", domain_asked_for(model).c_str(),
                to_string(model.coordinates));
  }
  void operator()(const Tensor_product& patch) const { print_type(patch); }
  void operator()(const Triangle& patch) const { print_type(patch); }

private:
  template <typename Description>
  static void print_type(const Description& model) {
    std::printf("Type: %s\n", type_name(Any_model(model)).c_str());
  }
};

void print_domain(const MP::Domain_report& report) {
  std::printf("Domain: %s, %s (wanted %.3g)\n", domain_name(report), clearance_text(report).c_str(),
              report.wanted_clearance);
  for (const std::string& remark : remarks(report))
    std::printf("  %s\n", remark.c_str());
}

} // namespace

void info_command(const std::string& input) {
  Patch_options options;
  options.input = input;
  const Any_model model = read_model(options);
  const auto generated = make_domain(model);
  const Loop ribbons = loop(model);

  const CGAL::Bbox_3& box = ribbons.bbox();
  std::printf("%s: %zu sides; corners: %zu convex, %zu reflex, %zu straight\n", input.c_str(),
              ribbons.size(), ribbons.number_of_corners(MP::Corner_type::convex),
              ribbons.number_of_corners(MP::Corner_type::reflex),
              ribbons.number_of_corners(MP::Corner_type::straight));
  std::printf("Control points within (%g, %g, %g) and (%g, %g, %g), diagonal %g\n", box.xmin(),
              box.ymin(), box.zmin(), box.xmax(), box.ymax(), box.zmax(), ribbons.diagonal());
  std::visit(Print_options(), model);
  print_ribbons(model, ribbons);
  print_domain(generated.report);
}

} // namespace multipatch
