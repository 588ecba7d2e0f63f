// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_POWER_SERIES_H
#define MULTISIDED_PATCHES_TEST_POWER_SERIES_H

#include <array>
#include <cstddef>

namespace fixtures {

/*
 * A power series in one variable, cut off after the coefficient of order `Size - 1`: what a jet is
 * along a ray, and of any order. To the package it passes for a jet without derivatives.
 */
template <typename FT_, std::size_t Size>
class Power_series {
public:
  using FT = FT_;
  static constexpr int order = 0;

  Power_series() : data_{} {}
  Power_series(const FT& constant) : data_{} { data_[0] = constant; }
  Power_series(const FT& constant, const FT& linear) : Power_series(constant) { data_[1] = linear; }

  const FT& value() const { return data_[0]; }
  // the number of leading coefficients that are 0
  std::size_t vanishing_order() const {
    std::size_t k = 0;
    while (k < Size && data_[k] == FT(0))
      ++k;
    return k;
  }

  Power_series& operator+=(const Power_series& b) {
    for (std::size_t k = 0; k < Size; ++k)
      data_[k] += b.data_[k];
    return *this;
  }
  Power_series& operator-=(const Power_series& b) {
    for (std::size_t k = 0; k < Size; ++k)
      data_[k] -= b.data_[k];
    return *this;
  }
  Power_series& operator*=(const Power_series& b) { return *this = *this * b; }
  Power_series& operator/=(const Power_series& b) { return *this = *this / b; }

  friend Power_series operator+(Power_series a, const Power_series& b) { return a += b; }
  friend Power_series operator-(Power_series a, const Power_series& b) { return a -= b; }
  friend Power_series operator*(const Power_series& a, const Power_series& b) {
    Power_series r;
    for (std::size_t k = a.vanishing_order(); k < Size; ++k)
      for (std::size_t m = 0; k + m < Size; ++m)
        r.data_[k + m] += a.data_[k] * b.data_[m];
    return r;
  }
  // \pre `b.value() != 0`
  friend Power_series operator/(const Power_series& a, const Power_series& b) {
    Power_series r;
    for (std::size_t k = 0; k < Size; ++k) {
      FT rest = a.data_[k];
      for (std::size_t m = 0; m < k; ++m)
        rest -= r.data_[m] * b.data_[k - m];
      r.data_[k] = rest / b.data_[0];
    }
    return r;
  }

private:
  std::array<FT, Size> data_;
};

} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_POWER_SERIES_H
