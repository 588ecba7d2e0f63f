// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_HARMONIC_H
#define MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_HARMONIC_H

#include "replay_polygon.h"

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/solve_to_accuracy.h>

namespace fuzz {

// Solves for the harmonic coordinates of a polygon file of about unit size. Its domain may be too
// narrow for the target.
inline MP::internal::harmonic::Best_solution
solve_for_harmonic(const std::string& bytes, double target_error, double acceptable_error) {
  namespace harmonic = MP::internal::harmonic;
  const Domain domain = read_polygon(bytes).domain;
  std::vector<harmonic::Complex> vertices;
  std::vector<std::size_t> next;
  for (std::size_t i = 0; i < domain.size(); ++i) {
    vertices.emplace_back(domain.vertex(i).x(), domain.vertex(i).y());
    next.push_back(domain.next(i));
  }
  const harmonic::Boundary boundary(std::move(vertices), std::move(next));
  const harmonic::Bisection_mesh mesh = harmonic::triangulate_boundary(boundary);
  return harmonic::solve_to_accuracy<CGAL::Sequential_tag>(boundary, mesh, target_error,
                                                           acceptable_error);
}

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_HARMONIC_H
