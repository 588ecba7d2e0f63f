// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_DOMAINS_INTERNAL_POLYGON_SHAPE_H
#define CGAL_MULTISIDED_PATCHES_DOMAINS_INTERNAL_POLYGON_SHAPE_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A closed polygon that a generator has drawn, not yet known to be valid.
using Vec2 = std::array<double, 2>;
using Polygon = std::vector<Vec2>;

inline double norm(const Vec2& a) {
  return std::hypot(a[0], a[1]);
}
inline Vec2 difference(const Vec2& a, const Vec2& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

// Side lengths and interior angles (radians): what the shape of a polygon is made of.
struct Polygon_shape {
  std::vector<double> lengths; // of side i, from corner i to corner i + 1
  std::vector<double> angles;  // at corner i
};

inline Polygon_shape shape_of(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  Polygon_shape shape;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = difference(polygon[i], polygon[(i + n - 1) % n]);
    const Vec2 out = difference(polygon[(i + 1) % n], polygon[i]);
    const double turn =
        std::atan2(in[0] * out[1] - in[1] * out[0], in[0] * out[0] + in[1] * out[1]);
    shape.lengths.push_back(norm(out));
    shape.angles.push_back(pi - turn);
  }
  return shape;
}

// Draws the polygon of a shape. The end of the last side misses the first vertex in general; this
// closing error is spread over the vertices in proportion to the length accumulated before them.
inline Polygon draw(const Polygon_shape& shape) {
  const std::size_t n = shape.lengths.size();
  Polygon polygon{{0, 0}};
  double direction = 0;
  for (std::size_t i = 0; i < n; ++i) {
    polygon.push_back({polygon[i][0] + shape.lengths[i] * std::cos(direction),
                       polygon[i][1] + shape.lengths[i] * std::sin(direction)});
    direction += pi - shape.angles[(i + 1) % n];
  }
  const Vec2 error = polygon[n];
  polygon.pop_back();
  const double total = std::accumulate(shape.lengths.begin(), shape.lengths.end(), 0.0);
  double accumulated = 0;
  for (std::size_t i = 0; i < n; ++i) {
    polygon[i] =
        difference(polygon[i], {error[0] * accumulated / total, error[1] * accumulated / total});
    accumulated += shape.lengths[i];
  }
  return polygon;
}

// The vertices, moved and scaled so that the bounding box starts at the origin and its larger side
// has length 1.
template <typename Traits>
std::vector<typename Traits::Point_2> to_unit_box(const Polygon& polygon) {
  Vec2 lower = polygon[0], upper = polygon[0];
  for (const Vec2& p : polygon)
    for (std::size_t c = 0; c < 2; ++c) {
      lower[c] = (std::min)(lower[c], p[c]);
      upper[c] = (std::max)(upper[c], p[c]);
    }
  const double size = (std::max)(upper[0] - lower[0], upper[1] - lower[1]);
  if (!(size > 0) || !std::isfinite(size))
    throw Input_error("the domain has no size: all its vertices coincide, or are not finite");
  using FT = typename Traits::FT;
  std::vector<typename Traits::Point_2> points;
  for (const Vec2& p : polygon)
    points.emplace_back(FT((p[0] - lower[0]) / size), FT((p[1] - lower[1]) / size));
  return points;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_DOMAINS_INTERNAL_POLYGON_SHAPE_H
