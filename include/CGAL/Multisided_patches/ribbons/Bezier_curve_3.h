// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_BEZIER_CURVE_3_H
#define CGAL_MULTISIDED_PATCHES_BEZIER_CURVE_3_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/internal/check_finite.h>
#include <CGAL/Multisided_patches/ribbons/Bezier_ribbon_3.h>
#include <CGAL/Multisided_patches/ribbons/internal/de_casteljau.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * A polynomial curve in Bézier form: C(s) = Σ B^d_j(s) P_j for s in [0,1], with the Bernstein
 * polynomials B^d_j(s) = (d over j) s^j (1 - s)^(d-j).
 *
 * The algorithms are the classical ones (Farin, *Curves and Surfaces for CAGD*, 5th edition, 2002);
 * they are exact if the number type is.
 *
 * \tparam Traits a CGAL kernel
 */
template <typename Traits>
class Bezier_curve_3 {
public:
  using Geom_traits = Traits;
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;

  /*!
   * stores a curve.
   *
   * \param control_points the points P_0, ..., P_d of a curve of degree d, from 1 to 1000 (120 in
   * `float`) (model units)
   *
   * \throws Input_error if there are too few or too many points, or a coordinate is not finite
   */
  explicit Bezier_curve_3(std::vector<Point_3> control_points)
      : control_points_(std::move(control_points)) {
    if (control_points_.size() < 2)
      throw Input_error("a Bezier curve needs at least 2 control points, not " +
                        std::to_string(control_points_.size()));
    constexpr std::size_t max_degree = internal::max_bernstein_degree<FT>();
    if (degree() > max_degree)
      throw Input_error("a Bezier curve of degree " + std::to_string(degree()) +
                        " is beyond the largest degree, " + std::to_string(max_degree));
    internal::check_finite(control_points_, "a Bezier curve");
  }

  //! the degree d
  std::size_t degree() const { return control_points_.size() - 1; }
  //! P_j
  const Point_3& control_point(std::size_t j) const {
    CGAL_precondition(j <= degree());
    return control_points_[j];
  }
  const std::vector<Point_3>& control_points() const { return control_points_; }

  //! the point C(s) (model units), by the algorithm of de Casteljau. Complexity: O(d²).
  Point_3 point(const FT& s) const {
    boost::container::small_vector<Point_3, 16> p(control_points_.begin(), control_points_.end());
    const FT t = FT(1) - s;
    for (std::size_t n = degree(); n > 0; --n)
      for (std::size_t j = 0; j < n; ++j)
        p[j] = internal::between(p[j], p[j + 1], s, t);
    return p[0];
  }

  /*!
   * the derivative of order `order` with respect to s (model units); zero beyond the degree.
   * Complexity: O(d²). \pre `order >= 1`
   */
  Vector_3 derivative(const FT& s, std::size_t order = 1) const {
    CGAL_precondition(order >= 1);
    if (order > degree())
      return Vector_3(FT(0), FT(0), FT(0));
    boost::container::small_vector<Vector_3, 16> v;
    for (std::size_t j = 0; j < degree(); ++j)
      v.push_back(control_points_[j + 1] - control_points_[j]);
    FT factor(static_cast<int>(degree()));
    for (std::size_t r = 1; r < order; ++r) {
      for (std::size_t j = 0; j + 1 < v.size(); ++j)
        v[j] = v[j + 1] - v[j];
      v.pop_back();
      factor = factor * FT(static_cast<int>(degree() - r));
    }
    const FT t = FT(1) - s;
    for (std::size_t n = v.size() - 1; n > 0; --n)
      for (std::size_t j = 0; j < n; ++j)
        v[j] = t * v[j] + s * v[j + 1];
    return factor * v[0];
  }

  /*!
   * the pieces of the curve from 0 to `s` and from `s` to 1, both with parameters in [0,1]. They
   * share the point C(s). Complexity: O(d²). \pre `0 <= s <= 1`
   */
  std::pair<Bezier_curve_3, Bezier_curve_3> subdivided(const FT& s) const {
    CGAL_precondition(FT(0) <= s && s <= FT(1));
    auto [left, right] = internal::split_curve(control_points_, s);
    return {Bezier_curve_3(std::move(left)), Bezier_curve_3(std::move(right))};
  }

  /*!
   * the piece of the curve from `a` to `b`, with parameters in [0,1]; it runs the other way if `a`
   * is larger than `b`. Complexity: O(d²). \pre `a` and `b` lie in [0,1] and differ
   */
  Bezier_curve_3 restricted(const FT& a, const FT& b) const {
    CGAL_precondition(a != b && FT(0) <= (std::min)(a, b) && (std::max)(a, b) <= FT(1));
    if (b < a)
      return restricted(b, a).reversed();
    return Bezier_curve_3(internal::curve_piece(control_points_, a, b));
  }

  //! the same curve with its degree raised by 1; see `elevated_to()`
  Bezier_curve_3 elevated() const { return elevated_to(degree() + 1); }

  /*!
   * the same curve with a higher degree, as `Bezier_ribbon_3::elevated()`. Complexity: the number
   * of degrees raised times that of control points. \pre `degree >= this->degree()`
   */
  Bezier_curve_3 elevated_to(std::size_t degree) const {
    return Bezier_curve_3(as_ribbon().elevated(degree).control_points());
  }

  /*!
   * a curve of degree d - 1 with the same end points. If this curve is the elevation of one, that
   * is it. Otherwise it is the one whose elevation has the control points closest to those of this
   * curve: the sum of their squared distances is smallest. Points of the two curves at one
   * parameter are never farther apart than the farthest of these control points.
   *
   * From degree 4 on this is not what `Bezier_ribbon_3::reduced()` does with a curve that is no
   * elevation: that one keeps derivatives at the ends, which change here, and moves the control
   * points farther instead.
   *
   * A curve is an elevation if Σ (-1)^j (d over j) P_j is zero. So the inner control points are
   * projected onto this linear condition, and the result is solved for the points of degree d - 1
   * from both ends towards the middle. Complexity: O(d). \pre `degree() >= 2`
   */
  Bezier_curve_3 reduced() const {
    CGAL_precondition(degree() >= 2);
    const std::vector<Point_3> p = closest_elevation();
    const std::size_t d = degree(), middle = (d - 1) / 2;
    const auto ratio = [](std::size_t a, std::size_t b) -> FT {
      return FT(static_cast<int>(a)) / FT(static_cast<int>(b));
    };
    std::vector<Point_3> q(p.begin(), p.end() - 1);
    q.back() = p.back();
    for (std::size_t j = 1; j <= middle; ++j)
      q[j] = p[j] + ratio(j, d - j) * (p[j] - q[j - 1]);
    for (std::size_t j = d - 1; j > middle + 1; --j)
      q[j - 1] = p[j] + ratio(d - j, j) * (p[j] - q[j]);
    return Bezier_curve_3(std::move(q));
  }

  //! the same curve run the other way: C(1 - s)
  Bezier_curve_3 reversed() const {
    return Bezier_curve_3(std::vector<Point_3>(control_points_.rbegin(), control_points_.rend()));
  }

  //! the length of the curve (model units), as `Bezier_ribbon_3::arc_length()`
  double arc_length() const { return as_ribbon().arc_length(); }

private:
  Bezier_ribbon_3<Traits> as_ribbon() const {
    return Bezier_ribbon_3<Traits>(degree(), 1, control_points_);
  }

  // The control points, the inner ones moved by as little as possible such that the curve is an
  // elevation.
  std::vector<Point_3> closest_elevation() const {
    // Binomial coefficients over the largest one, which may be as large as numbers can be.
    const std::size_t d = degree(), middle = d / 2;
    std::vector<FT> binomial(d + 1, FT(1));
    for (std::size_t j = middle; j > 0; --j)
      binomial[j - 1] = binomial[j] * FT(static_cast<int>(j)) / FT(static_cast<int>(d + 1 - j));
    for (std::size_t j = 0; j < middle; ++j)
      binomial[d - j] = binomial[j];

    Vector_3 sum(FT(0), FT(0), FT(0));
    FT squares(0);
    for (std::size_t j = 1; j <= d; ++j) {
      // Any point may be the origin, as the alternating sum of the coefficients is 0.
      const Vector_3 term = binomial[j] * (control_points_[j] - control_points_[0]);
      sum = j % 2 == 0 ? Vector_3(sum + term) : Vector_3(sum - term);
      if (j < d)
        squares = squares + binomial[j] * binomial[j];
    }
    std::vector<Point_3> points(control_points_);
    for (std::size_t j = 1; j < d; ++j) {
      const Vector_3 step = FT(binomial[j] / squares) * sum;
      points[j] = j % 2 == 0 ? Point_3(points[j] - step) : Point_3(points[j] + step);
    }
    return points;
  }

  std::vector<Point_3> control_points_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_BEZIER_CURVE_3_H
