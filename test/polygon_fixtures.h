// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_POLYGON_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_POLYGON_FIXTURES_H

#include "fixtures.h"

#include <utility>

// Polygons, with and without holes, that are hard for coordinates in different ways.
namespace fixtures {

using Points = std::vector<Point_2>;
constexpr double pi = MP::internal::pi;

inline Points square() {
  return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
}

inline Points unit_u_shape() {
  return {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
}

inline Points regular_polygon(std::size_t n) {
  Points p;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
    p.emplace_back(std::cos(t), std::sin(t));
  }
  return p;
}

// `tips` corners at distance 1 from the origin, and as many reflex ones at distance 0.4
inline Points star(std::size_t tips = 5) {
  Points p;
  for (std::size_t i = 0; i < 2 * tips; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.4, t = pi * static_cast<double>(i) / double(tips);
    p.emplace_back(r * std::cos(t), r * std::sin(t));
  }
  return p;
}

// Teeth of width 1 and length 2 on a back of width 1, with gaps of width 1: 4 sides a tooth.
inline Points comb(std::size_t teeth = 4) {
  Points p{{0, 0}, {2. * double(teeth) - 1, 0}};
  for (std::size_t i = teeth; i-- > 0;) {
    const double x = 2. * static_cast<double>(i);
    p.emplace_back(x + 1, 3);
    p.emplace_back(x, 3);
    if (i > 0) {
      p.emplace_back(x, 1);
      p.emplace_back(x - 1, 1);
    }
  }
  return p;
}

// A band of width 0.5 that winds around the origin, 8 sides a turn on either side.
inline Points spiral(std::size_t corners = 12) {
  Points outer, inner;
  for (std::size_t i = 0; i < corners; ++i) {
    const double t = pi * static_cast<double>(i) / 4, r = 1 + t / (2 * pi);
    outer.emplace_back((r + 0.25) * std::cos(t), (r + 0.25) * std::sin(t));
    inner.emplace_back((r - 0.25) * std::cos(t), (r - 0.25) * std::sin(t));
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

// a cut of width 0.002 from the outside
inline Points slotted() {
  return {{0, 0}, {2, 0}, {2, 1}, {1.001, 1}, {1.001, 0.2}, {0.999, 0.2}, {0.999, 1}, {0, 1}};
}

// two rooms that a corridor of the given width joins
inline Points dumbbell(double width) {
  return {{0, 0}, {2, 0}, {2, 1}, {1.5, 1}, {1.5, width}, {0.5, width}, {0.5, 1}, {0, 1}};
}

// a spike of about 0.2 degrees
inline Points spiked() {
  return {{0, 0}, {2, 0}, {2, 1}, {1.05, 1}, {1, 30}, {0.95, 1}, {0, 1}};
}

inline Points with_straight_corners() {
  return {{0, 0}, {0.7, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 1.5}, {1, 2}, {0, 2}, {0, 0.5}};
}

// corners within 1e-3 and 1e-9 radians of straight, on either side
inline Points with_nearly_straight_corners() {
  return {{0, 0}, {1, 1e-3}, {2, 0}, {2, 1}, {1.5, 1 + 1e-9}, {1, 1}, {0.5, 1.001}, {0, 1}};
}

inline Domain square_with_square_hole() {
  return Domain({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}});
}

inline Domain square_with_two_holes() {
  return Domain(
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}},
      {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {{2.5, 2.5}, {2.5, 3.5}, {3.5, 3.5}, {3.5, 2.5}}});
}

inline Domain square_with_triangular_hole() {
  return Domain({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{{1, 1}, {1.4, 2.2}, {2.5, 1.3}}});
}

// domains with all sides parallel to the axes
inline std::vector<Domain> rectilinear_domains() {
  return {Domain(square()),
          Domain(l_shape()),
          Domain(unit_u_shape()),
          Domain(slotted()),
          Domain(dumbbell(1e-2)),
          Domain(dumbbell(1e-6)),
          square_with_square_hole(),
          square_with_two_holes(),
          Domain(comb()),
          Domain(with_straight_corners())};
}

inline std::vector<Domain> all_domains() {
  std::vector<Domain> domains = rectilinear_domains();
  for (const Points& p :
       {Points{{0, 0}, {1, 0}, {0.3, 0.8}}, regular_polygon(5), regular_polygon(16), star(),
        spiral(), spiked(), with_nearly_straight_corners()})
    domains.emplace_back(p);
  domains.push_back(square_with_triangular_hole());
  return domains;
}

// A simple polygon through random points of the unit square: crossings are undone one by one
// ("2-opt"), which leaves spikes and sides that nearly touch.
inline Points random_polygon(Random& random, std::size_t n) {
  Points p;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random.in(0, 1), y = random.in(0, 1);
    p.emplace_back(x, y);
  }
  const auto uncross = [&] {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 2; j < n; ++j)
        if ((j + 1) % n != i && CGAL::do_intersect(Kernel::Segment_2(p[i], p[i + 1]),
                                                   Kernel::Segment_2(p[j], p[(j + 1) % n]))) {
          std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       p.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          return true;
        }
    return false;
  };
  while (uncross()) {
  }
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point_2 &a = p[i], &b = p[(i + 1) % n];
    area += a.x() * b.y() - a.y() * b.x();
  }
  if (area < 0)
    std::reverse(p.begin(), p.end());
  return p;
}

inline double distance_to_boundary(const Domain& domain, const Point_2& p) {
  double squared = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < domain.size(); ++k)
    squared = (std::min)(squared, CGAL::squared_distance(p, domain.side(k)));
  return std::sqrt(squared);
}

inline Points random_points_inside(const Domain& domain, std::size_t count, unsigned seed = 1) {
  Random random(seed);
  const CGAL::Bbox_2 box = domain.bbox();
  Points points;
  while (points.size() < count) {
    const double x = random.in(box.xmin(), box.xmax()), y = random.in(box.ymin(), box.ymax());
    if (domain.locate({x, y}).kind == Domain::Location::Kind::interior)
      points.emplace_back(x, y);
  }
  return points;
}

// A random polygon with up to `holes` triangular or quadrangular holes, where there is room.
inline Domain random_domain(Random& random, std::size_t n, std::size_t holes) {
  const Points outer = random_polygon(random, n);
  std::vector<Points> loops;
  for (std::size_t k = 0; k < holes; ++k) {
    const Domain domain(outer, loops);
    const Point_2 centre =
        random_points_inside(domain, 1, static_cast<unsigned>(random.integer(1, 1000000000)))[0];
    const double radius = random.in(0.3, 0.95) * distance_to_boundary(domain, centre);
    const std::size_t m = random.integer(3, 4);
    const double turn = random.in(0, 2 * pi);
    Points hole;
    for (std::size_t i = 0; i < m; ++i) {
      const double t = turn - 2 * pi * (double(i) + random.in(0, 0.5)) / double(m);
      hole.emplace_back(centre.x() + radius * std::cos(t), centre.y() + radius * std::sin(t));
    }
    if (radius > 1e-3)
      loops.push_back(hole);
  }
  return Domain(outer, loops);
}

} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_POLYGON_FIXTURES_H
