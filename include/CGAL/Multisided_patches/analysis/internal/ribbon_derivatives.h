// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_ANALYSIS_INTERNAL_RIBBON_DERIVATIVES_H
#define CGAL_MULTISIDED_PATCHES_ANALYSIS_INTERNAL_RIBBON_DERIVATIVES_H

#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/patches/internal/surface_derivatives.h>

#include <CGAL/Origin.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The derivatives of a Bézier curve of degree `points.size() - 1`: value, first and second.
struct Curve_derivatives {
  Vec3 value, first, second;
};

inline Vec3 bezier_point(const std::vector<Vec3>& points, double s) {
  std::vector<double> b(points.size());
  bernstein_polynomials(points.size() - 1, s, b.data());
  Vec3 point{0, 0, 0};
  for (std::size_t j = 0; j < points.size(); ++j)
    for (std::size_t c = 0; c < 3; ++c)
      point[c] += b[j] * points[j][c];
  return point;
}

// The control points of the derivative of a Bézier curve; of a point, the zero vector.
inline std::vector<Vec3> hodograph(const std::vector<Vec3>& points) {
  std::vector<Vec3> result;
  const double degree = static_cast<double>(points.size() - 1);
  for (std::size_t j = 0; j + 1 < points.size(); ++j) {
    const Vec3 d = difference(points[j + 1], points[j]);
    result.push_back({degree * d[0], degree * d[1], degree * d[2]});
  }
  if (result.empty())
    result.push_back({0, 0, 0});
  return result;
}

inline Curve_derivatives bezier_derivatives(const std::vector<Vec3>& points, double s) {
  const std::vector<Vec3> first = hodograph(points);
  return {bezier_point(points, s), bezier_point(first, s), bezier_point(hodograph(first), s)};
}

// What a ribbon prescribes at parameter s of its side: the derivatives by u = s and v = h, at
// h = 0, of the tensor product Bézier surface of which it is the first rows. Those of order k by h
// are 0 where the ribbon does not have k + 1 layers. O(d²).
template <typename Ribbon>
Surface_derivatives ribbon_derivatives(const Ribbon& ribbon, double s) {
  const double m = static_cast<double>(ribbon.cross_degree());
  std::vector<Vec3> value, first, second; // by h, for each column
  for (std::size_t j = 0; j <= ribbon.degree(); ++j) {
    const auto step = [&](std::size_t k) {
      return ribbon.layers() > k + 1
                 ? to_vec3(ribbon.control_point(j, k + 1) - ribbon.control_point(j, k))
                 : Vec3{0, 0, 0};
    };
    const Vec3 a = step(0), b = ribbon.layers() > 2 ? difference(step(1), a) : Vec3{0, 0, 0};
    value.push_back(to_vec3(ribbon.control_point(j, 0) - ORIGIN));
    first.push_back({m * a[0], m * a[1], m * a[2]});
    const double f = m * (m - 1);
    second.push_back({f * b[0], f * b[1], f * b[2]});
  }
  const Curve_derivatives along = bezier_derivatives(value, s);
  const Curve_derivatives across = bezier_derivatives(first, s);
  return {along.value,  along.first,  across.value,
          along.second, across.first, bezier_point(second, s)};
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_ANALYSIS_INTERNAL_RIBBON_DERIVATIVES_H
