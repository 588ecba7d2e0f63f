// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_report.h"

#include "report_json.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// A deviation that is not a number exceeds every tolerance.
bool exceeds(const std::optional<MP::Deviation>& deviation, double tolerance) {
  return deviation && !(deviation->max <= tolerance);
}

std::vector<std::string> exceeded(const Check_options& options, const MP::Continuity& continuity,
                                  double diagonal) {
  std::vector<std::string> names;
  if (exceeds(continuity.position, options.position_tolerance * diagonal))
    names.emplace_back("position");
  if (exceeds(continuity.tangent_plane, options.plane_tolerance))
    names.emplace_back("tangent plane");
  if (exceeds(continuity.normal_curvature, options.curvature_tolerance))
    names.emplace_back("curvature");
  return names;
}

void print_deviation(const std::optional<MP::Deviation>& deviation) {
  if (deviation)
    std::printf("  %8.1e %8.1e %9.6g", deviation->max, deviation->mean, deviation->s);
  else
    std::printf("  %8s %8s %9s", "-", "-", "-");
}

void print_row(const Check_options& options, const MP::Continuity& continuity, double diagonal) {
  print_deviation(continuity.position);
  print_deviation(continuity.tangent_plane);
  print_deviation(continuity.normal_curvature);
  const char* separator = "  exceeded: ";
  for (const std::string& name : exceeded(options, continuity, diagonal)) {
    std::printf("%s%s", separator, name.c_str());
    separator = ", ";
  }
}

// A table whose first column has a width.
void print_header(const char* first, int width) {
  std::printf("%-*s  %-27s  %-27s  %s\n", width, "", "position (model units)",
              "tangent plane (degrees)", "curvature (relative)");
  std::printf("%-*s", width, first);
  for (int k = 0; k < 3; ++k)
    std::printf("  %8s %8s %9s", "max", "mean", "at s");
  std::printf("\n");
}

void print_patch(const Check_options& options, const Checked_patch& patch) {
  std::printf("%s: %zu sides, diagonal %g\n", patch.input.c_str(), patch.continuity.sides.size(),
              patch.diagonal);
  print_header("side", 4);
  for (const MP::Side_continuity& side : patch.continuity.sides) {
    std::printf("%4zu", side.side);
    print_row(options, side, patch.diagonal);
    std::printf("\n");
  }
  for (const std::string& shortfall : patch.shortfalls)
    std::printf("  %s\n", shortfall.c_str());
  std::printf("Fairness: bending energy %.3g, curvature times diagonal up to %.3g on 99 %% of the "
              "area, at most %.3g at (u,v) = (%.3g, %.3g)\n",
              patch.fairness.bending_energy, patch.fairness.curvature_99 * patch.diagonal,
              patch.fairness.largest_curvature * patch.diagonal, patch.fairness.sharpest_point.x(),
              patch.fairness.sharpest_point.y());
}

std::string seam_name(const Check_report& report, const Checked_seam& seam) {
  return report.patches[seam.patch_a].input + " side " + std::to_string(seam.continuity.side_a) +
         " and " + report.patches[seam.patch_b].input + " side " +
         std::to_string(seam.continuity.side_b);
}

void print_seams(const Check_options& options, const Check_report& report) {
  if (report.seams.empty())
    return;
  const char* title = "common sides";
  std::size_t width = std::string(title).size();
  for (const Checked_seam& seam : report.seams)
    width = (std::max)(width, seam_name(report, seam).size());
  print_header(title, static_cast<int>(width));
  for (const Checked_seam& seam : report.seams) {
    std::printf("%-*s", static_cast<int>(width), seam_name(report, seam).c_str());
    print_row(options, seam.continuity, seam.diagonal);
    std::printf("%s\n", seam.has_gap ? "  not the same curve: a mesh has a gap here" : "");
  }
}

std::vector<std::string> mesh_failures(const Check_report& report) {
  std::vector<std::string> texts = defects(report.mesh);
  if (!report.is_as_joined)
    texts.emplace_back("the mesh came out torn; this is a defect of the program, please report it");
  for (const Checked_patch& patch : report.patches)
    if (!patch.domain_mesh_defect.empty())
      texts.push_back(patch.input +
                      ": the mesh of the domain is not valid: " + patch.domain_mesh_defect);
  return texts;
}

void print_mesh(const Check_report& report) {
  std::printf("Mesh: %s\n", description(report.mesh).c_str());
  for (const std::string& text : mesh_failures(report))
    std::printf("  %s\n", text.c_str());
}

void print_sides(const Check_report& report) {
  if (report.patches.size() > 1)
    std::printf("Sides: %s shared exactly, %s free\n",
                counted(report.sides.shared.size(), "pair").c_str(),
                counted(report.sides.free.size(), "side").c_str());
  for (const std::string& remark : report.sides.remarks)
    std::printf("  %s\n", remark.c_str());
}

Json deviation_json(const std::optional<MP::Deviation>& deviation) {
  if (!deviation)
    return nullptr;
  return {{"max", deviation->max}, {"mean", deviation->mean}, {"s", deviation->s}};
}

void add_continuity(Json& json, const Check_options& options, const MP::Continuity& continuity,
                    double diagonal) {
  json["position"] = deviation_json(continuity.position);
  json["tangent_plane_degrees"] = deviation_json(continuity.tangent_plane);
  json["normal_curvature_relative"] = deviation_json(continuity.normal_curvature);
  json["exceeded"] = exceeded(options, continuity, diagonal);
}

Json fairness_json(const MP::Fairness_report<Kernel>& fairness) {
  return {{"area", fairness.area},
          {"bending_energy", fairness.bending_energy},
          {"curvature_99", fairness.curvature_99},
          {"largest_curvature", fairness.largest_curvature},
          {"sharpest_point", {fairness.sharpest_point.x(), fairness.sharpest_point.y()}},
          {"samples", fairness.samples}};
}

Json patch_json(const Check_options& options, const Checked_patch& patch) {
  Json sides = Json::array();
  for (const MP::Side_continuity& side : patch.continuity.sides) {
    Json json{{"side", side.side}};
    add_continuity(json, options, side, patch.diagonal);
    sides.push_back(json);
  }
  return {{"input", patch.input},
          {"diagonal", patch.diagonal},
          {"sides", sides},
          {"contact_shortfalls", patch.shortfalls},
          {"fairness", fairness_json(patch.fairness)},
          {"domain_mesh_defect", patch.domain_mesh_defect}};
}

Json seam_json(const Check_options& options, const Check_report& report, const Checked_seam& seam) {
  Json json{{"input_a", report.patches[seam.patch_a].input}, {"side_a", seam.continuity.side_a},
            {"input_b", report.patches[seam.patch_b].input}, {"side_b", seam.continuity.side_b},
            {"reversed", seam.continuity.reversed},          {"exact", seam.is_joined}};
  add_continuity(json, options, seam.continuity, seam.diagonal);
  return json;
}

Json mesh_json(const Check_report& report) {
  Json json = checked_mesh_json(report.mesh);
  json["is_as_joined"] = report.is_as_joined;
  return json;
}

} // namespace

Check_count count_failures(const Check_options& options, const Check_report& report) {
  Check_count count;
  const auto add = [&](const MP::Continuity& continuity, double diagonal) {
    ++count.all;
    count.failed += !exceeded(options, continuity, diagonal).empty();
  };
  for (const Checked_patch& patch : report.patches)
    for (const MP::Side_continuity& side : patch.continuity.sides)
      add(side, patch.diagonal);
  for (const Checked_seam& seam : report.seams)
    add(seam.continuity, seam.diagonal);
  return count;
}

std::vector<std::string> failures(const Check_options& options, const Check_report& report) {
  std::vector<std::string> texts;
  const Check_count count = count_failures(options, report);
  if (count.failed > 0)
    texts.push_back("the tolerances do not hold along " + std::to_string(count.failed) + " of " +
                    std::to_string(count.all) + " sides" +
                    (report.seams.empty() ? "" : ", common ones counted once more"));
  for (const std::string& text : mesh_failures(report))
    texts.push_back(text);
  return texts;
}

void print_table(const Check_options& options, const Check_report& report) {
  for (const Checked_patch& patch : report.patches)
    print_patch(options, patch);
  print_seams(options, report);
  print_sides(report);
  print_mesh(report);
  std::printf("Tolerances: position %g of the diagonal, tangent plane %g degrees, curvature %g\n",
              options.position_tolerance, options.plane_tolerance, options.curvature_tolerance);
}

std::string check_json(const Check_options& options, const Check_report& report) {
  Json patches = Json::array(), seams = Json::array();
  std::vector<std::string> inputs;
  for (std::size_t k = 0; k < report.patches.size(); ++k) {
    inputs.push_back(report.patches[k].input);
    patches.push_back(patch_json(options, report.patches[k]));
  }
  for (const Checked_seam& seam : report.seams)
    seams.push_back(seam_json(options, report, seam));
  const Json json{{"passed", failures(options, report).empty()},
                  {"failures", failures(options, report)},
                  {"even_samples_per_side", options.samples},
                  {"tolerances",
                   {{"position_relative_to_diagonal", options.position_tolerance},
                    {"tangent_plane_degrees", options.plane_tolerance},
                    {"normal_curvature_relative", options.curvature_tolerance}}},
                  {"patches", patches},
                  {"shared_sides", seams},
                  {"free_sides", free_sides_json(report.sides, inputs)},
                  {"remarks", report.sides.remarks},
                  {"mesh", mesh_json(report)}};
  return to_text(json);
}

} // namespace multipatch
