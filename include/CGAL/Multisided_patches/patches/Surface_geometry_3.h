// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_SURFACE_GEOMETRY_3_H
#define CGAL_MULTISIDED_PATCHES_SURFACE_GEOMETRY_3_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/patches/Surface_curvature_3.h>

#include <optional>

namespace CGAL {
namespace Multisided_patches {

//! The products of the first derivatives, which measure lengths in a surface (squared model units /
//! squared domain units).
struct First_fundamental_form {
  double E; //!< S_u · S_u
  double F; //!< S_u · S_v
  double G; //!< S_v · S_v
};

//! The components of the second derivatives along the unit normal n (model units / squared domain
//! units).
struct Second_fundamental_form {
  double L; //!< S_uu · n
  double M; //!< S_uv · n
  double N; //!< S_vv · n
};

/*!
 * The differential geometry of a surface S(u,v) at one point, in `double` arithmetic whatever the
 * kernel is.
 *
 * \tparam Traits a CGAL kernel
 */
template <typename Traits>
struct Surface_geometry_3 {
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;

  Point_3 point;                       //!< S (model units)
  Vector_3 derivative_u, derivative_v; //!< S_u and S_v (model units / domain units)
  Vector_3 derivative_uu, derivative_uv, derivative_vv; //!< (model units / squared domain units)
  /*!
   * the unit normal: the direction of S_u × S_v, which is the side from which the boundary runs
   * counterclockwise; at vertices and where S_u and S_v span no plane, that of the patch, and the
   * zero vector if it has none either
   */
  Vector_3 normal;
  First_fundamental_form first_form;
  Second_fundamental_form second_form;
  //! the curvatures; empty where S_u and S_v do not span the tangent plane or derivatives are
  //! not finite
  std::optional<Surface_curvature_3<Traits>> curvature;
};

namespace internal {

template <typename Traits>
Surface_geometry_3<Traits> surface_geometry(const Surface_derivatives& s, const Vec3& normal) {
  using FT = typename Traits::FT;
  const auto vector = [](const Vec3& a) {
    return typename Traits::Vector_3(FT(a[0]), FT(a[1]), FT(a[2]));
  };
  Surface_geometry_3<Traits> geometry{ORIGIN + vector(s.point),
                                      vector(s.u),
                                      vector(s.v),
                                      vector(s.uu),
                                      vector(s.uv),
                                      vector(s.vv),
                                      vector(normal),
                                      {dot(s.u, s.u), dot(s.u, s.v), dot(s.v, s.v)},
                                      {dot(s.uu, normal), dot(s.uv, normal), dot(s.vv, normal)},
                                      {}};
  // At a vertex derivatives that do not exist may be anything, and span a plane that is none.
  constexpr double tolerance = 1e-6; // radians
  const Vec3 plane = tangent_plane_normal(s);
  if (all_finite(s) && plane != Vec3{0, 0, 0} && angle_between(plane, normal) < tolerance)
    geometry.curvature.emplace(s, normal);
  return geometry;
}

} // namespace internal

/*!
 * computes derivatives, normal, fundamental forms and curvatures of a patch at `uv`.
 *
 * Inside the domain a patch is smooth, and all of this exists unless the surface degenerates. On
 * the sides derivatives are limits from the inside. At vertices the normal is that of the ribbons,
 * but first and second derivatives, and so curvatures, need not exist: what is returned then is
 * what the coordinates of the patch give there, which their documentation says. Close to a corner,
 * evaluate at a point on a side instead.
 *
 * \tparam Patch a class with the members `evaluate<2>()` and `normal()` of `Concave_bezier_patch_3`
 *
 * \pre `uv` lies at `location`, and that is not outside the domain
 *
 * Complexity: that of `evaluate<2>()`, plus a constant.
 */
template <typename Patch>
Surface_geometry_3<typename Patch::Geom_traits>
surface_geometry(const Patch& patch, const typename Patch::Point_2& uv,
                 const typename Patch::Location& location) {
  using Traits = typename Patch::Geom_traits;
  const internal::Surface_derivatives s =
      internal::to_surface_derivatives(patch.template evaluate<2>(uv, location));
  internal::Vec3 normal = internal::tangent_plane_normal(s);
  const bool at_vertex = location.kind == Patch::Location::Kind::vertex;
  if (at_vertex || normal == internal::Vec3{0, 0, 0})
    normal = internal::to_vec3(patch.normal(uv, location));
  return internal::surface_geometry<Traits>(s, normal);
}

//! the same for a point of which only the position is known. \throws Outside_domain_error if `uv`
//! lies outside the domain
template <typename Patch>
Surface_geometry_3<typename Patch::Geom_traits>
surface_geometry(const Patch& patch, const typename Patch::Point_2& uv) {
  return surface_geometry(patch, uv, patch.domain().locate_inside(uv));
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_SURFACE_GEOMETRY_3_H
