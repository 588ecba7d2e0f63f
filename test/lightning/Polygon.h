// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_LIGHTNING_POLYGON_H
#define MULTISIDED_PATCHES_TEST_LIGHTNING_POLYGON_H

#include "../fixtures.h"
#include "numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// The domain as the lightning solver sees it. Everything else is placed relative to it.
namespace fixtures {
namespace lightning {

// A point, as an offset from the nearest vertex: close to it, no digit is lost.
struct Place {
  std::size_t vertex;
  Complex offset;
};

struct Boundary_point {
  Place place;
  std::size_t side;
  double s; // the parameter on the side
};

// A domain in complex numbers, scaled to about unit size by a power of two, which is exact.
class Polygon {
public:
  explicit Polygon(const Domain& domain)
      : domain_(domain), scale_(std::ldexp(1., -std::ilogb(domain.diameter()))) {
    for (const Point_2& p : domain.vertices())
      vertices_.push_back(scale_ * Complex(p.x(), p.y()));
  }

  const Domain& domain() const { return domain_; }
  std::size_t size() const { return vertices_.size(); }
  double diameter() const { return scale_ * domain_.diameter(); }
  Complex vertex(std::size_t k) const { return vertices_[k]; }
  Complex side(std::size_t k) const { return vertex(domain_.next(k)) - vertex(k); }
  Complex exterior_normal(std::size_t k) const {
    return Complex(0, -1) * side(k) / std::abs(side(k));
  }
  // the interior angle at a vertex over pi
  double angle(std::size_t k) const {
    const double a = std::arg(-side(domain_.prev(k)) / side(k)) / MP::internal::pi;
    return a > 0 ? a : a + 2;
  }
  // By reflection, solutions are analytic at a corner of pi/2, pi/3...
  bool is_regular(std::size_t k) const {
    const double power = 1 / angle(k);
    return power > 1.5 && std::abs(power - std::round(power)) < 1e-12;
  }
  // The way along the exterior bisector of a corner that its poles may use.
  Complex reach(std::size_t k) const {
    const Complex bisector =
        -side(k) / std::abs(side(k)) * std::polar(1., angle(k) * MP::internal::pi / 2);
    const double sides = (std::max)(std::abs(side(k)), std::abs(side(domain_.prev(k))));
    return (std::min)(sides, 0.6 * free_distance(k, bisector)) * bisector;
  }
  bool is_outside(Complex z) const {
    return domain_.locate({z.real() / scale_, z.imag() / scale_}).kind ==
           Domain::Location::Kind::outside;
  }

  Complex at(const Place& p) const { return vertex(p.vertex) + p.offset; }
  Complex difference(const Place& p, std::size_t k) const {
    return (vertex(p.vertex) - vertex(k)) + p.offset;
  }
  Place place(const Point_2& p) const {
    const auto offset = [&](std::size_t k) {
      return scale_ * Complex(p.x() - domain_.vertex(k).x(), p.y() - domain_.vertex(k).y());
    };
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < size(); ++k)
      if (std::abs(offset(k)) < std::abs(offset(nearest)))
        nearest = k;
    return {nearest, offset(nearest)};
  }
  Boundary_point before_target(std::size_t k, double rest) const {
    return {{domain_.next(k), -rest * side(k)}, k, 1 - rest};
  }
  Boundary_point on_side(std::size_t k, double s) const {
    return s <= 0.5 ? Boundary_point{{k, s * side(k)}, k, s} : before_target(k, 1 - s);
  }
  Complex nearest_on_boundary(Complex z) const {
    Complex nearest = vertex(0);
    for (std::size_t k = 0; k < size(); ++k) {
      const double s = ((z - vertex(k)) / side(k)).real();
      const Complex foot = vertex(k) + (std::min)(1., (std::max)(0., s)) * side(k);
      if (std::abs(z - foot) < std::abs(z - nearest))
        nearest = foot;
    }
    return nearest;
  }

private:
  // how far one can go from a vertex before meeting a side it does not belong to
  double free_distance(std::size_t k, Complex direction) const {
    double distance = diameter();
    for (std::size_t i = 0; i < size(); ++i) {
      if (i == k || i == domain_.prev(k))
        continue;
      const Complex a = (vertex(i) - vertex(k)) / direction, d = side(i) / direction;
      const double s = -a.imag() / d.imag(), t = a.real() + s * d.real();
      if (s >= 0 && s <= 1 && t > 0)
        distance = (std::min)(distance, t);
    }
    return distance;
  }

  Domain domain_;
  double scale_;
  std::vector<Complex> vertices_;
};

} // namespace lightning
} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_LIGHTNING_POLYGON_H
