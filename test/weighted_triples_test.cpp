// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/patches/internal/add_weighted_triples.h>

#include <array>
#include <vector>

using namespace fixtures;
using namespace MP::internal;

namespace {

constexpr std::size_t rows = 61, stride = 64;

template <typename Number>
struct Random_rows {
  explicit Random_rows(Random& random) : triples(rows) {
    for (std::size_t k = 0; k < rows * length; ++k)
      weights.push_back(static_cast<Number>(random.in(-1, 1)));
    for (std::array<Number, 3>& triple : triples)
      for (Number& x : triple)
        x = static_cast<Number>(random.in(-10, 10));
  }
  static constexpr std::size_t length = 128 / sizeof(Number);
  std::vector<Number> weights;
  std::vector<std::array<Number, 3>> triples;
};

// Number by number. Products are stored before they are added, so that no compiler fuses the two.
template <typename Number>
void add_one_by_one(const Random_rows<Number>& r, std::vector<Number>& sums) {
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < r.length; ++k) {
      Number sum = 0;
      for (std::size_t i = 0; i < rows; ++i) {
        const volatile Number product = r.weights[i * r.length + k] * r.triples[i][c];
        sum += product;
      }
      sums[c * stride + k] += sum;
    }
}

template <typename Number>
void check_all_widths(Random& random) {
  const Random_rows<Number> r(random);
  std::vector<Number> expected;
  for (std::size_t k = 0; k < 3 * stride; ++k)
    expected.push_back(static_cast<Number>(random.in(-10, 10)));
  std::vector<Number> narrow = expected, widest = expected;
  add_one_by_one(r, expected);
  add_weighted_triples_in<16, r.length>(r.weights.data(), r.triples.data(), rows, narrow.data(),
                                        stride, Vectors_of_row());
  add_weighted_triples<r.length>(r.weights.data(), r.triples.data(), rows, widest.data(), stride);
#if !defined(__FMA__) && !defined(__ARM_FEATURE_FMA) // products and sums may be fused otherwise
  CHECK(narrow == expected);
  CHECK(widest == expected);
#endif
  for (std::size_t k = 0; k < expected.size(); ++k) {
    CHECK(narrow[k] == Approx(expected[k]).epsilon(1e-4).margin(1e-4));
    CHECK(widest[k] == Approx(expected[k]).epsilon(1e-4).margin(1e-4));
  }
}

} // namespace

TEST_CASE("Sums of weighted triples are the same, bit for bit, in vectors of any width") {
  const unsigned int seed = 20261123;
  CAPTURE(seed);
  Random random(seed);
  for (int k = 0; k < 10; ++k) {
    check_all_widths<double>(random);
    check_all_widths<float>(random);
  }
}
