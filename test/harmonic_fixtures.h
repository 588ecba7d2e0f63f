// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_HARMONIC_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_HARMONIC_FIXTURES_H

#include "polygon_fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>

#include <map>

// What the tests of harmonic coordinates share.
namespace fixtures {

using Location = Domain::Location;
using Harmonic_coordinates_2 = MP::Harmonic_coordinates_2<Kernel>;
template <int Order>
using Jet = MP::Jet_2<double, Order>;

// the coordinates on all_domains(), computed once. A gap of 1e-6 is known to ten digits only.
inline const std::vector<Harmonic_coordinates_2>& on_all_domains(double target_error) {
  static std::map<double, std::vector<Harmonic_coordinates_2>> coordinates;
  std::vector<Harmonic_coordinates_2>& result = coordinates[target_error];
  if (result.empty())
    for (const Domain& domain : all_domains())
      result.emplace_back(domain, target_error, 1e-10);
  return result;
}

// the sides of a domain of about unit size, as the solver sees them
inline MP::internal::harmonic::Boundary boundary_of(const Domain& domain) {
  std::vector<MP::internal::harmonic::Complex> vertices;
  std::vector<std::size_t> next;
  for (std::size_t k = 0; k < domain.size(); ++k) {
    vertices.emplace_back(domain.vertex(k).x(), domain.vertex(k).y());
    next.push_back(domain.next(k));
  }
  return MP::internal::harmonic::Boundary(std::move(vertices), std::move(next));
}

template <int Order>
std::vector<Jet<Order>> evaluate(const Harmonic_coordinates_2& h, const Point_2& p,
                                 const Location& location = Location::interior()) {
  std::vector<Jet<Order>> lambda(h.domain().size());
  h.evaluate<Order>(p, location, lambda.data());
  return lambda;
}

inline double largest_difference(const std::vector<Jet<0>>& a, const std::vector<Jet<0>>& b) {
  double max = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    max = (std::max)(max, std::abs(a[i][0] - b[i][0]));
  return max;
}

// the largest difference of the values of two approximations, over random points
inline double largest_difference(const Harmonic_coordinates_2& a, const Harmonic_coordinates_2& b,
                                 std::size_t points = 200) {
  double max = 0;
  for (const Point_2& p : random_points_inside(a.domain(), points))
    max = (std::max)(max, largest_difference(evaluate<0>(a, p), evaluate<0>(b, p)));
  return max;
}

} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_HARMONIC_FIXTURES_H
