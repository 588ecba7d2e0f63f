// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Includes Catch2, version 2 or 3, and makes the names of version 2 usable with both.

#ifndef MULTISIDED_PATCHES_TEST_CATCH_H
#define MULTISIDED_PATCHES_TEST_CATCH_H

#if __has_include(<catch2/catch_test_macros.hpp>)

#include <catch2/catch_approx.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_all.hpp>

#include <cstddef>
#include <string>

using Catch::Approx;

namespace Catch {

namespace Matchers {

// The function of this name in version 3 looks for an element of a range; these, for text in text,
// are better matches for their arguments.
inline auto Contains(std::string text) {
  return ContainsSubstring(text);
}
template <std::size_t N>
auto Contains(const char (&text)[N]) {
  return ContainsSubstring(text);
}

} // namespace Matchers

using namespace Matchers;

} // namespace Catch

#else

#include <catch2/catch.hpp>

#endif

#endif // MULTISIDED_PATCHES_TEST_CATCH_H
