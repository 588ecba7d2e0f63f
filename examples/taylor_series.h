// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_EXAMPLES_TAYLOR_SERIES_H
#define MULTISIDED_PATCHES_EXAMPLES_TAYLOR_SERIES_H

#include <array>
#include <cmath>
#include <cstddef>

// A number with its derivatives: a polynomial in s and h, cut off above s³ and h³. A formula
// written for numbers, run on these, gives the Taylor coefficients of what it computes.
class Taylor {
public:
  static constexpr std::size_t size = 4;

  Taylor(double value = 0) { at(0, 0) = value; }
  // The variables, at the values where they are expanded.
  static Taylor s(double value) {
    Taylor t(value);
    t.at(1, 0) = 1;
    return t;
  }
  static Taylor h(double value) {
    Taylor t(value);
    t.at(0, 1) = 1;
    return t;
  }

  // The coefficient of s^i h^j.
  double& at(std::size_t i, std::size_t j) { return c_[i * size + j]; }
  double at(std::size_t i, std::size_t j) const { return c_[i * size + j]; }
  double value() const { return c_[0]; }

  friend Taylor operator+(Taylor a, const Taylor& b) {
    for (std::size_t i = 0; i < a.c_.size(); ++i)
      a.c_[i] += b.c_[i];
    return a;
  }
  friend Taylor operator-(Taylor a, const Taylor& b) {
    for (std::size_t i = 0; i < a.c_.size(); ++i)
      a.c_[i] -= b.c_[i];
    return a;
  }
  friend Taylor operator*(const Taylor& a, const Taylor& b) {
    Taylor product;
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j)
        for (std::size_t k = 0; i + k < size; ++k)
          for (std::size_t l = 0; j + l < size; ++l)
            product.at(i + k, j + l) += a.at(i, j) * b.at(k, l);
    return product;
  }
  friend Taylor operator-(const Taylor& a) { return Taylor(0) - a; }
  friend Taylor operator/(const Taylor& a, const Taylor& b) { return a * pow(b, -1); }

  friend Taylor sin(const Taylor& a) { return sine(a, std::sin(a.value()), std::cos(a.value())); }
  friend Taylor cos(const Taylor& a) { return sine(a, std::cos(a.value()), -std::sin(a.value())); }
  friend Taylor exp(const Taylor& a) {
    std::array<double, degree + 1> f;
    f[0] = std::exp(a.value());
    for (std::size_t n = 1; n <= degree; ++n)
      f[n] = f[n - 1] / double(n);
    return compose(f, a);
  }
  friend Taylor pow(const Taylor& a, double exponent) {
    std::array<double, degree + 1> f;
    f[0] = std::pow(a.value(), exponent);
    for (std::size_t n = 1; n <= degree; ++n)
      f[n] = f[n - 1] * (exponent - double(n - 1)) / (double(n) * a.value());
    return compose(f, a);
  }
  friend Taylor sqrt(const Taylor& a) { return pow(a, 0.5); }

private:
  static constexpr std::size_t degree = 2 * (size - 1);

  // f(a), where f[n] is the n-th Taylor coefficient of f at a.value().
  static Taylor compose(const std::array<double, degree + 1>& f, Taylor a) {
    a.at(0, 0) = 0;
    Taylor result(f[degree]);
    for (std::size_t n = degree; n-- > 0;)
      result = result * a + Taylor(f[n]);
    return result;
  }
  // The function with f'' = -f that has this value and this derivative at a.value().
  static Taylor sine(const Taylor& a, double value, double derivative) {
    std::array<double, degree + 1> f{value, derivative};
    for (std::size_t n = 2; n <= degree; ++n)
      f[n] = -f[n - 2] / double(n * (n - 1));
    return compose(f, a);
  }

  std::array<double, size * size> c_{};
};

#endif // MULTISIDED_PATCHES_EXAMPLES_TAYLOR_SERIES_H
