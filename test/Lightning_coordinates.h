// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_LIGHTNING_COORDINATES_H
#define MULTISIDED_PATCHES_TEST_LIGHTNING_COORDINATES_H

#include "fixtures.h"
#include "lightning/Basis.h"
#include "lightning/Corner.h"
#include "lightning/Polygon.h"
#include "lightning/exterior_circles.h"
#include "lightning/least_squares.h"
#include "lightning/numbers.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

/*
 * Harmonic coordinates once more, by a method that has nothing in common with that of the library:
 * global approximation by a "lightning solver" (Gopal and Trefethen, "Solving Laplace problems with
 * corner singularities via rational functions", SIAM J. Numer. Anal. 57, 2019).
 *
 * Every coordinate is a combination of real and imaginary parts of functions that are analytic in
 * the domain: powers z^(j/a) at corners of angle a pi, poles that cluster exponentially at the
 * corners, more poles on the medial axis of the outside, polynomials, and logarithms and
 * polynomials in 1/(z - c) for points c in holes. The coefficients fit the boundary values in the
 * least-squares sense. As such functions are harmonic, no error inside is larger than the largest
 * on the boundary, and that can be measured.
 */
namespace fixtures {

class Lightning_coordinates {
public:
  // Tries to keep all errors below `target_error`; `error_bound()` tells whether this worked. No
  // second attempt is made with more than `max_functions`, which take seconds if there are 1500.
  Lightning_coordinates(const Domain& domain, double target_error,
                        Eigen::Index max_functions = 2000)
      : polygon_(domain), spacing_(-5 / std::log(target_error)) {
    for (std::size_t k = 0; k < domain.size(); ++k) {
      corners_.emplace_back(polygon_, k);
      poles_.push_back(corners_[k].poles_for_error(target_error));
    }
    constexpr int max_rounds = 8;
    for (int round = 0; round < max_rounds && !(error_bound_ <= target_error); ++round)
      if (!improve(target_error, max_functions))
        break;
  }

  // Twice the largest error of any coordinate that was measured on the boundary. By the maximum
  // principle, it holds inside, too.
  double error_bound() const { return error_bound_; }

  // all coordinates of a point inside
  std::vector<double> operator()(const Point_2& p) const {
    const Eigen::VectorXd values =
        coefficients_.transpose() * basis_.evaluate(polygon_, polygon_.place(p));
    return std::vector<double>(values.data(), values.data() + values.size());
  }

private:
  static Eigen::Index index(std::size_t i) { return lightning::index(i); }
  using Circles = std::vector<lightning::Circle>;
  using Boundary_points = std::vector<lightning::Boundary_point>;

  lightning::Basis make_basis(const Circles& circles) const {
    lightning::Basis basis;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const auto powers = corners_[k].powers();
      const auto poles = corners_[k].poles(poles_[k]);
      basis.powers.insert(basis.powers.end(), powers.begin(), powers.end());
      basis.poles.insert(basis.poles.end(), poles.begin(), poles.end());
    }
    for (const lightning::Circle& c : circles)
      basis.poles.push_back(
          {{0, c.centre - polygon_.vertex(0)}, c.radius, 0.3 * spacing_ * c.radius, 1});
    const Domain& domain = polygon_.domain();
    for (std::size_t loop = 1; loop < domain.number_of_loops(); ++loop)
      basis.hole_centres.push_back(
          largest_circle(circles, domain.loop_begin(loop), domain.loop_begin(loop + 1)).centre);
    return basis;
  }
  static lightning::Circle largest_circle(const Circles& circles, std::size_t first_side,
                                          std::size_t end_side) {
    lightning::Circle largest{0, 0, 0, false};
    for (const lightning::Circle& c : circles)
      if (first_side <= c.side && c.side < end_side && c.radius > largest.radius)
        largest = c;
    if (largest.radius == 0)
      throw std::runtime_error("no circle found in a hole");
    return largest;
  }

  // Points on the boundary, as dense as the functions vary: exponentially close to corners,
  // Chebyshev points for the polynomials, and some where the circles touch.
  Boundary_points sample(const std::vector<lightning::Pole>& poles, double density,
                         double closest) const {
    Boundary_points points;
    for (std::size_t k = 0; k < polygon_.size(); ++k) {
      points.push_back(polygon_.on_side(k, 0));
      for (double r = 0.5; r > closest; r *= std::exp(-0.25 / density)) {
        points.push_back(polygon_.on_side(k, r));
        points.push_back(polygon_.before_target(k, r));
      }
      const double count = std::ceil(3 * density * degree_);
      for (double j = 0.5; j < count; ++j)
        points.push_back(polygon_.on_side(k, 0.5 - 0.5 * std::cos(MP::internal::pi * j / count)));
      for (const lightning::Pole& pole : poles)
        add_near(pole, k, density, points);
    }
    return points;
  }

  // Points on a side around the foot of a pole, if that is not far.
  void add_near(const lightning::Pole& pole, std::size_t side, double density,
                Boundary_points& points) const {
    const double length = std::abs(polygon_.side(side));
    const lightning::Complex foot = polygon_.difference(pole.place, side) / polygon_.side(side);
    const double steps = std::ceil(density * pole.steps), step = pole.step / density / length;
    for (double j = -steps; j <= steps && std::abs(foot.imag()) * length < 1.5 * pole.size; ++j)
      if (const double s = foot.real() + j * step; s > 0 && s < 1)
        points.push_back(polygon_.on_side(side, s));
  }

  // the coordinates of a point on the boundary
  Eigen::VectorXd hat_functions(const lightning::Boundary_point& p) const {
    Eigen::VectorXd hats = Eigen::VectorXd::Zero(index(polygon_.size()));
    hats[index(p.side)] = 1 - p.s;
    hats[index(polygon_.domain().next(p.side))] = p.s;
    return hats;
  }
  Eigen::MatrixXd hat_functions(const Boundary_points& points) const {
    Eigen::MatrixXd hats(index(points.size()), index(polygon_.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      hats.row(index(i)) = hat_functions(points[i]).transpose();
    return hats;
  }
  std::vector<double> errors(const lightning::Basis& basis, const Eigen::MatrixXd& coefficients,
                             const Boundary_points& points) const {
    std::vector<double> errors;
    for (const lightning::Boundary_point& p : points)
      errors.push_back(
          (coefficients.transpose() * basis.evaluate(polygon_, p.place) - hat_functions(p))
              .lpNorm<Eigen::Infinity>());
    return errors;
  }

  // Fits with the present numbers of functions, then asks for more where the error is too large.
  // Returns whether there is a point in going on.
  bool improve(double target_error, Eigen::Index max_functions) {
    lightning::Basis basis = make_basis(lightning::exterior_circles(polygon_, spacing_));
    const Boundary_points fitted = sample(basis.poles, 1, 1e-11);
    basis.set_polynomials(polygon_, fitted, Eigen::Index(degree_));
    Eigen::MatrixXd a = basis.matrix(polygon_, fitted);
    if (a.cols() > max_functions && coefficients_.size() > 0)
      return false;
    const Eigen::MatrixXd x = lightning::solve(a, hat_functions(fitted));
    const Boundary_points checked = sample(basis.poles, 2.7, 1e-15);
    const std::vector<double> error = errors(basis, x, checked);
    // Between the points, 1.4 times as much was met.
    const double bound = 2 * *std::max_element(error.begin(), error.end());
    if (x.allFinite() && bound < error_bound_) {
      error_bound_ = bound;
      basis_ = basis;
      coefficients_ = x;
    }
    refine(checked, error, target_error / 4);
    return true;
  }

  void refine(const Boundary_points& points, const std::vector<double>& errors, double tolerance) {
    bool smooth_part = false;
    std::vector<bool> at_corner(polygon_.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      if (errors[i] > tolerance) {
        if ((std::min)(points[i].s, 1 - points[i].s) > 0.1)
          smooth_part = true;
        else
          at_corner[points[i].place.vertex] = true;
      }
    for (std::size_t k = 0; k < polygon_.size(); ++k)
      if (at_corner[k])
        poles_[k] = 1.25 * poles_[k] + 1;
    if (smooth_part) {
      degree_ = std::ceil(1.25 * degree_);
      spacing_ *= 0.8;
    }
  }

  lightning::Polygon polygon_;
  std::vector<lightning::Corner> corners_;
  std::vector<double> poles_; // how many, at every corner
  double degree_ = 16;        // of the polynomials
  double spacing_;            // of the poles on the medial axis, in radii
  double error_bound_ = std::numeric_limits<double>::infinity();
  lightning::Basis basis_;
  Eigen::MatrixXd coefficients_;
};

} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_LIGHTNING_COORDINATES_H
