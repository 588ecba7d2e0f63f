// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_PATCH_3_H
#define CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_PATCH_3_H

#include <CGAL/Multisided_patches/bases/Concave_bezier_basis.h>
#include <CGAL/Multisided_patches/bases/automatic_central_weight.h>
#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/check_finite.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_model_3.h>
#include <CGAL/Multisided_patches/patches/fair_central_point.h>
#include <CGAL/Multisided_patches/patches/internal/Control_net_patch.h>

#include <cmath>
#include <cstddef>
#include <string>
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
 * of its ribbons. Where the model leaves the central weight to the patch (`automatic`, the
 * default), `basis().central_weight()` is the one that was chosen; if that is not `none` and the
 * model has no central control point, the patch has `fair_central_point()`. A patch is complete
 * when it is constructed, never changes, and can be evaluated from many threads at once.
 *
 * \tparam Traits a CGAL kernel with exact predicates
 * \tparam Coordinates a model of `BarycentricCoordinates_2`
 */
template <typename Traits, typename Coordinates = Harmonic_coordinates_2<Traits>>
class Concave_bezier_patch_3
    : public internal::Control_net_patch<Concave_bezier_patch_3<Traits, Coordinates>, Coordinates,
                                         Concave_bezier_basis> {
  using Base =
      internal::Control_net_patch<Concave_bezier_patch_3, Coordinates, Concave_bezier_basis>;

public:
  using typename Base::Point_3;
  using Model = Concave_bezier_model_3<Traits>;

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
  Concave_bezier_patch_3(const Model& model, const Coordinates& coordinates)
      : Concave_bezier_patch_3(model, coordinates, Base::report_on(coordinates.domain())) {}

private:
  Concave_bezier_patch_3(const Model& model, Generated_domain<Traits> generated)
      : Concave_bezier_patch_3(model, Base::make_coordinates(generated.domain),
                               std::move(generated.report)) {}

  // What comes later needs what comes before: first the coordinates, then the basis, then the
  // control points. Nothing is moved from until all are there.
  Concave_bezier_patch_3(const Model& model, Coordinates coordinates, Domain_report report)
      : Concave_bezier_patch_3(model, std::move(coordinates), std::move(report),
                               make_basis(model, coordinates)) {}
  Concave_bezier_patch_3(const Model& model, Coordinates&& coordinates, Domain_report&& report,
                         Concave_bezier_basis&& basis)
      : Concave_bezier_patch_3(model, std::move(coordinates), std::move(report), std::move(basis),
                               control_points(model, coordinates, basis)) {}
  Concave_bezier_patch_3(const Model& model, Coordinates&& coordinates, Domain_report&& report,
                         Concave_bezier_basis&& basis, const std::vector<Point_3>& points)
      : Base(model.loop, std::move(coordinates), std::move(report), std::move(basis), points) {}

  static Concave_bezier_basis make_basis(const Model& model, const Coordinates& coordinates) {
    check_options(model);
    std::vector<std::pair<std::size_t, std::size_t>> degrees_and_layers;
    for (const auto& ribbon : model.loop.ribbons())
      degrees_and_layers.emplace_back(ribbon.degree(), ribbon.layers());
    std::vector<std::size_t> corners, reflex_corners;
    for (const auto& corner : model.corner_control_points)
      corners.push_back(corner.index);
    for (std::size_t i = 0; i < model.loop.size(); ++i)
      if (model.loop.corner_type(i) == Corner_type::reflex)
        reflex_corners.push_back(i);
    Side_parameter_options parameter_options{model.parameter_dilation, model.reflex_weight,
                                             std::move(reflex_corners)};
    const Central_weight central_weight = choose_weight(model, coordinates, parameter_options);
    return Concave_bezier_basis(degrees_and_layers, central_weight, std::move(parameter_options),
                                std::move(corners));
  }

  static Central_weight choose_weight(const Model& model, const Coordinates& coordinates,
                                      const Side_parameter_options& parameter_options) {
    if (model.central_weight != Central_weight::automatic)
      return model.central_weight;
    const auto& domain = coordinates.domain();
    if (domain.size() != model.loop.size() || domain.number_of_loops() != 1)
      return Central_weight::none; // the base class will refuse it
    return automatic_central_weight(model.loop, coordinates, parameter_options,
                                    !model.corner_control_points.empty());
  }

  static void check_options(const Model& model) {
    constexpr double largest_weight = 1000;
    if (!std::isfinite(model.parameter_dilation))
      throw Input_error("the parameter dilation is not a finite number");
    if (!(model.reflex_weight >= 1 / largest_weight && model.reflex_weight <= largest_weight))
      throw Input_error("the weight of reflex corners has to be from 0.001 to 1000, not " +
                        internal::to_short_text(model.reflex_weight));
    if (model.central_point && !internal::has_finite_coordinates(*model.central_point))
      throw Input_error("the central control point is not finite");
    std::vector<bool> has_point(model.loop.size(), false);
    for (const auto& corner : model.corner_control_points) {
      const std::string of_side = " at the end of side " + std::to_string(corner.index);
      if (corner.index >= model.loop.size())
        throw Input_error("there is an extra control point" + of_side + ", but no such side");
      if (has_point[corner.index])
        throw Input_error("there are two extra control points" + of_side);
      if (!internal::has_finite_coordinates(corner.point))
        throw Input_error("the extra control point" + of_side + " is not finite");
      has_point[corner.index] = true;
    }
  }

  static std::vector<Point_3> control_points(const Model& model, const Coordinates& coordinates,
                                             const Concave_bezier_basis& basis) {
    std::vector<Point_3> points;
    for (const auto& ribbon : model.loop.ribbons())
      points.insert(points.end(), ribbon.control_points().begin(), ribbon.control_points().end());
    for (const auto& corner : model.corner_control_points)
      points.push_back(corner.point);
    points.push_back(model.central_point.value_or(model.default_central_point()));
    if (!model.central_point && model.central_weight == Central_weight::automatic &&
        basis.central_weight() != Central_weight::none)
      points.back() = internal::fair_central_point(coordinates, basis, points);
    return points;
  }
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_PATCH_3_H
