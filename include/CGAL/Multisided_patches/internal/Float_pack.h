// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_FLOAT_PACK_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_FLOAT_PACK_H

#include <cstddef>
#include <cstring>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Four numbers in single precision for which the same sum is computed at once.
class Float_pack {
public:
  static constexpr std::size_t lanes = 4;

  Float_pack() = default; // of undefined value, like a `float`
  explicit Float_pack(float x) {
    for_each_lane([&](std::size_t l) { values_[l] = x; });
  }

  // numbers from consecutive places in memory
  static Float_pack load(const float* p) {
    Float_pack r;
    std::memcpy(&r.values_, p, sizeof(r.values_));
    return r;
  }

  Float_pack& operator+=(const Float_pack& b) {
#ifdef __GNUC__
    values_ += b.values_;
#else
    for_each_lane([&](std::size_t l) { values_[l] += b.values_[l]; });
#endif
    return *this;
  }
  friend Float_pack operator*(Float_pack a, const Float_pack& b) {
#ifdef __GNUC__
    a.values_ *= b.values_;
#else
    for_each_lane([&](std::size_t l) { a.values_[l] *= b.values_[l]; });
#endif
    return a;
  }

  // Adds the numbers to those at consecutive places in memory.
  void add_to(float* p) const {
    Float_pack sum = load(p);
    sum += *this;
    std::memcpy(p, &sum.values_, sizeof(sum.values_));
  }

private:
  // A loop would not be unrolled at all levels of optimization.
  template <typename Function>
  static void for_each_lane(const Function& f) {
    f(0);
    f(1);
    f(2);
    f(3);
  }

#ifdef __GNUC__
  float __attribute__((vector_size(16))) values_;
#else
  float values_[lanes];
#endif
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_FLOAT_PACK_H
