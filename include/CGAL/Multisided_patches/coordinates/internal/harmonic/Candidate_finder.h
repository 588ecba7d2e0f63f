// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CANDIDATE_FINDER_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CANDIDATE_FINDER_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Bisection_mesh.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Boundary.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Channel.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/convergence_radii.h>

#include <map>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

inline double farthest(const Triangle_points& t, const Complex& z) {
  return std::sqrt((std::max)({std::norm(t[0] - z), std::norm(t[1] - z), std::norm(t[2] - z)}));
}

inline double farthest(const std::vector<Triangle_points>& triangles, const Complex& z) {
  double result = 0;
  for (const Triangle_points& t : triangles)
    result = (std::max)(result, farthest(t, z));
  return result;
}

// A cell that could be: its kind and place, and how far it may reach. For a channel the reach is in
// the channel itself.
struct Candidate {
  enum class Kind { corner, channel, interior, side };

  Kind kind;
  std::size_t index; // of the vertex, the channel or the side
  Complex centre;
  double radius; // of convergence
  double reach;  // the largest admissible distance from the centre
};

// Finds for a triangle a cell whose local solutions converge fast enough on it: by the factor tau
// with an affordable number of terms.
//
// The disc of a cell may reach across sides, but the cell does not: its triangles must not touch
// any sides but its own, where its functions have no boundary values, and must lie on this side of
// them. On this side of its own sides no other vertex lies in the disc, so a side that crosses it
// there parts it in two. Triangles that are visible from the centre are on this side of all of
// them, and so are those connected with them by others in the disc.
class Candidate_finder {
public:
  Candidate_finder(const Boundary& boundary, double tau)
      : boundary_(boundary), decay_(std::log(1 / tau)), corners_(boundary.size()) {
    for (std::size_t k = 0; k < boundary.size(); ++k) {
      const double radius = corner_radius(boundary, k);
      const double ratio =
          (std::min)(max_corner_ratio, std::exp(-decay_ * boundary.angle(k) / max_corner_size));
      corners_[k] = {Candidate::Kind::corner, k, boundary.vertex(k), radius, ratio * radius};
    }
  }

  // ln(1 / tau)
  double decay() const { return decay_; }
  const Channel& channel(std::size_t i) const { return channels_[i]; }

  // the best cell for a triangle, if there is any; the more capable kinds first
  std::optional<Candidate> find(const Leaf& leaf) {
    std::optional<Candidate> best = find_corner(leaf);
    if (best)
      return best;
    const std::array<std::size_t, 6> sides = nearest_sides(leaf.corners);
    if ((best = find_channel(leaf.corners, sides)))
      return best;
    if ((best = find_interior(leaf)))
      return best;
    return find_side(leaf, sides);
  }

  // whether a cell may contain a triangle that is visible from its centre or next to one that it
  // may contain
  bool admits(const Candidate& c, const Leaf& leaf) const {
    const Triangle_points& t = leaf.corners;
    switch (c.kind) {
    case Candidate::Kind::corner:
      return farthest(t, c.centre) <= c.reach &&
             touches_only(leaf, c.index, boundary_.prev(c.index)) && in_wedge(c.index, t);
    case Candidate::Kind::channel:
      return in_channel(channels_[c.index], t);
    case Candidate::Kind::side:
      return farthest(t, c.centre) <= c.reach && touches_only(leaf, c.index, c.index) &&
             contains(boundary_.half_plane(c.index), t);
    default:
      return farthest(t, c.centre) <= c.reach && touches_only(leaf, no_side, no_side);
    }
  }

private:
  // A power series may reach this far, relative to its radius of convergence.
  static constexpr double max_ratio = 0.6;
  // The series at a sharp corner converges almost to the end; this only keeps off rounding.
  static constexpr double max_corner_ratio = 1 - 1e-9;
  // The most terms at a corner; they decide how far its cell reaches.
  static constexpr int max_corner_size = 50;

  static constexpr std::size_t no_side = Bisection_mesh::none;

  static bool contains(const Half_plane& h, const Triangle_points& t) {
    return h.contains(t[0]) && h.contains(t[1]) && h.contains(t[2]);
  }

  static bool touches_only(const Leaf& leaf, std::size_t e1, std::size_t e2) {
    return std::all_of(leaf.sides.begin(), leaf.sides.end(),
                       [&](std::size_t s) { return s == no_side || s == e1 || s == e2; });
  }

  // whether no side crosses the segment from a centre, which may lie on sides e1 and e2, to a
  // triangle
  bool is_visible(const Triangle_points& t, const Complex& centre, std::size_t e1,
                  std::size_t e2) const {
    const Segment ray{centre, (t[0] + t[1] + t[2]) / 3.};
    for (std::size_t e = 0; e < boundary_.size(); ++e)
      if (e != e1 && e != e2 && cross_each_other(ray, boundary_.side(e)))
        return false;
    return true;
  }

  bool in_wedge(std::size_t k, const Triangle_points& t) const {
    const Half_plane h = boundary_.half_plane(k), g = boundary_.half_plane(boundary_.prev(k));
    const bool convex = boundary_.angle(k) < 1;
    return std::all_of(t.begin(), t.end(), [&](const Complex& z) {
      return convex ? h.contains(z) && g.contains(z) : h.contains(z) || g.contains(z);
    });
  }

  bool in_channel(const Channel& c, const Triangle_points& t) const {
    if (!contains(boundary_.half_plane(c.e1), t) || !contains(boundary_.half_plane(c.e2), t))
      return false;
    const Interval usable = c.usable();
    for (int i = 0; i < 3; ++i) {
      const Interval range = c.map.range({t[i], t[(i + 1) % 3]});
      if (!(range.low >= usable.low && range.high <= usable.high))
        return false;
    }
    return true;
  }

  // the corner in whose disc the triangle is deepest
  std::optional<Candidate> find_corner(const Leaf& leaf) const {
    std::optional<Candidate> best;
    double best_ratio = 1;
    for (const Candidate& c : corners_) {
      const double ratio = farthest(leaf.corners, c.centre) / c.reach;
      if (ratio <= best_ratio && admits(c, leaf) &&
          is_visible(leaf.corners, c.centre, c.index, boundary_.prev(c.index))) {
        best = c;
        best_ratio = ratio;
      }
    }
    return best;
  }

  std::optional<Candidate> find_channel(const Triangle_points& t,
                                        const std::array<std::size_t, 6>& sides) {
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (std::size_t j = i + 1; j < sides.size(); ++j)
        if (sides[j] < boundary_.size()) {
          for (const std::size_t c : channels_between(sides[i], sides[j]))
            if (in_channel(channels_[c], t))
              return Candidate{Candidate::Kind::channel, c, channels_[c].origin, 0, 0};
        }
    return std::nullopt;
  }

  std::optional<Candidate> find_interior(const Leaf& leaf) const {
    std::optional<Candidate> best;
    if (!touches_only(leaf, no_side, no_side))
      return best;
    const Triangle_points& t = leaf.corners;
    double best_ratio = max_ratio;
    for (const Complex& z :
         {(t[0] + t[1] + t[2]) / 3., (t[0] + t[1]) / 2., (t[1] + t[2]) / 2., (t[2] + t[0]) / 2.}) {
      const double radius = interior_radius(boundary_, z), ratio = farthest(t, z) / radius;
      if (ratio <= best_ratio) {
        best = Candidate{Candidate::Kind::interior, 0, z, radius, max_ratio * radius};
        best_ratio = ratio;
      }
    }
    return best;
  }

  std::optional<Candidate> find_side(const Leaf& leaf,
                                     const std::array<std::size_t, 6>& sides) const {
    const Triangle_points& t = leaf.corners;
    for (int i = 0; i < 3; ++i) {
      const std::size_t e = sides[i];
      if (!touches_only(leaf, e, e))
        continue;
      const Complex d = boundary_.direction(e), &source = boundary_.vertex(e);
      const double x[3] = {dot(t[0] - source, d), dot(t[1] - source, d), dot(t[2] - source, d)};
      const double middle = (std::min({x[0], x[1], x[2]}) + std::max({x[0], x[1], x[2]})) / 2;
      if (!(0 < middle && middle < boundary_.length(e)))
        continue;
      const Complex centre = source + middle * d;
      const double radius = side_radius(boundary_, e, centre);
      const Candidate c{Candidate::Kind::side, e, centre, radius, max_ratio * radius};
      if (admits(c, leaf) && is_visible(t, centre, e, e))
        return c;
    }
    return std::nullopt;
  }

  // the sides nearest to the triangle's centroid; the number of sides where there are no more
  std::array<std::size_t, 6> nearest_sides(const Triangle_points& t) const {
    std::array<std::size_t, 6> nearest;
    std::array<double, 6> distance;
    nearest.fill(boundary_.size());
    distance.fill(std::numeric_limits<double>::infinity());
    const Complex z = (t[0] + t[1] + t[2]) / 3.;
    for (std::size_t e = 0; e < boundary_.size(); ++e) {
      double d = squared_distance(z, boundary_.side(e));
      std::size_t candidate = e;
      for (std::size_t i = 0; i < nearest.size(); ++i) // insertion
        if (d < distance[i]) {
          std::swap(d, distance[i]);
          std::swap(candidate, nearest[i]);
        }
    }
    return nearest;
  }

  const std::vector<std::size_t>& channels_between(std::size_t e1, std::size_t e2) {
    const auto key = std::minmax(e1, e2);
    const auto found = channels_between_.find(key);
    if (found != channels_between_.end())
      return found->second;
    std::vector<std::size_t>& indices = channels_between_[key];
    if (boundary_.next(e1) == e2 || boundary_.next(e2) == e1)
      return indices;
    for (const Channel& c : channels(boundary_, e1, e2)) {
      indices.push_back(channels_.size());
      channels_.push_back(c);
    }
    return indices;
  }

  const Boundary& boundary_;
  double decay_;
  std::vector<Candidate> corners_;
  std::vector<Channel> channels_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> channels_between_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_CANDIDATE_FINDER_H
