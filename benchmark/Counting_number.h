// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_BENCHMARK_COUNTING_NUMBER_H
#define MULTISIDED_PATCHES_BENCHMARK_COUNTING_NUMBER_H

namespace bench {

/*!
 * A `double` that counts: run a formula that is generic in its number type with this one, and know
 * how many additions, subtractions, multiplications and divisions it takes.
 */
class Counting_number {
public:
  Counting_number(double value = 0) : value_(value) {}

  double value() const { return value_; }
  static long operations() { return counter(); }

  Counting_number& operator+=(Counting_number b) { return set(value_ + b.value_); }
  Counting_number& operator-=(Counting_number b) { return set(value_ - b.value_); }
  Counting_number& operator*=(Counting_number b) { return set(value_ * b.value_); }
  Counting_number& operator/=(Counting_number b) { return set(value_ / b.value_); }
  friend Counting_number operator+(Counting_number a, Counting_number b) { return a += b; }
  friend Counting_number operator-(Counting_number a, Counting_number b) { return a -= b; }
  friend Counting_number operator*(Counting_number a, Counting_number b) { return a *= b; }
  friend Counting_number operator/(Counting_number a, Counting_number b) { return a /= b; }
  friend Counting_number operator-(Counting_number a) { return Counting_number(-a.value_); }

  friend bool operator==(Counting_number a, Counting_number b) { return a.value_ == b.value_; }
  friend bool operator!=(Counting_number a, Counting_number b) { return a.value_ != b.value_; }
  friend bool operator<(Counting_number a, Counting_number b) { return a.value_ < b.value_; }
  friend bool operator<=(Counting_number a, Counting_number b) { return a.value_ <= b.value_; }
  friend bool operator>(Counting_number a, Counting_number b) { return a.value_ > b.value_; }
  friend bool operator>=(Counting_number a, Counting_number b) { return a.value_ >= b.value_; }

private:
  static long& counter() {
    static long count = 0;
    return count;
  }
  Counting_number& set(double result) {
    ++counter();
    value_ = result;
    return *this;
  }

  double value_;
};

} // namespace bench

#endif // MULTISIDED_PATCHES_BENCHMARK_COUNTING_NUMBER_H
