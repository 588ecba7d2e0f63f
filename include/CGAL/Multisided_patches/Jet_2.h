// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_JET_2_H
#define CGAL_MULTISIDED_PATCHES_JET_2_H

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Multisided_patches {

/*!
 * A value with its partial derivatives in two variables (u,v) up to a fixed order: truncated Taylor
 * arithmetic. A formula that is written once, generic in its number type, gives plain values with
 * `Jet_2<FT,0>`, gradients with `Jet_2<FT,1>` and Hessians with `Jet_2<FT,2>`, exact up to the
 * arithmetic of `FT`; there are no finite differences anywhere in the package.
 *
 * \tparam FT_ a field number type
 * \tparam Order_ the highest order of derivative kept: 0, 1 or 2
 */
template <typename FT_, int Order_>
class Jet_2 {
  static_assert(0 <= Order_ && Order_ <= 2, "jets hold derivatives of order 0, 1 or 2");

public:
  using FT = FT_;
  static constexpr int order = Order_;
  //! the number of entries: 1, 3 or 6
  static constexpr std::size_t size = (order + 1) * (order + 2) / 2;

  //! the constant 0
  Jet_2() { // FT() need not be 0, as for CGAL's lazy numbers
    for_each_entry([&](std::size_t i) { data_[i] = FT(0); });
  }
  //! a constant; its derivatives are 0
  Jet_2(const FT& constant) : Jet_2() { data_[0] = constant; }

  //! the first variable, at `u`
  static Jet_2 u_variable(const FT& u) { return variable(u, 1); }
  //! the second variable, at `v`
  static Jet_2 v_variable(const FT& v) { return variable(v, 2); }

  //! entry `i` in the order value, d/du, d/dv, d²/du², d²/dudv, d²/dv²
  const FT& operator[](std::size_t i) const { return data_[i]; }
  FT& operator[](std::size_t i) { return data_[i]; }

  const FT& value() const { return data_[0]; }

  Jet_2& operator+=(const Jet_2& b) {
    for_each_entry([&](std::size_t i) { data_[i] += b[i]; });
    return *this;
  }
  Jet_2& operator-=(const Jet_2& b) {
    for_each_entry([&](std::size_t i) { data_[i] -= b[i]; });
    return *this;
  }
  Jet_2& operator*=(const Jet_2& b) { return *this = *this * b; }
  Jet_2& operator/=(const Jet_2& b) { return *this = *this / b; }
  Jet_2& operator*=(FT b) { // by value: b may be an entry of this jet
    for_each_entry([&](std::size_t i) { data_[i] *= b; });
    return *this;
  }

  friend Jet_2 operator-(const Jet_2& a) {
    Jet_2 r{Undefined()};
    for_each_entry([&](std::size_t i) { r[i] = -a[i]; });
    return r;
  }
  friend Jet_2 operator+(Jet_2 a, const Jet_2& b) { return a += b; }
  friend Jet_2 operator-(Jet_2 a, const Jet_2& b) { return a -= b; }
  friend Jet_2 operator*(Jet_2 a, const FT& b) { return a *= b; }
  friend Jet_2 operator*(const FT& a, Jet_2 b) { return b *= a; }
  friend Jet_2 operator*(const Jet_2& a, const Jet_2& b) {
    Jet_2 r{Undefined()};
    r[0] = a[0] * b[0];
    if constexpr (order >= 1) {
      r[1] = a[1] * b[0] + a[0] * b[1];
      r[2] = a[2] * b[0] + a[0] * b[2];
    }
    if constexpr (order >= 2) {
      const FT uu = a[1] * b[1], vv = a[2] * b[2];
      r[3] = a[3] * b[0] + uu + uu + a[0] * b[3];
      r[4] = a[4] * b[0] + a[1] * b[2] + a[2] * b[1] + a[0] * b[4];
      r[5] = a[5] * b[0] + vv + vv + a[0] * b[5];
    }
    return r;
  }
  //! \pre `b.value() != 0`
  friend Jet_2 operator/(const Jet_2& a, const Jet_2& b) {
    // From a = q b, differentiated; the value is a single, correctly rounded division.
    Jet_2 q{Undefined()};
    q[0] = a[0] / b[0];
    if constexpr (order >= 1) {
      q[1] = (a[1] - q[0] * b[1]) / b[0];
      q[2] = (a[2] - q[0] * b[2]) / b[0];
    }
    if constexpr (order >= 2) {
      const FT uu = q[1] * b[1], vv = q[2] * b[2];
      q[3] = (a[3] - uu - uu - q[0] * b[3]) / b[0];
      q[4] = (a[4] - q[1] * b[2] - q[2] * b[1] - q[0] * b[4]) / b[0];
      q[5] = (a[5] - vv - vv - q[0] * b[5]) / b[0];
    }
    return q;
  }

  /*!
   * the chain rule: the jet of f∘g, where g is this jet and `f0`, `f1`, `f2` are f, f' and f'' at
   * g's value.
   */
  Jet_2 composed(const FT& f0, const FT& f1, const FT& f2) const {
    Jet_2 r{Undefined()};
    r[0] = f0;
    if constexpr (order >= 1) {
      r[1] = f1 * data_[1];
      r[2] = f1 * data_[2];
    }
    if constexpr (order >= 2) {
      r[3] = f1 * data_[3] + f2 * data_[1] * data_[1];
      r[4] = f1 * data_[4] + f2 * data_[1] * data_[2];
      r[5] = f1 * data_[5] + f2 * data_[2] * data_[2];
    }
    return r;
  }

private:
  // A loop would not be unrolled at all levels of optimization.
  template <typename Function>
  static void for_each_entry(const Function& f) {
    f(0);
    if constexpr (order >= 1) {
      f(1);
      f(2);
    }
    if constexpr (order >= 2) {
      f(3);
      f(4);
      f(5);
    }
  }

  struct Undefined {};
  explicit Jet_2(Undefined) {}

  static Jet_2 variable(const FT& x, std::size_t entry) {
    Jet_2 r(x);
    if (entry < size)
      r[entry] = FT(1);
    return r;
  }

  std::array<FT, size> data_;
};

/*!
 * 1 / a, with a single division. \pre `a.value() != 0`
 */
template <typename FT, int Order>
Jet_2<FT, Order> inverse(const Jet_2<FT, Order>& a) {
  const FT f0 = FT(1) / a.value();
  if constexpr (Order == 0)
    return Jet_2<FT, Order>(f0);
  const FT f1 = -f0 * f0;
  return a.composed(f0, f1, FT(-2) * f0 * f1);
}

/*!
 * the non-negative square root. \pre `a.value() > 0`, or `a.value() == 0` and the order is 0
 */
template <typename FT, int Order>
Jet_2<FT, Order> sqrt(const Jet_2<FT, Order>& a) {
  using std::sqrt;
  const FT root = sqrt(a.value());
  if constexpr (Order == 0)
    return Jet_2<FT, Order>(root);
  const FT first = FT(1) / (root + root);
  return a.composed(root, first, -first / (a.value() + a.value()));
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_JET_2_H
