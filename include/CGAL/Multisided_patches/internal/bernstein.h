// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_BERNSTEIN_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_BERNSTEIN_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/internal/integer_power.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The number type of the coefficients of jets, and of numbers.
template <typename T>
struct Scalar_of {
  using type = T;
};
template <typename FT, int Order>
struct Scalar_of<Jet_2<FT, Order>> {
  using type = FT;
};

// The largest degree: beyond, binomial coefficients leave the range of the number type.
template <typename FT>
constexpr std::size_t max_bernstein_degree() {
  constexpr int max_exponent = std::numeric_limits<FT>::max_exponent;
  return 0 < max_exponent && max_exponent < 1008 ? max_exponent - 8 : 1000;
}

// Writes the first `count` Bernstein polynomials B^degree_0(t), B^degree_1(t), ... to `values`,
// from t and 1 - t, both accurate: then all of them are, near 0 and 1 as well. For any number type,
// exact ones and jets included. O(degree). \pre 1 <= count <= degree + 1, degree <=
// max_bernstein_degree
template <typename T>
void bernstein_polynomials(std::size_t degree, std::size_t count, const T& t, const T& one_minus_t,
                           T* values) {
  using Scalar = typename Scalar_of<T>::type;
  values[count - 1] = integer_power(one_minus_t, degree + 1 - count);
  for (std::size_t j = count - 1; j > 0; --j)
    values[j - 1] = values[j] * one_minus_t;
  T power = t;
  Scalar binomial(1);
  for (std::size_t j = 1; j < count; ++j) {
    binomial = binomial * Scalar(static_cast<int>(degree + 1 - j)) / Scalar(static_cast<int>(j));
    values[j] *= power * binomial;
    if (j + 1 < count)
      power *= t;
  }
}

// the same for all of them, from t alone
template <typename T>
void bernstein_polynomials(std::size_t degree, const T& t, T* values) {
  bernstein_polynomials(degree, degree + 1, t, T(T(1) - t), values);
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_BERNSTEIN_H
