// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DEVIATION_METER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DEVIATION_METER_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/internal/Sampled_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Measures how far the triangles of a mesh are from the surface that they stand for, at samples
// inside them: distances all over the triangle, and angles between normals next to the corners,
// too, where they are largest on a smooth surface.
//
// The distance of a sample is that from its triangle or, if that is too large, from the nearest of
// its neighbours, too: where the parameters run unevenly, a point of the surface often lies over
// the triangle next to the one whose parameters it has.
template <typename Surface>
class Deviation_meter {
public:
  // The bounds are in units of the surface and degrees; infinite where they do not matter. Because
  // deviations between the samples are a little larger than at them, a fraction of the bounds, the
  // reserve, is aimed at.
  Deviation_meter(const Surface& surface, double max_chordal_deviation, double max_normal_deviation,
                  double reserve)
      : surface_(surface), max_chordal_deviation_(max_chordal_deviation),
        max_normal_deviation_(max_normal_deviation * pi / 180), reserve_(reserve) {}

  struct Deviation {
    double chordal = 0, normal = 0; // units of the surface, radians
  };

  // How much is measured: for an estimate, or to tell whether a triangle is within the bounds.
  enum class Effort { estimate, verification };

  // Of one of the triangles of the mesh.
  Deviation operator()(const Sampled_mesh& mesh, const Linked_triangle& t,
                       Effort effort = Effort::verification) const {
    Deviation deviation;
    if (std::isfinite(max_chordal_deviation_))
      deviation.chordal = chordal_deviation(mesh, t, effort);
    if (std::isfinite(max_normal_deviation_))
      deviation.normal = normal_deviation(mesh, t, effort);
    return deviation;
  }

  // By which factor edges are too long for these deviations: of a smooth surface, the distance from
  // it goes with the square of their length, and the angle with the length. Up to 1 is within the
  // bounds, less the reserve.
  double excess(const Deviation& deviation) const {
    return (std::max)(std::sqrt(deviation.chordal / (reserve_ * max_chordal_deviation_)),
                      deviation.normal / (reserve_ * max_normal_deviation_));
  }

private:
  using Kernel = Simple_cartesian<double>;

  // The barycentric coordinate of samples for one of the corners; the others are equal.
  static constexpr double centroid = 1. / 3, towards_corner = 2. / 3, towards_edge = 1. / 6,
                          near_corner = 0.94, at_edge = 0.02;

  static Uv sample(const Sampled_mesh& mesh, const Linked_triangle& t, int corner, double weight) {
    const auto p = [&](int i) { return mesh.uv[t.vertices[(corner + i) % 3]]; };
    return weight * p(0) + (1 - weight) / 2 * (p(1) + p(2));
  }

  double chordal_deviation(const Sampled_mesh& mesh, const Linked_triangle& t,
                           Effort effort) const {
    double deviation = 0;
    const auto measure = [&](double weight) {
      for (int i = 0; i < (weight == centroid ? 1 : 3); ++i)
        raise(deviation, distance(mesh, t, sample(mesh, t, i, weight)));
    };
    measure(towards_corner);
    if (effort == Effort::estimate)
      return deviation;
    measure(centroid);
    measure(at_edge);
    // By how much it may be larger between the samples.
    constexpr double gap = 1.25;
    if (gap * deviation > reserve_ * max_chordal_deviation_)
      measure(towards_edge);
    return deviation;
  }

  double normal_deviation(const Sampled_mesh& mesh, const Linked_triangle& t, Effort effort) const {
    const auto p = [&](int i) -> const Vec3& { return mesh.positions[t.vertices[i]]; };
    const Vec3 normal = normalized(cross(difference(p(1), p(0)), difference(p(2), p(0))));
    // A triangle without a normal has none that fits.
    if (normal == Vec3{0, 0, 0})
      return pi;
    double deviation = 0;
    const auto measure = [&](int corner, double weight) {
      const Vec3 n = surface_.normal(sample(mesh, t, corner, weight));
      if (n != Vec3{0, 0, 0})
        raise(deviation, angle_between(n, normal));
    };
    const bool is_singular = std::any_of(t.vertices.begin(), t.vertices.end(),
                                         [&](std::size_t v) { return mesh.is_singular(v); });
    for (int i = 0; i < 3; ++i)
      measure(i, is_singular ? towards_corner : near_corner);
    if (effort == Effort::estimate)
      return deviation;
    measure(0, centroid);
    for (int i = 0; i < 3; ++i)
      measure(i, at_edge);
    return deviation;
  }

  // A surface that is not finite deviates without end.
  static void raise(double& deviation, double another) {
    if (!(another <= deviation))
      deviation = std::isnan(another) ? std::numeric_limits<double>::infinity() : another;
  }

  static Kernel::Point_3 to_point(const Vec3& p) { return {p[0], p[1], p[2]}; }

  static double squared_distance(const Kernel::Point_3& p, const Sampled_mesh& mesh,
                                 const Linked_triangle& t) {
    return CGAL::squared_distance(p, Kernel::Triangle_3(to_point(mesh.positions[t.vertices[0]]),
                                                        to_point(mesh.positions[t.vertices[1]]),
                                                        to_point(mesh.positions[t.vertices[2]])));
  }

  double distance(const Sampled_mesh& mesh, const Linked_triangle& t, const Uv& at) const {
    const Kernel::Point_3 p = to_point(surface_.position(at));
    double square = squared_distance(p, mesh, t);
    if (std::sqrt(square) > reserve_ * max_chordal_deviation_)
      for (const std::size_t n : t.neighbors)
        if (n != Linked_triangle::none)
          square = (std::min)(square, squared_distance(p, mesh, mesh.triangles[n]));
    return std::sqrt(square);
  }

  const Surface& surface_;
  double max_chordal_deviation_, max_normal_deviation_, reserve_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DEVIATION_METER_H
