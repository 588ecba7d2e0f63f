// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_AT_POINTS_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_AT_POINTS_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_2.h>

#include <boost/container/vector.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// What a metric is at the points of a mesh.
//
// Field is a function that gives the metric at a point; Metric_2 operator()(Uv, std::size_t& hint)
// gets as a hint what it left behind at a point close by, such as the number of a triangle.
template <typename Field>
class Metric_at_points {
public:
  explicit Metric_at_points(const Field& field) : field_(&field) {}

  std::size_t size() const { return metrics_.size(); }
  const Metric_2& operator[](std::size_t k) const { return metrics_[k]; }
  std::size_t hint(std::size_t k) const { return hints_[k]; }
  // A triangle, given by the numbers of its corners.
  template <typename Point_2>
  Metric_triangle triangle(const std::vector<Point_2>& points,
                           const Linked_triangle::Indices& v) const {
    return Metric_triangle({to_uv(points[v[0]]), to_uv(points[v[1]]), to_uv(points[v[2]])},
                           1. / 3 * (metrics_[v[0]] + metrics_[v[1]] + metrics_[v[2]]));
  }

  void reserve(std::size_t n) {
    metrics_.reserve(n);
    hints_.reserve(n);
  }
  void add(const Uv& p, std::size_t hint) {
    metrics_.push_back(scale_ * (*field_)(p, hint));
    hints_.push_back(static_cast<Linked_triangle::Index>(hint));
  }
  // Keeps the first n, or makes room for points that are set later.
  void resize(std::size_t n) {
    metrics_.resize(n, boost::container::default_init);
    hints_.resize(n, boost::container::default_init);
  }
  // Threads may do so at the same time for different k.
  void set(std::size_t k, const Uv& p, std::size_t hint) {
    metrics_[k] = scale_ * (*field_)(p, hint);
    hints_[k] = static_cast<Linked_triangle::Index>(hint);
  }

  // The metric at some of the points, in their order.
  Metric_at_points part(const std::vector<std::size_t>& points) const {
    Metric_at_points result = with_field(*field_);
    for (const std::size_t k : points)
      result.copy(*this, k);
    return result;
  }
  // Adds point k of another one.
  void copy(const Metric_at_points& other, std::size_t k) {
    metrics_.push_back(other.metrics_[k]);
    hints_.push_back(other.hints_[k]);
  }

  const Field& field() const { return *field_; }
  // No points, but the unit of lengths, and another field.
  Metric_at_points with_field(const Field& field) const {
    Metric_at_points result(field);
    result.scale_ = scale_;
    return result;
  }
  // Replaces the field; then the metric has to be set anew at all points.
  void set_field(const Field& field) { field_ = &field; }

  // Multiplies all lengths, also those at points that are added later.
  void scale_lengths(double factor) {
    scale_ *= factor * factor;
    for (Metric_2& m : metrics_)
      m = factor * factor * m;
  }

private:
  const Field* field_;
  double scale_ = 1; // of squared lengths
  boost::container::vector<Metric_2> metrics_;
  boost::container::vector<Linked_triangle::Index> hints_; // where the field was last asked
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_AT_POINTS_H
