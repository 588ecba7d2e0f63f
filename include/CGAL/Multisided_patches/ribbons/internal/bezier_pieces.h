// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_BEZIER_PIECES_H
#define CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_BEZIER_PIECES_H

#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/ribbons/Bezier_ribbon_3.h>
#include <CGAL/Multisided_patches/ribbons/internal/de_casteljau.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

template <typename Traits>
std::vector<typename Traits::Point_3> row_of(const Bezier_ribbon_3<Traits>& ribbon, std::size_t k) {
  std::vector<typename Traits::Point_3> row;
  for (std::size_t j = 0; j <= ribbon.degree(); ++j)
    row.push_back(ribbon.control_point(j, k));
  return row;
}

// The part of a ribbon over [begin,end] of its side: each row by itself.
template <typename Traits>
Bezier_ribbon_3<Traits> ribbon_piece(const Bezier_ribbon_3<Traits>& ribbon,
                                     const typename Traits::FT& begin,
                                     const typename Traits::FT& end) {
  std::vector<typename Traits::Point_3> points;
  for (std::size_t k = 0; k < ribbon.layers(); ++k) {
    const auto row = curve_piece(row_of(ribbon, k), begin, end);
    points.insert(points.end(), row.begin(), row.end());
  }
  return Bezier_ribbon_3<Traits>(ribbon.degree(), ribbon.layers(), std::move(points));
}

// Whether control points of two curves of one degree are the same, each within `tolerance`.
template <typename Point_3>
bool same_control_points(const std::vector<Point_3>& a, const std::vector<Point_3>& b,
                         double tolerance) {
  for (std::size_t j = 0; j < a.size(); ++j)
    if (a[j] != b[j] && !(norm(to_vec3(a[j] - b[j])) <= tolerance))
      return false;
  return true;
}

/*
 * The ribbon of which two are the pieces, one after the other, if there is one: of the same degree
 * and with as many layers. Its own pieces are the given ones, up to `tolerance` for each control
 * point. Where it is cut follows from the speeds of the boundary curves: with v and w as the
 * derivatives where they meet, at v / (v + w).
 *
 * The longer piece is extrapolated to at most twice its length. There the Bernstein polynomials of
 * degree d have absolute values with a sum of at most 3^d, the factor for errors of its control
 * points: with rounded ones, pieces of high degree are not recognized.
 */
template <typename Traits>
std::optional<Bezier_ribbon_3<Traits>> join_ribbons(const Bezier_ribbon_3<Traits>& first,
                                                    const Bezier_ribbon_3<Traits>& second,
                                                    double tolerance) {
  using FT = typename Traits::FT;
  const std::size_t d = first.degree();
  if (second.degree() != d || second.layers() != first.layers())
    return std::nullopt;
  const typename Traits::Vector_3 v = first.control_point(d, 0) - first.control_point(d - 1, 0),
                                  w = second.control_point(1, 0) - second.control_point(0, 0);
  const typename Traits::Vector_3 sum = v + w;
  const FT length = sum * sum;
  if (!(FT(0) < length))
    return std::nullopt;
  const FT t = FT(v * sum) / length, rest = FT(1) - t;
  if (!(FT(0) < t && FT(0) < rest))
    return std::nullopt;

  std::vector<typename Traits::Point_3> points;
  for (std::size_t k = 0; k < first.layers(); ++k) {
    const auto before = row_of(first, k), after = row_of(second, k);
    // The longer piece tells more exactly what the whole is.
    auto row = rest < t ? split_curve(before, FT(FT(1) / t)).first
                        : split_curve(after, FT(-t / rest)).second;
    row.front() = before.front();
    row.back() = after.back();
    const auto pieces = split_curve(row, t);
    if (!same_control_points(pieces.first, before, tolerance) ||
        !same_control_points(pieces.second, after, tolerance))
      return std::nullopt;
    points.insert(points.end(), row.begin(), row.end());
  }
  return Bezier_ribbon_3<Traits>(d, first.layers(), std::move(points));
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_BEZIER_PIECES_H
