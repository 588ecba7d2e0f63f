// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_report.h"
#include "report_output.h"
#include "stage_clock.h"

#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>
#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// A side as far as it takes to recognize it in another patch.
struct Side_outline {
  std::size_t patch, side;
  double length;
  std::array<Kernel::Point_3, 5> points; // evenly spaced in the parameter
};

std::vector<Side_outline> outlines(const std::vector<Model>& models) {
  std::vector<Side_outline> result;
  for (std::size_t k = 0; k < models.size(); ++k)
    for (std::size_t i = 0; i < models[k].loop.size(); ++i) {
      const auto& ribbon = models[k].loop[i];
      Side_outline outline{k, i, ribbon.arc_length(), {}};
      for (std::size_t j = 0; j < 5; ++j)
        outline.points[j] = ribbon.boundary_point(static_cast<double>(j) / 4);
      result.push_back(outline);
    }
  return result;
}

// Whether two sides are meant to be one curve: a gap between patches is to be found, not passed
// over, so this is more tolerant than any tolerance of the position should be.
bool are_alike(const Side_outline& a, const Side_outline& b) {
  const double gap = 1e-3 * (std::min)(a.length, b.length);
  bool same = true, reversed = true;
  for (std::size_t j = 0; j < 5 && (same || reversed); ++j) {
    same = same && CGAL::squared_distance(a.points[j], b.points[j]) <= gap * gap;
    reversed = reversed && CGAL::squared_distance(a.points[j], b.points[4 - j]) <= gap * gap;
  }
  return same || reversed;
}

template <typename Patch>
void check_patches(const std::vector<Patch>& patches, const Check_options& options,
                   Check_report& report) {
  for (std::size_t k = 0; k < patches.size(); ++k) {
    report.patches[k].diagonal = patches[k].loop().diagonal();
    report.patches[k].continuity = MP::continuity_report(patches[k], options.samples);
  }
}

template <typename Patch>
void check_seams(const std::vector<Patch>& patches, const std::vector<Side_outline>& sides,
                 const Check_options& options, Check_report& report) {
  for (std::size_t a = 0; a < sides.size(); ++a)
    for (std::size_t b = a + 1; b < sides.size(); ++b)
      if (are_alike(sides[a], sides[b])) {
        const Patch &first = patches[sides[a].patch], &second = patches[sides[b].patch];
        report.seams.push_back(
            {sides[a].patch, sides[b].patch,
             (std::max)(first.loop().diagonal(), second.loop().diagonal()),
             MP::continuity_report(first, sides[a].side, second, sides[b].side, options.samples)});
      }
}

template <typename Coordinates>
void run(const Check_options& options, const std::vector<Model>& models, Stage_clock& clock,
         Check_report& report) {
  using Patch = MP::Concave_bezier_patch_3<Kernel, Coordinates>;
  std::vector<Patch> patches;
  clock.run("domain and coordinates", [&] {
    for (std::size_t k = 0; k < models.size(); ++k)
      try {
        patches.emplace_back(models[k]);
      } catch (const MP::Error& error) {
        throw MP::Error(options.inputs[k] + ": " + error.what());
      }
  });
  clock.run("checks", [&] {
    check_patches(patches, options, report);
    check_seams(patches, outlines(models), options, report);
  });
}

void run(const Check_options& options, const std::vector<Model>& models, Stage_clock& clock,
         Check_report& report) {
  switch (options.patch.coordinates) {
  case Coordinates_choice::harmonic:
    return run<MP::Harmonic_coordinates_2<Kernel>>(options, models, clock, report);
  case Coordinates_choice::mean_value:
    return run<MP::Mean_value_coordinates_2<Kernel>>(options, models, clock, report);
  case Coordinates_choice::wachspress:
    return run<MP::Wachspress_coordinates_2<Kernel>>(options, models, clock, report);
  }
}

void check_tolerance(double tolerance, const char* option) {
  if (!(tolerance >= 0))
    throw MP::Input_error(std::string(option) + " must be at least 0, not " +
                          MP::internal::to_short_text(tolerance));
}

std::vector<Model> read_models(const Check_options& options, Check_report& report) {
  std::vector<Model> models;
  for (const std::string& input : options.inputs) {
    Patch_options patch = options.patch;
    patch.input = input;
    models.push_back(read_model(patch));
    const Model& model = models.back();
    if (!options.quiet)
      warn_of_mismatches(model);
    report.patches.push_back({input, 0, {}, {}});
    for (std::size_t i = 0; i < model.loop.size(); ++i) {
      const std::string text = MP::contact_shortfall(model.loop, i, model.central_weight);
      if (!text.empty())
        report.patches.back().shortfalls.push_back(text);
    }
  }
  return models;
}

} // namespace

void check_command(const Check_options& options) {
  // What cannot succeed fails before the work, not after it.
  check_tolerance(options.position_tolerance, "--position-tolerance");
  check_tolerance(options.plane_tolerance, "--plane-tolerance");
  check_tolerance(options.curvature_tolerance, "--curvature-tolerance");
  const Report_output output(options.json, options.quiet, options.inputs);
  Stage_clock clock(options.quiet);
  Check_report report;
  const std::vector<Model> models =
      clock.run("reading", [&] { return read_models(options, report); });
  run(options, models, clock, report);
  output.write([&] { return check_json(options, report); }, [&] { print_table(options, report); });
  const Check_count count = count_failures(options, report);
  if (count.failed > 0)
    throw MP::Error("the tolerances do not hold along " + std::to_string(count.failed) + " of " +
                    std::to_string(count.all) + " sides" +
                    (report.seams.empty() ? "" : ", common ones counted once more"));
}

} // namespace multipatch
