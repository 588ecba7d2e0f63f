// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MEAN_VALUE_COORDINATES_2_H
#define CGAL_MULTISIDED_PATCHES_MEAN_VALUE_COORDINATES_2_H

#include <CGAL/Multisided_patches/coordinates/internal/Coordinates_base.h>
#include <CGAL/Multisided_patches/coordinates/internal/vertex_offsets.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Multisided_patches {

/*!
 * Mean value coordinates on any polygon, with or without holes. They are smooth inside and cheap,
 * but negative in parts of polygons that are not convex, where patches built on them can have
 * poles.
 *
 * With r_j the distance of p from v_j, A_j the cross and D_j the dot product of v_j - p and
 * v_{j+1} - p, the weights are w_i = (t_{i-1} + t_i) / r_i, where t_j = A_j / (r_j r_{j+1} + D_j)
 * is the tangent of half the angle at which side j is seen, and λ_i = w_i / Σ w (Floater, *Mean
 * value coordinates*, Computer Aided Geometric Design 20, 2003; Hormann and Floater, *Mean value
 * coordinates for arbitrary planar polygons*, ACM Transactions on Graphics 25, 2006). All weights
 * are multiplied by A_k of the side seen at the largest angle, so that values and derivatives hold
 * on the sides as well. At a vertex the coordinates are not differentiable; the derivatives
 * returned there are 0.
 *
 * The formulas are generic in the number type, which must have a square root: evaluated with 100
 * digits, of `boost::multiprecision` for instance, they are the yardstick for `double`.
 *
 * \cgalModels{BarycentricCoordinates_2}
 *
 * \tparam Traits a CGAL kernel with exact predicates whose number type has a square root
 */
template <typename Traits>
class Mean_value_coordinates_2
    : public internal::Coordinates_base<Mean_value_coordinates_2<Traits>, Traits> {
  using Base = internal::Coordinates_base<Mean_value_coordinates_2<Traits>, Traits>;

public:
  using typename Base::Domain;
  using typename Base::FT;
  using typename Base::Location;
  using typename Base::Point_2;

  explicit Mean_value_coordinates_2(const Domain& domain) : Base(domain) {}

#ifndef DOXYGEN_RUNNING
  // Called by the base class. O(n).
  template <int Order, typename Real>
  void evaluate_formula(const Real& u, const Real& v, const Domain_location<Real>& location,
                        Jet_2<Real, Order>* lambda) const {
    using Jet = Jet_2<Real, Order>;
    using Kind = typename Domain_location<Real>::Kind;
    const Domain& domain = this->domain();
    const std::size_t n = domain.size();
    if (location.kind == Kind::vertex) {
      std::fill(lambda, lambda + n, Jet());
      return;
    }

    const internal::Vertex_offsets<Real> offsets(domain, u, v, location);
    boost::container::small_vector<Jet, 32> r(n), cross(n), dot(n), rr(n), tangent(n);
    for (std::size_t j = 0; j < n; ++j)
      r[j] = offsets.template distance<Order>(j);
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t k = domain.next(j);
      cross[j] = offsets.template cross<Order>(j, k);
      dot[j] = offsets.template dot<Order>(j, k);
      rr[j] = r[j] * r[k];
    }
    if (location.kind == Kind::side)
      cross[location.index][0] = Real(0);

    const std::size_t widest =
        location.kind == Kind::side ? location.index : widest_side<Real>(cross, dot, rr);
    for (std::size_t j = 0; j < n; ++j)
      tangent[j] = j == widest                ? rr[j] - dot[j]
                   : dot[j].value() < Real(0) ? cross[widest] * (rr[j] - dot[j]) / cross[j]
                                              : cross[widest] * cross[j] / (rr[j] + dot[j]);
    Jet sum;
    for (std::size_t i = 0; i < n; ++i) {
      lambda[i] = (tangent[domain.prev(i)] + tangent[i]) / r[i];
      sum += lambda[i];
    }
    for (std::size_t i = 0; i < n; ++i)
      lambda[i] /= sum;
  }
#endif

private:
  // The side seen at the largest angle. Near a side the cross product may round to 0 or less.
  template <typename Real, typename Jets>
  static std::size_t widest_side(const Jets& cross, const Jets& dot, const Jets& rr) {
    const auto magnitude = [&](std::size_t j) {
      return Real(cross[j].value() < Real(0) ? Real(-cross[j].value()) : cross[j].value());
    };
    const auto height = [&](std::size_t j) { return Real(rr[j].value() - dot[j].value()); };
    std::size_t widest = 0;
    for (std::size_t j = 1; j < cross.size(); ++j)
      if (magnitude(j) * height(widest) < magnitude(widest) * height(j))
        widest = j;
    return widest;
  }
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MEAN_VALUE_COORDINATES_2_H
