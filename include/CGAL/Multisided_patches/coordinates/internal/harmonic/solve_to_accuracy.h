// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_TO_ACCURACY_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_TO_ACCURACY_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/solve_laplace.h>
#include <CGAL/Multisided_patches/errors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// The best solution of several rounds; there is none while the error is infinite.
struct Best_solution {
  Harmonic_basis basis;
  double error = std::numeric_limits<double>::infinity();
  int rounds = 0;
  std::string failure; // of the last round that failed
};

// tau from the target and the polygon: the largest of more errors counts with more vertices, and
// where sides are very short, errors may be larger than jumps. Fitted to the errors that were
// measured on many shapes, so that nearly all need one round.
inline double initial_tau(double target_error, const Boundary& boundary) {
  double shortest = 1;
  for (std::size_t k = 0; k < boundary.size(); ++k)
    shortest = (std::min)(shortest, boundary.length(k));
  const double target = target_error * safety_factor(1, 1) / safety_factor(1, shortest);
  const double tau = (std::min)(7 * std::pow(target, 0.83), 1.3 * std::pow(target, 0.73));
  return tau * std::sqrt(40. / static_cast<double>(boundary.size()));
}

// by how much to lessen tau after an error above the target; the error is about tau^1.3
inline double tau_reduction(double target_error, double error) {
  // Such an error is hardly ever one of tau, which is cheaper to find out with a small step.
  constexpr double improbable = 1000;
  if (error > improbable * target_error)
    return 0.1;
  return (std::min)(0.25, 0.6 * std::pow(target_error / error, 1 / 1.3));
}

constexpr int max_rounds = 5;

// How many rounds in a row may hardly lessen the error. None, once it is acceptable. Within twice
// of that, all there are: the error is then mostly rounding, which varies with tau, and may fall
// below.
inline int allowed_useless_rounds(double error, double acceptable_error) {
  if (error <= acceptable_error)
    return 0;
  return error <= 2 * acceptable_error ? max_rounds : 1;
}

// solves Laplace's equation with ever smaller tau until the error is below the target, or nothing
// is to be gained any more: where two vertices are so close that rounding shows in their distance,
// the error stays what it is however small tau gets.
template <typename ConcurrencyTag>
Best_solution solve_to_accuracy(const Boundary& boundary, const Bisection_mesh& mesh,
                                double target_error, double acceptable_error) {
  constexpr double tau_min = 1e-13, tau_max = 1e-2;
  int useless_rounds = 0;
  double tau = initial_tau(target_error, boundary);
  Best_solution best;
  while (best.rounds < max_rounds && best.error > target_error) {
    tau = (std::min)(tau_max, (std::max)(tau_min, tau));
    ++best.rounds;
    try {
      Solution s = solve_laplace<ConcurrencyTag>(boundary, mesh, tau, target_error);
      if (std::isfinite(s.error)) {
        // The error should have become a tenth of what it was; if that was not acceptable, half
        // of it is useful, too.
        const double useful = best.error <= acceptable_error ? 0.1 : 0.5;
        useless_rounds = s.error > useful * best.error ? useless_rounds + 1 : 0;
        if (s.error < best.error) {
          best.error = s.error;
          best.basis = std::move(s.basis);
        }
        if (tau == tau_min || useless_rounds > allowed_useless_rounds(best.error, acceptable_error))
          break;
        tau *= useless_rounds > 0 ? 0.1 : tau_reduction(target_error, s.error);
        continue;
      }
    } catch (const Numerical_error& e) {
      best.failure = e.what();
    }
    if (tau == tau_max)
      break;
    tau *= 30; // A coarser subdivision may still do.
  }
  return best;
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SOLVE_TO_ACCURACY_H
