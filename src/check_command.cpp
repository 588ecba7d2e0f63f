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

// Whether a remark says why sides with the same curve are not joined.
bool is_remarked(const Side_outline& a, const Side_outline& b, const Check_options& options,
                 const Check_report& report) {
  const auto name = [&](const Side_outline& side) {
    return options.inputs[side.patch] + " side " + std::to_string(side.side);
  };
  const std::string start = name(a) + " and " + name(b) + " have the same curve";
  return std::any_of(
      report.sides.remarks.begin(), report.sides.remarks.end(),
      [&](const std::string& remark) { return remark.compare(0, start.size(), start) == 0; });
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
           !joined && !is_remarked(x, y, options, report),
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
  report.is_as_joined = is_as_joined(report.mesh.statistics, report.sides);
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

std::vector<Any_model> read_models(const Check_options& options, Check_report& report) {
  const std::vector<Any_model> models = read_models(options.patch, options.inputs, options.quiet);
  for (std::size_t k = 0; k < models.size(); ++k)
    report.patches.push_back({options.inputs[k], 0, {}, contact_shortfalls(models[k]), {}, {}});
  return models;
}

} // namespace

void check_command(const Check_options& options) {
  // What cannot succeed fails before the work, not after it.
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
    throw MP::Error(in_one_line(wrong));
}

} // namespace multipatch
