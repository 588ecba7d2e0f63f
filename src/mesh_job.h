// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MESH_JOB_H
#define MULTIPATCH_MESH_JOB_H

#include "any_model.h"
#include "commands.h"
#include "stage_clock.h"

#include <CGAL/Multisided_patches/meshing/Mesh_density.h>

#include <string>
#include <vector>

namespace multipatch {

// What the command mesh is about.
struct Mesh_job {
  const Mesh_options& options;
  CGAL::Multisided_patches::Mesh_density density;
  Stage_clock clock;
  std::vector<Any_model> models = {};
};

// Mesh a single patch, or several that may have sides in common; check, write and report.
void mesh_patch(Mesh_job& job);
void mesh_complex(Mesh_job& job);

// What the options say about it.
CGAL::Multisided_patches::Mesh_density wanted_density(const Mesh_options& options);

// Throws if a mesh is not what it must be.
void require_sound(bool is_sound, const std::string& output);
void require_sound(bool is_sound, const Mesh_options& options);

} // namespace multipatch

#endif // MULTIPATCH_MESH_JOB_H
