// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_CHECK_REPORT_H
#define MULTIPATCH_CHECK_REPORT_H

#include "commands.h"
#include "joined_sides.h"
#include "mesh_statistics.h"

#include <CGAL/Multisided_patches/analysis/Side_continuity.h>
#include <CGAL/Multisided_patches/analysis/fairness_report.h>

#include <cstddef>
#include <string>
#include <vector>

namespace multipatch {

// How a patch meets its ribbons.
struct Checked_patch {
  std::string input;
  double diagonal;
  CGAL::Multisided_patches::Continuity_report continuity;
  std::vector<std::string> shortfalls; // sides that cannot have what their layers promise
  CGAL::Multisided_patches::Fairness_report<Kernel> fairness = {};
  std::string domain_mesh_defect = {}; // empty if the mesh of its domain is fine
};

// How two patches meet along a side.
struct Checked_seam {
  std::size_t patch_a, patch_b; // indices
  double diagonal;              // the larger one
  bool is_joined;               // whether they are one in the mesh
  bool has_gap;                 // whether they are not as the curves are not the same
  CGAL::Multisided_patches::Seam_continuity continuity;
};

struct Check_report {
  std::vector<Checked_patch> patches;
  std::vector<Checked_seam> seams;
  Joined_sides sides;
  Checked_mesh mesh; // of all patches
  bool is_as_joined = false;
};

// The number of sides and seams that exceed a tolerance, and of all of them.
struct Check_count {
  std::size_t failed = 0, all = 0;
};
Check_count count_failures(const Check_options& options, const Check_report& report);

// What is wrong, a phrase each.
std::vector<std::string> failures(const Check_options& options, const Check_report& report);

// Prints a table of all sides and seams.
void print_table(const Check_options& options, const Check_report& report);

// The same as a JSON text.
std::string check_json(const Check_options& options, const Check_report& report);

} // namespace multipatch

#endif // MULTIPATCH_CHECK_REPORT_H
