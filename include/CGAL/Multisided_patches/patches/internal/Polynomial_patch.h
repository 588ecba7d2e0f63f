// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_POLYNOMIAL_PATCH_H
#define CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_POLYNOMIAL_PATCH_H

#include <CGAL/Multisided_patches/patches/internal/Patch_base.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

/*!
 * A polynomial surface over a domain, in Bézier form: it has control points, and no coordinates.
 *
 * \tparam Patch the class that derives from this one; it has
 *   `template <int Order, typename Real> Surface_jet<Order, Real> evaluate(const Real& u,
 *   const Real& v, const Domain_location<Real>&) const`, the same as below, computed in any field
 *   number type `Real` into which `FT` converts without loss; and it brings
 *   `Polynomial_patch::evaluate` into scope
 * \tparam Traits a CGAL kernel with exact predicates
 */
template <typename Patch, typename Traits>
class Polynomial_patch : public Patch_base<Patch, Traits> {
  using Base = Patch_base<Patch, Traits>;

public:
  using typename Base::Domain;
  using typename Base::FT;
  using typename Base::Location;
  using typename Base::Loop;
  using typename Base::Point_2;
  using typename Base::Point_3;
  template <int Order, typename Real = FT>
  using Surface_jet = typename Base::template Surface_jet<Order, Real>;

  const Domain& domain() const { return domain_; }
  //! all control points, in the order of the class
  const std::vector<Point_3>& control_points() const { return control_points_; }

  using Base::evaluate;

  /*!
   * the point and its partial derivatives up to `Order` (0, 1 or 2) with respect to u and v: entry
   * `[c][k]` of the result is coordinate c (x, y, z), for k = 0 its value, and then its derivatives
   * by u, v, uu, uv and vv. At a location on the boundary the point may be rounded.
   *
   * \pre `uv` lies at `location`, and that is not outside the domain
   *
   * Complexity: that of `Patch`.
   */
  template <int Order>
  Surface_jet<Order> evaluate(const Point_2& uv, const Location& location) const {
    return static_cast<const Patch&>(*this).template evaluate<Order, FT>(uv.x(), uv.y(), location);
  }

protected:
  // A reference to the points, as `loop` may be made of them in the same call.
  Polynomial_patch(Loop loop, std::vector<Point_3>&& control_points, Domain domain)
      : Base(std::move(loop)), control_points_(std::move(control_points)),
        domain_(std::move(domain)) {}

private:
  std::vector<Point_3> control_points_;
  Domain domain_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_POLYNOMIAL_PATCH_H
