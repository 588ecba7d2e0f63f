// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_MODEL_3_H
#define CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_MODEL_3_H

#include <CGAL/Multisided_patches/bases/Central_weight.h>
#include <CGAL/Multisided_patches/domains/Domain_options.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <CGAL/centroid.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * All that determines a concave generalized Bézier patch: its ribbons, its central control point
 * and the choices about its domain and weights. This is also what a `.cgb` file holds.
 *
 * A `Ribbon_loop_3` converts to a model with the default choices.
 *
 * \tparam Traits a CGAL kernel
 */
template <typename Traits>
struct Concave_bezier_model_3 {
  using Geom_traits = Traits;
  using Point_3 = typename Traits::Point_3;
  using Loop = Ribbon_loop_3<Traits>;

  //! An extra control point at a corner, as `.cgb` files can give; kept, but not used by the patch.
  struct Corner_control_point {
    std::size_t index; //!< as in the file: the corner where side `index` ends
    Point_3 point;
  };

  Concave_bezier_model_3(Loop ribbon_loop) : loop(std::move(ribbon_loop)) {}

  Loop loop;
  //! the central control point (model units); if there is none, `default_central_point()` is used
  std::optional<Point_3> central_point;
  Central_weight central_weight = Central_weight::none;
  Domain_options domain;
  //! δ in h_i = (1 - λ_i - λ_{i+1}) (1 - δ λ_{i-1} λ_{i+2}); 0 is the plain side parameter
  double parameter_dilation = 0;
  std::vector<Corner_control_point> corner_control_points;

  //! the centroid of the innermost rows of all ribbons (model units)
  Point_3 default_central_point() const {
    std::vector<Point_3> points;
    for (const auto& r : loop.ribbons())
      points.insert(points.end(), r.control_points().end() - (r.degree() + 1),
                    r.control_points().end());
    return centroid(points.begin(), points.end(), Dimension_tag<0>());
  }
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CONCAVE_BEZIER_MODEL_3_H
