// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_report.h"
#include "make_patches.h"
#include "report_output.h"
#include "stage_clock.h"

#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/analysis/fairness_report.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/meshing/is_valid_domain_mesh.h>
#include <CGAL/Multisided_patches/meshing/mesh_domain.h>
#include <CGAL/Multisided_patches/meshing/tessellate_complex.h>

#include <algorithm>
#include <array>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// A side as far as it takes to recognize it in another patch.
struct Side_outline {
  std::size_t patch, side;
  double length;
  std::array<Kernel::Point_3, 5> points; // evenly spaced in the parameter
};

std::vector<Side_outline> outlines(const std::vector<Any_patch>& patches) {
  std::vector<Side_outline> result;
  for (std::size_t k = 0; k < patches.size(); ++k)
    for (std::size_t i = 0; i < patches[k].loop().size(); ++i) {
      const auto& ribbon = patches[k].loop()[i];
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

void check_patches(const std::vector<Any_patch>& patches, const Check_options& options,
                   Check_report& report) {
  for (std::size_t k = 0; k < patches.size(); ++k) {
    report.patches[k].diagonal = patches[k].loop().diagonal();
    report.patches[k].continuity = MP::continuity_report(patches[k], options.samples);
  }
}

void check_seams(const std::vector<Any_patch>& patches, const std::vector<Side_outline>& sides,
                 const Check_options& options, Check_report& report) {
  for (std::size_t a = 0; a < sides.size(); ++a)
    for (std::size_t b = a + 1; b < sides.size(); ++b) {
      const Side_outline &x = sides[a], &y = sides[b];
      const bool joined = report.sides.are_joined(x.patch, x.side, y.patch, y.side);
      if (!joined && !are_alike(x, y))
        continue;
      const Any_patch &first = patches[x.patch], &second = patches[y.patch];
      report.seams.push_back(
          {x.patch, y.patch, (std::max)(first.loop().diagonal(), second.loop().diagonal()), joined,
           MP::continuity_report(first, x.side, second, y.side, options.samples)});
    }
}

constexpr std::size_t default_triangles = 2000; // a patch

std::size_t mesh_triangles(const Check_options& options) {
  return options.mesh_triangles.value_or(
      (std::min)(default_triangles * options.inputs.size(), MP::Mesh_density::max_triangles));
}

void check_mesh(const MP::Patch_complex<Any_patch>& complex, const Check_options& options,
                Check_report& report) {
  const std::size_t triangles = mesh_triangles(options);
  Mesh mesh;
  MP::tessellate(complex, mesh, MP::Mesh_density::triangles(triangles));
  report.mesh.statistics = measure(mesh);
  report.mesh.self_intersections = self_intersections(mesh);
  report.mesh.is_as_joined = is_as_joined(report.mesh.statistics, report.sides);
}

void check_domains(const std::vector<Any_patch>& patches, const Check_options& options,
                   Check_report& report) {
  const std::size_t share = (std::max)(default_triangles, mesh_triangles(options) / patches.size());
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const Domain_mesh mesh = MP::mesh_domain(patches[k], MP::Mesh_density::triangles(share));
    report.patches[k].domain_mesh_defect = MP::domain_mesh_defect(patches[k].domain(), mesh);
    report.patches[k].fairness = MP::fairness_report(patches[k], mesh);
  }
}

void run(const Check_options& options, const std::vector<Any_model>& models, Stage_clock& clock,
         Check_report& report) {
  auto patches =
      clock.run("domain and coordinates", [&] { return make_patches(models, options.inputs); });
  const MP::Patch_complex<Any_patch> complex(std::move(patches), options.inputs);
  report.sides = joined_sides(complex);
  clock.run("checks", [&] {
    check_patches(complex.patches(), options, report);
    check_seams(complex.patches(), outlines(complex.patches()), options, report);
  });
  clock.run("meshing", [&] {
    check_mesh(complex, options, report);
    check_domains(complex.patches(), options, report);
  });
}

void check_tolerance(double tolerance, const char* option) {
  if (!(tolerance >= 0))
    throw MP::Input_error(std::string(option) + " must be at least 0, not " +
                          MP::internal::to_short_text(tolerance));
}

std::vector<Any_model> read_models(const Check_options& options, Check_report& report) {
  const std::vector<Any_model> models = read_models(options.patch, options.inputs, options.quiet);
  for (std::size_t k = 0; k < models.size(); ++k)
    report.patches.push_back({options.inputs[k], 0, {}, contact_shortfalls(models[k]), {}, {}});
  return models;
}

std::string joined(const std::vector<std::string>& phrases) {
  std::string text;
  for (const std::string& phrase : phrases)
    text += (text.empty() ? "" : "; ") + phrase;
  return text;
}

} // namespace

void check_command(const Check_options& options) {
  // What cannot succeed fails before the work, not after it.
  check_tolerance(options.position_tolerance, "--position-tolerance");
  check_tolerance(options.plane_tolerance, "--plane-tolerance");
  check_tolerance(options.curvature_tolerance, "--curvature-tolerance");
  const Report_output output(options.json, options.quiet, options.inputs);
  Check_report report;
  {
    Stage_clock clock(options.quiet);
    const std::vector<Any_model> models =
        clock.run("reading", [&] { return read_models(options, report); });
    run(options, models, clock, report);
  }
  output.write([&] { return check_json(options, report); }, [&] { print_table(options, report); });
  const std::vector<std::string> wrong = failures(options, report);
  if (!wrong.empty())
    throw MP::Error(joined(wrong));
}

} // namespace multipatch
