// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_RANDOM_PLANS_H
#define MULTISIDED_PATCHES_TEST_FUZZ_RANDOM_PLANS_H

#include "../polygon_fixtures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>

// Random polygons, from harmless ones to such as nobody would draw.
namespace fuzz {

using namespace fixtures;

// The generator of one case. Neighbouring seeds and indices give unrelated sequences.
inline Random random_of_case(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t z = seed * 0x9e3779b97f4a7c15u + index; // splitmix64
  for (int k = 0; k < 2; ++k) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
  }
  return Random(static_cast<unsigned>(z ^ (z >> 32)));
}

inline bool chance(Random& random, double probability) {
  return random.in(0, 1) < probability;
}
inline double power_of_ten(Random& random, double low, double high) {
  return std::pow(10, random.in(low, high));
}
template <typename Container>
const auto& pick(Random& random, const Container& choices) {
  return *std::next(std::begin(choices),
                    static_cast<std::ptrdiff_t>(random.integer(0, std::size(choices) - 1)));
}

// Teeth and slots of random widths, slots down to 1e-6: 4 sides a tooth.
inline Points random_comb(Random& random, std::size_t teeth) {
  Points top;
  double x = 0;
  for (std::size_t k = 0; k < teeth; ++k) {
    const double height = random.in(1, 3), width = power_of_ten(random, -1, 0.3);
    top.insert(top.end(), {{x, height}, {x + width, height}});
    x += width;
    if (k + 1 < teeth) {
      const double bottom = random.in(0, 0.9), slot = power_of_ten(random, -6, 0);
      top.insert(top.end(), {{x, bottom}, {x + slot, bottom}});
      x += slot;
    }
  }
  Points p{{0, -random.in(0.01, 1)}, {x, -random.in(0.01, 1)}};
  p.insert(p.end(), top.rbegin(), top.rend());
  return p;
}

inline Points random_spiral(Random& random, std::size_t corners) {
  Points outer, inner;
  const double half_width = power_of_ten(random, -3, -0.55);
  for (std::size_t i = 0; i < corners; ++i) {
    const double t = pi * static_cast<double>(i) / 4, r = 1 + t / (2 * pi);
    outer.emplace_back((r + half_width) * std::cos(t), (r + half_width) * std::sin(t));
    inner.emplace_back((r - half_width) * std::cos(t), (r - half_width) * std::sin(t));
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

// A convex polygon with a spike on a side, outwards or inwards, of 2 degrees down to 1e-5.
inline Points random_spiked(Random& random, std::size_t n) {
  Points p = convex_polygon(random, n - 3);
  const std::size_t i = random.integer(0, n - 4);
  const Point_2 a = p[i], b = p[(i + 1) % p.size()], m = CGAL::midpoint(a, b);
  const Kernel::Vector_2 side = b - a, out(side.y(), -side.x());
  const double height = chance(random, 0.5) ? random.in(0.3, 30) : -random.in(0.01, 1);
  const double half_width = std::abs(height) * power_of_ten(random, -7, -1.8);
  const Points spike{m - half_width * side, m + height * out, m + half_width * side};
  p.insert(p.begin() + static_cast<std::ptrdiff_t>(i) + 1, spike.begin(), spike.end());
  return p;
}

// A convex polygon with corners on its sides that are straight but for 1e-3 to 1e-12.
inline Points random_nearly_straight(Random& random, std::size_t n) {
  Points p = convex_polygon(random, (std::max)(std::size_t(3), n / 2));
  while (p.size() < n) {
    const std::size_t i = random.integer(0, p.size() - 1);
    const Point_2 a = p[i], b = p[(i + 1) % p.size()];
    const Kernel::Vector_2 side = b - a, out(side.y(), -side.x());
    const double bump = power_of_ten(random, -12, -3) * (chance(random, 0.5) ? 1 : -1);
    p.insert(p.begin() + static_cast<std::ptrdiff_t>(i) + 1,
             a + random.in(0.1, 0.9) * side + bump * out);
  }
  return p;
}

// A polygon whose corners are cut off, with sides down to 1e-7.
inline Points random_uneven(Random& random, std::size_t n) {
  const Points p = star_shaped_polygon(random, (std::max)(std::size_t(3), n / 2), 0.3);
  Points cut;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double size = power_of_ten(random, -7, -1);
    const Point_2 &before = p[(i + p.size() - 1) % p.size()], &after = p[(i + 1) % p.size()];
    if (chance(random, 0.3))
      cut.push_back(p[i]);
    else
      cut.insert(cut.end(), {p[i] + size * (before - p[i]), p[i] + size * (after - p[i])});
  }
  return cut;
}

struct Plan {
  const char* name;
  Points points;
};

// Convex, or star-shaped around a point that all sides keep away from.
inline Plan harmless_plan(Random& random) {
  const std::size_t n = random.integer(3, 12);
  if (chance(random, 0.6))
    return {"convex", convex_polygon(random, n)};
  return {"star-shaped", star_shaped_polygon(random, n, random.in(0.4, 0.9))};
}

inline Plan random_plan(Random& random) {
  const double u = random.in(0, 1);
  const std::size_t n = 3 + static_cast<std::size_t>(38 * u * u * u);
  const auto at_least = [&](std::size_t m) { return (std::max)(n, m); };
  switch (random.integer(0, 9)) {
  case 0:
  case 1:
    return {"star-shaped", star_shaped_polygon(random, n, random.in(0.3, 0.9))};
  case 2:
    return {"convex", convex_polygon(random, n)};
  case 3:
    return {"spiky star-shaped", star_shaped_polygon(random, n, 0.02)};
  case 4:
    return {"2-opt", random_polygon(random, n)};
  case 5:
    return {"comb", random_comb(random, (std::max)(std::size_t(1), n / 4))};
  case 6:
    return {"spiral", random_spiral(random, at_least(6) / 2)};
  case 7:
    return {"spiked", random_spiked(random, at_least(6))};
  case 8:
    return {"nearly straight", random_nearly_straight(random, at_least(4))};
  default:
    return {"uneven", random_uneven(random, at_least(6))};
  }
}

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_RANDOM_PLANS_H
