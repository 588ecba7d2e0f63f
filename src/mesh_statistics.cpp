// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_statistics.h"

#include <CGAL/Multisided_patches/internal/cgal_compat.h>

#include <cmath>
#include <cstdio>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

double mean_edge(const Mesh& mesh) {
  double total = 0;
  for (const auto e : mesh.edges())
    total += std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return total / static_cast<double>(mesh.number_of_edges());
}

MP::Mesh_check check(const Mesh& mesh) {
  const auto normals =
      MP::internal::find_property_map<Mesh::Vertex_index, Kernel::Vector_3>(mesh, "v:normal");
  const auto patches = MP::internal::find_property_map<Mesh::Face_index, int>(mesh, "f:patch");
  if (!normals)
    return MP::check_mesh(mesh);
  const auto parameters = CGAL::parameters::vertex_normal_map(*normals);
  return patches ? MP::check_mesh(mesh, parameters.face_patch_map(*patches))
                 : MP::check_mesh(mesh, parameters);
}

} // namespace

Mesh_statistics measure(const Mesh& mesh) {
  return {check(mesh), mean_edge(mesh)};
}

std::string description(const Checked_mesh& mesh) {
  const Mesh_statistics& m = mesh.statistics;
  char sizes[120];
  std::snprintf(sizes, sizeof sizes, "angles %.3g to %.4g degrees, edges %.3g to %.3g",
                m.smallest_angle, m.largest_angle, m.shortest_edge, m.longest_edge);
  std::string text = counted(m.triangles, "triangle") + ", " + counted(m.components, "component") +
                     ", " +
                     (m.is_closed() ? "closed" : counted(m.boundary_loops, "boundary loop")) +
                     ", Euler characteristic " + std::to_string(m.euler_characteristic) + "; " +
                     sizes + "; " + counted(mesh.self_intersections, "self-intersection") + ", " +
                     counted(m.degenerate_triangles, "degenerate triangle") + ", " +
                     counted(m.folded_edges, "folded edge");
  if (m.inverted_triangles)
    text += ", " + counted(*m.inverted_triangles, "inverted triangle");
  return text;
}

std::vector<std::string> defects(const Checked_mesh& mesh) {
  std::vector<std::string> texts;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0)
      texts.push_back("the mesh has " + counted(count, what));
  };
  add(mesh.self_intersections, "self-intersection");
  add(mesh.statistics.degenerate_triangles, "degenerate triangle");
  add(mesh.statistics.folded_edges, "folded edge");
  add(mesh.statistics.inverted_triangles.value_or(0), "inverted triangle");
  return texts;
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

std::string in_one_line(const std::vector<std::string>& phrases) {
  std::string text;
  for (const std::string& phrase : phrases)
    text += (text.empty() ? "" : "; ") + phrase;
  return text;
}

bool is_as_joined(const Mesh_statistics& mesh, const Joined_sides& sides) {
  for (const MP::Patch_topology& patch : mesh.patches)
    if (!(sides.is_joined_to_itself(patch.patch) ? patch.components == 1 : patch.is_disk()))
      return false;
  return mesh.is_closed() == sides.free.empty();
}

} // namespace multipatch
