// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_BEZIER_RIBBON_3_H
#define CGAL_MULTISIDED_PATCHES_BEZIER_RIBBON_3_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/internal/check_finite.h>
#include <CGAL/Multisided_patches/internal/gauss_legendre.h>
#include <CGAL/Multisided_patches/ribbons/internal/degree_change.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * One side of a patch: a Bézier boundary curve and the rows of control points that lead inwards.
 *
 * A ribbon of degree d with l layers has (d + 1) l control points C_{j,k}; j = 0..d runs along the
 * side, k = 0..l-1 from the boundary inwards. Row 0 is the control polygon of the boundary curve.
 * The ribbon stands for the first l rows of a tensor product Bézier surface of degree d by 2l - 1,
 * so with 2 layers it fixes the tangent planes along the side (G1), with 3 the curvatures (G2).
 *
 * \tparam Traits a CGAL kernel
 */
template <typename Traits>
class Bezier_ribbon_3 {
public:
  using Geom_traits = Traits;
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;

  /*!
   * stores a ribbon.
   *
   * \param degree the degree d along the side, from 1 to 1000 (120 in `float`)
   * \param layers the number l of rows, from 1 to 500 (60 in `float`)
   * \param control_points the (d + 1) l points row by row, row 0 (the boundary) first (model units)
   *
   * \throws Input_error if the sizes do not fit together or a coordinate is not finite
   */
  Bezier_ribbon_3(std::size_t degree, std::size_t layers, std::vector<Point_3> control_points)
      : degree_(degree), layers_(layers), control_points_(std::move(control_points)) {
    if (degree < 1 || layers < 1)
      throw Input_error("a ribbon needs a degree of at least 1 and at least 1 layer, not degree " +
                        std::to_string(degree) + " and " + std::to_string(layers) + " layers");
    constexpr std::size_t max_degree = internal::max_bernstein_degree<FT>();
    if (degree > max_degree || 2 * layers > max_degree)
      throw Input_error("a ribbon of degree " + std::to_string(degree) + " with " +
                        std::to_string(layers) + " layers is beyond the largest degree, " +
                        std::to_string(max_degree) + " along the side and across");
    if (control_points_.empty() || control_points_.size() / layers - 1 != degree ||
        control_points_.size() % layers != 0)
      throw Input_error("a ribbon of degree " + std::to_string(degree) + " with " +
                        std::to_string(layers) +
                        " layers needs (degree + 1) * layers control points, not " +
                        std::to_string(control_points_.size()));
    for (std::size_t i = 0; i < control_points_.size(); ++i)
      if (!internal::has_finite_coordinates(control_points_[i]))
        throw Input_error("control point " + std::to_string(i % (degree + 1)) + " of row " +
                          std::to_string(i / (degree + 1)) + " is not finite");
  }

  //! the degree d along the side
  std::size_t degree() const { return degree_; }
  //! the number l of rows of control points
  std::size_t layers() const { return layers_; }
  //! the degree across the side, 2l - 1
  std::size_t cross_degree() const { return 2 * layers_ - 1; }

  //! C_{j,k}: column `j` along the side, row `k` inwards
  const Point_3& control_point(std::size_t j, std::size_t k) const {
    CGAL_precondition(j <= degree_ && k < layers_);
    return control_points_[k * (degree_ + 1) + j];
  }
  //! all control points, row by row
  const std::vector<Point_3>& control_points() const { return control_points_; }

  //! the same ribbon with C_{j,k} at `p` (model units). \throws Input_error if `p` is not finite
  Bezier_ribbon_3 with_control_point(std::size_t j, std::size_t k, const Point_3& p) const {
    CGAL_precondition(j <= degree_ && k < layers_);
    std::vector<Point_3> points(control_points_);
    points[k * (degree_ + 1) + j] = p;
    return Bezier_ribbon_3(degree_, layers_, std::move(points));
  }

  /*!
   * the boundary curve at `s` in [0,1] (model units). The reversed ribbon gives the same point at
   * 1 - s, bit for bit if 1 - s is exact, so that two patches on one curve agree on it. Complexity:
   * O(d²).
   */
  Point_3 boundary_point(const FT& s) const {
    // A curve that runs back the way it came has one direction only: that of its first half.
    const Sign direction = direction_of_curve();
    if (direction == NEGATIVE || (direction == ZERO && s > FT(1) - s))
      return ORIGIN + combine_row(0, FT(1) - s, [this](std::size_t j) { return degree_ - j; });
    return ORIGIN + combine_row(0, s, [](std::size_t j) { return j; });
  }

  //! the derivative of the boundary curve with respect to s (model units). Complexity: O(d²).
  Vector_3 boundary_derivative(const FT& s) const {
    boost::container::small_vector<FT, 16> b(degree_);
    internal::bernstein_polynomials(degree_ - 1, s, b.data());
    Vector_3 sum(FT(0), FT(0), FT(0));
    for (std::size_t j = 0; j < degree_; ++j)
      sum = sum + b[j] * (control_point(j + 1, 0) - control_point(j, 0));
    return FT(static_cast<int>(degree_)) * sum;
  }

  /*!
   * the derivative across the side, with respect to h at h = 0 (model units); it points inwards.
   * Complexity: O(d²). \pre `layers() >= 2`
   */
  Vector_3 cross_derivative(const FT& s) const {
    CGAL_precondition(layers_ >= 2);
    const auto forwards = [](std::size_t j) { return j; };
    return FT(static_cast<int>(cross_degree())) *
           (combine_row(1, s, forwards) - combine_row(0, s, forwards));
  }

  /*!
   * the length of the boundary curve (model units), by Gauss quadrature on pieces that are halved
   * until the halves agree with the whole to 1e-12 of the length of the control polygon. The
   * reversed ribbon has the same length, bit for bit.
   */
  double arc_length() const {
    if (runs_backwards())
      return reversed().arc_length();
    // The control polygon bounds the length from above and sets the scale of the tolerance.
    double scale = 0;
    for (std::size_t j = 0; j < degree_; ++j)
      scale += length(control_point(j + 1, 0) - control_point(j, 0));
    return scale > 0 ? arc_length(0, 1, gauss(0, 1), 1e-12 * scale, 20) : 0;
  }

  //! the same ribbon with the side run the other way: column j becomes column d - j
  Bezier_ribbon_3 reversed() const {
    std::vector<Point_3> points(control_points_);
    for (auto row = points.begin(); row != points.end(); row += degree_ + 1)
      std::reverse(row, row + degree_ + 1);
    return Bezier_ribbon_3(degree_, layers_, std::move(points));
  }

  /*!
   * the same ribbon with a higher degree along the side: every row is the same curve as before, and
   * so the ribbon the same surface. With inexact arithmetic its control points are rounded; the
   * reversed ribbon then gives the same ones, bit for bit, but points of the elevated and the
   * original curve may differ in their last bits.
   *
   * Complexity: the number of degrees raised times that of control points. \pre `degree >=
   * degree()`
   */
  Bezier_ribbon_3 elevated(std::size_t degree) const {
    CGAL_precondition(degree >= degree_);
    if (runs_backwards())
      return reversed().elevated(degree).reversed();
    return with_rows(degree, [&](std::vector<Point_3>& row) {
      for (std::size_t d = degree_; d < degree; ++d)
        internal::raise_curve(row);
    });
  }

  /*!
   * the ribbon with a lower degree along the side: the one of which this is the elevation, if there
   * is one. Otherwise it is an approximation. Each step from a degree d to d - 1 keeps the end
   * points of all rows, and their derivatives at both ends up to order ⌊d/2⌋ - 1; in exact
   * arithmetic ribbons that agree at a corner so far still do. From degree 4 on
   * `Bezier_curve_3::reduced()` is another approximation: it keeps the end points only, for a least
   * squares fit of the control points.
   *
   * With inexact arithmetic the reversed ribbon gives the same control points, bit for bit.
   *
   * Complexity: the number of degrees times that of control points. \pre `1 <= degree <= degree()`
   */
  Bezier_ribbon_3 reduced(std::size_t degree) const {
    CGAL_precondition(1 <= degree && degree <= degree_);
    return with_rows(degree, [&](std::vector<Point_3>& row) {
      for (std::size_t d = degree_; d > degree; --d)
        internal::lower_curve(row);
    });
  }

  /*!
   * the ribbon with m layers instead of l, and so of degree 2m - 1 across the side.
   *
   * The boundary curve stays, and so do the derivatives across the side at h = 0, all along it, as
   * far as both numbers of layers tell them: up to order min(l,m) - 1. If there are more layers
   * than before, the derivatives of the orders l to m - 1 are zero, so that the cross-sections go
   * on as the curves of lowest degree. Going to more layers and back changes nothing, but for
   * rounding.
   *
   * \param layers m, at least 1
   *
   * \throws Input_error if there are more layers than a ribbon can have
   *
   * Complexity: for each column, cubic in the larger number of layers. \pre `layers >= 1`
   */
  Bezier_ribbon_3 with_layers(std::size_t layers) const {
    CGAL_precondition(layers >= 1);
    if (2 * layers > internal::max_bernstein_degree<FT>())
      throw Input_error("a ribbon cannot have " + std::to_string(layers) + " layers, only up to " +
                        std::to_string(internal::max_bernstein_degree<FT>() / 2));
    return Bezier_ribbon_3(degree_, layers,
                           internal::change_columns(
                               degree_ + 1, (std::min)(layers, layers_),
                               [this](std::size_t j, std::size_t k) { return control_point(j, k); },
                               [&](std::vector<Point_3>& column) {
                                 internal::change_prefix_degree(column, cross_degree(),
                                                                2 * layers - 1);
                                 while (column.size() < layers)
                                   internal::append_smoothly(column);
                               }));
  }

private:
  // The ribbon of the given degree whose rows `change` makes from the rows of this one.
  template <typename Change>
  Bezier_ribbon_3 with_rows(std::size_t degree, const Change& change) const {
    std::vector<Point_3> points;
    points.reserve((degree + 1) * layers_);
    for (auto row = control_points_.begin(); row != control_points_.end(); row += degree_ + 1) {
      std::vector<Point_3> changed(row, row + degree_ + 1);
      change(changed);
      points.insert(points.end(), changed.begin(), changed.end());
    }
    return Bezier_ribbon_3(degree, layers_, std::move(points));
  }

  static double length(const Vector_3& v) {
    return std::hypot(CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z()));
  }

  // Whether the boundary curve runs from its lexicographically smaller end to the larger one; zero
  // if its control points are the same from both ends. Of the two directions of a curve,
  // computations take the positive one.
  Sign direction_of_curve() const {
    for (std::size_t j = 0; 2 * j < degree_; ++j) {
      const Point_3 &a = control_point(j, 0), &b = control_point(degree_ - j, 0);
      if (a != b)
        return a < b ? POSITIVE : NEGATIVE;
    }
    return ZERO;
  }
  bool runs_backwards() const { return direction_of_curve() == NEGATIVE; }

  template <typename Column>
  Vector_3 combine_row(std::size_t row, const FT& s, const Column& column) const {
    boost::container::small_vector<FT, 16> b(degree_ + 1);
    internal::bernstein_polynomials(degree_, s, b.data());
    Vector_3 sum(FT(0), FT(0), FT(0));
    for (std::size_t j = 0; j <= degree_; ++j)
      sum = sum + b[j] * (control_point(column(j), row) - ORIGIN);
    return sum;
  }

  double gauss(double a, double b) const {
    static const std::vector<internal::Quadrature_node> rule = internal::gauss_legendre(15);
    double sum = 0;
    for (const internal::Quadrature_node& node : rule)
      sum += node.weight * length(boundary_derivative(FT(a + node.t * (b - a))));
    return sum * (b - a);
  }

  double arc_length(double a, double b, double whole, double tolerance, int depth) const {
    const double m = (a + b) / 2, left = gauss(a, m), right = gauss(m, b);
    if (depth == 0 || std::abs(left + right - whole) <= tolerance)
      return left + right;
    return arc_length(a, m, left, tolerance, depth - 1) +
           arc_length(m, b, right, tolerance, depth - 1);
  }

  std::size_t degree_, layers_;
  std::vector<Point_3> control_points_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_BEZIER_RIBBON_3_H
