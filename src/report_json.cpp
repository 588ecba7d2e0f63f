// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report_json.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>

#include <algorithm>
#include <cmath>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// JSON has no infinity: the clearance of a triangle is null.
Json finite_or_null(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

double largest_mismatch(const Model& model) {
  double largest = 0;
  for (std::size_t i = 0; i < model.loop.size(); ++i)
    largest = (std::max)(largest, model.loop.corner_normal_mismatch(i));
  return degrees(largest);
}

Json contact_shortfalls_json(const Model& model) {
  Json shortfalls = Json::array();
  for (std::size_t i = 0; i < model.loop.size(); ++i) {
    const std::string text = MP::contact_shortfall(model.loop, i, model.central_weight);
    if (!text.empty())
      shortfalls.push_back({{"side", i},
                            {"order", MP::contact_order(model.loop, i, model.central_weight)},
                            {"promised", model.loop[i].layers() - 1},
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

Json model_json(const Model& model) {
  const auto corners = [&](MP::Corner_type type) { return model.loop.number_of_corners(type); };
  return {{"sides", model.loop.size()},
          {"convex_corners", corners(MP::Corner_type::convex)},
          {"reflex_corners", corners(MP::Corner_type::reflex)},
          {"straight_corners", corners(MP::Corner_type::straight)},
          {"diagonal", model.loop.diagonal()},
          {"largest_plane_mismatch_degrees", largest_mismatch(model)},
          {"contact_shortfalls", contact_shortfalls_json(model)},
          {"central_weight", to_string(model.central_weight)},
          {"unused_corner_control_points", model.corner_control_points.size()}};
}

Json domain_json(const MP::Domain_report& domain) {
  Json remarks = Json::array();
  for (const auto& remark : domain.remarks)
    remarks.push_back({{"generator", to_string(remark.generator)}, {"reason", remark.reason}});
  return {{"requested", to_string(domain.requested)},
          {"used", to_string(domain.used)},
          {"repair", domain.repair},
          {"clearance", finite_or_null(domain.clearance)},
          {"wanted_clearance", domain.wanted_clearance},
          {"remarks", remarks}};
}

Json coordinates_json(const Mesh_options& options, const Patch_report& patch) {
  Json json{{"name", to_string(options.patch.coordinates)}};
  add_if_any(json, "error_bound", patch.coordinates_error_bound);
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
