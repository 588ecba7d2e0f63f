// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_job.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>

#include <filesystem>
#include <system_error>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

void refuse_directories(const std::vector<std::string>& inputs) {
  std::error_code ignored;
  for (const std::string& input : inputs)
    if (std::filesystem::is_directory(input, ignored))
      throw MP::Input_error(input + ": expected a file, found a directory; with "
                                    "--output-directory, all patches in it are meshed");
}

} // namespace

MP::Mesh_density wanted_density(const Mesh_options& options) {
  constexpr std::size_t default_triangles = 10000;
  std::optional<MP::Mesh_density> wanted;
  const auto add = [&](const MP::Mesh_density& other) {
    wanted = wanted ? *wanted & other : other;
  };
  if (options.edge_length)
    add(MP::Mesh_density::edge_length(*options.edge_length));
  if (options.chordal_deviation)
    add(MP::Mesh_density::chordal_deviation(*options.chordal_deviation));
  if (options.normal_deviation)
    add(MP::Mesh_density::normal_deviation(*options.normal_deviation));
  return wanted ? *wanted
                : MP::Mesh_density::triangles(options.triangles.value_or(default_triangles));
}

void require_sound(bool is_sound, const std::string& output) {
  if (!is_sound)
    throw MP::Numerical_error(output + ": the mesh came out torn; this is a defect of the "
                                       "program, please report it");
}

void require_sound(bool is_sound, const Mesh_options& options) {
  require_sound(is_sound, options.output);
}

void mesh_command(const Mesh_options& options) {
  if (!options.batch.directory.empty()) {
    batch_command(options);
    return;
  }
  // What cannot succeed fails before the work, not after it.
  check_different(options.output, options.inputs);
  if (!options.report.empty()) {
    check_different(options.report, options.inputs);
    check_different(options.report, {options.output});
  }
  refuse_directories(options.inputs);
  Mesh_job job{options, wanted_density(options), Stage_clock(options.quiet)};
  job.models = job.clock.run(
      "reading", [&] { return read_models(options.patch, options.inputs, options.quiet); });
  MP::internal::check_writable(options.output);
  if (!options.report.empty())
    MP::internal::check_writable(options.report);
  if (options.inputs.size() == 1)
    mesh_patch(job);
  else
    mesh_complex(job);
}

} // namespace multipatch
