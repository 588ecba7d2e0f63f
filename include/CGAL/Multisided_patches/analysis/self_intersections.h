// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_SELF_INTERSECTIONS_H
#define CGAL_MULTISIDED_PATCHES_SELF_INTERSECTIONS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * counts the pairs of triangles of a mesh that have more in common than the vertex or edge that
 * they share. Triangles of separate components that touch are such a pair. Degenerate triangles
 * are left out; `check_mesh()` counts those.
 *
 * This takes much longer than `check_mesh()`, and its header much longer to compile.
 *
 * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
 * \tparam Mesh a model of `FaceListGraph` and `HalfedgeListGraph` whose faces are triangles
 *
 * \param mesh the mesh
 * \param np optional named parameters of CGAL: `vertex_point_map`, `geom_traits`, ...
 */
template <typename ConcurrencyTag = Parallel_if_available_tag, typename Mesh,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t number_of_self_intersections(const Mesh& mesh,
                                         const NamedParameters& np = parameters::default_values()) {
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;
  using Pair = std::pair<Face, Face>;
  std::vector<Pair> pairs;
  Polygon_mesh_processing::self_intersections<ConcurrencyTag>(mesh, std::back_inserter(pairs), np);
  // CGAL reports a degenerate triangle as one that meets itself.
  return static_cast<std::size_t>(std::count_if(
      pairs.begin(), pairs.end(), [](const Pair& pair) { return pair.first != pair.second; }));
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_SELF_INTERSECTIONS_H
