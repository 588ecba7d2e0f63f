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
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Measures how far the triangles of a mesh are from the surface that they stand for, at samples
// inside them: near the corners, at the centroid, and next to the middles of the edges.
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

  static constexpr std::size_t all_samples = 7, few_samples = 3;

  // Of one of the triangles of the mesh. Few samples give an estimate.
  Deviation operator()(const Sampled_mesh& mesh, const Linked_triangle& t,
                       std::size_t number_of_samples = all_samples) const {
    const auto p = [&](int i) -> const Vec3& { return mesh.positions[t.vertices[i]]; };
    const Vec3 normal = normalized(cross(difference(p(1), p(0)), difference(p(2), p(0))));
    Deviation deviation;
    for (std::size_t k = 0; k < number_of_samples; ++k) {
      const std::array<double, 3>& b = samples[k];
      const Uv at = b[0] * mesh.uv[t.vertices[0]] + b[1] * mesh.uv[t.vertices[1]] +
                    b[2] * mesh.uv[t.vertices[2]];
      if (std::isfinite(max_chordal_deviation_))
        deviation.chordal = (std::max)(deviation.chordal, distance(mesh, t, at));
      if (std::isfinite(max_normal_deviation_)) {
        const Vec3 n = surface_.normal(at);
        // A triangle without a normal has none that fits.
        const double angle = normal == Vec3{0, 0, 0} ? pi : angle_between(n, normal);
        if (n != Vec3{0, 0, 0} && !(angle <= deviation.normal))
          deviation.normal = angle;
      }
    }
    return deviation;
  }

  bool is_within_bounds(const Deviation& deviation) const {
    return deviation.chordal <= max_chordal_deviation_ && deviation.normal <= max_normal_deviation_;
  }

  // By which factor edges are too long for these deviations: of a smooth surface, the distance from
  // it goes with the square of their length, and the angle with the length. Up to 1 is within the
  // bounds.
  double excess(const Deviation& deviation) const {
    return (std::max)(std::sqrt(deviation.chordal / (reserve_ * max_chordal_deviation_)),
                      deviation.normal / (reserve_ * max_normal_deviation_));
  }

private:
  using Kernel = Simple_cartesian<double>;

  static constexpr std::array<std::array<double, 3>, all_samples> samples{{{2. / 3, 1. / 6, 1. / 6},
                                                                           {1. / 6, 2. / 3, 1. / 6},
                                                                           {1. / 6, 1. / 6, 2. / 3},
                                                                           {1. / 3, 1. / 3, 1. / 3},
                                                                           {0.02, 0.49, 0.49},
                                                                           {0.49, 0.02, 0.49},
                                                                           {0.49, 0.49, 0.02}}};

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
