// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_DEGREE_CHANGE_H
#define CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_DEGREE_CHANGE_H

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// at + numerator / denominator (towards - at). Written as a step, points that coincide stay as they
// are; half-way the two are treated alike.
template <typename Point_3>
Point_3 step_towards(const Point_3& at, const Point_3& towards, std::size_t numerator,
                     std::size_t denominator) {
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  if (2 * numerator == denominator)
    return CGAL::midpoint(at, towards);
  const FT share = FT(static_cast<int>(numerator)) / FT(static_cast<int>(denominator));
  return at + share * (towards - at);
}

// Makes the first control points of a Bézier curve of degree m those of the same curve written with
// degree m + 1. pre: points.size() <= degree + 2; all of degree + 2 points may be asked for if the
// last is there twice
template <typename Point_3>
void raise_prefix(std::vector<Point_3>& points, std::size_t degree) {
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  CGAL_precondition(points.size() <= degree + 2);
  for (std::size_t k = points.size(); k-- > 1;) {
    const FT share = FT(static_cast<int>(k)) / FT(static_cast<int>(degree + 1));
    points[k] = points[k] + share * (points[k - 1] - points[k]);
  }
}

// The inverse: makes the first control points of degree m those of a curve of degree m - 1 with the
// same derivatives at the start, up to the order that these points tell. pre: points.size() <=
// degree
template <typename Point_3>
void lower_prefix(std::vector<Point_3>& points, std::size_t degree) {
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  CGAL_precondition(points.size() <= degree);
  for (std::size_t k = 1; k < points.size(); ++k) {
    const FT share = FT(static_cast<int>(k)) / FT(static_cast<int>(degree - k));
    points[k] = points[k] + share * (points[k] - points[k - 1]);
  }
}

template <typename Point_3>
void change_prefix_degree(std::vector<Point_3>& points, std::size_t from, std::size_t to) {
  for (; from < to; ++from)
    raise_prefix(points, from);
  for (; from > to; --from)
    lower_prefix(points, from);
}

/*
 * Control points in columns: `control_point(j, k)` is point k of column j, of as many as `columns`
 * and `rows` say. Returns them row by row after `change(column)`, with a vector of points, has made
 * the same number of points from each column.
 */
template <typename Control_point, typename Change>
auto change_columns(std::size_t columns, std::size_t rows, const Control_point& control_point,
                    const Change& change) {
  using Point_3 = std::decay_t<decltype(control_point(columns, rows))>;
  std::vector<Point_3> points;
  for (std::size_t j = 0; j < columns; ++j) {
    std::vector<Point_3> column;
    for (std::size_t k = 0; k < rows; ++k)
      column.push_back(control_point(j, k));
    change(column);
    points.resize(columns * column.size());
    for (std::size_t k = 0; k < column.size(); ++k)
      points[k * columns + j] = column[k];
  }
  return points;
}

// The first rows of a tensor product surface of degree `from` across them, as those of a surface of
// degree `to`: each column by `change_prefix_degree()`.
template <typename Control_point>
auto change_cross_degree(std::size_t columns, std::size_t rows, const Control_point& control_point,
                         std::size_t from, std::size_t to) {
  return change_columns(columns, rows, control_point,
                        [&](auto& column) { change_prefix_degree(column, from, to); });
}

// Adds one more of the first control points, such that the derivative of the order that it
// determines vanishes: it continues the polynomial of lowest degree through the points.
template <typename Point_3>
void append_smoothly(std::vector<Point_3>& points) {
  using Vector_3 = typename Kernel_traits<Point_3>::Kernel::Vector_3;
  Point_3 next = points.back();
  std::vector<Vector_3> differences;
  for (std::size_t k = 1; k < points.size(); ++k)
    differences.push_back(points[k] - points[k - 1]);
  while (!differences.empty()) {
    next = next + differences.back();
    for (std::size_t k = 1; k < differences.size(); ++k)
      differences[k - 1] = differences[k] - differences[k - 1];
    differences.pop_back();
  }
  points.push_back(next);
}

// All control points of a curve, written with one degree more.
template <typename Point_3>
void raise_curve(std::vector<Point_3>& points) {
  points.push_back(points.back());
  raise_prefix(points, points.size() - 2);
}

/*
 * All control points of a curve of degree d >= 2 with one degree less: the inverse of
 * `raise_curve()` where there is one. Otherwise the first half of the points keeps the derivatives
 * at the start, the second half those at the end, up to order ⌊d/2⌋ - 1; for odd d the point in the
 * middle is the mean of what the two say (A. R. Forrest, *Interactive interpolation and
 * approximation by Bézier polynomials*, The Computer Journal 15, 1972).
 */
template <typename Point_3>
void lower_curve(std::vector<Point_3>& points) {
  const std::size_t d = points.size() - 1;
  const auto half = static_cast<std::ptrdiff_t>((d + 1) / 2);
  CGAL_precondition(d >= 2);
  std::vector<Point_3> first(points.begin(), points.begin() + half),
      last(points.rbegin(), points.rbegin() + half);
  lower_prefix(first, d);
  lower_prefix(last, d);
  if (d % 2 != 0) {
    first.back() = CGAL::midpoint(first.back(), last.back());
    last.pop_back();
  }
  std::copy(last.rbegin(), last.rend(), std::copy(first.begin(), first.end(), points.begin()));
  points.pop_back();
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_DEGREE_CHANGE_H
