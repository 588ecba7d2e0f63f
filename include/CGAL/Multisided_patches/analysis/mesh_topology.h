// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESH_TOPOLOGY_H
#define CGAL_MULTISIDED_PATCHES_MESH_TOPOLOGY_H

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! What a mesh is, seen as a topological space.
struct Mesh_topology {
  std::size_t components = 0;
  std::size_t boundary_loops = 0;
  long euler_characteristic = 0;

  //! whether the mesh is a single disk
  bool is_disk() const {
    return components == 1 && boundary_loops == 1 && euler_characteristic == 1;
  }
};

/*!
 * counts the components and boundary loops of a mesh.
 *
 * \tparam Mesh a `CGAL::Surface_mesh` without removed elements
 *
 * Complexity: linear in the size of the mesh.
 */
template <typename Mesh>
Mesh_topology mesh_topology(const Mesh& mesh) {
  const std::size_t n = mesh.number_of_vertices();
  std::vector<std::size_t> rank(n), parent(n);
  boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
  Mesh_topology topology;
  topology.components = n;
  for (std::size_t v = 0; v < n; ++v)
    sets.make_set(v);
  for (const auto e : mesh.edges()) {
    const std::size_t a = sets.find_set(std::size_t(mesh.vertex(e, 0)));
    const std::size_t b = sets.find_set(std::size_t(mesh.vertex(e, 1)));
    if (a != b) {
      sets.link(a, b);
      --topology.components;
    }
  }

  std::vector<bool> seen(mesh.number_of_halfedges(), false);
  for (const auto start : mesh.halfedges()) {
    if (!mesh.is_border(start) || seen[start])
      continue;
    ++topology.boundary_loops;
    for (auto h = start; !seen[h]; h = mesh.next(h))
      seen[h] = true;
  }
  topology.euler_characteristic = static_cast<long>(n) - static_cast<long>(mesh.number_of_edges()) +
                                  static_cast<long>(mesh.number_of_faces());
  return topology;
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESH_TOPOLOGY_H
