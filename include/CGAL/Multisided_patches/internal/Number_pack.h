// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_NUMBER_PACK_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_NUMBER_PACK_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/internal/bernstein.h>

#if defined(__GNUC__) && defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Two numbers, each in a lane of its own, that the same formula is computed for at once. What one
// lane gets does not depend on the others: it is, to the last bit, what the formula gives in
// `double`, unless the compiler was told to contract products and sums, which it may do differently
// in the two.
//
// A formula works on packs and on any other number type alike if it decides with select() and not
// with `if`, and leaves to any() whether there is a reason to take a rare way.
class Number_pack {
#ifdef __GNUC__
  // What every processor with SSE2 or Neon does at once, and small enough for any allocator.
  using Part = double __attribute__((vector_size(16)));
  static constexpr std::size_t part_width = 2;
#else
  using Part = double;
  static constexpr std::size_t part_width = 1;
#endif

public:
  // With more lanes, jets of packs would not fit into registers; that costs more than it gains.
  static constexpr std::size_t lanes = 2;

  // For every lane whether something holds.
  class Mask {
  public:
    bool operator[](std::size_t l) const {
#ifdef __GNUC__
      return parts_[l / part_width][l % part_width] != 0;
#else
      return parts_[l];
#endif
    }
    friend bool any(const Mask& m) {
#ifdef __GNUC__
      return (m.parts_[0][0] | m.parts_[0][1]) != 0;
#else
      return m.parts_[0] || m.parts_[1];
#endif
    }

    decltype(Part() < Part()) parts_[lanes / part_width]; // of no concern to others
  };

  Number_pack() = default; // of undefined value, like a `double`
  Number_pack(double x) {
#ifdef __GNUC__
    for_each_part([&](std::size_t i) { parts_[i] = Part{x, x}; });
#else
    for_each_part([&](std::size_t i) { parts_[i] = x; });
#endif
  }

  double operator[](std::size_t l) const {
#ifdef __GNUC__
    return parts_[l / part_width][l % part_width];
#else
    return parts_[l];
#endif
  }
  // numbers from consecutive places in memory, or to there
  static Number_pack load(const double* p) {
    Number_pack r;
    std::memcpy(r.parts_, p, sizeof(r.parts_));
    return r;
  }
  static Number_pack load(const float* p) {
    Number_pack r;
#if defined(__GNUC__) && defined(__SSE2__)
    double two_floats;
    std::memcpy(&two_floats, p, sizeof(two_floats));
    r.parts_[0] = _mm_cvtps_pd(_mm_castpd_ps(_mm_set_sd(two_floats)));
#else
    for (std::size_t l = 0; l < lanes; ++l)
      r.set(l, static_cast<double>(p[l]));
#endif
    return r;
  }
  void store(double* p) const {
    std::memcpy(p, parts_, sizeof(parts_));
  }
  // Adds the numbers to those at consecutive places in memory.
  void add_to(double* p) const {
    (load(p) + *this).store(p);
  }
  void set(std::size_t l, double x) {
#ifdef __GNUC__
    parts_[l / part_width][l % part_width] = x;
#else
    parts_[l] = x;
#endif
  }

  Number_pack& operator+=(const Number_pack& b) {
    for_each_part([&](std::size_t i) { parts_[i] += b.parts_[i]; });
    return *this;
  }
  Number_pack& operator-=(const Number_pack& b) {
    for_each_part([&](std::size_t i) { parts_[i] -= b.parts_[i]; });
    return *this;
  }
  Number_pack& operator*=(const Number_pack& b) {
    for_each_part([&](std::size_t i) { parts_[i] *= b.parts_[i]; });
    return *this;
  }
  Number_pack& operator/=(const Number_pack& b) {
    for_each_part([&](std::size_t i) { parts_[i] /= b.parts_[i]; });
    return *this;
  }
  friend Number_pack operator-(Number_pack a) {
    for_each_part([&](std::size_t i) { a.parts_[i] = -a.parts_[i]; });
    return a;
  }
  friend Number_pack operator+(Number_pack a, const Number_pack& b) {
    return a += b;
  }
  friend Number_pack operator-(Number_pack a, const Number_pack& b) {
    return a -= b;
  }
  friend Number_pack operator*(Number_pack a, const Number_pack& b) {
    return a *= b;
  }
  friend Number_pack operator/(Number_pack a, const Number_pack& b) {
    return a /= b;
  }

  friend Mask operator<(const Number_pack& a, const Number_pack& b) {
    Mask m;
    for_each_part([&](std::size_t i) { m.parts_[i] = a.parts_[i] < b.parts_[i]; });
    return m;
  }
  friend Mask operator<=(const Number_pack& a, const Number_pack& b) {
    Mask m;
    for_each_part([&](std::size_t i) { m.parts_[i] = a.parts_[i] <= b.parts_[i]; });
    return m;
  }
  friend Mask operator==(const Number_pack& a, const Number_pack& b) {
    Mask m;
    for_each_part([&](std::size_t i) { m.parts_[i] = a.parts_[i] == b.parts_[i]; });
    return m;
  }

  friend Number_pack sqrt(const Number_pack& a) {
    Number_pack r;
#if defined(__GNUC__) && defined(__SSE2__)
    r.parts_[0] = _mm_sqrt_pd(a.parts_[0]);
#else
    for (std::size_t l = 0; l < lanes; ++l)
      r.set(l, std::sqrt(a[l]));
#endif
    return r;
  }

  // a where the mask holds, and b elsewhere
  friend Number_pack select(const Mask& m, const Number_pack& a, const Number_pack& b) {
    Number_pack r;
    for_each_part([&](std::size_t i) {
#ifdef __GNUC__ // the operator ?: would compare the mask with 0 first
      using Bits = decltype(m.parts_[i] & m.parts_[i]);
      r.parts_[i] = (Part)((m.parts_[i] & (Bits)a.parts_[i]) | (~m.parts_[i] & (Bits)b.parts_[i]));
#else
      r.parts_[i] = m.parts_[i] ? a.parts_[i] : b.parts_[i];
#endif
    });
    return r;
  }

private:
  // A loop would not be unrolled at all levels of optimization.
  template <typename Function>
  static void for_each_part(const Function& f) {
    f(0);
    if constexpr (lanes / part_width == 2)
      f(1);
  }

  Part parts_[lanes / part_width];
};

// The number type of the lanes, and their number; other types have one lane.
template <>
struct Scalar_of<Number_pack> {
  using type = double;
};
template <int Order>
struct Scalar_of<Jet_2<Number_pack, Order>> {
  using type = double;
};
template <typename FT>
inline constexpr std::size_t lanes_of = 1;
template <>
inline constexpr std::size_t lanes_of<Number_pack> = Number_pack::lanes;

inline bool any(bool mask) {
  return mask;
}
inline bool holds(bool mask, std::size_t) {
  return mask;
}
inline bool holds(const Number_pack::Mask& mask, std::size_t l) {
  return mask[l];
}

template <typename T>
const T& select(bool mask, const T& a, const T& b) {
  return mask ? a : b;
}
template <int Order>
Jet_2<Number_pack, Order> select(const Number_pack::Mask& mask, const Jet_2<Number_pack, Order>& a,
                                 const Jet_2<Number_pack, Order>& b) {
  Jet_2<Number_pack, Order> r;
  for (std::size_t k = 0; k < r.size; ++k)
    r[k] = select(mask, a[k], b[k]);
  return r;
}

// What is in lane `l`.
template <typename T>
const T& lane(const T& x, std::size_t) {
  return x;
}
inline double lane(const Number_pack& x, std::size_t l) {
  return x[l];
}
template <int Order>
Jet_2<double, Order> lane(const Jet_2<Number_pack, Order>& x, std::size_t l) {
  Jet_2<double, Order> r;
  for (std::size_t k = 0; k < r.size; ++k)
    r[k] = x[k][l];
  return r;
}

template <typename T>
void set_lane(T& x, std::size_t, const T& value) {
  x = value;
}
inline void set_lane(Number_pack& x, std::size_t l, double value) {
  x.set(l, value);
}
template <int Order>
void set_lane(Jet_2<Number_pack, Order>& x, std::size_t l, const Jet_2<double, Order>& value) {
  for (std::size_t k = 0; k < x.size; ++k)
    x[k].set(l, value[k]);
}

// Indices, one for each lane, that select() works on.
template <typename FT>
using Lane_indices = std::conditional_t<lanes_of<FT> == 1, std::size_t, FT>;

template <typename FT>
Lane_indices<FT> same_index(std::size_t i) {
  if constexpr (lanes_of<FT> == 1)
    return i;
  else
    return FT(static_cast<double>(i));
}
inline std::size_t index_in_lane(std::size_t i, std::size_t) {
  return i;
}
inline std::size_t index_in_lane(const Number_pack& i, std::size_t l) {
  return static_cast<std::size_t>(i[l]);
}

// In each lane what `of(i)` has there, for the index i of the lane. Calls `of` once for each index
// that occurs.
template <typename T, typename Indices, typename Function>
T gather(const Indices& indices, const Function& of) {
  constexpr std::size_t lanes = lanes_of<typename T::FT>;
  const std::size_t first = index_in_lane(indices, 0);
  T result = of(first);
  for (std::size_t l = 1; l < lanes; ++l) {
    const std::size_t i = index_in_lane(indices, l);
    std::size_t before = 0;
    while (index_in_lane(indices, before) != i)
      ++before;
    if (before < l || i == first)
      continue; // it is there already
    const T other = of(i);
    for (std::size_t k = l; k < lanes; ++k)
      if (index_in_lane(indices, k) == i)
        set_lane(result, k, lane(other, k));
  }
  return result;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_NUMBER_PACK_H
