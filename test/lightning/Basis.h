// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_LIGHTNING_BASIS_H
#define MULTISIDED_PATCHES_TEST_LIGHTNING_BASIS_H

#include "Corner.h"
#include "Orthonormal_polynomials.h"
#include "Polygon.h"
#include "numbers.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fixtures {
namespace lightning {

// The functions whose real and imaginary parts are combined.
struct Basis {
  std::vector<Corner_power> powers;
  std::vector<Pole> poles;
  std::vector<Complex> hole_centres;
  std::vector<Orthonormal_polynomials> polynomials; // in z and in 1/(z - c) for each hole

  Complex variable(std::size_t i, Complex z) const {
    return i == 0 ? z : 1. / (z - hole_centres[i - 1]);
  }
  void set_polynomials(const Polygon& polygon, const std::vector<Boundary_point>& points,
                       Eigen::Index degree) {
    for (std::size_t i = 0; i <= hole_centres.size(); ++i) {
      Eigen::VectorXcd t(index(points.size()));
      for (std::size_t k = 0; k < points.size(); ++k)
        t[index(k)] = variable(i, polygon.at(points[k].place));
      polynomials.emplace_back(t, degree);
    }
  }

  Eigen::VectorXd evaluate(const Polygon& polygon, const Place& p) const {
    std::vector<double> parts{1};
    const auto add = [&](Complex f) { parts.insert(parts.end(), {f.real(), f.imag()}); };
    for (const Corner_power& f : powers)
      add(f(polygon.difference(p, f.vertex)));
    for (const Pole& pole : poles)
      add(pole.size / (polygon.difference(p, pole.place.vertex) - pole.place.offset));
    for (std::size_t i = 0; i < polynomials.size(); ++i) {
      const Complex t = variable(i, polygon.at(p));
      const Eigen::VectorXcd q = polynomials[i](t);
      std::for_each(q.data() + 1, q.data() + q.size(), add);
      if (i > 0)
        parts.push_back(std::log(std::abs(t)));
    }
    return Eigen::Map<const Eigen::VectorXd>(parts.data(), index(parts.size()));
  }
  Eigen::MatrixXd matrix(const Polygon& polygon, const std::vector<Boundary_point>& points) const {
    Eigen::MatrixXd a;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::VectorXd row = evaluate(polygon, points[i].place);
      if (i == 0)
        a.resize(index(points.size()), row.size());
      a.row(index(i)) = row.transpose();
    }
    return a;
  }
};

} // namespace lightning
} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_LIGHTNING_BASIS_H
