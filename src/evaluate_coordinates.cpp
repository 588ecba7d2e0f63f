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

using Points = std::vector<Kernel::Point_2>;
using Locations = std::vector<Domain::Location>;
using Harmonic_coordinates = MP::Harmonic_coordinates_2<Kernel>;
// One matrix for each part; a row for each vertex and a column for each point.
template <int Order>
using Parts = Harmonic_coordinates::Batch<Order>;

template <int Order>
Parts<Order> evaluate_inside(const Harmonic_coordinates& coordinates, const Points& points,
                             const Locations& locations) {
  return coordinates.evaluate_batch<Order>(points, locations);
}

template <int Order, typename Coordinates>
Parts<Order> evaluate_inside(const Coordinates& coordinates, const Points& points,
                             const Locations& locations) {
  std::vector<MP::Jet_2<double, Order>> lambda(coordinates.domain().size());
  Parts<Order> parts;
  for (auto& part : parts)
    part.resize(static_cast<Eigen::Index>(lambda.size()), static_cast<Eigen::Index>(points.size()));
  for (std::size_t j = 0; j < points.size(); ++j) {
    coordinates.template evaluate<Order>(points[j], locations[j], lambda.data());
    for (std::size_t k = 0; k < parts.size(); ++k)
      for (std::size_t i = 0; i < lambda.size(); ++i)
        parts[k](static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = lambda[i][k];
  }
  return parts;
}

template <int Order, typename Coordinates>
std::vector<double> evaluate(const Coordinates& coordinates,
                             const std::vector<std::size_t>& vertices,
                             const std::vector<Located_point>& points) {
  Points inside;
  Locations locations;
  for (const auto& [point, location] : points)
    if (location.kind != Domain::Location::Kind::outside) {
      inside.push_back(point);
      locations.push_back(location);
    }
  const Parts<Order> parts = evaluate_inside<Order>(coordinates, inside, locations);
  std::vector<double> values;
  values.reserve(points.size() * vertices.size() * parts.size());
  Eigen::Index column = 0;
  for (const auto& [point, location] : points) {
    const bool is_inside = location.kind != Domain::Location::Kind::outside;
    const std::size_t defined = !is_inside                                 ? 0
                                : is_differentiable<Coordinates>(location) ? parts.size()
                                                                           : 1;
    for (const std::size_t i : vertices)
      for (std::size_t k = 0; k < parts.size(); ++k) {
        values.push_back(k < defined ? parts[k](static_cast<Eigen::Index>(i), column) : nan);
        if (k < defined)
          check_finite(values.back(), point);
      }
    column += is_inside;
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
