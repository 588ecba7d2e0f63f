// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_GENERALIZED_BEZIER_PATCH_3_H
#define CGAL_MULTISIDED_PATCHES_GENERALIZED_BEZIER_PATCH_3_H

#include <CGAL/Multisided_patches/bases/Generalized_bezier_basis.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/domains/make_regular_domain.h>
#include <CGAL/Multisided_patches/patches/internal/Control_net_patch.h>
#include <CGAL/Multisided_patches/ribbons/Generalized_bezier_net_3.h>

#include <utility>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The generalized Bézier patch: a smooth surface with any number of sides over a convex domain,
 * from a control net that is a ring of control points around a central one (Várady, Salvi and
 * Karikó, *A multi-sided Bézier patch with a simple control structure*, Computer Graphics Forum 35,
 * 2016; Várady, Salvi and Kovács, *Enhancement of a multi-sided Bézier surface representation*,
 * Computer Aided Geometric Design 55, 2017).
 *
 * The patch is the `Generalized_bezier_basis` on barycentric coordinates of a planar domain, times
 * the control points. It has the derivatives across its sides of the ribbons that its net gives. On
 * four sides and a square domain it is the tensor product patch of its control points. On three
 * sides it is not a Bézier triangle, but has the boundary curves of one of the same degree.
 *
 * A patch is complete when it is constructed, never changes, and can be evaluated from many threads
 * at once.
 *
 * \cgalModels{MultisidedPatch_3}
 *
 * \tparam Traits a CGAL kernel with exact predicates
 * \tparam Coordinates a model of `BarycentricCoordinates_2`
 */
template <typename Traits, typename Coordinates = Wachspress_coordinates_2<Traits>>
class Generalized_bezier_patch_3
    : public internal::Control_net_patch<Generalized_bezier_patch_3<Traits, Coordinates>,
                                         Coordinates, Generalized_bezier_basis> {
  using Base = internal::Control_net_patch<Generalized_bezier_patch_3, Coordinates,
                                           Generalized_bezier_basis>;

public:
  using Net = Generalized_bezier_net_3<Traits>;

  /*!
   * makes a patch over a regular polygon.
   *
   * \throws Input_error if a side of the net is a single point
   */
  explicit Generalized_bezier_patch_3(const Net& net)
      : Generalized_bezier_patch_3(
            net, Base::make_coordinates(make_regular_domain<Traits>(net.size()))) {}

  /*!
   * makes the domain from the ribbons of the net with `make_domain()`.
   *
   * \throws Input_error if a side of the net is a single point, or the coordinates do not exist on
   * the domain: those of Wachspress do on convex domains only
   */
  Generalized_bezier_patch_3(const Net& net, const Domain_options& domain)
      : Generalized_bezier_patch_3(net, make_domain(net.loop(), domain)) {}

  /*!
   * takes coordinates on a domain of the caller's choice, with one vertex for each side.
   *
   * \throws Input_error if the numbers of vertices and sides differ, or a side is a single point
   */
  Generalized_bezier_patch_3(const Net& net, const Coordinates& coordinates)
      : Base(net.loop(), coordinates, Base::report_on(coordinates.domain()),
             Generalized_bezier_basis(net), net.control_points()),
        net_(net) {}

  //! the control net
  const Net& net() const { return net_; }

private:
  Generalized_bezier_patch_3(const Net& net, Generated_domain<Traits> generated)
      : Base(net.loop(), Base::make_coordinates(generated.domain), std::move(generated.report),
             Generalized_bezier_basis(net), net.control_points()),
        net_(net) {}

  Net net_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_GENERALIZED_BEZIER_PATCH_3_H
