// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_GENERALIZED_BEZIER_NET_3_H
#define CGAL_MULTISIDED_PATCHES_GENERALIZED_BEZIER_NET_3_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/internal/check_finite.h>
#include <CGAL/Multisided_patches/ribbons/Bezier_ribbon_3.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>
#include <CGAL/Multisided_patches/ribbons/internal/degree_change.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The control net of a generalized Bézier patch: n sides of one degree d, with l = ⌊(d + 1) / 2⌋
 * layers of control points around a central one.
 *
 * Side i has the points C^i_{j,k}, j = 0..d along the side and k = 0..l-1 inwards. Those near a
 * corner belong to both sides that meet there: C^i_{j,k} = C^{i+1}_{k,d-j} for j > d - l. So the
 * net has n l (d - l + 1) points and the central one. On four sides it is that of a tensor product
 * patch of degree d by d.
 *
 * Points are stored ring by ring: for each row k, and in it for each side i, the columns j = k to
 * d - k - 1; then the central point.
 *
 * \tparam Traits a CGAL kernel
 */
template <typename Traits>
class Generalized_bezier_net_3 {
public:
  using Geom_traits = Traits;
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Loop = Ribbon_loop_3<Traits>;

  /*!
   * stores a net.
   *
   * \param sides n, from 3 to `max_sides`
   * \param degree d, from 1 to 1000 (120 in `float`)
   * \param control_points n l (d - l + 1) points ring by ring, and the central one at the end
   * (model units)
   *
   * \throws Input_error if the sizes do not fit together or a coordinate is not finite
   */
  Generalized_bezier_net_3(std::size_t sides, std::size_t degree,
                           std::vector<Point_3> control_points)
      : sides_(sides), degree_(degree), control_points_(std::move(control_points)) {
    if (control_points_.size() != number_of_control_points(sides, degree))
      throw Input_error("a control net of " + std::to_string(sides) + " sides and degree " +
                        std::to_string(degree) + " has " +
                        std::to_string(number_of_control_points(sides, degree)) + " points, not " +
                        std::to_string(control_points_.size()));
    internal::check_finite(control_points_, "the net");
  }

  //! The largest number of sides.
  static constexpr std::size_t max_sides = 1000000;

  //! the number of points that such a net has, the central one included. \throws Input_error if
  //! there are no such nets
  static std::size_t number_of_control_points(std::size_t sides, std::size_t degree) {
    if (sides < 3 || sides > max_sides || degree < 1)
      throw Input_error("a control net needs from 3 to " + std::to_string(max_sides) +
                        " sides and degree 1 or more, not " + std::to_string(sides) +
                        " sides and degree " + std::to_string(degree));
    constexpr std::size_t max_degree = internal::max_bernstein_degree<FT>();
    if (degree > max_degree)
      throw Input_error("a control net of degree " + std::to_string(degree) +
                        " is beyond the largest degree, " + std::to_string(max_degree));
    const std::size_t layers = (degree + 1) / 2;
    return sides * layers * (degree - layers + 1) + 1;
  }

  //! the number n of sides
  std::size_t size() const { return sides_; }
  std::size_t degree() const { return degree_; }
  //! the number l = ⌊(d + 1) / 2⌋ of rows of control points
  std::size_t layers() const { return (degree_ + 1) / 2; }
  std::size_t next(std::size_t i) const { return i + 1 == sides_ ? 0 : i + 1; }
  std::size_t prev(std::size_t i) const { return i == 0 ? sides_ - 1 : i - 1; }

  //! the index of C^i_{j,k} in `control_points()`
  std::size_t index(std::size_t i, std::size_t j, std::size_t k) const {
    CGAL_precondition(i < sides_ && j <= degree_ && k < layers());
    if (j < k) // a point of the side before, of an outer ring
      return index_in_ring(prev(i), degree_ - k, j);
    if (j >= degree_ - k)
      return index_in_ring(next(i), k, degree_ - j);
    return index_in_ring(i, j, k);
  }
  std::size_t central_index() const { return control_points_.size() - 1; }

  //! C^i_{j,k}: side `i`, column `j` along it, row `k` inwards
  const Point_3& control_point(std::size_t i, std::size_t j, std::size_t k) const {
    return control_points_[index(i, j, k)];
  }
  const Point_3& central_point() const { return control_points_.back(); }
  //! all control points, ring by ring, the central one last
  const std::vector<Point_3>& control_points() const { return control_points_; }

  //! the same net with other points. \throws Input_error as the constructor
  Generalized_bezier_net_3 with_control_points(std::vector<Point_3> control_points) const {
    return Generalized_bezier_net_3(sides_, degree_, std::move(control_points));
  }

  /*!
   * the ribbons that the patch of this net meets. A ribbon with l layers is of degree 2l - 1 across
   * its side, and the patch is of degree d, which for even d is one more: so inner rows are moved
   * such that the derivatives across the side are the same, up to that of order l - 1.
   *
   * \throws Input_error if they are no loop, because a side is a single point
   */
  Loop loop() const {
    std::vector<Bezier_ribbon_3<Traits>> ribbons;
    for (std::size_t i = 0; i < sides_; ++i) {
      const auto point = [&](std::size_t j, std::size_t k) { return control_point(i, j, k); };
      ribbons.emplace_back(
          degree_, layers(),
          internal::change_cross_degree(degree_ + 1, layers(), point, degree_, 2 * layers() - 1));
    }
    return Loop(std::move(ribbons));
  }

private:
  // pre: k <= j < d - k
  std::size_t index_in_ring(std::size_t i, std::size_t j, std::size_t k) const {
    // The rings before have n (d - 2k') points each.
    return sides_ * k * (degree_ - k + 1) + i * (degree_ - 2 * k) + j - k;
  }

  std::size_t sides_, degree_;
  std::vector<Point_3> control_points_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_GENERALIZED_BEZIER_NET_3_H
