// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_COMPLEX_REPORT_H
#define MULTIPATCH_COMPLEX_REPORT_H

#include "joined_sides.h"
#include "mesh_report.h"

#include <vector>

namespace multipatch {

// What is worth knowing about the finished mesh of several patches.
struct Complex_report {
  std::vector<Any_patch> patches;
  Joined_sides sides;
  Mesh_statistics mesh;
};

// As for a single patch.
void print_report(const Mesh_job& job, const Complex_report& report);
void write_report(const Mesh_job& job, const Complex_report& report);

} // namespace multipatch

#endif // MULTIPATCH_COMPLEX_REPORT_H
