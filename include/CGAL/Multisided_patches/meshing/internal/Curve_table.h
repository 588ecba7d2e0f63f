// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CURVE_TABLE_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CURVE_TABLE_H

#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/internal/Canonical_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

/*
 * Points of a curve, denser where it bends or where its speed changes, with the lengths of the
 * curve up to them. Parameters are dyadic.
 *
 * Cells of two steps are halved until the two steps are about equally long and about parallel.
 * Where the curve stops (cusps, coincident control points), they never are; cells of a millionth of
 * the length are then short enough.
 *
 * Complexity: some hundreds of points for a plain curve, at most `2 * max_nodes`.
 */
class Curve_table {
public:
  explicit Curve_table(const Canonical_curve& curve) : curve_(curve) {
    for (int k = 0; k <= first_steps; ++k)
      nodes_.push_back(node(static_cast<double>(k) / first_steps));
    for (int level = 0; level < max_levels && nodes_.size() < max_nodes && refine();)
      ++level;
    measure();
    drop_coincident();
    set_slopes();
  }

  // The number of nodes; less than 2, if the curve is a point.
  std::size_t size() const { return nodes_.size(); }
  double length() const { return nodes_.back().length; }
  double length(std::size_t k) const { return nodes_[k].length; }
  double parameter(std::size_t k) const { return nodes_[k].t; }
  const Vec3& point(std::size_t k) const { return nodes_[k].point; }

  // The parameter at the share `u` of the length between nodes k and k + 1: a monotone cubic. Those
  // of Boost have slopes of first order only, at the ends and where the steps change.
  double parameter(std::size_t k, double u) const {
    const Node &a = nodes_[k], &b = nodes_[k + 1];
    const double h = b.length - a.length, v = 1 - u;
    return v * v * (a.t * (1 + 2 * u) + a.slope * h * u) +
           u * u * (b.t * (1 + 2 * v) - b.slope * h * v);
  }

  // The curvature at a node: the turn of the chords for their length, less what may be rounding.
  double curvature(std::size_t k) const {
    if (size() < 3)
      return 0;
    k = (std::min)((std::max)(k, std::size_t(1)), size() - 2);
    const Vec3 u = difference(point(k), point(k - 1)), v = difference(point(k + 1), point(k));
    const double before = norm(u), after = norm(v);
    const double noise = 2 * curve_.rounding() / (std::min)(before, after);
    return (std::max)(0.0, angle_between(u, v) - noise) / ((before + after) / 2);
  }

private:
  static constexpr int first_steps = 128;
  static constexpr int max_levels = 40;
  static constexpr std::size_t max_nodes = 8192;
  // Between the steps of a cell: the difference, relative to the cell, and the angle.
  static constexpr double max_unevenness = 0.02;
  static constexpr double max_angle = 0.1;
  // Cells below this share of the length stay as they are.
  static constexpr double shortest_cell = 1e-6;

  struct Node {
    double t;
    Vec3 point;
    double length, slope; // slope: of t as a function of the length
  };

  Node node(double t) const { return {t, curve_(t), 0, 0}; }
  Node middle(const Node& a, const Node& b) const { return node((a.t + b.t) / 2); }
  double chord(std::size_t i, std::size_t j) const {
    return norm(difference(nodes_[j].point, nodes_[i].point));
  }

  // Cells that rounding would bend by more than a tenth of a turn over the length are too short.
  double shortest_length() const {
    double length = 0;
    for (std::size_t k = 0; k + 1 < nodes_.size(); ++k)
      length += chord(k, k + 1);
    return (std::max)(shortest_cell * length, std::sqrt(10 * curve_.rounding() * length));
  }

  bool is_uneven(std::size_t k, double shortest) const {
    const Vec3 u = difference(nodes_[k + 1].point, nodes_[k].point),
               v = difference(nodes_[k + 2].point, nodes_[k + 1].point);
    const double before = norm(u), after = norm(v);
    return before + after > shortest &&
           (std::abs(before - after) > max_unevenness * (before + after) ||
            angle_between(u, v) > max_angle);
  }

  // Halves the cells that are uneven, and tells whether there were any.
  bool refine() {
    const double shortest = shortest_length();
    std::vector<Node> finer;
    for (std::size_t k = 0; k + 2 < nodes_.size(); k += 2) {
      const Node &a = nodes_[k], &m = nodes_[k + 1], &b = nodes_[k + 2];
      if (is_uneven(k, shortest))
        finer.insert(finer.end(), {a, middle(a, m), m, middle(m, b)});
      else
        finer.insert(finer.end(), {a, m});
    }
    finer.push_back(nodes_.back());
    const bool changed = finer.size() != nodes_.size();
    nodes_ = std::move(finer);
    return changed;
  }

  // The error of a chord falls with the square of the step, so that the two steps of a cell and its
  // chord together give the length to fourth order (Richardson).
  void measure() {
    for (std::size_t k = 0; k + 2 < nodes_.size(); k += 2) {
      const double before = chord(k, k + 1), after = chord(k + 1, k + 2), both = before + after;
      const double correction = both > 0 ? (4 - chord(k, k + 2) / both) / 3 : 1;
      nodes_[k + 1].length = nodes_[k].length + correction * before;
      nodes_[k + 2].length = nodes_[k + 1].length + correction * after;
    }
  }

  // Nodes at which the curve has not moved on would leave the slope undefined.
  void drop_coincident() {
    const Node last = nodes_.back();
    const auto stands = [](const Node& a, const Node& b) { return !(a.length < b.length); };
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end(), stands), nodes_.end());
    if (size() > 1)
      nodes_.back() = last;
  }

  double secant(std::size_t k) const {
    return (parameter(k + 1) - parameter(k)) / (length(k + 1) - length(k));
  }

  // Slopes at most three times the secants leave the cubics monotone (Fritsch and Carlson 1980).
  void set_slopes() {
    const std::size_t last = size() - 1;
    for (std::size_t k = 0; k <= last && last > 0; ++k) {
      const double limit =
          3 * (std::min)(secant(k > 0 ? k - 1 : 0), secant((std::min)(k, last - 1)));
      const double slope = polynomial_slope(k);
      nodes_[k].slope = slope > 0 ? (std::min)(slope, limit) : 0;
    }
  }

  // The slope at node k of the polynomial that interpolates at five nodes, those around k but at
  // the ends: a sum over the secants from k to the others, of fourth order.
  double polynomial_slope(std::size_t k) const {
    const std::size_t nodes = (std::min)(size(), std::size_t(5));
    const std::size_t begin = (std::min)(k < 2 ? 0 : k - 2, size() - nodes), end = begin + nodes;
    double slope = 0;
    for (std::size_t j = begin; j < end; ++j) {
      if (j == k)
        continue;
      double weight = 1;
      for (std::size_t i = begin; i < end; ++i)
        if (i != j && i != k)
          weight *= (length(k) - length(i)) / (length(j) - length(i));
      slope += weight * (parameter(j) - parameter(k)) / (length(j) - length(k));
    }
    return slope;
  }

  const Canonical_curve& curve_;
  std::vector<Node> nodes_; // until they are measured: cells of two steps each
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CURVE_TABLE_H
