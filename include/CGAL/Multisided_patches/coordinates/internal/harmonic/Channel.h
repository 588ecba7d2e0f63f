// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CHANNEL_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CHANNEL_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Strip_map.h>

#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// A stretch between two facing sides that no other side reaches into: free is in units of Re W.
struct Channel {
  std::size_t e1, e2;
  Complex origin; // the point c of Strip_map
  Strip_map map;
  Interval free;

  // The part of the channel on which the series of a cell may be used: what enters at the ends has
  // decayed.
  Interval usable() const {
    const double margin = (std::min)(1., 0.3 * free.length());
    return {free.low + margin, free.high - margin};
  }
};

// A shorter stretch does not pay: ordinary cells cover it with fewer unknowns.
inline constexpr double min_channel_length = 2.5;
// Opposite sides at a greater angle (radians) do not make a channel.
inline constexpr double max_channel_angle = 1.2;

// the map of sides e1, e2 seen from the point `origin` of e1, if they face each other there
inline std::optional<Strip_map> strip_map(const Boundary& boundary, std::size_t e1, std::size_t e2,
                                          const Complex& origin) {
  const Complex d1 = boundary.direction(e1), d2 = boundary.direction(e2);
  const double beta = std::atan2(-cross(d1, d2), -dot(d1, d2));
  if (beta < 0 || beta > max_channel_angle)
    return std::nullopt;
  const double height = boundary.half_plane(e2).signed_distance(origin) / std::cos(beta);
  if (!(height > 0))
    return std::nullopt;
  return Strip_map(origin, d1, height, beta);
}

// takes `blocked` off the intervals
inline void subtract(std::vector<Interval>& free, const Interval& blocked) {
  std::vector<Interval> rest;
  for (const Interval& i : free) {
    if (i.low < blocked.low)
      rest.push_back({i.low, (std::min)(i.high, blocked.low)});
    if (i.high > blocked.high)
      rest.push_back({(std::max)(i.low, blocked.high), i.high});
  }
  free = std::move(rest);
}

// the stretches, in units of Re W, between e1 and e2 that no other side reaches into
inline std::vector<Interval> free_intervals(const Boundary& boundary, std::size_t e1,
                                            std::size_t e2, const Strip_map& map) {
  const Half_plane h1 = boundary.half_plane(e1), h2 = boundary.half_plane(e2);
  const std::optional<Segment> s1 = clip(boundary.side(e1), h2), s2 = clip(boundary.side(e2), h1);
  if (!s1 || !s2)
    return {};
  const Interval r1 = map.range(*s1), r2 = map.range(*s2);
  std::vector<Interval> free{{(std::max)(r1.low, r2.low), (std::min)(r1.high, r2.high)}};
  if (!(free[0].length() >= min_channel_length))
    return {};
  for (std::size_t e = 0; e < boundary.size() && !free.empty(); ++e) {
    if (e == e1 || e == e2)
      continue;
    std::optional<Segment> s = clip(boundary.side(e), h1);
    if (s && (s = clip(*s, h2)))
      subtract(free, map.range(*s));
  }
  return free;
}

// all channels between two sides that share no vertex, in either order
inline std::vector<Channel> channels(const Boundary& boundary, std::size_t e1, std::size_t e2) {
  if (cross(boundary.direction(e1), boundary.direction(e2)) > 0)
    std::swap(e1, e2); // now e2 rises from e1
  std::vector<Channel> result;
  // The end of e1 is where e2 is highest.
  const Complex end = boundary.vertex(boundary.next(e1));
  const std::optional<Strip_map> map = strip_map(boundary, e1, e2, end);
  if (!map)
    return result;
  for (const Interval& free : free_intervals(boundary, e1, e2, *map)) {
    if (!(free.length() >= min_channel_length))
      continue;
    const double middle = map->abscissa((free.low + free.high) / 2);
    const Complex origin = end + middle * boundary.direction(e1);
    const std::optional<Strip_map> local = strip_map(boundary, e1, e2, origin);
    if (!local)
      continue;
    // Where the gap is as thin as rounding, both maps know its height only to a few digits, and so
    // differ in W where it is large, but agree on abscissas.
    const auto image = [&](double s) {
      return local->image(Complex(map->abscissa(s) - middle)).real();
    };
    result.push_back({e1, e2, origin, *local, {image(free.low), image(free.high)}});
  }
  return result;
}

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CHANNEL_H
