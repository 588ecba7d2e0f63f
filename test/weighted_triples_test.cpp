// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/patches/internal/add_weighted_triples.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

using namespace fixtures;
using namespace MP::internal;

namespace {

constexpr std::size_t length = 64, parts = 3;

template <typename Number, std::size_t Size>
struct Random_rows {
  explicit Random_rows(Random& random) {
    for (std::size_t i = 0; i < Size; ++i) {
      for (std::size_t k = 0; k < parts * length; ++k)
        weights[i].push_back(static_cast<Number>(random.in(-1, 1)));
      rows.weights[i] = weights[i].data();
      for (Number& x : rows.triples[i])
        x = static_cast<Number>(random.in(-10, 10));
    }
  }
  std::array<std::vector<Number>, Size> weights;
  Weighted_triples<Number, Size> rows;
};

// Number by number. Products are stored before they are added, so that no compiler fuses the two.
template <typename Number, std::size_t Size>
void add_one_by_one(const Weighted_triples<Number, Size>& rows, std::vector<Number>& sums) {
  for (std::size_t part = 0; part < parts; ++part)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < length; ++k) {
        Number sum = 0;
        for (std::size_t i = 0; i < Size; ++i) {
          const volatile Number product = rows.weights[i][part * length + k] * rows.triples[i][c];
          sum += product;
        }
        sums[(3 * part + c) * length + k] += sum;
      }
}

template <typename Number, std::size_t Size>
void check_all_widths(Random& random) {
  const Random_rows<Number, Size> random_rows(random);
  std::vector<Number> expected;
  for (std::size_t k = 0; k < 3 * parts * length; ++k)
    expected.push_back(static_cast<Number>(random.in(-10, 10)));
  std::vector<Number> narrow = expected, widest = expected;
  add_one_by_one(random_rows.rows, expected);
  add_weighted_triples_in<16, length, parts>(random_rows.rows, narrow.data(),
                                             std::make_index_sequence<Size>());
  add_weighted_triples<length, parts>(random_rows.rows, widest.data());
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
    check_all_widths<double, 4>(random);
    check_all_widths<float, 8>(random);
  }
}
