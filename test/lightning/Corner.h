// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_LIGHTNING_CORNER_H
#define MULTISIDED_PATCHES_TEST_LIGHTNING_CORNER_H

#include "Polygon.h"
#include "numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// The functions that stand for the singularity of a solution at a corner.
namespace fixtures {
namespace lightning {

// e^z - 1, to full precision close to 0: the standard library has it for real numbers only
inline Complex expm1(Complex z) {
  const double half = std::sin(z.imag() / 2);
  return {std::expm1(z.real()) * std::cos(z.imag()) - 2 * half * half,
          std::exp(z.real()) * std::sin(z.imag())};
}

// w^exponent for w = z / (z - end), whose cut is the segment from the corner 0 to `end`. If the
// exponent is almost an integer m, (w^exponent - w^m) / (exponent - m), in the limit w^m log w.
struct Corner_power {
  std::size_t vertex;
  Complex end;
  double exponent;

  Complex operator()(Complex z) const {
    if (z == 0.)
      return 0;
    const Complex log_w = std::log(z / (z - end));
    const double m = std::round(exponent), e = exponent - m;
    if (std::abs(e) > 0.1)
      return std::exp(exponent * log_w);
    return std::exp(m * log_w) * (e == 0 ? log_w : expm1(e * log_w) / e);
  }
};

struct Pole {
  Place place;
  double size; // of the neighbourhood it is responsible for
  double step; // between points of the boundary that see it well, if it is near
  int steps;   // how many points, on either side
};

// What is singular at a vertex: the powers j/a + m (j from reflection, m from the map to w) below
// `max_power` exactly, what is left of higher ones by poles.
class Corner {
public:
  Corner(const Polygon& polygon, std::size_t k)
      : vertex_(k), regular_(polygon.is_regular(k)), angle_(polygon.angle(k)),
        end_(polygon.reach(k)) {}

  double poles_for_error(double error) const {
    const double root = std::log(1 / error) / (clustering() * first_power_left());
    return regular_ ? 0 : root * root / 2 + 5;
  }
  std::vector<Corner_power> powers() const {
    std::vector<Corner_power> powers;
    for (double j = 1 / angle_; j < max_power && !regular_; j += 1 / angle_)
      for (double e = j; e < max_power; e += 1)
        if (std::none_of(powers.begin(), powers.end(), [&](const Corner_power& other) {
              return std::abs(e - other.exponent) < 1e-4;
            }))
          powers.push_back({vertex_, end_, e});
    return powers;
  }
  // exponentially close to the vertex, but the closer the sparser
  std::vector<Pole> poles(double count) const {
    const double n = regular_ ? 0 : std::floor(count);
    const double sigma = (std::min)(clustering(), 29 / std::sqrt(n));
    std::vector<Pole> poles;
    for (double j = 1; j <= n; ++j) {
      const Complex offset = std::exp(sigma * (std::sqrt(j) - std::sqrt(n))) * end_;
      const double r = std::abs(offset);
      poles.push_back({{vertex_, offset}, r, 0.3 * r, 3});
    }
    return poles;
  }

private:
  static constexpr double max_power = 5.1;

  double first_power_left() const { return (std::max)(1 / angle_, max_power); }
  double clustering() const {
    return MP::internal::pi * std::sqrt(2 * (std::max)(0.1, 2 - angle_) / first_power_left());
  }

  std::size_t vertex_;
  bool regular_;
  double angle_;
  Complex end_;
};

} // namespace lightning
} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_LIGHTNING_CORNER_H
