// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_AUTOMATIC_CENTRAL_WEIGHT_H
#define CGAL_MULTISIDED_PATCHES_AUTOMATIC_CENTRAL_WEIGHT_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/bases/Central_weight.h>
#include <CGAL/Multisided_patches/bases/Concave_bezier_basis.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>
#include <CGAL/Multisided_patches/ribbons/Corner_type.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! The largest weight deficiency (of 1, the sum of all weights) that `Central_weight::automatic`
//! leaves to the ribbons. With more of it they have bumps at reflex corners: of the example models
//! two have 0.48, and bumps; all others have 0.29 or less, and none.
inline constexpr double max_weight_deficiency_of_ribbons = 0.4;

//! The smallest weight deficiency with which `Central_weight::automatic` takes a central control
//! point: where its weight is negative, it pushes the surface away. It is so in the necks of stars
//! with long rays (-0.04), but hardly in stars with short ones (-0.01).
inline constexpr double min_weight_of_central_point = -0.015;

//! How far the place where the deficiency is more than half of its maximum may spread for
//! `Central_weight::automatic` to take a central control point: the mean square of the distances
//! from its centroid, where that of a disk of the same area is 1. The hub of a cross has 1; two
//! hubs, which no single point can serve, have 12.
inline constexpr double max_spread_of_deficiency = 1.5;

namespace internal {

// The ribbons of which the deficiency is taken, whatever those of the patch are: the limits above
// are for these.
inline constexpr std::size_t deficiency_degree = 3, deficiency_layers = 2;

// Points of this many rows and columns in the bounding box of the domain. The deficiency varies
// slowly; on the example models its maximum is missed by less than 0.02.
inline constexpr int deficiency_lattice_size = 16;

// Calls f(x, y, lambda) for the points of the lattice inside the domain, with the derivatives of
// the coordinates up to `Order`, in `double`.
template <int Order, typename Coordinates, typename Function>
void for_each_lattice_point(const Coordinates& coordinates, const Function& f) {
  using Traits = typename Coordinates::Geom_traits;
  using FT = typename Traits::FT;
  const auto& domain = coordinates.domain();
  const Bbox_2 box = domain.bbox();
  std::vector<Jet_2<FT, Order>> lambda(domain.size());
  std::vector<Jet_2<double, Order>> rounded(domain.size());
  // In the middle of the cells, where few domains have a side or a vertex.
  const auto place = [](double low, double high, int cell) {
    return low + (high - low) * ((2 * cell + 1) / (2.0 * deficiency_lattice_size));
  };
  for (int row = 0; row < deficiency_lattice_size; ++row)
    for (int column = 0; column < deficiency_lattice_size; ++column) {
      const double x = place(box.xmin(), box.xmax(), column),
                   y = place(box.ymin(), box.ymax(), row);
      const typename Traits::Point_2 p{FT(x), FT(y)};
      const auto location = domain.locate(p);
      if (location.kind != decltype(location)::Kind::interior)
        continue;
      coordinates.template evaluate<Order>(p, location, lambda.data());
      for (std::size_t i = 0; i < lambda.size(); ++i)
        for (std::size_t k = 0; k < Jet_2<FT, Order>::size; ++k)
          rounded[i][k] = CGAL::to_double(lambda[i][k]);
      f(x, y, rounded.data());
    }
}

// How much the weights of ribbons lack to 1, and where.
struct Weight_deficiency {
  double largest = 0, smallest = 0;
  double spread = 0; // see max_spread_of_deficiency
};

template <typename Coordinates>
Weight_deficiency weight_deficiency(const Concave_bezier_basis& ribbons,
                                    const Coordinates& coordinates) {
  struct Sample {
    double x, y, value;
  };
  std::vector<Sample> samples;
  Concave_bezier_basis::Workspace<Jet_2<double, 0>> workspace;
  Weight_deficiency result;
  for_each_lattice_point<0>(coordinates, [&](double x, double y, const Jet_2<double, 0>* lambda) {
    const double value = ribbons.weight_deficiency(coordinates.domain(), lambda, workspace).value();
    result.largest = (std::max)(result.largest, value);
    result.smallest = (std::min)(result.smallest, value);
    samples.push_back({x, y, value});
  });
  const auto sum = [&](const auto& f) {
    double total = 0;
    for (const Sample& sample : samples)
      if (sample.value > result.largest / 2)
        total += f(sample);
    return total;
  };
  const double count = sum([](const Sample&) { return 1; });
  const double x = sum([](const Sample&s) { return s.x; }) / count,
               y = sum([](const Sample&s) { return s.y; }) / count;
  const double squares =
      sum([&](const Sample& s) { return (s.x - x) * (s.x - x) + (s.y - y) * (s.y - y); });
  const Bbox_2 box = coordinates.domain().bbox();
  const double cell = (box.xmax() - box.xmin()) * (box.ymax() - box.ymin()) /
                      (deficiency_lattice_size * deficiency_lattice_size);
  if (count > 0)
    result.spread = 2 * pi * squares / (count * count * cell);
  return result;
}

template <typename Domain>
bool has_reflex_corner(const Domain& domain) {
  for (std::size_t i = 0; i < domain.size(); ++i)
    if (domain.corner_type(i) == Corner_type::reflex)
      return true;
  return false;
}

// The middle column of an even degree belongs to no corner, its weight is not divided between two
// sides, and so leaves the deficiency negative in the middle of sides (-0.13 for degree 4).
template <typename Loop>
bool has_even_degree(const Loop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (loop[i].degree() % 2 == 0)
      return true;
  return false;
}

// Whether the patch has the same contact with all ribbons as without a central control point.
template <typename Loop>
bool keeps_contact(const Loop& loop, Central_weight weight) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (contact_order(loop, i, weight) < contact_order(loop, i))
      return false;
  return true;
}

// The weight that suits the ribbons if there is to be a central control point; `none` if no contact
// is to be given up for it.
template <typename Loop>
Central_weight suitable_central_weight(const Loop& loop, bool has_corner_control_points) {
  if ((has_corner_control_points || has_even_degree(loop)) &&
      keeps_contact(loop, Central_weight::full_product))
    return Central_weight::full_product;
  return has_corner_control_points ? Central_weight::none : Central_weight::weight_deficiency;
}

} // namespace internal

/*!
 * the central weight that `Central_weight::automatic` stands for, on one domain.
 *
 * What the weights of the ribbons lack to 1 in the middle of a domain, their deficiency, is spread
 * over all of them if there is no central control point. If it is large, ribbons far away get a
 * share that makes bumps at reflex corners. A central control point takes them away if it has one
 * place to be in. So there is one if
 *   - the domain has a reflex corner,
 *   - the deficiency exceeds `max_weight_deficiency_of_ribbons` somewhere,
 *   - it is nowhere below `min_weight_of_central_point`,
 *   - where it is more than half of its maximum is one compact place, not spread more than
 *     `max_spread_of_deficiency` (that is what is asked: peaks are not counted),
 *   - and no `contact_order()` gets lower;
 *
 * in all other cases the weight is `none`. The manual has the measurements behind this.
 *
 * The deficiency is that of ribbons of degree 3 with 2 layers, so that whether there is a central
 * control point depends on the domain alone, and elevation does not change it. Which weight it has
 * depends on the ribbons, too: `weight_deficiency` or, where the deficiency of these is negative in
 * places, `full_product`. It is so with extra control points at corners, and with ribbons of even
 * degree; of the latter those with 3 layers that get the contact of these have `weight_deficiency`
 * nevertheless, as `full_product` would lower it.
 *
 * "Somewhere" is on a lattice of 16 by 16 points in the bounding box of the domain, of which those
 * inside count. Everything but the coordinates is computed in `double`. The same input always gives
 * the same answer, but one close to a limit may change when the domain is moved or turned. Name a
 * weight where that must not happen.
 *
 * \tparam Loop `Ribbon_loop_3`, or a class like that of `contact_order()`
 * \tparam Coordinates a model of `BarycentricCoordinates_2`
 *
 * \param loop the ribbons
 * \param coordinates coordinates on the domain, with one vertex for each ribbon
 * \param parameter_options what goes into the side parameters of the patch
 * \param has_corner_control_points whether there are extra control points at corners
 *
 * Complexity: that of at most 256 evaluations of the coordinates and the basis.
 */
template <typename Loop, typename Coordinates>
Central_weight automatic_central_weight(const Loop& loop, const Coordinates& coordinates,
                                        const Side_parameter_options& parameter_options = {},
                                        bool has_corner_control_points = false) {
  const Central_weight wanted = internal::suitable_central_weight(loop, has_corner_control_points);
  if (!internal::has_reflex_corner(coordinates.domain()) || wanted == Central_weight::none)
    return Central_weight::none;
  const Concave_bezier_basis ribbons(
      std::vector(loop.size(), std::pair(internal::deficiency_degree, internal::deficiency_layers)),
      Central_weight::none, parameter_options);
  const internal::Weight_deficiency deficiency = internal::weight_deficiency(ribbons, coordinates);
  const bool needs_point = deficiency.largest > max_weight_deficiency_of_ribbons;
  const bool has_place = deficiency.smallest >= min_weight_of_central_point &&
                         deficiency.spread <= max_spread_of_deficiency;
  return needs_point && has_place ? wanted : Central_weight::none;
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_AUTOMATIC_CENTRAL_WEIGHT_H
