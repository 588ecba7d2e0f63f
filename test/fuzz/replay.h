// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_H
#define MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_H

#include <CGAL/Multisided_patches/errors.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>

// What must hold for every input of a reader, whatever its bytes are. The fuzzers look for inputs
// for which it does not, and a test replays the inputs that are kept: any exception is a finding.
namespace fuzz {

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline void require(bool good, const std::string& what) {
  if (!good)
    throw std::logic_error("not true: " + what);
}

// The message of a refusal can be shown: it is one short line, whatever the input is.
inline void require_presentable(const std::string& message) {
  require(message.size() < 500, "the message is short");
  for (const char c : message)
    require(c >= 32 && c < 127, "the message is printable");
}

// What a reader returns, or nothing if it refuses the input, which it may do with this error only.
template <typename Read>
auto read_or_refuse(const Read& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const MP::Input_error& error) {
    require_presentable(error.what());
    return std::nullopt;
  }
}

// Numbers are the same if their bits are: 0 and -0 differ.
inline bool is_same(double a, double b) {
  std::uint64_t bits_a = 0, bits_b = 0;
  std::memcpy(&bits_a, &a, sizeof a);
  std::memcpy(&bits_b, &b, sizeof b);
  return bits_a == bits_b;
}

template <typename Point>
bool is_same_point(const Point& a, const Point& b) {
  bool same = true;
  for (int i = 0; i < a.dimension(); ++i)
    same = same && is_same(a.cartesian(i), b.cartesian(i));
  return same;
}

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_H
