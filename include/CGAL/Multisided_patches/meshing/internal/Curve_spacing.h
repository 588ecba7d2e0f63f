// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CURVE_SPACING_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CURVE_SPACING_H

#include <CGAL/Multisided_patches/meshing/internal/Canonical_curve.h>
#include <CGAL/Multisided_patches/meshing/internal/Curve_table.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// What segments must keep to, in the units of a `Canonical_curve`; infinity where there is no
// bound.
struct Segment_bounds {
  double length, deviation, turn; // turn: radians
};

/*
 * How long the segments of a polyline should be along a curve: a function of its length, linear
 * between the nodes of a table and not too steep, so that neighbouring segments are about equally
 * long. Its inverse, integrated along the curve, counts the segments.
 */
class Curve_spacing {
public:
  Curve_spacing(const Canonical_curve& curve, const Curve_table& table,
                const Segment_bounds& bounds)
      : curve_(curve), table_(table), bounds_(bounds) {
    for (std::size_t k = 0; k < table.size(); ++k)
      spacing_.push_back(wanted(table.curvature(k)));
    grade();
  }

  // The number of segments, as a real number; infinity if it is too large for one.
  double count() const { return counts_.back(); }

  // The parameters at which the curve is cut into `m` segments, strictly inside (0,1). Parameters
  // that rounding makes equal are taken once.
  std::vector<double> divide(std::size_t m) const {
    std::vector<double> samples;
    std::size_t cell = 0;
    for (std::size_t k = 1; k < m; ++k) {
      const double target = count() * (static_cast<double>(k) / static_cast<double>(m));
      while (cell + 2 < counts_.size() && counts_[cell + 1] <= target)
        ++cell;
      const double share = share_of_length(cell, target - counts_[cell]);
      const double t = with_exact_complement(table_.parameter(cell, share));
      if (t > (samples.empty() ? 0 : samples.back()) && t < 1)
        samples.push_back(t);
    }
    return samples;
  }

  // Makes segments shorter where those between the samples are too far from the curve. Returns the
  // largest distance.
  double shorten(const std::vector<double>& samples) {
    std::vector<double> factors(spacing_.size(), 1);
    double largest = 0, t = 0;
    Vec3 p = curve_(0);
    std::size_t node = 0; // the last one that is not beyond the segment's source
    for (std::size_t k = 0; k <= samples.size(); ++k) {
      const double next_t = k < samples.size() ? samples[k] : 1;
      const Vec3 next_p = curve_(next_t);
      std::size_t end = node;
      while (end + 1 < table_.size() && table_.parameter(end) < next_t)
        ++end;
      const double reached = deviation(t, next_t, p, next_p, node, end);
      largest = (std::max)(largest, reached);
      if (reached > largest_measured * bounds_.deviation)
        for (std::size_t i = node; i <= end; ++i)
          factors[i] = (std::min)(factors[i], shortening(reached));
      t = next_t;
      p = next_p;
      node = table_.parameter(end) > t ? end - 1 : end;
    }
    for (std::size_t i = 0; i < spacing_.size(); ++i)
      spacing_[i] *= factors[i];
    grade();
    return largest;
  }

  // What `shorten()` may return: distances are measured at some points, and others are larger.
  double largest_accepted() const { return largest_measured * bounds_.deviation; }

private:
  // The largest change of the spacing for the length along the curve: a segment is at most
  // exp(0.3) = 1.35 times as long as its neighbour.
  static constexpr double max_gradient = 0.3;
  // Distances are measured at 7 parameters inside of each segment. The largest of an arc is at
  // most 1/16 of its length from one of them, and then that is at least 1 - 4/16² = 0.984 of it.
  static constexpr int checks = 8;
  static constexpr double largest_measured = 0.98;
  // The share of the bound for which spacings are chosen, so that most pass.
  static constexpr double target_deviation = 0.96;
  // In units of the inverse of the length: curves bend at least so much, as straight sides do not
  // tell how the surface bends; and what bends more is a corner, which no number of segments
  // rounds off.
  static constexpr double least_curvature = 1;
  static constexpr double largest_curvature = 1e4;

  double wanted(double curvature) const {
    const double length = table_.length();
    curvature = (std::max)(curvature, least_curvature / length);
    const double deviation = target_deviation * bounds_.deviation;
    // No point of a segment's arc is further away than half the length of the arc.
    const double flat = (std::max)(std::sqrt(8 * deviation / curvature), 2 * deviation);
    const double turn = bounds_.turn / (std::min)(curvature, largest_curvature / length);
    return (std::min)({bounds_.length, flat, turn, length});
  }

  // Limits the gradient by shortening, then counts.
  void grade() {
    const std::size_t n = spacing_.size();
    for (std::size_t k = 1; k < n; ++k)
      spacing_[k] = (std::min)(spacing_[k], spacing_[k - 1] + max_gradient * cell_length(k - 1));
    for (std::size_t k = n - 1; k > 0; --k)
      spacing_[k - 1] =
          (std::min)(spacing_[k - 1], spacing_[k] + max_gradient * cell_length(k - 1));
    counts_.assign(1, 0);
    for (std::size_t k = 0; k + 1 < n; ++k)
      counts_.push_back(counts_.back() + cell_count(k));
  }

  double cell_length(std::size_t k) const { return table_.length(k + 1) - table_.length(k); }

  // The integral of 1/spacing over a cell of length l, where the spacing grows from a to b:
  // l log(b/a) / (b - a).
  double cell_count(std::size_t k) const {
    const double a = spacing_[k], growth = (spacing_[k + 1] - a) / a;
    if (!(a > 0) || !(spacing_[k + 1] > 0))
      return std::numeric_limits<double>::infinity();
    return cell_length(k) / a * (growth == 0 ? 1 : std::log1p(growth) / growth);
  }

  // The inverse: the share of the cell's length that has the given count.
  double share_of_length(std::size_t k, double count) const {
    const double a = spacing_[k], growth = (spacing_[k + 1] - a) / a;
    const double x = count * a / cell_length(k);
    const double share = growth == 0 ? x : std::expm1(growth * x) / growth;
    return (std::min)((std::max)(share, 0.0), 1.0);
  }

  // The distance of the curve between parameters s and t from the segment pq. The nodes inside,
  // which are between `first` and `last`, tell about long segments.
  double deviation(double s, double t, const Vec3& p, const Vec3& q, std::size_t first,
                   std::size_t last) const {
    double largest = 0;
    for (int k = 1; k < checks; ++k) {
      const double x = with_exact_complement(s + (t - s) * k / checks);
      largest = (std::max)(largest, distance_to_segment(curve_(x), p, q));
    }
    for (std::size_t i = first + 1; i < last; ++i)
      largest = (std::max)(largest, distance_to_segment(table_.point(i), p, q));
    return largest;
  }

  // The distance falls with the square of the length, and at least linearly.
  double shortening(double reached) const {
    return (std::min)(0.95,
                      (std::max)(0.5, std::sqrt(target_deviation * bounds_.deviation / reached)));
  }

  const Canonical_curve& curve_;
  const Curve_table& table_;
  Segment_bounds bounds_;
  std::vector<double> spacing_; // at the nodes
  std::vector<double> counts_;  // of segments up to the nodes
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_CURVE_SPACING_H
