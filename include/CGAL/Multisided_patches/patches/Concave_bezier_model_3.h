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

  //! An extra control point at a corner, usually a reflex one, see `Concave_bezier_basis`; at most
  //! one for each corner.
  struct Corner_control_point {
    std::size_t index; //!< that of the side that ends at the corner
    Point_3 point;
  };

  Concave_bezier_model_3(Loop ribbon_loop) : loop(std::move(ribbon_loop)) {}

  Loop loop;
  //! the central control point (model units); if there is none, `default_central_point()` is used,
  //! or `fair_central_point()` by a patch that chooses the weight itself
  std::optional<Point_3> central_point;
  Central_weight central_weight = Central_weight::automatic;
  Domain_options domain;
  //! δ in h_i = (1 - λ_i - λ_{i+1}) (1 - δ λ_{i-1} λ_{i+2}); 0 is the plain side parameter
  double parameter_dilation = 0;
  //! by what the coordinates of reflex corners are multiplied in h_i, see
  //! `compute_side_parameters()`; from 0.001 to 1000
  double reflex_weight = 1;
  std::vector<Corner_control_point> corner_control_points;

  /*!
   * an extra control point for each reflex corner: where the first control points inwards from the
   * corner, of the two ribbons that meet there, span a parallelogram with it (model units). There
   * the ribbons leave a gap between them. Corners at which a ribbon has one layer only get none.
   */
  std::vector<Corner_control_point> default_corner_control_points() const {
    std::vector<Corner_control_point> points;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto &in = loop[i], &out = loop[loop.next(i)];
      if (loop.corner_type(loop.next(i)) == Corner_type::reflex && in.layers() > 1 &&
          out.layers() > 1)
        points.push_back({i, in.control_point(in.degree(), 1) +
                                 (out.control_point(0, 1) - out.control_point(0, 0))});
    }
    return points;
  }

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
