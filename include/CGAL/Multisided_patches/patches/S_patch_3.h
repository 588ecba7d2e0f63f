// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_S_PATCH_3_H
#define CGAL_MULTISIDED_PATCHES_S_PATCH_3_H

#include <CGAL/Multisided_patches/bases/S_patch_basis.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/domains/make_regular_domain.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/patches/internal/Control_net_patch.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>
#include <CGAL/Multisided_patches/ribbons/S_patch_net_3.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The S-patch: the generalization of Bézier triangles to any number of sides (Loop and DeRose, *A
 * multisided generalization of Bézier surfaces*, ACM Transactions on Graphics 8, 1989).
 *
 * The patch is the `S_patch_basis` on barycentric coordinates of a planar domain, times the control
 * points of an `S_patch_net_3`. On three sides it is the Bézier triangle of the net; on a square
 * with Wachspress coordinates, which are bilinear there, it is a tensor product patch of degree d
 * by d for depth d. Its boundary curves are the Bézier curves of the boundary of the net, whatever
 * the coordinates; so the domain may be concave if the coordinates are made for that.
 *
 * `fill_with_S_patch()` makes the net from ribbons, and `loop()` of its patch has them, with 2
 * layers. A net does not hold them, and so neither does a `.patch.json` file: `loop()` of a patch
 * made from a net alone, elevated or read from a file for instance, are its boundary curves, with
 * one layer. Then normals on the boundary are those of the surface, and `continuity_report()` has
 * no tangent planes to compare with. Pass the ribbons to the constructor that takes them.
 *
 * \cgalModels{MultisidedPatch_3}
 *
 * \tparam Traits a CGAL kernel with exact predicates
 * \tparam Coordinates a model of `BarycentricCoordinates_2`
 */
template <typename Traits, typename Coordinates = Wachspress_coordinates_2<Traits>>
class S_patch_3 : public internal::Control_net_patch<S_patch_3<Traits, Coordinates>, Coordinates,
                                                     S_patch_basis> {
  using Base = internal::Control_net_patch<S_patch_3, Coordinates, S_patch_basis>;

public:
  using typename Base::Loop;
  using typename Base::Point_3;
  using Net = S_patch_net_3<Traits>;

  /*!
   * makes a patch over a regular polygon.
   *
   * \throws Input_error if a side of the net is a single point
   */
  explicit S_patch_3(const Net& net)
      : S_patch_3(net, Base::make_coordinates(make_regular_domain<Traits>(net.size()))) {}

  /*!
   * takes coordinates on a domain of the caller's choice, with one vertex for each side.
   *
   * \throws Input_error if the numbers of vertices and sides differ, or a side is a single point
   */
  S_patch_3(const Net& net, const Coordinates& coordinates)
      : S_patch_3(net, net.loop(), coordinates, Boundary_is_checked()) {}

  /*!
   * the same for a net that was made to meet ribbons: `loop()` returns these, normals on the
   * boundary are those of the ribbons, and `continuity_report()` compares with them.
   *
   * \param net the control points
   * \param loop ribbons of degree at most d; the control points of their boundary curves, elevated
   * to degree d, have to be those of the net, to 1e-9 of the diagonal of the loop and a few
   * roundings of the largest coordinate
   * \param coordinates coordinates with one vertex for each side
   *
   * \throws Input_error if the numbers of vertices and sides differ, or the boundary curves are not
   * those of the net
   */
  S_patch_3(const Net& net, const Loop& loop, const Coordinates& coordinates)
      : S_patch_3(net, checked(net, loop), coordinates, Boundary_is_checked()) {}

  //! the control net
  const Net& net() const { return net_; }

private:
  struct Boundary_is_checked {};

  S_patch_3(const Net& net, const Loop& loop, const Coordinates& coordinates, Boundary_is_checked)
      : Base(loop, coordinates, Base::report_on(coordinates.domain()),
             S_patch_basis(net.size(), net.depth()), net.control_points()),
        net_(net) {}

  static const Loop& checked(const Net& net, const Loop& loop) {
    if (loop.size() != net.size())
      throw Input_error("a net with " + std::to_string(net.size()) +
                        " sides needs as many ribbons, not " + std::to_string(loop.size()));
    const double tolerance = 1e-9 * loop.diagonal() + 8 * internal::coordinate_rounding(loop);
    for (std::size_t i = 0; i < loop.size(); ++i)
      check_boundary(net.boundary(i), loop[i], i, tolerance);
    return loop;
  }

  using Ribbon = typename Loop::Ribbon;

  static void check_boundary(const Ribbon& boundary, const Ribbon& ribbon, std::size_t side,
                             double tolerance) {
    const std::size_t depth = boundary.degree();
    if (ribbon.degree() > depth)
      throw Input_error("the ribbon of side " + std::to_string(side) + " has degree " +
                        std::to_string(ribbon.degree()) + "; the boundary of the net has degree " +
                        std::to_string(depth));
    const Ribbon elevated = ribbon.elevated(depth);
    for (std::size_t j = 0; j <= depth; ++j) {
      const double gap = internal::norm(
          internal::to_vec3(elevated.control_point(j, 0) - boundary.control_point(j, 0)));
      if (!(gap <= tolerance))
        throw Input_error("the boundary of the net is not that of the ribbon of side " +
                          std::to_string(side) + ": control point " + std::to_string(j) +
                          " of the curve of degree " + std::to_string(depth) + " is off by " +
                          internal::to_short_text(gap));
    }
  }

  Net net_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_S_PATCH_3_H
