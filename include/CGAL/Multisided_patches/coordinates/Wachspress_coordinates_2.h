// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_WACHSPRESS_COORDINATES_2_H
#define CGAL_MULTISIDED_PATCHES_WACHSPRESS_COORDINATES_2_H

#include <CGAL/Multisided_patches/coordinates/internal/Coordinates_base.h>
#include <CGAL/Multisided_patches/coordinates/internal/vertex_offsets.h>
#include <CGAL/Multisided_patches/errors.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * Wachspress coordinates on a strictly convex polygon: rational functions of (u,v) of lowest
 * degree, smooth up to and including the boundary.
 *
 * With A_j(p) the area of the triangle (v_j, v_{j+1}, p) and C_i that of (v_{i-1}, v_i, v_{i+1}),
 * the weights are w_i = C_i / (A_{i-1}(p) A_i(p)), and λ_i = w_i / Σ w (Meyer, Lee, Barr and
 * Desbrun, *Generalized barycentric coordinates on irregular polygons*, Journal of Graphics Tools
 * 7, 2002). All weights are multiplied by A_{m-1}(p) A_m(p), where m is the vertex with the
 * smallest such product: so nothing is divided by 0 on the boundary, and derivatives of all orders
 * hold there.
 *
 * The formulas are generic in the number type; with an exact one the coordinates are exact.
 *
 * \cgalModels{BarycentricCoordinates_2}
 *
 * \tparam Traits a CGAL kernel with exact predicates
 */
template <typename Traits>
class Wachspress_coordinates_2
    : public internal::Coordinates_base<Wachspress_coordinates_2<Traits>, Traits> {
  using Base = internal::Coordinates_base<Wachspress_coordinates_2<Traits>, Traits>;

public:
  using typename Base::Domain;
  using typename Base::FT;
  using typename Base::Location;
  using typename Base::Point_2;

  //! \throws Input_error if the domain has a hole, or a corner that is not convex
  explicit Wachspress_coordinates_2(const Domain& domain) : Base(domain) {
    if (domain.number_of_loops() > 1)
      throw Input_error("Wachspress coordinates need a domain without holes");
    for (std::size_t i = 0; i < domain.size(); ++i) {
      const Corner_type type = domain.corner_type(i);
      if (type != Corner_type::convex)
        throw Input_error("Wachspress coordinates need a strictly convex domain; corner " +
                          std::to_string(i) + " is " + to_string(type));
    }
  }

#ifndef DOXYGEN_RUNNING
  // Called by the base class. O(n).
  template <int Order, typename Real>
  void evaluate_formula(const Real& u, const Real& v, const Domain_location<Real>& location,
                        Jet_2<Real, Order>* lambda) const {
    using Jet = Jet_2<Real, Order>;
    using Kind = typename Domain_location<Real>::Kind;
    const Domain& domain = this->domain();
    const std::size_t n = domain.size();

    const internal::Vertex_offsets<Real> offsets(domain, u, v, location);
    boost::container::small_vector<Jet, 32> area(n);
    for (std::size_t j = 0; j < n; ++j)
      area[j] = offsets.template cross<Order>(j, domain.next(j));
    if (location.kind == Kind::side)
      area[location.index][0] = Real(0);
    const std::size_t m = nearest_vertex(location, area);

    const std::size_t before_m = domain.prev(m);
    Jet sum;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = domain.prev(i);
      lambda[i] = Jet(corner_area<Real>(i));
      for (const std::size_t j : {before_m, m})
        if (j != before && j != i)
          lambda[i] *= area[j];
      for (const std::size_t j : {before, i})
        if (j != before_m && j != m)
          lambda[i] /= area[j];
      sum += lambda[i];
    }
    for (std::size_t i = 0; i < n; ++i)
      lambda[i] /= sum;
  }
#endif

private:
  template <typename Real>
  Real corner_area(std::size_t i) const {
    const Point_2 &before = this->domain().vertex(this->domain().prev(i)),
                  &corner = this->domain().vertex(i),
                  &after = this->domain().vertex(this->domain().next(i));
    const Real x(corner.x()), y(corner.y());
    return (Real(after.x()) - x) * (Real(before.y()) - y) -
           (Real(after.y()) - y) * (Real(before.x()) - x);
  }

  // the vertex for which the product of the areas at its two sides is smallest: none of the others
  // is much smaller, so that it makes a good common factor
  template <typename Real, typename Jets>
  std::size_t nearest_vertex(const Domain_location<Real>& location, const Jets& area) const {
    using Kind = typename Domain_location<Real>::Kind;
    if (location.kind == Kind::vertex || (location.kind == Kind::side && location.s < Real(0.5)))
      return location.index;
    if (location.kind == Kind::side)
      return this->domain().next(location.index);
    const auto product = [&](std::size_t i) {
      return Real(area[this->domain().prev(i)].value() * area[i].value());
    };
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < area.size(); ++i)
      if (product(i) < product(nearest))
        nearest = i;
    return nearest;
  }
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_WACHSPRESS_COORDINATES_2_H
