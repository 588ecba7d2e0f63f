// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_report.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;
using Json = nlohmann::ordered_json;

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

Json contact_shortfalls(const Model& model) {
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

Json model_json(const Model& model) {
  const auto corners = [&](MP::Corner_type type) { return model.loop.number_of_corners(type); };
  return {{"sides", model.loop.size()},
          {"convex_corners", corners(MP::Corner_type::convex)},
          {"reflex_corners", corners(MP::Corner_type::reflex)},
          {"straight_corners", corners(MP::Corner_type::straight)},
          {"diagonal", model.loop.diagonal()},
          {"largest_plane_mismatch_degrees", largest_mismatch(model)},
          {"contact_shortfalls", contact_shortfalls(model)},
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

Json mesh_json(const Mesh_report& report) {
  return {{"vertices", report.vertices},
          {"boundary_vertices", report.boundary_vertices},
          {"triangles", report.triangles},
          {"shortest_edge", report.shortest_edge},
          {"mean_edge", report.mean_edge},
          {"longest_edge", report.longest_edge},
          {"components", report.topology.components},
          {"boundary_loops", report.topology.boundary_loops},
          {"euler_characteristic", report.topology.euler_characteristic},
          {"is_disk", report.topology.is_disk()}};
}

Json boundary_json(const MP::Boundary_deviation& boundary, double diagonal) {
  return {{"vertex_deviation", boundary.vertices},
          {"vertex_deviation_relative", boundary.vertices / diagonal},
          {"edge_deviation", boundary.edges},
          {"edge_deviation_relative", boundary.edges / diagonal}};
}

} // namespace

void measure_edges(const CGAL::Surface_mesh<Kernel::Point_3>& mesh, Mesh_report& report) {
  double total = 0;
  bool first = true;
  for (const auto e : mesh.edges()) {
    const double length = std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
    report.shortest_edge = first ? length : (std::min)(report.shortest_edge, length);
    report.longest_edge = (std::max)(report.longest_edge, length);
    total += length;
    first = false;
  }
  report.mean_edge = total / static_cast<double>(mesh.number_of_edges());
}

void print_report(const Mesh_options& options, const Model& model, const Mesh_report& report,
                  const Stage_clock& clock) {
  double seconds = 0;
  for (const auto& stage : clock.seconds())
    seconds += stage.second;
  std::printf("%s: %zu triangles, %zu vertices; domain %s, clearance %.3g; %.2f s\n",
              options.output.c_str(), report.triangles, report.vertices,
              to_string(report.domain.used), report.domain.clearance, seconds);
  print_remarks(report.domain);
  print_contact_shortfalls(model);
}

void write_report(const Mesh_options& options, const Model& model, const Mesh_report& report,
                  const Stage_clock& clock) {
  Json coordinates{{"name", to_string(options.patch.coordinates)}};
  if (report.coordinates_error_bound)
    coordinates["error_bound"] = *report.coordinates_error_bound;
  Json seconds = Json::object();
  for (const auto& [stage, time] : clock.seconds())
    seconds[stage] = time;
  const Json json{{"input", options.patch.input},
                  {"output", options.output},
                  {"model", model_json(model)},
                  {"domain", domain_json(report.domain)},
                  {"coordinates", coordinates},
                  {"mesh", mesh_json(report)},
                  {"boundary", boundary_json(report.boundary, model.loop.diagonal())},
                  {"seconds", seconds}};
  MP::internal::Atomic_file file(options.report);
  file.stream() << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  file.commit();
}

} // namespace multipatch
