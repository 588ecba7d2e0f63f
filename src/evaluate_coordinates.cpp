// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_coordinates.h"

#include <CGAL/Multisided_patches/internal/to_text.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The library gives zeros for the derivatives that mean value coordinates do not have.
template <typename Coordinates>
bool is_differentiable(const Domain::Location& location) {
  return !std::is_same_v<Coordinates, MP::Mean_value_coordinates_2<Kernel>> ||
         location.kind != Domain::Location::Kind::vertex;
}

void check_finite(double x, const Kernel::Point_2& p) {
  if (!std::isfinite(x))
    throw MP::Numerical_error(
        "the coordinates at the point (" + MP::internal::to_short_text(p.x()) + ", " +
        MP::internal::to_short_text(p.y()) + ") are beyond what can be computed");
}

template <int Order, typename Coordinates>
std::vector<double> evaluate(const Coordinates& coordinates,
                             const std::vector<std::size_t>& vertices,
                             const std::vector<Located_point>& points) {
  using Jet = MP::Jet_2<double, Order>;
  std::vector<Jet> lambda(coordinates.domain().size());
  std::vector<double> values;
  values.reserve(points.size() * vertices.size() * number_of_parts(Order));
  for (const auto& [point, location] : points) {
    const bool inside = location.kind != Domain::Location::Kind::outside;
    if (inside)
      coordinates.template evaluate<Order>(point, location, lambda.data());
    const std::size_t defined = !inside                                    ? 0
                                : is_differentiable<Coordinates>(location) ? number_of_parts(Order)
                                                                           : 1;
    for (const std::size_t i : vertices)
      for (std::size_t k = 0; k < number_of_parts(Order); ++k) {
        values.push_back(k < defined ? lambda[i][k] : nan);
        if (k < defined)
          check_finite(values.back(), point);
      }
  }
  return values;
}

} // namespace

std::vector<double> evaluate(const Any_coordinates& coordinates,
                             const std::vector<std::size_t>& vertices, int derivatives,
                             const std::vector<Located_point>& points) {
  return std::visit(
      [&](const auto& c) {
        return derivatives == 0   ? evaluate<0>(c, vertices, points)
               : derivatives == 1 ? evaluate<1>(c, vertices, points)
                                  : evaluate<2>(c, vertices, points);
      },
      coordinates);
}

} // namespace multipatch
