// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "merge_fixtures.h"

#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

using namespace merge_fixtures;
using MP::Corner_type;

namespace {

using Merged = MP::Merged_loop_3<Exact>;

// A bicubic patch over the square [x,x+3] × [0,3], with bumps.
Grid bumpy_grid(Random& random, int x) {
  Grid grid(4);
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      grid[static_cast<std::size_t>(a)].emplace_back(
          x + a + ratio(static_cast<int>(random.integer(0, 20)), 100),
          b + ratio(static_cast<int>(random.integer(0, 20)), 100),
          ratio(static_cast<int>(random.integer(0, 100)), 100));
  return grid;
}

Loop loop_of(const Grid& grid) {
  return fixtures::tensor_product_loop<Exact>(grid);
}

// The two parts of a patch, u in [0,t] and in [t,1].
std::pair<Grid, Grid> split(const Grid& grid, const FT& t) {
  Grid left(grid.size()), right(grid.size());
  for (std::size_t b = 0; b < grid[0].size(); ++b) {
    std::vector<Point> row;
    for (const std::vector<Point>& column : grid)
      row.push_back(column[b]);
    for (std::size_t last = row.size() - 1; last < row.size(); --last) {
      left[row.size() - 1 - last].push_back(row[0]);
      right[last].push_back(row[last]);
      for (std::size_t j = 0; j < last; ++j)
        row[j] =
            CGAL::ORIGIN + ((1 - t) * (row[j] - CGAL::ORIGIN) + t * (row[j + 1] - CGAL::ORIGIN));
    }
  }
  return {left, right};
}

const Polygon nine_corners{{0, 0}, {6, 0}, {5, 2}, {6, 4}, {6, 8}, {4, 9}, {2, 9}, {0, 8}, {-1, 4}};

// Whether a ribbon is, row by row, the part of another one from `begin` to `end`: polynomials that
// are equal at more parameters than their degree.
bool is_part(const Ribbon& part, const Ribbon& whole, const FT& begin, const FT& end) {
  if (part.layers() != whole.layers())
    return false;
  const int count = static_cast<int>((std::max)(part.degree(), whole.degree())) + 1;
  for (std::size_t k = 0; k < part.layers(); ++k)
    for (int i = 0; i <= count; ++i) {
      const FT s = ratio(i, count);
      if (row_point(part, k, s) != row_point(whole, k, FT(begin + s * (end - begin))))
        return false;
    }
  return true;
}

// Whether every side that was not joined has the ribbon of its source, or the part of it.
void check_sources(const Merged& merged, const Loop& first, const Loop& second) {
  REQUIRE(merged.sources.size() == merged.loop.size());
  for (std::size_t i = 0; i < merged.loop.size(); ++i) {
    CAPTURE(i);
    const auto& sources = merged.sources[i];
    if (sources.size() == 1) {
      const Loop& from = sources[0].loop == 0 ? first : second;
      CHECK(is_part(merged.loop[i], from[sources[0].side], sources[0].begin, sources[0].end));
    }
  }
}

// A loop between two curves, the lower one from left to right, with straight sides at both ends.
template <typename Point_3>
auto loop_between(const std::vector<Point_3>& lower, const std::vector<Point_3>& upper) {
  using Kernel = typename CGAL::Kernel_traits<Point_3>::Kernel;
  std::vector<MP::Bezier_ribbon_3<Kernel>> ribbons;
  ribbons.emplace_back(lower.size() - 1, 1, lower);
  ribbons.emplace_back(1, 1, std::vector<Point_3>{lower.back(), upper.back()});
  ribbons.emplace_back(upper.size() - 1, 1, std::vector<Point_3>(upper.rbegin(), upper.rend()));
  ribbons.emplace_back(1, 1, std::vector<Point_3>{upper.front(), lower.front()});
  return MP::Ribbon_loop_3<Kernel>(ribbons);
}

// The left and the right half of such a loop with random curves of the given degree.
template <typename Kernel>
auto random_halves(Random& random, std::size_t degree) {
  using Point_3 = typename Kernel::Point_3;
  using Number = typename Kernel::FT;
  std::vector<Point_3> lower, upper;
  const auto height = [&] { return static_cast<double>(random.integer(0, 1000)) / 1000; };
  for (std::size_t j = 0; j <= degree; ++j) {
    lower.emplace_back(static_cast<double>(j), height(), height());
    upper.emplace_back(static_cast<double>(j), 5 + height(), height());
  }
  const Number half = Number(1) / Number(2);
  const auto below = MP::internal::split_curve(lower, half),
             above = MP::internal::split_curve(upper, half);
  return std::make_pair(loop_between(below.first, above.first),
                        loop_between(below.second, above.second));
}

// The square [0,2]², and a loop with x = 2 in common with it up to y = `top`, both plane.
std::pair<fixtures::Loop, fixtures::Loop> plane_squares(double top) {
  using P = fixtures::Point_3;
  return {loop_between<P>({P(0, 0, 0), P(2, 0, 0)}, {P(0, 2, 0), P(2, 2, 0)}),
          loop_between<P>({P(2, 0, 0), P(4, 0, 0)}, {P(2, top, 0), P(4, 2, 0)})};
}

MP::Merge_options without_joining() {
  MP::Merge_options options;
  options.join_sides = false;
  return options;
}

} // namespace

TEST_CASE("Two halves of a patch merge into the loop of the whole") {
  Random random(1);
  const Grid grid = bumpy_grid(random, 0);
  for (const FT& t : {ratio(1, 2), ratio(1, 3), ratio(5, 7)}) {
    const auto [left, right] = split(grid, t);
    const Loop a = loop_of(left), b = loop_of(right), whole = loop_of(grid);
    const Merged merged = MP::merge_loops(a, b);
    REQUIRE(merged.loop.size() == 4);
    check_sources(merged, a, b);
    // The lower and the upper side; the ribbons of the other two are as deep as the halves.
    std::size_t joined = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (merged.sources[i].size() == 2) {
        ++joined;
        const std::size_t side = merged.sources[i][0].side;
        CHECK(side % 2 == 0);
        CHECK(merged.loop[i].control_points() == whole[side].control_points());
      }
    CHECK(joined == 2);

    const Merged apart = MP::merge_loops(a, b, without_joining());
    CHECK(apart.loop.size() == 6);
    CHECK(apart.loop.number_of_corners(Corner_type::straight) == 2);
    check_sources(apart, a, b);
  }
}

TEST_CASE("Two patches of four sides with a curve in common merge into one of six or five") {
  Random random(2);
  const auto [left, right] = split(bumpy_grid(random, 0), ratio(1, 2));
  // Another upper side of the right one, and then another lower one too.
  Grid other = right;
  for (std::size_t a = 1; a < 4; ++a)
    other[a][3] = other[a][3] + Vector(0, 0, 1);
  const Merged five = MP::merge_loops(loop_of(left), loop_of(other));
  CHECK(five.loop.size() == 5);
  check_sources(five, loop_of(left), loop_of(other));
  for (std::size_t a = 1; a < 4; ++a)
    other[a][0] = other[a][0] + Vector(0, 0, 1);
  const Merged six = MP::merge_loops(loop_of(left), loop_of(other));
  CHECK(six.loop.size() == 6);
  check_sources(six, loop_of(left), loop_of(other));
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(six.sources[i][0].loop == (i < 3 ? 0 : 1));
    CHECK(six.sources[i][0].begin == 0);
    CHECK(six.sources[i][0].end == 1);
  }
  // Sides 2, 3 and 0 of the left patch, and 0, 1 and 2 of the right one.
  CHECK(six.sources[0][0].side == 2);
  CHECK(six.sources[3][0].side == 0);
}

TEST_CASE("A curve that is part of one of the other loop leaves the rest as a side") {
  Random random(3);
  const Grid grid = bumpy_grid(random, 0);
  const FT from = GENERATE(FT(0), ratio(1, 5)), to = GENERATE(ratio(2, 3), FT(1));
  // The left side of the second patch is a part of the right side of the first one.
  Grid other = bumpy_grid(random, 3);
  other[0] = MP::internal::curve_piece(grid[3], from, to);
  const Loop a = loop_of(grid), b = loop_of(other);
  const std::size_t size = std::size_t(6) + (from == 0 ? 0 : 1) + (to == 1 ? 0 : 1);
  CAPTURE(size);
  const Merged merged = MP::merge_loops(a, b);
  REQUIRE(merged.loop.size() == size);
  check_sources(merged, a, b);
  const auto& first = merged.sources.front().front();
  CHECK(first.side == (to == 1 ? 2 : 1));
  CHECK(first.begin == (to == 1 ? FT(0) : to));
  const auto& last = merged.sources[size - 4].front();
  CHECK(last.side == (from == 0 ? 0 : 1));
  CHECK(last.end == (from == 0 ? FT(1) : from));
  // The same, whichever comes first.
  const Merged swapped = MP::merge_loops(b, a);
  CHECK(swapped.loop.size() == size);
  check_sources(swapped, b, a);
}

TEST_CASE("Nine and four sides merge into twelve, with a reflex corner at either end") {
  const Loop a = loop_over(nine_corners), b = loop_over({{6, 4}, {9, 4}, {9, 6}, {6, 6}});
  REQUIRE(a.number_of_corners(Corner_type::reflex) == 1);
  const Merged merged = MP::merge_loops(a, b);
  CHECK(merged.loop.size() == 12);
  check_sources(merged, a, b);
  // The two ends of the shared curve, and the corner that the first loop had.
  CHECK(merged.loop.number_of_corners(Corner_type::reflex) == 3);
  CHECK(merged.loop.corner_type(0) == Corner_type::reflex);
  CHECK(merged.sources[0][0].begin == ratio(1, 2));
}

TEST_CASE("Nine and nine sides merge into thirteen along two curves and a half") {
  const Loop a = loop_over(nine_corners),
             b = loop_over(
                 {{6, 6}, {6, 4}, {5, 2}, {6, 0}, {9, -1}, {11, 0}, {12, 3}, {11, 6}, {9, 7}});
  const Merged merged = MP::merge_loops(a, b);
  CHECK(merged.loop.size() == 13);
  check_sources(merged, a, b);
  // The reflex corners that the loops had are inside now.
  CHECK(merged.loop.number_of_corners(Corner_type::reflex) == 2);
  CHECK(merged.loop.corner_type(0) == Corner_type::reflex);
}

TEST_CASE("Sides may overlap with their ends only, and one side with several") {
  const Loop square = loop_over({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  const Merged shifted = MP::merge_loops(square, loop_over({{2, 1}, {4, 1}, {4, 3}, {2, 3}}));
  CHECK(shifted.loop.size() == 8);
  CHECK(shifted.loop.number_of_corners(Corner_type::reflex) == 2);
  const Loop two = loop_over({{2, 2}, {2, 1}, {2, 0}, {5, -1}, {5, 3}});
  CHECK(MP::merge_loops(square, two).loop.size() == 6);
  CHECK(MP::merge_loops(two, square).loop.size() == 6);
}

TEST_CASE("A shared curve may have another degree in the other loop") {
  const Loop a = loop_over({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  std::vector<Ribbon> ribbons = loop_over({{2, 0}, {4, -1}, {4, 3}, {2, 2}}).ribbons();
  for (Ribbon& r : ribbons)
    r = r.elevated(5);
  const Loop b(ribbons);
  const Merged merged = MP::merge_loops(a, b);
  CHECK(merged.loop.size() == 6);
  check_sources(merged, a, b);
}

TEST_CASE("Merging goes on with loops that were merged") {
  const Loop a = loop_over({{0, 0}, {1, 0}, {1, 1}, {0, 1}}),
             b = loop_over({{1, 0}, {2, 0}, {2, 1}, {1, 1}}),
             c = loop_over({{0, 1}, {1, 1}, {1, 2}, {0, 2}}),
             d = loop_over({{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  const Loop row = MP::merge_loops(a, b).loop;
  CHECK(row.size() == 4); // on this surface straight sides in one line are one curve
  const Loop l_shape = MP::merge_loops(row, c).loop;
  CHECK(l_shape.size() == 6);
  CHECK(l_shape.number_of_corners(Corner_type::reflex) == 1);
  const Loop square = MP::merge_loops(l_shape, d).loop;
  CHECK(square.size() == 4);
  CHECK(square.number_of_corners(Corner_type::convex) == 4);
}

TEST_CASE("Rounded halves of a patch, and curves a little apart, merge too") {
  const unsigned seed = GENERATE(range(1u, 21u));
  CAPTURE(seed);
  Random random(seed);
  std::vector<std::vector<fixtures::Point_3>> left(4), right(4), whole(4);
  const double t = random.in(0.1, 0.9), noise = seed % 2 == 0 ? 0 : 1e-10;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < 4; ++b)
      whole[a].emplace_back(static_cast<double>(a), static_cast<double>(b), random.in(0, 1));
  for (std::size_t b = 0; b < 4; ++b) {
    const auto halves = MP::internal::split_curve(
        std::vector<fixtures::Point_3>{whole[0][b], whole[1][b], whole[2][b], whole[3][b]}, t);
    for (std::size_t a = 0; a < 4; ++a) {
      left[a].push_back(halves.first[a]);
      right[a].push_back(halves.second[a] + fixtures::Vector_3(0, 0, random.in(-noise, noise)));
    }
  }
  using fixtures::Kernel;
  const fixtures::Loop a = fixtures::tensor_product_loop<Kernel>(left),
                       b = fixtures::tensor_product_loop<Kernel>(right);
  MP::Merge_options options;
  CHECK(MP::merge_loops(a, b, options).loop.size() == 4);
  options.join_sides = false;
  const MP::Merged_loop_3<Kernel> apart = MP::merge_loops(a, b, options);
  REQUIRE(apart.loop.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& source = apart.sources[i].front();
    const auto& ribbon = (source.loop == 0 ? a : b)[source.side];
    // But for the end, which is moved to meet the other loop.
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(apart.loop[i].control_point(j, 0) == ribbon.control_point(j, 0));
  }
  options.relative_tolerance = 0;
  if (noise > 0)
    CHECK_THROWS_AS(MP::merge_loops(a, b, options), MP::Input_error);
}

TEST_CASE("In double, a side is cut where the other loop begins") {
  Random random(40);
  for (int i = 0; i < 20; ++i) {
    using fixtures::Kernel;
    std::vector<std::vector<fixtures::Point_3>> left(4), right(4);
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < 4; ++b) {
        left[a].emplace_back(a, b, random.in(0, 1));
        right[a].emplace_back(a + 3, b, random.in(0, 1));
      }
    const double from = random.in(0.1, 0.4), to = random.in(0.6, 0.9);
    right[0] = MP::internal::curve_piece(left[3], from, to);
    const auto merged = MP::merge_loops(fixtures::tensor_product_loop<Kernel>(left),
                                        fixtures::tensor_product_loop<Kernel>(right));
    REQUIRE(merged.loop.size() == 8);
    CHECK(merged.sources[0][0].begin == Approx(to).epsilon(0).margin(1e-14));
    CHECK(merged.sources[4][0].end == Approx(from).epsilon(0).margin(1e-14));
    CHECK(merged.loop.corner_point(0) == right[0][3]);
  }
}

TEST_CASE("Rounded halves of a side join up to degree 16, exact ones at any degree") {
  const unsigned seed = GENERATE(range(1u, 11u));
  CAPTURE(seed);
  Random random(seed);
  const auto [left, right] = random_halves<fixtures::Kernel>(random, 16);
  CHECK(MP::merge_loops(left, right).loop.size() == 4);
  if (seed == 1) {
    const auto [a, b] = random_halves<Exact>(random, 30);
    CHECK(MP::merge_loops(a, b).loop.size() == 4);
  }
}

TEST_CASE("The ends of two curves are the same or apart, with nothing in between") {
  const double tolerance = std::sqrt(8.0) * 1e-9; // of the default, for the square
  for (const double factor : {0.1, 0.5, 0.99, 1.01, 1.1, 1.5, 1.99, 2.01, 3.0, 10.0})
    for (const double sign : {-1, 1}) {
      CAPTURE(factor, sign);
      const auto [a, b] = plane_squares(2 + sign * factor * tolerance);
      // Apart, a small side is left over, and nothing joins at that end.
      const std::size_t size = factor < 1 ? 6 : 7;
      CHECK(MP::merge_loops(a, b, without_joining()).loop.size() == size);
      CHECK(MP::merge_loops(b, a, without_joining()).loop.size() == size);
    }
}

TEST_CASE("No slivers are left at either end of a side") {
  // Much more than the tolerance of 1e-13 times the size, but nothing as a parameter.
  MP::Merge_options options = without_joining();
  options.relative_tolerance = 1e-13;
  const auto at_end = plane_squares(2 - 1e-10);
  CHECK(MP::merge_loops(at_end.first, at_end.second, options).loop.size() == 6);
  CHECK(MP::merge_loops(at_end.second, at_end.first, options).loop.size() == 6);
  // Upside down, so that what was the end is the start.
  using P = fixtures::Point_3;
  const auto lower = loop_between<P>({P(2, 1e-10, 0), P(4, 0, 0)}, {P(2, 2, 0), P(4, 2, 0)});
  CHECK(MP::merge_loops(at_end.first, lower, options).loop.size() == 6);
  CHECK(MP::merge_loops(lower, at_end.first, options).loop.size() == 6);
}
