// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DEFAULT_MAPS_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DEFAULT_MAPS_H

#include <CGAL/Multisided_patches/meshing/Mesh_maps.h>

#include <CGAL/Origin.h>
#include <CGAL/Surface_mesh/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <type_traits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The coordinates of a point in two maps of their own, as files of meshes have them.
template <typename Map>
struct Uv_maps {
  Map u, v;

  template <typename Key, typename Point_2>
  friend void put(const Uv_maps& maps, const Key& key, const Point_2& p) {
    put(maps.u, key, CGAL::to_double(p.x()));
    put(maps.v, key, CGAL::to_double(p.y()));
  }
};

// The maps themselves, or those that stand for the default.
template <typename Patch, typename FaceGraph>
Mesh_maps<> maps_or_default(const Default_maps&, FaceGraph&) {
  return {};
}

template <typename Patch, typename Point_3>
auto maps_or_default(const Default_maps&, Surface_mesh<Point_3>& mesh) {
  using Vertex = typename Surface_mesh<Point_3>::Vertex_index;
  using Vector_3 = typename Patch::Geom_traits::Vector_3;
  const auto u = mesh.template add_property_map<Vertex, double>("v:u", 0).first;
  const auto v = mesh.template add_property_map<Vertex, double>("v:v", 0).first;
  const auto normals =
      mesh.template add_property_map<Vertex, Vector_3>("v:normal", Vector_3(NULL_VECTOR)).first;
  return Mesh_maps<>().vertex_normal_map(normals).vertex_uv_map(
      Uv_maps<std::decay_t<decltype(u)>>{u, v});
}

template <typename Patch, typename Maps, typename FaceGraph>
const Maps& maps_or_default(const Maps& maps, FaceGraph&) {
  return maps;
}

// In a complex, faces tell their patch.
template <typename Patch, typename Maps, typename FaceGraph>
auto maps_or_default_of_complex(const Maps& maps, FaceGraph& mesh) {
  return maps_or_default<Patch>(maps, mesh);
}

template <typename Patch, typename Point_3>
auto maps_or_default_of_complex(const Default_maps& maps, Surface_mesh<Point_3>& mesh) {
  using Face = typename Surface_mesh<Point_3>::Face_index;
  const auto patches = mesh.template add_property_map<Face, int>("f:patch", 0).first;
  return maps_or_default<Patch>(maps, mesh).face_patch_map(patches);
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DEFAULT_MAPS_H
