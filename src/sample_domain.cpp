// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sample_domain.h"

#include <CGAL/Multisided_patches/meshing/triangulate_domain.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// The points on n sides of length p in total, 1 + floor(length / h) a side, are about n/2 + p/h. A
// triangular lattice with spacing h has a point for an area of √3/2 h². It keeps 0.6 h away from
// the sides, which costs it 0.6 p h of the area; where that is more than there is, it is empty.
double spacing_for(const Domain& domain, std::size_t points) {
  double perimeter = 0;
  for (std::size_t i = 0; i < domain.size(); ++i)
    perimeter += domain.side_length(i);
  const double cells = domain.area() / (std::sqrt(3.0) / 2);
  const double sides = (1 - 0.6 / (std::sqrt(3.0) / 2)) * perimeter;
  const double wanted =
      (std::max)(1.0, static_cast<double>(points) - static_cast<double>(domain.size()) / 2);
  // the solution of cells / h² + sides / h = wanted
  const double spacing = (sides + std::sqrt(sides * sides + 4 * cells * wanted)) / (2 * wanted);
  return (std::max)(spacing, perimeter / wanted);
}

} // namespace

MP::Domain_mesh_2<Kernel> sample_domain(const Domain& domain, std::size_t points) {
  const double spacing = spacing_for(domain, points);
  const double area = domain.area();
  if (!std::isnormal(area) || !std::isnormal(spacing))
    throw MP::Numerical_error("the domain is too large or too small for its area to be computed");
  std::vector<std::size_t> segments;
  for (std::size_t i = 0; i < domain.size(); ++i)
    segments.push_back(1 + static_cast<std::size_t>(domain.side_length(i) / spacing));
  return MP::triangulate_domain(domain, segments, spacing);
}

} // namespace multipatch
