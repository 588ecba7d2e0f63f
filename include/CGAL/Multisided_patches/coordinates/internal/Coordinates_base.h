// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_COORDINATES_BASE_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_COORDINATES_BASE_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/errors.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// What all models of BarycentricCoordinates_2 share: they own the domain, and take their values on
// its boundary from the linear functions there, not from a formula that may round.
//
// Derived gives
//   template <int Order, typename Real>
//   void evaluate_formula(const Real& u, const Real& v, const Domain_location<Real>& location,
//                         Jet_2<Real, Order>* lambda) const
// which is called for points inside, and, if Order > 0, on the boundary for the derivatives.
template <typename Derived, typename Traits>
class Coordinates_base {
public:
  using Geom_traits = Traits;
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;
  using Domain = Polygonal_domain_2<Traits>;
  using Location = typename Domain::Location;

  explicit Coordinates_base(const Domain& domain) : domain_(domain) {}

  const Domain& domain() const { return domain_; }

  template <int Order>
  void evaluate(const Point_2& p, const Location& location, Jet_2<FT, Order>* lambda) const {
    evaluate<Order, FT>(p.x(), p.y(), location, lambda);
  }

  template <int Order, typename Real>
  void evaluate(const Real& u, const Real& v, const Domain_location<Real>& location,
                Jet_2<Real, Order>* lambda) const {
    if (location.kind == Domain_location<Real>::Kind::outside)
      throw Outside_domain_error("coordinates are not defined outside the domain");
    if (Order > 0 || !location.is_on_boundary())
      static_cast<const Derived&>(*this).template evaluate_formula<Order>(u, v, location, lambda);
    if (location.is_on_boundary())
      set_boundary_values(location, lambda);
  }

  template <typename OutputIterator>
  OutputIterator operator()(const Point_2& p, OutputIterator out) const {
    const Location location = domain_.locate_inside(p);
    boost::container::small_vector<Jet_2<FT, 0>, 32> lambda(domain_.size());
    evaluate<0>(p, location, lambda.data());
    for (const Jet_2<FT, 0>& l : lambda)
      *out++ = l.value();
    return out;
  }

private:
  template <int Order, typename Real>
  void set_boundary_values(const Domain_location<Real>& location,
                           Jet_2<Real, Order>* lambda) const {
    for (std::size_t i = 0; i < domain_.size(); ++i)
      lambda[i][0] = Real(0);
    const std::size_t i = location.index;
    if (location.kind == Domain_location<Real>::Kind::vertex) {
      lambda[i][0] = Real(1);
    } else {
      lambda[i][0] = Real(1) - location.s;
      lambda[domain_.next(i)][0] = location.s;
    }
  }

  Domain domain_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_COORDINATES_BASE_H
