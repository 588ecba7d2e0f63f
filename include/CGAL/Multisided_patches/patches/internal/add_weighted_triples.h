// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_ADD_WEIGHTED_TRIPLES_H
#define CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_ADD_WEIGHTED_TRIPLES_H

#include <array>
#include <cstddef>
#include <cstdint>
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

// A few rows of weights, side by side, with a triple each.
template <typename Number, std::size_t Size>
struct Weighted_triples {
  std::array<const Number*, Size> weights; // each at the start of its row
  std::array<std::array<Number, 3>, Size> triples;
};

// Rows that are read side by side are streams that processors do not foresee. So what follows in
// memory is asked for while they are used.
CGAL_MULTISIDED_PATCHES_ALWAYS_INLINE void prefetch_memory([[maybe_unused]] const void* start,
                                                           [[maybe_unused]] std::size_t offset) {
#ifdef __GNUC__
  // An address, which may be past the end.
  __builtin_prefetch(
      reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(start) + offset));
#endif
}

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

// (References, as what is passed in wide vectors depends on what the program is compiled for.)
template <typename Vector, typename Number>
CGAL_MULTISIDED_PATCHES_ALWAYS_INLINE void add_product(const Number* weights,
                                                       const std::array<Vector, 3>& triple,
                                                       std::array<Vector, 3>& sums) {
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

// What add_weighted_triples() does, so many bytes at a time.
template <std::size_t Bytes, std::size_t Length, std::size_t Parts, typename Number,
          std::size_t Size, std::size_t... I>
CGAL_MULTISIDED_PATCHES_ALWAYS_INLINE void
add_weighted_triples_in(const Weighted_triples<Number, Size>& rows, Number* sums,
                        std::index_sequence<I...>) {
  using Vector = typename Vector_of<Number, Bytes>::Type;
  constexpr std::size_t lanes = Vector_of<Number, Bytes>::lanes;
  static_assert(Length % lanes == 0);
  constexpr std::size_t distance = 8192; // bytes; what memory delivers while rows are used
  std::array<std::array<Vector, 3>, Size> triples;
  for (std::size_t i = 0; i < Size; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      triples[i][c] = rows.triples[i][c] - Vector{};
  for (std::size_t part = 0; part < Parts; ++part) {
    Number* const x = sums + part * 3 * Length;
    for (std::size_t k = 0; k < Length; k += lanes) {
      const std::size_t at = part * Length + k;
      for (std::size_t byte = 0; byte < sizeof(Vector) * Size; byte += 64)
        prefetch_memory(rows.weights[0], at * sizeof(Number) * Size + byte + distance);
      std::array<Vector, 3> sum{};
      (add_product(rows.weights[I] + at, triples[I], sum), ...); // a loop might not be unrolled
      for (std::size_t c = 0; c < 3; ++c)
        add_to(x + c * Length + k, sum[c]);
    }
  }
}

#ifdef CGAL_MULTISIDED_PATCHES_ASK_FOR_AVX2
template <std::size_t Length, std::size_t Parts, typename Number, std::size_t Size>
[[gnu::target("avx2")]] void add_weighted_triples_avx2(const Weighted_triples<Number, Size>& rows,
                                                       Number* sums) {
  add_weighted_triples_in<32, Length, Parts>(rows, sums, std::make_index_sequence<Size>());
}
inline bool has_avx2() {
  static const bool result = __builtin_cpu_supports("avx2") != 0;
  return result;
}
#endif

// Adds the products of triples and weights: for part p and coordinate c to the `Length` numbers
// from (3 p + c) Length on. The weights of part p start at p Length in every row. `Length` is a
// multiple of 8.
template <std::size_t Length, std::size_t Parts, typename Number, std::size_t Size>
void add_weighted_triples(const Weighted_triples<Number, Size>& rows, Number* sums) {
#ifdef CGAL_MULTISIDED_PATCHES_ASK_FOR_AVX2
  if (has_avx2())
    return add_weighted_triples_avx2<Length, Parts>(rows, sums);
#endif
#ifdef __AVX2__
  constexpr std::size_t bytes = 32;
#else
  constexpr std::size_t bytes = 16;
#endif
  add_weighted_triples_in<bytes, Length, Parts>(rows, sums, std::make_index_sequence<Size>());
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#undef CGAL_MULTISIDED_PATCHES_ALWAYS_INLINE
#undef CGAL_MULTISIDED_PATCHES_ASK_FOR_AVX2

#endif // CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_ADD_WEIGHTED_TRIPLES_H
