// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_PATCH_3_H
#define CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_PATCH_3_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/bases/Concave_bezier_basis.h>
#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_model_3.h>
#include <CGAL/Multisided_patches/patches/internal/surface_derivatives.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

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

/*!
 * The concave generalized Bézier patch: a smooth surface that fills a loop of Bézier ribbons with
 * any number of sides and corners that may turn inwards (Salvi and Várady, *Multi-sided Bézier
 * surfaces over concave polygonal domains*, Computers & Graphics 74, 2018).
 *
 * The patch is the `Concave_bezier_basis` on barycentric coordinates of a planar domain, times the
 * control points. It has the boundary curves and, from 2 layers and degree 3 on, the tangent planes
 * of its ribbons. A patch is complete when it is constructed, never changes, and can be evaluated
 * from many threads at once.
 *
 * \tparam Traits a CGAL kernel with exact predicates
 * \tparam Coordinates a model of `BarycentricCoordinates_2`
 */
template <typename Traits, typename Coordinates = Harmonic_coordinates_2<Traits>>
class Concave_bezier_patch_3 {
public:
  using Geom_traits = Traits;
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;
  using Model = Concave_bezier_model_3<Traits>;
  using Loop = typename Model::Loop;
  using Domain = Polygonal_domain_2<Traits>;
  using Location = typename Domain::Location;
  //! x, y and z as functions of (u,v): a point of the surface with its partial derivatives
  template <int Order, typename Real = FT>
  using Surface_jet = std::array<Jet_2<Real, Order>, 3>;

  /*!
   * makes the domain with `make_domain()`, its coordinates, and the basis.
   *
   * \param model the ribbons, central control point and options; a `Ribbon_loop_3` converts to it
   *
   * \throws Input_error if the options make no sense, or the coordinates do not exist on the domain
   * \throws Accuracy_error if harmonic coordinates cannot be computed even to 1e-3
   */
  explicit Concave_bezier_patch_3(const Model& model)
      : Concave_bezier_patch_3(model, make_domain(model.loop, model.domain)) {}

  /*!
   * takes coordinates on a domain of the caller's choice, with one vertex for each ribbon.
   *
   * \throws Input_error if the numbers of vertices and ribbons differ
   */
  Concave_bezier_patch_3(const Model& model, Coordinates coordinates)
      : Concave_bezier_patch_3(model, std::move(coordinates), Domain_report()) {
    domain_report_.clearance = domain().clearance();
  }

  //! the ribbons that the patch fills
  const Loop& loop() const { return loop_; }
  const Domain& domain() const { return coordinates_.domain(); }
  //! how the domain came about
  const Domain_report& domain_report() const { return domain_report_; }
  const Coordinates& coordinates() const { return coordinates_; }
  const Concave_bezier_basis& basis() const { return basis_; }

  //! the length of the boundary curve of side `i` (model units)
  double side_length(std::size_t i) const { return loop_[i].arc_length(); }

  /*!
   * the point of the patch at `uv` (model units). On the boundary this is the point of the boundary
   * curve itself.
   *
   * \throws Outside_domain_error if `uv` lies outside the domain
   *
   * Complexity: that of the coordinates, plus linear in the number of control points.
   */
  Point_3 operator()(const Point_2& uv) const { return point(uv, domain().locate_inside(uv)); }

  //! the same where the caller knows where `uv` lies. \pre `uv` is not outside the domain
  Point_3 point(const Point_2& uv, const Location& location) const {
    if (location.is_on_boundary())
      return boundary_point(location);
    return to_point(evaluate<0>(uv, location));
  }

  /*!
   * the point at parameter `s` in [0,1] of boundary curve `i` (model units). In the domain this is
   * `domain().point_on_side(i, s)`, which as a rounded point may lie outside.
   */
  Point_3 point_on_side(std::size_t i, const FT& s) const { return loop_[i].boundary_point(s); }
  //! the unit normal there
  Vector_3 normal_on_side(std::size_t i, const FT& s) const {
    return normal(domain().point_on_side(i, s), domain().location_on_side(i, s));
  }

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
   */
  template <int Order>
  Surface_jet<Order> evaluate(const Point_2& uv, const Location& location) const {
    boost::container::small_vector<Jet_2<FT, Order>, 16> lambda(domain().size());
    coordinates_.template evaluate<Order>(uv, location, lambda.data());
    return combine(lambda.data());
  }

  //! the same for a point of which only the position is known. \throws Outside_domain_error
  template <int Order>
  Surface_jet<Order> evaluate(const Point_2& uv) const {
    return evaluate<Order>(uv, domain().locate_inside(uv));
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

  /*!
   * evaluates many points at once.
   *
   * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the
   * result is the same
   * \param points a random access range of `Point_2` in the domain
   * \param out receives one `Point_3` for each, in order
   * \return one past the last element written
   *
   * \throws Outside_domain_error if one of the points lies outside the domain
   */
  template <typename ConcurrencyTag = Parallel_if_available_tag, typename PointRange,
            typename OutputIterator>
  OutputIterator evaluate_points(const PointRange& points, OutputIterator out) const {
    std::vector<Point_3> result(points.size());
    internal::for_each_index<ConcurrencyTag>(
        result.size(), [&](std::size_t i) { result[i] = (*this)(points[i]); });
    return std::copy(result.begin(), result.end(), out);
  }

  //! the unit normal at `uv`, on the side from which the boundary runs counterclockwise; zero where
  //! the patch has no tangent plane. \throws Outside_domain_error
  Vector_3 normal(const Point_2& uv) const { return normal(uv, domain().locate_inside(uv)); }

  /*!
   * the same where the caller knows where `uv` lies. On the boundary the normal is that of the
   * ribbon, as far as the ribbon has cross-derivatives. \pre `uv` is not outside the domain
   */
  Vector_3 normal(const Point_2& uv, const Location& location) const {
    internal::Vec3 n{0, 0, 0};
    if (location.is_on_boundary())
      n = ribbon_normal(location);
    if (n == internal::Vec3{0, 0, 0})
      n = tangent_plane_normal(evaluate<1>(uv, location));
    return to_vector(n);
  }

  //! `point()` and `normal()` at the cost of one evaluation
  std::pair<Point_3, Vector_3> point_and_normal(const Point_2& uv, const Location& location) const {
    if (location.is_on_boundary())
      return {boundary_point(location), normal(uv, location)};
    const Surface_jet<1> surface = evaluate<1>(uv, location);
    return {to_point(surface), to_vector(tangent_plane_normal(surface))};
  }

private:
  // A patch meets its ribbons however inaccurate the coordinates are inside; so a domain that is
  // too narrow for full accuracy is no reason to give up.
  static Coordinates make_coordinates(const Domain& domain) {
    constexpr double target_error = 1e-8, acceptable_error = 1e-3;
    if constexpr (std::is_constructible_v<Coordinates, const Domain&, double, double>)
      return Coordinates(domain, target_error, acceptable_error);
    else
      return Coordinates(domain);
  }

  Concave_bezier_patch_3(const Model& model, Generated_domain<Traits> generated)
      : Concave_bezier_patch_3(model, make_coordinates(generated.domain),
                               std::move(generated.report)) {}

  Concave_bezier_patch_3(const Model& model, Coordinates coordinates, Domain_report report)
      : loop_(model.loop), coordinates_(std::move(coordinates)), domain_report_(std::move(report)),
        basis_(structure(loop_), model.central_weight, model.parameter_dilation) {
    if (domain().size() != loop_.size() || domain().number_of_loops() != 1)
      throw Input_error("the domain of a patch with " + std::to_string(loop_.size()) +
                        " ribbons needs as many vertices in one loop, not " +
                        std::to_string(domain().size()));
    for (const auto& ribbon : loop_.ribbons())
      for (const Point_3& p : ribbon.control_points())
        control_net_.push_back({p.x(), p.y(), p.z()});
    const Point_3 central = model.central_point.value_or(model.default_central_point());
    control_net_.push_back({central.x(), central.y(), central.z()});
  }

  static std::vector<std::pair<std::size_t, std::size_t>> structure(const Loop& loop) {
    std::vector<std::pair<std::size_t, std::size_t>> degrees_and_layers;
    for (const auto& ribbon : loop.ribbons())
      degrees_and_layers.emplace_back(ribbon.degree(), ribbon.layers());
    return degrees_and_layers;
  }

  Point_3 boundary_point(const Location& location) const {
    return loop_[location.index].boundary_point(location.s);
  }

  internal::Vec3 ribbon_normal(const Location& location) const {
    if (location.kind == Location::Kind::vertex)
      return internal::to_vec3(loop_.corner_normal(location.index));
    const auto& ribbon = loop_[location.index];
    if (ribbon.layers() < 2)
      return {0, 0, 0};
    return internal::tangent_plane_normal(internal::to_vec3(ribbon.boundary_derivative(location.s)),
                                          internal::to_vec3(ribbon.cross_derivative(location.s)));
  }

  template <int Order>
  static Point_3 to_point(const Surface_jet<Order>& surface) {
    return Point_3(surface[0].value(), surface[1].value(), surface[2].value());
  }

  static internal::Vec3 tangent_plane_normal(const Surface_jet<1>& surface) {
    const auto derivative = [&](std::size_t i) {
      return internal::Vec3{CGAL::to_double(surface[0][i]), CGAL::to_double(surface[1][i]),
                            CGAL::to_double(surface[2][i])};
    };
    return internal::tangent_plane_normal(derivative(1), derivative(2));
  }

  static Vector_3 to_vector(const internal::Vec3& v) {
    return Vector_3(FT(v[0]), FT(v[1]), FT(v[2]));
  }

  Loop loop_;
  Coordinates coordinates_;
  Domain_report domain_report_;
  Concave_bezier_basis basis_;
  std::vector<std::array<FT, 3>> control_net_; // in the order of the basis
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_PATCH_3_H
