// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"

#include <CGAL/Multisided_patches/Jet_2.h>

#include <cmath>
#include <random>

namespace MP = CGAL::Multisided_patches;
using Jet = MP::Jet_2<double, 2>;

namespace {

// f = (1 + u v²) / (2 + u - v), with its derivatives worked out by hand.
struct Rational {
  double u, v;
  double p = 1 + u * v * v, pu = v * v, pv = 2 * u * v, puv = 2 * v, pvv = 2 * u;
  double q = 2 + u - v;

  double entry(std::size_t i) const {
    switch (i) {
    case 0:
      return p / q;
    case 1:
      return pu / q - p / (q * q);
    case 2:
      return pv / q + p / (q * q);
    case 3:
      return -2 * pu / (q * q) + 2 * p / (q * q * q);
    case 4:
      return puv / q + pu / (q * q) - pv / (q * q) - 2 * p / (q * q * q);
    default:
      return pvv / q + 2 * pv / (q * q) + 2 * p / (q * q * q);
    }
  }
};

} // namespace

TEST_CASE("Jets of a rational function have its value, gradient and Hessian") {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  for (int k = 0; k < 100; ++k) {
    const double u0 = uniform(engine), v0 = uniform(engine);
    const Jet u = Jet::u_variable(u0), v = Jet::v_variable(v0);
    const Jet f = (Jet(1) + u * v * v) / (2.0 + u - v);
    const Rational exact{u0, v0};
    for (std::size_t i = 0; i < Jet::size; ++i)
      CHECK(f[i] == Approx(exact.entry(i)).margin(1e-14));
  }
}

TEST_CASE("The square of a square root is what it was taken of") {
  const Jet u = Jet::u_variable(0.7), v = Jet::v_variable(-0.3);
  const Jet f = u * u + 2.0 * v * v + u * v;
  const Jet root = sqrt(f), square = root * root;
  CHECK(root.value() == Approx(std::sqrt(f.value())));
  for (std::size_t i = 0; i < Jet::size; ++i)
    CHECK(square[i] == Approx(f[i]).margin(1e-14));
}

TEST_CASE("Jets of lower order are the beginnings of those of higher order") {
  const auto formula = [](const auto& u, const auto& v) { return sqrt(u * v + u) / (u - v); };
  const Jet second = formula(Jet::u_variable(2), Jet::v_variable(0.5));
  using First = MP::Jet_2<double, 1>;
  const First first = formula(First::u_variable(2), First::v_variable(0.5));
  using Value = MP::Jet_2<double, 0>;
  CHECK(formula(Value(2), Value(0.5)).value() == second.value());
  for (std::size_t i = 0; i < First::size; ++i)
    CHECK(first[i] == second[i]);
}

TEST_CASE("A jet can be multiplied by one of its own entries") {
  Jet f = Jet::u_variable(3);
  f *= f.value();
  CHECK(f.value() == 9);
  CHECK(f[1] == 3);
}
