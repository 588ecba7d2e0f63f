// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report_json.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// JSON has no infinity: the clearance of a triangle is null.
Json finite_or_null(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

double largest_mismatch(const Loop& loop) {
  double largest = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    largest = (std::max)(largest, loop.corner_normal_mismatch(i));
  return degrees(largest);
}

// Only the ribbons of concave patches promise what the patch may not have.
Json contact_shortfalls_json(const Any_model& model) {
  Json shortfalls = Json::array();
  const auto* concave = std::get_if<Concave_model>(&model);
  for (std::size_t i = 0; concave != nullptr && i < concave->loop.size(); ++i) {
    const std::string text = MP::contact_shortfall(concave->loop, i, concave->central_weight);
    if (!text.empty())
      shortfalls.push_back({{"side", i},
                            {"order", MP::contact_order(concave->loop, i, concave->central_weight)},
                            {"promised", concave->loop[i].layers() - 1},
                            {"reason", text}});
  }
  return shortfalls;
}

template <typename Number>
void add_if_any(Json& json, const char* key, const std::optional<Number>& number) {
  if (number)
    json[key] = *number;
}

} // namespace

Json model_json(const Any_model& model, const Any_patch& patch) {
  const Loop& loop = patch.loop();
  Json json{{"type", to_string(MP::IO::patch_type<Kernel>(model))},
            {"sides", loop.size()},
            {"convex_corners", loop.number_of_corners(MP::Corner_type::convex)},
            {"reflex_corners", loop.number_of_corners(MP::Corner_type::reflex)},
            {"straight_corners", loop.number_of_corners(MP::Corner_type::straight)},
            {"diagonal", loop.diagonal()},
            {"largest_plane_mismatch_degrees", largest_mismatch(loop)},
            {"contact_shortfalls", contact_shortfalls_json(model)}};
  if (const auto* concave = std::get_if<Concave_model>(&model)) {
    json["central_weight"] =
        to_string(patch.origin().central_weight.value_or(concave->central_weight));
    json["central_weight_requested"] = to_string(concave->central_weight);
    json["corner_control_points"] = concave->corner_control_points.size();
  }
  return json;
}

Json domain_json(const MP::Domain_report& domain) {
  Json remarks = Json::array();
  for (const auto& remark : domain.remarks)
    remarks.push_back({{"generator", to_string(remark.generator)}, {"reason", remark.reason}});
  const bool is_given = domain.used == MP::Domain_generator::automatic;
  return {{"requested", is_given ? domain_name(domain) : to_string(domain.requested)},
          {"used", domain_name(domain)},
          {"repair", domain.repair},
          {"clearance", finite_or_null(domain.clearance)},
          {"wanted_clearance", domain.wanted_clearance},
          {"remarks", remarks}};
}

Json coordinates_json(const Patch_origin& origin) {
  if (!origin.coordinates)
    return nullptr;
  Json json{{"name", to_string(*origin.coordinates)}};
  add_if_any(json, "error_bound", origin.error_bound);
  return json;
}

Json density_json(const MP::Mesh_density& density) {
  Json json = Json::object();
  add_if_any(json, "target_triangles", density.target_triangles());
  add_if_any(json, "target_edge_length", density.target_edge_length());
  add_if_any(json, "max_chordal_deviation", density.max_chordal_deviation());
  add_if_any(json, "max_normal_deviation_degrees", density.max_normal_deviation());
  return json;
}

Json statistics_json(const Mesh_statistics& mesh) {
  Json json{{"vertices", mesh.vertices},
            {"edges", mesh.edges},
            {"triangles", mesh.triangles},
            {"shortest_edge", mesh.shortest_edge},
            {"mean_edge", mesh.mean_edge},
            {"longest_edge", mesh.longest_edge},
            {"smallest_angle_degrees", mesh.smallest_angle},
            {"largest_angle_degrees", mesh.largest_angle},
            {"components", mesh.components},
            {"boundary_loops", mesh.boundary_loops},
            {"euler_characteristic", mesh.euler_characteristic},
            {"closed", mesh.is_closed()},
            {"degenerate_triangles", mesh.degenerate_triangles},
            {"folded_edges", mesh.folded_edges}};
  add_if_any(json, "inverted_triangles", mesh.inverted_triangles);
  return json;
}

Json checked_mesh_json(const Checked_mesh& mesh) {
  Json json = statistics_json(mesh.statistics);
  json["self_intersections"] = mesh.self_intersections;
  return json;
}

Json seconds_json(const Stage_clock& clock) {
  Json seconds = Json::object();
  for (const auto& [stage, time] : clock.seconds())
    seconds[stage] = time;
  return seconds;
}

Json shared_sides_json(const Joined_sides& sides, const std::vector<std::string>& inputs) {
  Json json = Json::array();
  for (const MP::Shared_side& s : sides.shared)
    json.push_back({{"input_a", inputs[s.patch_a]},
                    {"side_a", s.side_a},
                    {"input_b", inputs[s.patch_b]},
                    {"side_b", s.side_b}});
  return json;
}

Json free_sides_json(const Joined_sides& sides, const std::vector<std::string>& inputs) {
  Json json = Json::array();
  for (const auto& [patch, side] : sides.free)
    json.push_back({{"input", inputs[patch]}, {"side", side}});
  return json;
}

std::string to_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void write_json(const std::string& file_name, const Json& json) {
  MP::internal::Atomic_file file(file_name);
  file.stream() << to_text(json);
  file.commit();
}

} // namespace multipatch
