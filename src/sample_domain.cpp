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

// A mesh of V points, B of them on the boundary, has about 2 V - B triangles. With n sides of
// length p in total, 1 + floor(length / h) points a side, B is about p / h + n / 2. The triangles
// of triangulate_domain() with spacing h have 0.94 of the area of equilateral ones on the average,
// which is √3/4 h². In a slot all points lie on the sides.
double spacing_for(const Domain& domain, std::size_t points) {
  double perimeter = 0;
  for (std::size_t i = 0; i < domain.size(); ++i)
    perimeter += domain.side_length(i);
  const auto n = static_cast<double>(domain.size());
  const double cells = domain.area() / (0.94 * std::sqrt(3.0) / 2);
  const double wanted = (std::max)(1.0, static_cast<double>(points) - n / 4);
  // the solution of cells / h² + perimeter / 2 / h = wanted
  const double spacing =
      (perimeter / 2 + std::sqrt(perimeter * perimeter / 4 + 4 * cells * wanted)) / (2 * wanted);
  const double on_sides = (std::max)(1.0, static_cast<double>(points) - n / 2);
  return (std::max)(spacing, perimeter / on_sides);
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
