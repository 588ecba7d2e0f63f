// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "merge_fixtures.h"

#include <limits>

using namespace merge_fixtures;

TEST_CASE("A tolerance that is none is refused") {
  const Loop a = loop_over({{0, 0}, {2, 0}, {2, 2}, {0, 2}}),
             b = loop_over({{2, 2}, {2, 0}, {4, 0}, {4, 2}});
  MP::Merge_options options;
  for (const double good : {0.0, 1e-6, MP::Merge_options::max_relative_tolerance}) {
    options.relative_tolerance = good;
    CHECK(MP::merge_loops(a, b, options).loop.size() == 4);
  }
  for (const double bad : {-1e-9, 0.011, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
    options.relative_tolerance = bad;
    CHECK_THROWS_WITH(MP::merge_loops(a, b, options),
                      Catch::Matchers::Contains("not between 0 and 0.01"));
  }
}

TEST_CASE("Loops that touch apart from the shared chain are refused") {
  using Catch::Matchers::Contains;
  const Loop square = loop_over({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  const auto loop_with = [](int x, int y) {
    return loop_over({{2, 2}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {x, y}, {2, 3}});
  };
  // A corner on the upper side of the square, at its end, and beside it.
  CHECK_THROWS_WITH(MP::merge_loops(square, loop_with(1, 2)),
                    Contains("start of side 5 of the second is inside side 2 of the first"));
  CHECK_THROWS_WITH(MP::merge_loops(loop_with(1, 2), square),
                    Contains("start of side 5 of the first is inside side 2 of the second"));
  CHECK_THROWS_WITH(MP::merge_loops(square, loop_with(0, 2)),
                    Contains("start of side 3 of the first is that of side 5 of the second"));
  CHECK(MP::merge_loops(square, loop_with(1, 3)).loop.size() == 8);
  CHECK(MP::merge_loops(loop_with(1, 3), square).loop.size() == 8);
}

TEST_CASE("Loops that share nothing, or in the same direction, are refused") {
  using Catch::Matchers::Contains;
  const Loop a = loop_over({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  CHECK_THROWS_WITH(MP::merge_loops(a, loop_over({{5, 0}, {7, 0}, {7, 2}, {5, 2}})),
                    Contains("no part") && !Contains("direction"));
  // They touch at a corner only, or cross.
  CHECK_THROWS_AS(MP::merge_loops(a, loop_over({{2, 2}, {4, 2}, {4, 4}, {2, 4}})), MP::Input_error);
  CHECK_THROWS_AS(MP::merge_loops(a, loop_over({{1, 1}, {5, 1}, {5, 3}, {1, 3}})), MP::Input_error);
  CHECK_THROWS_WITH(MP::merge_loops(a, loop_over({{2, 0}, {2, 2}, {4, 2}, {4, 0}})),
                    Contains("side 1 of the first and side 0 of the second") &&
                        Contains("wrong way"));
}

TEST_CASE("A side that two sides of the other loop claim is refused") {
  CHECK_THROWS_WITH(MP::merge_loops(loop_over({{0, 0}, {2, 0}, {2, 2}, {0, 2}}),
                                    loop_over({{2, 2}, {2, 0}, {5, 0}, {2, 2}, {2, 0}, {5, -1}})),
                    Catch::Matchers::Contains("side 1 of the other"));
}

TEST_CASE("Loops around more than one hole, or around nothing, are refused") {
  using Catch::Matchers::Contains;
  const Loop u = loop_over({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}});
  CHECK_THROWS_WITH(MP::merge_loops(u, loop_over({{0, 4}, {2, 4}, {4, 4}, {6, 4}, {6, 6}, {0, 6}})),
                    Contains("2 separate chains"));
  // One side of the lid covers both ends, so that it is shared in two parts.
  CHECK_THROWS_AS(MP::merge_loops(u, loop_over({{0, 4}, {6, 4}, {6, 6}, {0, 6}})), MP::Input_error);
  // The second loop is the first one from the other side.
  CHECK_THROWS_WITH(
      MP::merge_loops(u,
                      loop_over({{0, 4}, {2, 4}, {2, 2}, {4, 2}, {4, 4}, {6, 4}, {6, 0}, {0, 0}})),
      Contains("nothing of it"));
  // They share a curve, and meet at (0,2) as well.
  CHECK_THROWS_WITH(
      MP::merge_loops(loop_over({{0, 0}, {2, 0}, {2, 2}, {0, 2}}),
                      loop_over({{2, 2}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}, {1, 3}})),
      Contains("touch itself"));
}
