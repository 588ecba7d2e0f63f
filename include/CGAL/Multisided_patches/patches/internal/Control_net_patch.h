// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_CONTROL_NET_PATCH_H
#define CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_CONTROL_NET_PATCH_H

#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/Number_pack.h>
#include <CGAL/Multisided_patches/patches/internal/Patch_base.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

/*!
 * A basis on barycentric coordinates of a domain, times a control net.
 *
 * \tparam Patch the class that derives from this one
 * \tparam Coordinates a model of `BarycentricCoordinates_2`
 * \tparam Basis a model of `ControlNetBasis`
 */
template <typename Patch, typename Coordinates_, typename Basis_>
class Control_net_patch : public Patch_base<Patch, typename Coordinates_::Geom_traits> {
  using Base = Patch_base<Patch, typename Coordinates_::Geom_traits>;

public:
  using typename Base::Domain;
  using typename Base::FT;
  using typename Base::Location;
  using typename Base::Loop;
  using typename Base::Point_2;
  using typename Base::Point_3;
  using Coordinates = Coordinates_;
  using Basis = Basis_;
  template <int Order, typename Real = FT>
  using Surface_jet = typename Base::template Surface_jet<Order, Real>;

  const Domain& domain() const { return coordinates_.domain(); }
  //! how the domain came about
  const Domain_report& domain_report() const { return domain_report_; }
  const Coordinates& coordinates() const { return coordinates_; }
  const Basis& basis() const { return basis_; }
  //! control point `c` in the order of the basis. \pre `c < basis().size()`
  Point_3 control_point(std::size_t c) const {
    CGAL_precondition(c < control_net_.size());
    return Point_3(control_net_[c][0], control_net_[c][1], control_net_[c][2]);
  }

  using Base::evaluate;

  /*!
   * the point and its partial derivatives up to `Order` (0, 1 or 2) with respect to u and v: entry
   * `[c][k]` of the result is coordinate c (x, y, z), for k = 0 its value, and then its derivatives
   * by u, v, uu, uv and vv. On the sides they are limits from the inside. At vertices they may not
   * exist: first ones do if the ribbons agree and the coordinates have them, second ones depend on
   * the direction in general. What is returned then has equal weights for both ribbons, and what
   * the coordinates give, which for harmonic coordinates and a reflex or straight corner is the
   * (large) derivative at a point close by.
   *
   * \pre `uv` lies at `location`, and that is not outside the domain
   *
   * Complexity: that of the coordinates, plus that of the basis.
   */
  template <int Order>
  Surface_jet<Order> evaluate(const Point_2& uv, const Location& location) const {
    boost::container::small_vector<Jet_2<FT, Order>, 16> lambda(domain().size());
    coordinates_.template evaluate<Order>(uv, location, lambda.data());
    return combine(lambda.data());
  }

  /*!
   * the point and its derivatives computed in another number type, into which those of the domain
   * and of the control points convert without loss: an exact one, or a floating-point type with
   * more digits, tells how exact the result in `FT` is.
   *
   * \tparam Real a field number type; `Coordinates` says which it can do with
   */
  template <int Order, typename Real>
  Surface_jet<Order, Real> evaluate(const Real& u, const Real& v,
                                    const Domain_location<Real>& location) const {
    boost::container::small_vector<Jet_2<Real, Order>, 16> lambda(domain().size());
    coordinates_.template evaluate<Order>(u, v, location, lambda.data());
    return combine(lambda.data());
  }

  /*!
   * the point and its derivatives from coordinates that were computed elsewhere, in any number
   * type: what follows is as exact as that type.
   *
   * \param lambda the coordinates of all vertices, with derivatives up to `Order`
   */
  template <int Order, typename Real>
  Surface_jet<Order, Real> combine(const Jet_2<Real, Order>* lambda) const {
    return basis_.combine(domain(), lambda, control_net_);
  }

#ifndef DOXYGEN_RUNNING
  // Called by the base class: f(k, jets) for the points k = 0, ..., count - 1, as evaluate() has
  // them, with the points `point_of(k)` at `location_of(k)`. In `double` several points take the
  // same steps at once.
  template <int Order, typename PointOf, typename LocationOf, typename Function>
  void evaluate_block(std::size_t count, const PointOf& point_of, const LocationOf& location_of,
                      const Function& f) const {
    using Number = std::conditional_t<std::is_same_v<FT, double>, Number_pack, FT>;
    using Jet = Jet_2<Number, Order>;
    typename Basis::template Workspace<Jet> workspace;
    for_each_pack<Order, Number>(
        count, point_of, location_of, [&](std::size_t first, std::size_t last, const Jet* lambda) {
          const auto surface = basis_.combine(domain(), lambda, control_net_, workspace);
          for (std::size_t k = first; k < last; ++k)
            f(k, Surface_jet<Order>{lane(surface[0], k - first), lane(surface[1], k - first),
                                    lane(surface[2], k - first)});
        });
  }

  // Calls f(first, last, lambda) with the coordinates of the points k = first, ..., last - 1, as
  // many as `Number` has lanes, for one such group after the other. In a last group that is smaller
  // the other lanes are those of its last point.
  template <int Order, typename Number, typename PointOf, typename LocationOf, typename Function>
  void for_each_pack(std::size_t count, const PointOf& point_of, const LocationOf& location_of,
                     const Function& f) const {
    constexpr std::size_t lanes = lanes_of<Number>;
    const std::size_t n = domain().size();
    boost::container::small_vector<Jet_2<FT, Order>, 32> at_point(n);
    boost::container::small_vector<Jet_2<Number, Order>, 32> lambda(n);
    for (std::size_t first = 0; first < count; first += lanes) {
      const std::size_t last = (std::min)(first + lanes, count);
      for (std::size_t l = 0; l < lanes; ++l) {
        if (first + l < last)
          coordinates_.template evaluate<Order>(point_of(first + l), location_of(first + l),
                                                at_point.data());
        for (std::size_t i = 0; i < n; ++i)
          set_lane(lambda[i], l, at_point[i]);
      }
      f(first, last, lambda.data());
    }
  }
#endif

protected:
  // `control_points` has the points in the order of the basis.
  Control_net_patch(Loop loop, Coordinates coordinates, Domain_report report, Basis basis,
                    const std::vector<Point_3>& control_points)
      : Base(std::move(loop)), coordinates_(std::move(coordinates)),
        domain_report_(std::move(report)), basis_(std::move(basis)) {
    CGAL_precondition(control_points.size() == basis_.size());
    const std::size_t n = this->loop().size();
    if (domain().size() != n || domain().number_of_loops() != 1)
      throw Input_error("the domain of a patch with " + std::to_string(n) +
                        " sides needs as many vertices in one loop, not " +
                        std::to_string(domain().size()) + " in " +
                        std::to_string(domain().number_of_loops()));
    control_net_.reserve(control_points.size());
    for (const Point_3& p : control_points)
      control_net_.push_back({p.x(), p.y(), p.z()});
  }

  // A patch meets its boundary however inaccurate the coordinates are inside; so a domain that is
  // too narrow for full accuracy is no reason to give up.
  static Coordinates make_coordinates(const Domain& domain) {
    constexpr double target_error = 1e-8, acceptable_error = 1e-3;
    if constexpr (std::is_constructible_v<Coordinates, const Domain&, double, double>)
      return Coordinates(domain, target_error, acceptable_error);
    else
      return Coordinates(domain);
  }

  // The report on a domain that did not come from `make_domain()`.
  static Domain_report report_on(const Domain& domain) {
    Domain_report report;
    report.clearance = domain.clearance();
    return report;
  }

private:
  Coordinates coordinates_;
  Domain_report domain_report_;
  Basis basis_;
  std::vector<std::array<FT, 3>> control_net_; // in the order of the basis
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_CONTROL_NET_PATCH_H
