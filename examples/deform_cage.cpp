// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Harmonic coordinates without any patch: moves one corner of a cage, and what is inside with it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>

#include <iostream>
#include <iterator>
#include <vector>

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Domain = MP::Polygonal_domain_2<Kernel>;

int main() {
  const std::vector<Point_2> cage{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const MP::Harmonic_coordinates_2<Kernel> coordinates{Domain(cage)};
  std::cout << "errors are below " << coordinates.error_bound() << '\n';

  // one point, as with CGAL's classes of coordinates
  std::vector<double> lambda;
  coordinates({0.5, 0.5}, std::back_inserter(lambda));
  for (const double l : lambda)
    std::cout << l << ' ';
  std::cout << '\n';

  // many points at once: one column for each
  const std::vector<Point_2> points{{0.5, 0.5}, {0.9, 0.9}, {1, 0}, {1.5, 0.5}, {0.5, 1.5}};
  const Eigen::MatrixXd weights = coordinates.evaluate_batch(points).front();
  Eigen::Matrix2Xd corners(2, cage.size());
  for (std::size_t i = 0; i < cage.size(); ++i)
    corners.col(static_cast<Eigen::Index>(i)) << cage[i].x(), cage[i].y();
  corners.col(3) << 1.3, 1.2; // the reflex corner moves
  std::cout << (corners * weights).transpose() << '\n';
}
