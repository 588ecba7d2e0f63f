// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SIDE_SUBDIVISION_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SIDE_SUBDIVISION_H

#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Boundary.h>

#include <algorithm>

namespace CGAL {
namespace Multisided_patches {
namespace internal {
namespace harmonic {

// Places to cut the sides at, before the domain is triangulated: parameters in (0,1), ascending,
// for every side.
//
// The triangulation of the vertices alone joins a side to all vertices across from it. If these are
// many and near, as across the back of a comb, the triangles are slivers along the whole side, and
// refining each of them takes a number of cells that is quadratic in that of the vertices. So a
// side is cut at the feet of vertices that are near, measured by its length.
class Side_subdivision {
public:
  explicit Side_subdivision(const Boundary& boundary)
      : boundary_(boundary), parameters_(boundary.size()) {
    for (std::size_t e = 0; e < boundary.size(); ++e)
      subdivide(e);
  }

  const std::vector<double>& parameters(std::size_t side) const { return parameters_[side]; }

private:
  // On random polygons neither matters; on combs any such numbers do.
  static constexpr double max_distance = 0.125; // of the length of the side
  static constexpr double min_spacing = 0.3;    // between cuts, of the distance
  // Rounding would show in the place of a nearer foot.
  static constexpr double min_distance = 1e-10;

  struct Foot {
    double distance; // from the vertex
    double abscissa; // along the side
    std::size_t vertex;
  };

  // The nearest vertices come first: a foot is of no use next to that of a nearer vertex.
  void subdivide(std::size_t e) {
    std::vector<Foot> feet;
    for (std::size_t k = 0; k < boundary_.size(); ++k) {
      const Complex z = boundary_.vertex(k) - boundary_.vertex(e);
      const double d = cross(boundary_.direction(e), z), x = dot(boundary_.direction(e), z);
      if (min_distance < d && d < max_distance * boundary_.length(e) && 0 < x &&
          x < boundary_.length(e))
        feet.push_back({d, x, k});
    }
    std::sort(feet.begin(), feet.end(),
              [](const Foot& a, const Foot& b) { return a.distance < b.distance; });
    std::vector<double> cuts{0, boundary_.length(e)};
    for (const Foot& foot : feet) {
      const auto next = std::upper_bound(cuts.begin(), cuts.end(), foot.abscissa);
      const double spacing = (std::min)(*next - foot.abscissa, foot.abscissa - *(next - 1));
      if (spacing > min_spacing * foot.distance && is_visible(foot, e))
        cuts.insert(next, foot.abscissa);
    }
    for (std::size_t i = 1; i + 1 < cuts.size(); ++i)
      parameters_[e].push_back(cuts[i] / boundary_.length(e));
  }

  // whether the segment between a vertex and its foot crosses no other side
  bool is_visible(const Foot& foot, std::size_t e) const {
    const Segment ray{boundary_.vertex(foot.vertex),
                      boundary_.vertex(e) + foot.abscissa * boundary_.direction(e)};
    for (std::size_t k = 0; k < boundary_.size(); ++k) {
      if (k == e || k == foot.vertex || boundary_.next(k) == foot.vertex)
        continue;
      if (cross_each_other(ray, boundary_.side(k)))
        return false;
    }
    return true;
  }

  const Boundary& boundary_;
  std::vector<std::vector<double>> parameters_;
};

} // namespace harmonic
} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_HARMONIC_SIDE_SUBDIVISION_H
