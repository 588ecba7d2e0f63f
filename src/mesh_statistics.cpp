// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_statistics.h"

#include <CGAL/Multisided_patches/internal/cgal_compat.h>

#include <cmath>

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

bool is_as_joined(const Mesh_statistics& mesh, const Joined_sides& sides) {
  for (const MP::Patch_topology& patch : mesh.patches)
    if (!(sides.is_joined_to_itself(patch.patch) ? patch.components == 1 : patch.is_disk()))
      return false;
  return mesh.is_closed() == sides.free.empty();
}

} // namespace multipatch
