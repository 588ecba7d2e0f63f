// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MAKE_SIMILARITY_DOMAIN_H
#define CGAL_MULTISIDED_PATCHES_MAKE_SIMILARITY_DOMAIN_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/domains/internal/polygon_shape.h>
#include <CGAL/Multisided_patches/domains/make_regular_domain.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! What is scaled so that the interior angles of a loop sum to (n - 2)π, as those of a polygon do.
enum class Angle_scaling {
  inner_angles,  //!< the interior angle of every corner
  smaller_angles //!< the interior angle of convex corners and the outer angle of reflex ones
};

namespace internal {

// Angles closer to 0 or 2π than this are drawn with it: a cusp cannot be a corner of a polygon.
inline constexpr double smallest_angle = pi / 36;

template <typename Traits>
std::vector<double> scaled_angles(const Ribbon_loop_3<Traits>& loop, Angle_scaling scaling) {
  std::vector<double> angles;
  double sum = 0, target = pi * static_cast<double>(loop.size() - 2);
  // Seen as the negative of its outer angle, a reflex corner asks for 2π less in the sum.
  const auto offset = [&](std::size_t i) {
    return scaling == Angle_scaling::smaller_angles && loop.corner_type(i) == Corner_type::reflex
               ? 2 * pi
               : 0;
  };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    angles.push_back(std::clamp(loop.corner_angle(i), smallest_angle, 2 * pi - smallest_angle));
    sum += angles[i] - offset(i);
    target -= offset(i);
  }
  const double factor = target / sum;
  if (!(factor > 0) || !std::isfinite(factor))
    throw Input_error("the outer angles of the reflex corners outweigh the angles of the others");
  for (std::size_t i = 0; i < loop.size(); ++i)
    angles[i] = offset(i) + factor * (angles[i] - offset(i));
  return angles;
}

template <typename Traits>
Polygon_shape similar_shape(const Ribbon_loop_3<Traits>& loop, Angle_scaling scaling) {
  Polygon_shape shape{{}, scaled_angles(loop, scaling)};
  for (const auto& ribbon : loop.ribbons())
    shape.lengths.push_back(ribbon.arc_length());
  return shape;
}

// The shape between `from` (t = 0) and `to` (t = 1), lengths taken relative to the perimeter.
inline Polygon_shape blend(const Polygon_shape& from, const Polygon_shape& to, double t) {
  const double from_perimeter = std::accumulate(from.lengths.begin(), from.lengths.end(), 0.0);
  const double to_perimeter = std::accumulate(to.lengths.begin(), to.lengths.end(), 0.0);
  Polygon_shape shape;
  for (std::size_t i = 0; i < from.lengths.size(); ++i) {
    shape.lengths.push_back((1 - t) * from.lengths[i] / from_perimeter +
                            t * to.lengths[i] / to_perimeter);
    shape.angles.push_back((1 - t) * from.angles[i] + t * to.angles[i]);
  }
  return shape;
}

// The domain of a shape, taken towards the regular domain of the loop by `repair` in [0,1].
template <typename Traits>
Polygonal_domain_2<Traits> repaired_domain(const Ribbon_loop_3<Traits>& loop,
                                           const Polygon_shape& shape, double repair) {
  const Polygon polygon =
      repair > 0 ? draw(blend(shape, shape_of(dented_regular_polygon(loop)), repair)) : draw(shape);
  return Polygonal_domain_2<Traits>(to_unit_box<Traits>(polygon));
}

} // namespace internal

/*!
 * makes a polygon that resembles a loop: its side lengths are the arc lengths of the boundary
 * curves and its interior angles those between the end tangents, scaled to the sum (n - 2)π; the
 * closing error is spread over the vertices in proportion to the length accumulated before them
 * (Salvi and Várady, *Multi-sided Bézier surfaces over concave polygonal domains*, Computers &
 * Graphics 74, 2018).
 *
 * \param loop the ribbons
 * \param scaling how the angles are scaled
 * \param repair a number in [0,1] that takes the shape, its relative lengths and angles, linearly
 * from that of the loop (0) to that of `make_regular_domain()` (1), on the way to which
 * self-intersections and bottlenecks open
 *
 * \return the domain, in the unit square
 * \throws Input_error if the polygon is not simple, or the angles cannot be scaled
 */
template <typename Traits>
Polygonal_domain_2<Traits>
make_similarity_domain(const Ribbon_loop_3<Traits>& loop,
                       Angle_scaling scaling = Angle_scaling::inner_angles, double repair = 0) {
  return internal::repaired_domain(loop, internal::similar_shape(loop, scaling), repair);
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MAKE_SIMILARITY_DOMAIN_H
