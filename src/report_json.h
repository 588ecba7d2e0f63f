// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_REPORT_JSON_H
#define MULTIPATCH_REPORT_JSON_H

#include "mesh_report.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace multipatch {

using Json = nlohmann::ordered_json;

// What reports on meshes have in common.
Json model_json(const Any_model& model, const Any_patch& patch);
Json domain_json(const CGAL::Multisided_patches::Domain_report& domain);
Json coordinates_json(const Patch_origin& origin);
Json density_json(const CGAL::Multisided_patches::Mesh_density& density);
Json statistics_json(const Mesh_statistics& mesh);
Json checked_mesh_json(const Checked_mesh& mesh);
Json seconds_json(const Stage_clock& clock);

// The pairs of sides that are joined, by the names of the inputs, and those that are not.
Json shared_sides_json(const Joined_sides& sides, const std::vector<std::string>& inputs);
Json free_sides_json(const Joined_sides& sides, const std::vector<std::string>& inputs);

// File names need not be UTF-8, which JSON is.
std::string to_text(const Json& json);

// Writes a file, whole or not at all.
void write_json(const std::string& file_name, const Json& json);

} // namespace multipatch

#endif // MULTIPATCH_REPORT_JSON_H
