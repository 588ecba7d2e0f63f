// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SHARED_SIDES_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SHARED_SIDES_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

struct Side_id {
  std::size_t patch, side;

  friend bool operator<(const Side_id& a, const Side_id& b) {
    return std::make_pair(a.patch, a.side) < std::make_pair(b.patch, b.side);
  }
  friend bool operator==(const Side_id& a, const Side_id& b) {
    return a.patch == b.patch && a.side == b.side;
  }
};

// A side with points of its curve at evenly spaced parameters, both ends included.
struct Side_outline {
  static constexpr std::size_t intervals = 32;

  Side_id id;
  std::array<Vec3, intervals + 1> points;
};

// Distances are compared without squares, which could overflow or vanish.
inline bool are_within(const Vec3& a, const Vec3& b, double distance) {
  return norm(difference(a, b)) <= distance;
}

inline bool are_same(const Side_outline& a, const Side_outline& b, double tolerance) {
  for (std::size_t k = 0; k <= Side_outline::intervals; ++k)
    if (!are_within(a.points[k], b.points[k], tolerance))
      return false;
  return true;
}

inline bool are_reverse(const Side_outline& a, const Side_outline& b, double tolerance) {
  for (std::size_t k = 0; k <= Side_outline::intervals; ++k)
    if (!are_within(a.points[k], b.points[Side_outline::intervals - k], tolerance))
      return false;
  return true;
}

// The sides of all patches, in order.
template <typename Patch>
std::vector<Side_outline> sample_all_sides(const std::vector<Patch>& patches,
                                           const std::vector<std::string>& names) {
  using FT = typename Patch::Geom_traits::FT;
  std::vector<Side_outline> sides;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const auto& domain = patches[k].domain();
    for (std::size_t i = 0; i < domain.size(); ++i) {
      Side_outline side{{k, i}, {}};
      for (std::size_t j = 0; j <= Side_outline::intervals; ++j) {
        const FT s(static_cast<double>(j) / Side_outline::intervals);
        side.points[j] = to_vec3(
            patches[k].point(domain.point_on_side(i, s), domain.location_on_side(i, s)) - ORIGIN);
        if (!std::isfinite(norm(side.points[j])))
          throw Numerical_error(names[k] + ": a point of side " + std::to_string(i) +
                                " is not finite");
      }
      sides.push_back(side);
    }
  }
  return sides;
}

// Which sides are the same. Pairs have the side that comes first first, and are in its order.
struct Side_matches {
  using Pair = std::pair<Side_id, Side_id>;

  std::vector<Pair> shared;    // sides that run in opposite directions, each in one pair at most
  std::vector<Pair> conflicts; // other sides with the same curve
  std::vector<Pair> alike;     // those of them that run in the same direction

  bool runs_alike(const Side_id& a, const Side_id& b) const {
    return std::find(alike.begin(), alike.end(), Pair(a, b)) != alike.end();
  }
};

inline Side_matches match_sides(const std::vector<Side_outline>& sides, double relative_tolerance) {
  if (sides.empty())
    return {};
  Vec3 low = sides[0].points[0], high = low;
  for (const Side_outline& side : sides)
    for (std::size_t c = 0; c < 3; ++c) {
      low[c] = (std::min)(low[c], side.points[0][c]);
      high[c] = (std::max)(high[c], side.points[0][c]);
    }
  const double tolerance = relative_tolerance * norm(difference(high, low));

  // The midpoint does not depend on the direction, so the same sides are close in its order.
  const auto middle = [&](std::size_t k) {
    return sides[k].points[Side_outline::intervals / 2][0];
  };
  std::vector<std::size_t> order(sides.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::make_pair(middle(a), a) < std::make_pair(middle(b), b);
  });
  std::vector<std::pair<std::size_t, std::size_t>> reverse, same;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1;
         j < order.size() && middle(order[j]) - middle(order[i]) <= tolerance; ++j) {
      const auto pair = std::minmax(order[i], order[j]);
      if (are_reverse(sides[pair.first], sides[pair.second], tolerance))
        reverse.push_back(pair);
      else if (are_same(sides[pair.first], sides[pair.second], tolerance))
        same.push_back(pair);
    }
  std::sort(reverse.begin(), reverse.end());
  std::sort(same.begin(), same.end());

  Side_matches matches;
  std::vector<bool> is_shared(sides.size(), false);
  for (const auto& [a, b] : reverse) {
    const bool free = !is_shared[a] && !is_shared[b];
    (free ? matches.shared : matches.conflicts).emplace_back(sides[a].id, sides[b].id);
    is_shared[a] = is_shared[a] || free;
    is_shared[b] = is_shared[b] || free;
  }
  for (const auto& [a, b] : same) {
    // Of three or more sides with one curve some run alike, which is no news.
    if (is_shared[a] || is_shared[b])
      continue;
    matches.conflicts.emplace_back(sides[a].id, sides[b].id);
    matches.alike.push_back(matches.conflicts.back());
  }
  return matches;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SHARED_SIDES_H
