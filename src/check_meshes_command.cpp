// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_file.h"
#include "mesh_statistics.h"
#include "report_json.h"
#include "report_output.h"
#include "stage_clock.h"

#include <cstdio>
#include <optional>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

struct Checked_file {
  std::string input;
  std::optional<Checked_mesh> mesh; // none if the triangles make none
  std::vector<std::string> defects;
};

Checked_file check(const std::string& input, Stage_clock& clock) {
  const Mesh_file file = clock.run("reading", [&] { return read_mesh_file(input); });
  if (!file.defect.empty())
    return {input, std::nullopt, {"the triangles make no mesh: " + file.defect}};
  return clock.run("checks", [&]() -> Checked_file {
    try {
      const Checked_mesh mesh{measure(file.mesh), self_intersections(file.mesh)};
      return {input, mesh, defects(mesh)};
    } catch (const MP::Input_error& error) {
      throw MP::Input_error(input + ": " + error.what());
    }
  });
}

void print(const Checked_file& file) {
  if (file.mesh)
    std::printf("%s: %s\n", file.input.c_str(), description(*file.mesh).c_str());
  else
    std::printf("%s:\n", file.input.c_str());
  for (const std::string& defect : file.defects)
    std::printf("  %s\n", defect.c_str());
}

Json file_json(const Checked_file& file) {
  Json json{{"input", file.input}, {"passed", file.defects.empty()}, {"failures", file.defects}};
  json["mesh"] = file.mesh ? checked_mesh_json(*file.mesh) : Json();
  return json;
}

std::vector<std::string> failures(const std::vector<Checked_file>& files) {
  std::vector<std::string> texts;
  for (const Checked_file& file : files)
    for (const std::string& defect : file.defects)
      texts.push_back(file.input + ": " + defect);
  return texts;
}

std::string to_json(const std::vector<Checked_file>& files) {
  Json meshes = Json::array();
  for (const Checked_file& file : files)
    meshes.push_back(file_json(file));
  const std::vector<std::string> wrong = failures(files);
  return to_text({{"passed", wrong.empty()}, {"failures", wrong}, {"meshes", meshes}});
}

} // namespace

void check_meshes_command(const Check_options& options) {
  const Report_output output(options.json, options.quiet, options.inputs);
  std::vector<Checked_file> files;
  {
    Stage_clock clock(options.quiet);
    for (const std::string& input : options.inputs)
      files.push_back(check(input, clock));
  }
  output.write([&] { return to_json(files); },
               [&] {
                 for (const Checked_file& file : files)
                   print(file);
               });
  const std::vector<std::string> wrong = failures(files);
  if (!wrong.empty())
    throw MP::Error(in_one_line(wrong));
}

} // namespace multipatch
