// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_ANY_COORDINATES_2_H
#define CGAL_MULTISIDED_PATCHES_IO_ANY_COORDINATES_2_H

#include <CGAL/Multisided_patches/IO/Coordinates_choice.h>
#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>

#include <utility>
#include <variant>

namespace CGAL {
namespace Multisided_patches {
namespace IO {

/*!
 * The barycentric coordinates that a file asks for, chosen when the program runs. They are those of
 * the class that `Coordinates_choice` names.
 *
 * \cgalModels{BarycentricCoordinates_2}
 *
 * \tparam Traits a CGAL kernel with exact predicates and inexact constructions
 */
template <typename Traits>
class Any_coordinates_2 {
public:
  using Geom_traits = Traits;
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;
  using Domain = Polygonal_domain_2<Traits>;
  using Location = typename Domain::Location;

  /*!
   * computes the coordinates of a domain. Harmonic ones are as accurate as patches make them: to
   * 1e-8 or, where that is out of reach, to 1e-3.
   *
   * \throws Input_error if the coordinates do not exist on this domain: those of Wachspress do on
   * convex domains only
   * \throws Accuracy_error if harmonic coordinates cannot be computed even to 1e-3
   */
  explicit Any_coordinates_2(const Domain& domain,
                             Coordinates_choice choice = Coordinates_choice::harmonic)
      : coordinates_(make(domain, choice)) {}

  const Domain& domain() const {
    return std::visit([](const auto& c) -> const Domain& { return c.domain(); }, coordinates_);
  }
  //! which coordinates they are
  Coordinates_choice choice() const {
    return static_cast<Coordinates_choice>(coordinates_.index());
  }

  //! as the concept `BarycentricCoordinates_2` says
  template <int Order>
  void evaluate(const Point_2& p, const Location& location, Jet_2<FT, Order>* lambda) const {
    std::visit([&](const auto& c) { c.template evaluate<Order>(p, location, lambda); },
               coordinates_);
  }

  //! the same in another number type, with those that `Harmonic_coordinates_2` can do with
  template <int Order, typename Real>
  void evaluate(const Real& u, const Real& v, const Domain_location<Real>& location,
                Jet_2<Real, Order>* lambda) const {
    std::visit([&](const auto& c) { c.template evaluate<Order>(u, v, location, lambda); },
               coordinates_);
  }

  //! as the concept says
  template <typename OutputIterator>
  OutputIterator operator()(const Point_2& p, OutputIterator out) const {
    return std::visit([&](const auto& c) { return c(p, out); }, coordinates_);
  }

private:
  // In the order of Coordinates_choice.
  using Variant = std::variant<Harmonic_coordinates_2<Traits>, Mean_value_coordinates_2<Traits>,
                               Wachspress_coordinates_2<Traits>>;

  static Variant make(const Domain& domain, Coordinates_choice choice) {
    constexpr double target_error = 1e-8, acceptable_error = 1e-3;
    switch (choice) {
    case Coordinates_choice::mean_value:
      return Mean_value_coordinates_2<Traits>(domain);
    case Coordinates_choice::wachspress:
      return Wachspress_coordinates_2<Traits>(domain);
    default:
      return Harmonic_coordinates_2<Traits>(domain, target_error, acceptable_error);
    }
  }

  Variant coordinates_;
};

} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_ANY_COORDINATES_2_H
