// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_ADD_WEIGHTED_TRIPLES_H
#define CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_ADD_WEIGHTED_TRIPLES_H

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

// The widest vectors are used that the processor has when the program runs, whatever it was
// compiled for, where the compiler knows how to ask. Sums and products are the same, bit for bit,
// as each is in one lane; unless the compiler may fuse them, which it does where the program is
// compiled for processors that can. (On Windows, GCC does not align wide vectors on the stack.)
#if defined(__GNUC__) && defined(__x86_64__) && !defined(__AVX2__) && !defined(_WIN32)
#define CGAL_MULTISIDED_PATCHES_ASK_FOR_AVX2
#endif
#ifdef __GNUC__
#define CGAL_MULTISIDED_PATCHES_ALWAYS_INLINE [[gnu::always_inline]] inline
#else
#define CGAL_MULTISIDED_PATCHES_ALWAYS_INLINE inline
#endif

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Numbers of which so many bytes are worked on at once.
template <typename Number, std::size_t Bytes>
struct Vector_of {
#ifdef __GNUC__
  typedef Number Type __attribute__((vector_size(Bytes)));
#else
  using Type = Number;
#endif
  static constexpr std::size_t lanes = sizeof(Type) / sizeof(Number);
};

template <typename Vector>
using Vector_triple = std::array<Vector, 3>;

// (References, as what is passed in wide vectors depends on what the program is compiled for.)
template <typename Vector, typename Number>
CGAL_MULTISIDED_PATCHES_ALWAYS_INLINE void add_product(const Number* weights,
                                                       const Vector_triple<Vector>& triple,
                                                       Vector_triple<Vector>& sums) {
  Vector w;
  std::memcpy(&w, weights, sizeof(w));
  sums[0] += w * triple[0];
  sums[1] += w * triple[1];
  sums[2] += w * triple[2];
}

template <typename Vector, typename Number>
CGAL_MULTISIDED_PATCHES_ALWAYS_INLINE void add_to(Number* numbers, const Vector& vector) {
  Vector sum;
  std::memcpy(&sum, numbers, sizeof(sum));
  sum += vector;
  std::memcpy(numbers, &sum, sizeof(sum));
}

// What add_weighted_triples() does, so many bytes at a time. As many vectors of each row are taken
// together as there are indices I: their sums stay in registers. If they are a whole row, reading
// goes straight on; narrower ones take several passes.
template <std::size_t Bytes, std::size_t Length, typename Number, std::size_t... I>
CGAL_MULTISIDED_PATCHES_ALWAYS_INLINE void
add_weighted_triples_in(const Number* weights, const std::array<Number, 3>* triples,
                        std::size_t rows, Number* sums, std::size_t stride,
                        std::index_sequence<I...>) {
  using Vector = typename Vector_of<Number, Bytes>::Type;
  constexpr std::size_t lanes = Vector_of<Number, Bytes>::lanes;
  static_assert(Length % (sizeof...(I) * lanes) == 0);
  for (std::size_t k = 0; k < Length; k += sizeof...(I) * lanes) {
    std::array<Vector_triple<Vector>, sizeof...(I)> sum{};
    for (std::size_t r = 0; r < rows; ++r) {
      const Vector_triple<Vector> triple{triples[r][0] - Vector{}, triples[r][1] - Vector{},
                                         triples[r][2] - Vector{}};
      // A loop might not be unrolled.
      (add_product(weights + r * Length + k + I * lanes, triple, sum[I]), ...);
    }
    for (std::size_t c = 0; c < 3; ++c)
      (add_to(sums + c * stride + k + I * lanes, sum[I][c]), ...);
  }
}

// Twelve sums, a triple and a vector of weights are what sixteen registers hold.
using Vectors_of_row = std::make_index_sequence<4>;

#ifdef CGAL_MULTISIDED_PATCHES_ASK_FOR_AVX2
template <std::size_t Length, typename Number>
[[gnu::target("avx2")]] void
add_weighted_triples_avx2(const Number* weights, const std::array<Number, 3>* triples,
                          std::size_t rows, Number* sums, std::size_t stride) {
  add_weighted_triples_in<32, Length>(weights, triples, rows, sums, stride, Vectors_of_row());
}
inline bool has_avx2() {
  static const bool result = __builtin_cpu_supports("avx2") != 0;
  return result;
}
#endif

// Adds the products of triples with a row of `Length` weights each, which follow each other: for
// coordinate c to the `Length` numbers from `sums[c * stride]` on. `Length` numbers are a multiple
// of 128 bytes.
template <std::size_t Length, typename Number>
void add_weighted_triples(const Number* weights, const std::array<Number, 3>* triples,
                          std::size_t rows, Number* sums, std::size_t stride) {
#ifdef CGAL_MULTISIDED_PATCHES_ASK_FOR_AVX2
  if (has_avx2())
    return add_weighted_triples_avx2<Length>(weights, triples, rows, sums, stride);
#endif
#ifdef __AVX2__
  constexpr std::size_t bytes = 32;
#else
  constexpr std::size_t bytes = 16;
#endif
  add_weighted_triples_in<bytes, Length>(weights, triples, rows, sums, stride, Vectors_of_row());
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#undef CGAL_MULTISIDED_PATCHES_ALWAYS_INLINE
#undef CGAL_MULTISIDED_PATCHES_ASK_FOR_AVX2

#endif // CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_ADD_WEIGHTED_TRIPLES_H
