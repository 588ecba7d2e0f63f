// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_FIXTURES_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <string>
#include <vector>

// What several tests build their inputs from. All randomness comes from a seed that the test
// prints.
namespace fixtures {

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Ribbon = MP::Bezier_ribbon_3<Kernel>;
using Loop = MP::Ribbon_loop_3<Kernel>;
using Domain = MP::Polygonal_domain_2<Kernel>;

class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  std::size_t integer(std::size_t low, std::size_t high) {
    return std::uniform_int_distribution<std::size_t>(low, high)(engine_);
  }

private:
  std::mt19937 engine_;
};

// A simple polygon that is star-shaped around the origin: sorted directions, random radii.
inline std::vector<Point_2> star_shaped_polygon(Random& random, std::size_t n, double smallest) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < n; ++i)
    angles.push_back((static_cast<double>(i) + random.in(0.1, 0.9)) * 2 * MP::internal::pi /
                     static_cast<double>(n));
  std::vector<Point_2> polygon;
  for (const double angle : angles) {
    const double radius = random.in(smallest, 1);
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

inline std::vector<Point_2> convex_polygon(Random& random, std::size_t n) {
  return star_shaped_polygon(random, n, 1);
}

inline std::vector<Point_2> l_shape() {
  return {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
}

// Mirror symmetric in u: vertex i is the image of vertex 7 - i.
inline std::vector<Point_2> u_shape() {
  return {{-0.5, 1}, {-0.5, 2}, {-2, 2}, {-2, 0}, {2, 0}, {2, 2}, {0.5, 2}, {0.5, 1}};
}

// A point inside the domain, by rejection, that keeps some distance from the boundary.
inline Point_2 interior_point(Random& random, const Domain& domain) {
  const CGAL::Bbox_2 box = domain.bbox();
  for (;;) {
    const Point_2 p(random.in(box.xmin(), box.xmax()), random.in(box.ymin(), box.ymax()));
    bool close = domain.locate(p).kind != Domain::Location::Kind::interior;
    for (std::size_t i = 0; !close && i < domain.size(); ++i)
      close = CGAL::squared_distance(p, domain.side(i)) < 1e-6;
    if (!close)
      return p;
  }
}

/*
 * A loop over a polygon, lifted by a height function: cubic ribbons with 2 layers whose plans are
 * the sides of the polygon, and whose second rows lie along the adjacent sides (continued into the
 * polygon at reflex corners), `depth` of the way.
 */
inline Loop lifted_loop(const std::vector<Point_2>& polygon,
                        const std::function<double(double, double)>& height, double depth = 0.3) {
  const std::size_t n = polygon.size();
  const auto lift = [&](const Point_2& p) { return Point_3(p.x(), p.y(), height(p.x(), p.y())); };
  std::vector<Ribbon> ribbons;
  for (std::size_t i = 0; i < n; ++i) {
    const Point_2 &before = polygon[(i + n - 1) % n], &a = polygon[i], &b = polygon[(i + 1) % n],
                  &after = polygon[(i + 2) % n];
    const auto inwards = [](const Point_2& p, const Point_2& q, const Point_2& r, bool at_start) {
      // At the middle corner q of p, q, r: along the other side, or away from it at a reflex
      // corner.
      const bool reflex = CGAL::orientation(p, q, r) == CGAL::RIGHT_TURN;
      const Kernel::Vector_2 along = at_start ? p - q : r - q;
      return reflex ? -along : along;
    };
    const Kernel::Vector_2 first = inwards(before, a, b, true), last = inwards(a, b, after, false);
    std::vector<Point_3> points;
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 4; ++j) {
        const double s = j / 3.0;
        points.push_back(lift(a + s * (b - a) + k * depth * ((1 - s) * first + s * last)));
      }
    ribbons.emplace_back(3, 2, points);
  }
  return Loop(std::move(ribbons));
}

// A wild but closed loop: degrees 1..5, 1..3 layers, curves that wave in all directions.
inline Loop random_loop(Random& random, std::size_t n, double waviness) {
  const std::vector<Point_2> plan = star_shaped_polygon(random, n, 0.15);
  const auto jitter = [&](double size) {
    return Vector_3(random.in(-size, size), random.in(-size, size), random.in(-size, size));
  };
  std::vector<Point_3> corners;
  for (const Point_2& p : plan)
    corners.push_back(Point_3(p.x(), p.y(), 0) + jitter(waviness));
  std::vector<Ribbon> ribbons;
  for (std::size_t i = 0; i < n; ++i) {
    const Point_3 &a = corners[i], &b = corners[(i + 1) % n];
    const std::size_t degree = random.integer(1, 5), layers = random.integer(1, 3);
    std::vector<Point_3> points;
    for (std::size_t k = 0; k < layers; ++k)
      for (std::size_t j = 0; j <= degree; ++j) {
        const double s = static_cast<double>(j) / static_cast<double>(degree);
        const bool corner = k == 0 && (j == 0 || j == degree);
        const Point_3 on_chord = j == degree ? b : a + s * (b - a);
        const Vector_3 inwards = 0.2 * static_cast<double>(k) * (CGAL::ORIGIN - on_chord);
        points.push_back(corner ? on_chord : on_chord + inwards + jitter(waviness / 3));
      }
    ribbons.emplace_back(degree, layers, points);
  }
  return Loop(std::move(ribbons));
}

// The rows of a tensor product Bézier net of odd degree d, seen from the four sides of the square:
// (d + 1) / 2 layers each. `net[a][b]` is the control point of B_a(u) B_b(v).
template <typename Traits>
MP::Ribbon_loop_3<Traits>
tensor_product_loop(const std::vector<std::vector<typename Traits::Point_3>>& net) {
  const std::size_t d = net.size() - 1, layers = (d + 1) / 2;
  std::vector<MP::Bezier_ribbon_3<Traits>> ribbons;
  for (int side = 0; side < 4; ++side) {
    std::vector<typename Traits::Point_3> points;
    for (std::size_t k = 0; k < layers; ++k)
      for (std::size_t j = 0; j <= d; ++j)
        points.push_back(side == 0   ? net[j][k]
                         : side == 1 ? net[d - k][j]
                         : side == 2 ? net[d - j][d - k]
                                     : net[k][d - j]);
    ribbons.emplace_back(d, layers, points);
  }
  return MP::Ribbon_loop_3<Traits>(std::move(ribbons));
}

} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_FIXTURES_H
