// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_BSPLINE_CURVE_3_H
#define CGAL_MULTISIDED_PATCHES_BSPLINE_CURVE_3_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/internal/check_finite.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/ribbons/Bezier_curve_3.h>
#include <CGAL/Multisided_patches/ribbons/internal/de_casteljau.h>

#include <CGAL/Origin.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * A piecewise polynomial curve in B-spline form: C(t) = Σ N_i(t) P_i, with the B-splines N_i of
 * degree p over the knots t_0 <= ... <= t_(n+p) (n control points).
 *
 * The curve is defined for t in [t_p, t_n]. It is *clamped* if its first and its last p + 1 knots
 * are equal, and then starts at P_0 and ends at P_(n-1); it need not be. At a knot of multiplicity
 * m inside, the derivatives up to order p - m are continuous.
 *
 * The algorithms are the classical ones (Farin, *Curves and Surfaces for CAGD*, 5th edition, 2002);
 * they are exact if the number type is.
 *
 * \tparam Traits a CGAL kernel
 */
template <typename Traits>
class Bspline_curve_3 {
public:
  using Geom_traits = Traits;
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;

  //! A polynomial piece of the curve: `curve.point((t - begin) / (end - begin))` is C(t).
  struct Bezier_piece {
    Bezier_curve_3<Traits> curve;
    FT begin, end; //!< two successive, different knots
  };

  /*!
   * stores a curve.
   *
   * \param degree p, from 1 to 1000 (120 in `float`)
   * \param knots n + p + 1 numbers that do not decrease, with t_p < t_n; a knot inside the
   * parameter range is repeated at most p times, others at most p + 1 times
   * \param control_points n points, at least p + 1 (model units)
   *
   * \throws Input_error if the sizes do not fit together, the knots are not as above, or a number
   * is not finite
   */
  Bspline_curve_3(std::size_t degree, std::vector<FT> knots, std::vector<Point_3> control_points)
      : degree_(degree), knots_(std::move(knots)), control_points_(std::move(control_points)) {
    check_sizes();
    check_knots();
    internal::check_finite(control_points_, "a B-spline curve");
  }

  //! the degree p
  std::size_t degree() const { return degree_; }
  const std::vector<FT>& knots() const { return knots_; }
  const std::vector<Point_3>& control_points() const { return control_points_; }

  //! the smallest and the largest parameter, t_p and t_n
  std::pair<FT, FT> parameter_range() const {
    return {knots_[degree_], knots_[control_points_.size()]};
  }
  //! whether the first and the last p + 1 knots are equal
  bool is_clamped() const {
    return knots_.front() == knots_[degree_] && knots_[control_points_.size()] == knots_.back();
  }
  //! how many knots are equal to `t`. Complexity: O(log n).
  std::size_t multiplicity(const FT& t) const {
    const auto range = std::equal_range(knots_.begin(), knots_.end(), t);
    return range.second - range.first;
  }

  /*!
   * the point C(t) (model units), by the algorithm of de Boor. Complexity: O(p² + log n). \pre `t`
   * is in the parameter range
   */
  Point_3 point(const FT& t) const { return ORIGIN + local_derivative(t, 0); }

  /*!
   * the derivative of order `order` with respect to t (model units per unit of the parameter); zero
   * beyond the degree. At a knot it is that of the piece which starts there or, at the end of the
   * parameter range, of the last piece.
   *
   * Complexity: O(p² + log n). \pre `order >= 1` and `t` is in the parameter range
   */
  Vector_3 derivative(const FT& t, std::size_t order = 1) const {
    CGAL_precondition(order >= 1);
    if (order > degree_)
      return Vector_3(FT(0), FT(0), FT(0));
    return local_derivative(t, order);
  }

  /*!
   * the same curve with one more knot, at `t` (Boehm, *Inserting new knots into B-spline curves*,
   * Computer-Aided Design 12, 1980).
   *
   * Complexity: O(n + p). \pre `t` is in the parameter range and `multiplicity(t) < degree()`
   */
  Bspline_curve_3 with_knot(const FT& t) const {
    CGAL_precondition(is_in_range(t) && multiplicity(t) < degree_);
    const auto after = std::upper_bound(knots_.begin(), knots_.end(), t);
    const std::size_t k = after - knots_.begin() - 1; // t_k <= t < t_{k+1}
    std::vector<FT> knots(knots_.begin(), after);
    knots.push_back(t);
    knots.insert(knots.end(), after, knots_.end());

    const std::size_t first = k - degree_ + 1, last = k - multiplicity(t);
    std::vector<Point_3> points(control_points_.begin(), control_points_.begin() + first);
    for (std::size_t i = first; i <= last; ++i) {
      const FT width = knots_[i + degree_] - knots_[i];
      points.push_back(internal::between(control_points_[i - 1], control_points_[i],
                                         FT((t - knots_[i]) / width),
                                         FT((knots_[i + degree_] - t) / width)));
    }
    points.insert(points.end(), control_points_.begin() + last, control_points_.end());
    return Bspline_curve_3(degree_, std::move(knots), std::move(points));
  }

  /*!
   * the polynomial pieces of the curve, in order: one for each two successive, different knots of
   * the parameter range. Each ends at the point where the next one starts, bit for bit.
   *
   * They are the control points of the curve whose knots are all p-fold, by knot insertion.
   * Complexity: O(p³) for each piece.
   */
  std::vector<Bezier_piece> bezier_pieces() const {
    std::vector<Bezier_piece> pieces;
    for (std::size_t k = degree_; k < control_points_.size(); ++k) {
      if (knots_[k] == knots_[k + 1])
        continue;
      std::vector<Point_3> points = bezier_points(k);
      // The last point of one piece and the first of the next are rounded differently.
      if (!pieces.empty())
        points.front() = pieces.back().curve.control_points().back();
      pieces.push_back(
          {Bezier_curve_3<Traits>(std::move(points)), FT(knots_[k]), FT(knots_[k + 1])});
    }
    return pieces;
  }

private:
  void check_sizes() const {
    constexpr std::size_t max_degree = internal::max_bernstein_degree<FT>();
    if (degree_ < 1 || degree_ > max_degree)
      throw Input_error("a B-spline curve needs a degree from 1 to " + std::to_string(max_degree) +
                        ", not " + std::to_string(degree_));
    if (control_points_.size() < degree_ + 1)
      throw Input_error("a B-spline curve of degree " + std::to_string(degree_) +
                        " needs at least " + std::to_string(degree_ + 1) + " control points, not " +
                        std::to_string(control_points_.size()));
    if (knots_.size() != control_points_.size() + degree_ + 1)
      throw Input_error("a B-spline curve of degree " + std::to_string(degree_) + " with " +
                        std::to_string(control_points_.size()) + " control points needs " +
                        std::to_string(control_points_.size() + degree_ + 1) + " knots, not " +
                        std::to_string(knots_.size()));
  }

  void check_knots() const {
    for (std::size_t i = 0; i < knots_.size(); ++i) {
      if (!CGAL::is_finite(knots_[i]))
        throw Input_error("knot " + std::to_string(i) + " of a B-spline curve is not finite");
      if (i > 0 && knots_[i] < knots_[i - 1])
        throw Input_error("the knots of a B-spline curve must not decrease, but knot " +
                          std::to_string(i) + " is " + text(i) + ", after " + text(i - 1));
    }
    const FT &begin = knots_[degree_], &end = knots_[control_points_.size()];
    if (begin == end)
      throw Input_error("the parameter range of a B-spline curve, from knot " +
                        std::to_string(degree_) + " to knot " +
                        std::to_string(control_points_.size()) + ", is the single number " +
                        text(degree_));
    for (std::size_t i = 1; i < knots_.size(); ++i)
      if (knots_[i] != knots_[i - 1] && !CGAL::is_finite(FT(FT(1) / FT(knots_[i] - knots_[i - 1]))))
        throw Input_error("knots " + std::to_string(i - 1) + " and " + std::to_string(i) +
                          " of a B-spline curve, " + text(i - 1) + " and " + text(i) +
                          ", are too close to each other");
    if (!CGAL::is_finite(FT(knots_.back() - knots_.front())))
      throw Input_error("the knots of a B-spline curve are too far apart: they run from " +
                        text(0) + " to " + text(knots_.size() - 1));
    for (std::size_t i = 0, next = 0; i < knots_.size(); i = next) {
      while (next < knots_.size() && knots_[next] == knots_[i])
        ++next;
      const bool is_inside = begin < knots_[i] && knots_[i] < end;
      const std::size_t most = is_inside ? degree_ : degree_ + 1;
      if (next - i > most)
        throw Input_error("the knot " + text(i) + " of a B-spline curve of degree " +
                          std::to_string(degree_) + " is repeated " + std::to_string(next - i) +
                          " times, not at most " + std::to_string(most) +
                          (is_inside ? ": the curve may be torn there" : ""));
    }
  }

  std::string text(std::size_t i) const {
    return internal::to_short_text(CGAL::to_double(knots_[i]));
  }

  bool is_in_range(const FT& t) const {
    return !(t < knots_[degree_]) && !(knots_[control_points_.size()] < t);
  }

  // The index k of the piece from t_k to t_{k+1} to which `t` belongs; t_k < t_{k+1}.
  std::size_t piece_of(const FT& t) const {
    CGAL_precondition(is_in_range(t));
    const auto begin = knots_.begin() + degree_ + 1, end = knots_.begin() + control_points_.size();
    const auto after = t < *end ? std::upper_bound(begin, end, t) : std::lower_bound(begin, end, t);
    return after - knots_.begin() - 1;
  }

  // The derivative of any order up to the degree: on its piece the curve is a combination of p + 1
  // points; the control points of its derivative are differences of these. \pre order <= degree()
  Vector_3 local_derivative(const FT& t, std::size_t order) const {
    const std::size_t k = piece_of(t), offset = k - degree_;
    boost::container::small_vector<Vector_3, 16> v;
    for (std::size_t i = offset; i <= k; ++i)
      v.push_back(control_points_[i] - ORIGIN);
    std::size_t degree = degree_; // of the derivative so far
    for (std::size_t r = 1; r <= order; ++r, --degree)
      for (std::size_t i = k; i >= offset + r; --i) {
        const FT factor = FT(static_cast<int>(degree)) / FT(knots_[i + degree] - knots_[i]);
        v[i - offset] = factor * (v[i - offset] - v[i - offset - 1]);
      }
    for (std::size_t r = order + 1; r <= degree_; ++r, --degree)
      for (std::size_t i = k; i >= offset + r; --i) {
        const FT width = knots_[i + degree] - knots_[i];
        v[i - offset] = FT((t - knots_[i]) / width) * v[i - offset] +
                        FT((knots_[i + degree] - t) / width) * v[i - offset - 1];
      }
    return v.back();
  }

  // The control points of the piece from t_k to t_{k+1}; t_k < t_{k+1}.
  std::vector<Point_3> bezier_points(std::size_t k) const {
    // All that the piece depends on is a curve of its own.
    const std::size_t first = k - degree_;
    Bspline_curve_3 piece(
        degree_, std::vector<FT>(knots_.begin() + first, knots_.begin() + first + 2 * degree_ + 2),
        std::vector<Point_3>(control_points_.begin() + first, control_points_.begin() + k + 1));
    for (const FT& t : {knots_[k], knots_[k + 1]})
      while (piece.multiplicity(t) < degree_)
        piece = piece.with_knot(t);
    const auto begin = piece.control_points_.begin() + piece.piece_of(knots_[k]) - degree_;
    return std::vector<Point_3>(begin, begin + degree_ + 1);
  }

  std::size_t degree_;
  std::vector<FT> knots_;
  std::vector<Point_3> control_points_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_BSPLINE_CURVE_3_H
