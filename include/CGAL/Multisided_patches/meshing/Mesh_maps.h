// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESH_MAPS_H
#define CGAL_MULTISIDED_PATCHES_MESH_MAPS_H

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Multisided_patches {

//! Stands for a property map that nobody asked for.
struct No_map {};

/*!
 * The property maps into which `tessellate()` writes what it knows beyond points and triangles:
 *
 * \code
 * tessellate(patch, mesh, density, Mesh_maps().vertex_normal_map(normals).face_patch_map(ids));
 * \endcode
 *
 * All are models of `WritablePropertyMap` whose keys are the descriptors of the mesh. Values:
 *   - `vertex_normal_map`: `Vector_3` of unit length, or the zero vector where not even the
 *     triangles around the vertex have a normal; in a complex, the mean of those of the patches;
 *   - `vertex_uv_map`: `Point_2` (domain units); on a side that patches share, of the first;
 *   - `vertex_mean_curvature_map`, `vertex_Gaussian_curvature_map`: `double` (the inverse of model
 *     units, and of their square), not a number where the surface has no curvature; they need the
 *     second derivatives of the patch, as `surface_geometry()` does;
 *   - `halfedge_side_map`: `std::size_t`, the side of its patch on which a halfedge of a triangle
 *     lies; written only for those that lie on a side;
 *   - `face_patch_map`: `std::size_t`, the index of the patch in the complex, 0 for a patch alone.
 */
template <typename Normal = No_map, typename Uv = No_map, typename Mean = No_map,
          typename Gaussian = No_map, typename Side = No_map, typename Patch = No_map>
class Mesh_maps {
public:
  Normal normal;
  Uv uv;
  Mean mean_curvature;
  Gaussian gaussian_curvature;
  Side side;
  Patch patch;

  template <typename Map>
  Mesh_maps<Map, Uv, Mean, Gaussian, Side, Patch> vertex_normal_map(Map map) const {
    return {map, uv, mean_curvature, gaussian_curvature, side, patch};
  }
  template <typename Map>
  Mesh_maps<Normal, Map, Mean, Gaussian, Side, Patch> vertex_uv_map(Map map) const {
    return {normal, map, mean_curvature, gaussian_curvature, side, patch};
  }
  template <typename Map>
  Mesh_maps<Normal, Uv, Map, Gaussian, Side, Patch> vertex_mean_curvature_map(Map map) const {
    return {normal, uv, map, gaussian_curvature, side, patch};
  }
  template <typename Map>
  Mesh_maps<Normal, Uv, Mean, Map, Side, Patch> vertex_Gaussian_curvature_map(Map map) const {
    return {normal, uv, mean_curvature, map, side, patch};
  }
  template <typename Map>
  Mesh_maps<Normal, Uv, Mean, Gaussian, Map, Patch> halfedge_side_map(Map map) const {
    return {normal, uv, mean_curvature, gaussian_curvature, map, patch};
  }
  template <typename Map>
  Mesh_maps<Normal, Uv, Mean, Gaussian, Side, Map> face_patch_map(Map map) const {
    return {normal, uv, mean_curvature, gaussian_curvature, side, map};
  }
};

/*!
 * Stands for the property maps that `tessellate()` makes if it is not told others: for a
 * `Surface_mesh` these are `"v:normal"` (`Vector_3`, unit length), `"v:u"` and `"v:v"` (`double`,
 * domain units), and of a complex `"f:patch"` (`int`), too; for other meshes none.
 */
struct Default_maps {};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESH_MAPS_H
