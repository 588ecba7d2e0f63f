// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_TENSOR_PRODUCT_PATCH_3_H
#define CGAL_MULTISIDED_PATCHES_TENSOR_PRODUCT_PATCH_3_H

#include <CGAL/Multisided_patches/domains/Domain_location.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/internal/check_finite.h>
#include <CGAL/Multisided_patches/patches/internal/Polynomial_patch.h>
#include <CGAL/Multisided_patches/ribbons/Bezier_curve_3.h>
#include <CGAL/Multisided_patches/ribbons/internal/degree_change.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * A tensor product Bézier surface of degree d by e: S(u,v) = Σ B^d_i(u) B^e_j(v) b_{ij} over the
 * unit square, with Bernstein polynomials B. Degree 1 by 1 is bilinear.
 *
 * Control points come row by row, parallel to side 0: for j = 0..e, and in each row for i = 0..d.
 * Vertices 0 to 3 of the domain are (0,0), (1,0), (1,1) and (0,1).
 *
 * \cgalModels{MultisidedPatch_3}
 *
 * \tparam Traits a CGAL kernel with exact predicates
 */
template <typename Traits>
class Tensor_product_patch_3
    : public internal::Polynomial_patch<Tensor_product_patch_3<Traits>, Traits> {
  using Base = internal::Polynomial_patch<Tensor_product_patch_3<Traits>, Traits>;

public:
  using typename Base::Domain;
  using typename Base::FT;
  using typename Base::Location;
  using typename Base::Loop;
  using typename Base::Point_2;
  using typename Base::Point_3;
  template <int Order, typename Real = FT>
  using Surface_jet = typename Base::template Surface_jet<Order, Real>;

  /*!
   * makes a patch.
   *
   * \param degree_u, degree_v d and e, from 1 to 1000 (120 in `float`)
   * \param control_points (d + 1) (e + 1) points in the order above (model units)
   *
   * \throws Input_error if the sizes do not fit together, a coordinate is not finite, or the
   * boundary curve of a side is a single point
   */
  Tensor_product_patch_3(std::size_t degree_u, std::size_t degree_v,
                         std::vector<Point_3> control_points)
      : Base(make_loop(degree_u, degree_v, control_points), std::move(control_points),
             Domain({Point_2(FT(0), FT(0)), Point_2(FT(1), FT(0)), Point_2(FT(1), FT(1)),
                     Point_2(FT(0), FT(1))})),
        degree_u_(degree_u), degree_v_(degree_v) {}

  /*!
   * the bilinear patch of four corner points.
   *
   * \param corner_0, corner_1, corner_2, corner_3 the points at the vertices of the domain: the
   * corners in counterclockwise order (model units)
   *
   * \throws Input_error if two successive corners coincide or a coordinate is not finite
   */
  static Tensor_product_patch_3 bilinear(const Point_3& corner_0, const Point_3& corner_1,
                                         const Point_3& corner_2, const Point_3& corner_3) {
    return Tensor_product_patch_3(1, 1, {corner_0, corner_1, corner_3, corner_2});
  }

  //! d, the degree in u
  std::size_t degree_u() const { return degree_u_; }
  //! e, the degree in v
  std::size_t degree_v() const { return degree_v_; }
  //! b_{ij}
  const Point_3& control_point(std::size_t i, std::size_t j) const {
    CGAL_precondition(i <= degree_u_ && j <= degree_v_);
    return this->control_points()[j * (degree_u_ + 1) + i];
  }

  using Base::evaluate;

  /*!
   * the point and its derivatives by the sum above, in another number type, into which the
   * coordinates of the control points convert without loss.
   *
   * \tparam Real a field number type
   *
   * Complexity: linear in the number of control points.
   */
  template <int Order, typename Real>
  Surface_jet<Order, Real> evaluate(const Real& u, const Real& v,
                                    const Domain_location<Real>& location) const {
    using Jet = Jet_2<Real, Order>;
    const Parameters<Real> at = parameters(u, v, location);
    boost::container::small_vector<Jet, 8> in_u(degree_u_ + 1), in_v(degree_v_ + 1);
    const Jet u_jet = Jet::u_variable(at.u), v_jet = Jet::v_variable(at.v);
    // 1 - u, of which the value may be known better.
    Jet far_u = -u_jet, far_v = -v_jet;
    far_u[0] = at.one_minus_u;
    far_v[0] = at.one_minus_v;
    internal::bernstein_polynomials(degree_u_, degree_u_ + 1, u_jet, far_u, in_u.data());
    internal::bernstein_polynomials(degree_v_, degree_v_ + 1, v_jet, far_v, in_v.data());
    Surface_jet<Order, Real> sum;
    for (std::size_t j = 0; j <= degree_v_; ++j) {
      Surface_jet<Order, Real> row;
      for (std::size_t i = 0; i <= degree_u_; ++i) {
        const Point_3& p = control_point(i, j);
        row[0] += in_u[i] * Real(p.x());
        row[1] += in_u[i] * Real(p.y());
        row[2] += in_u[i] * Real(p.z());
      }
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += in_v[j] * row[c];
    }
    return sum;
  }

  /*!
   * the same surface with higher degrees. Complexity: the number of degrees raised times that of
   * control points. \pre neither degree is less than that of this patch
   */
  Tensor_product_patch_3 elevated_to(std::size_t degree_u, std::size_t degree_v) const {
    CGAL_precondition(degree_u >= degree_u_ && degree_v >= degree_v_);
    std::vector<Point_3> wide;
    wide.reserve((degree_u + 1) * (degree_v_ + 1));
    const std::vector<Point_3>& given = this->control_points();
    for (auto row = given.begin(); row != given.end(); row += degree_u_ + 1) {
      const auto elevated =
          elevated_points(std::vector<Point_3>(row, row + degree_u_ + 1), degree_u);
      wide.insert(wide.end(), elevated.begin(), elevated.end());
    }
    return Tensor_product_patch_3(
        degree_u, degree_v,
        internal::change_columns(
            degree_u + 1, degree_v_ + 1,
            [&](std::size_t i, std::size_t j) { return wide[j * (degree_u + 1) + i]; },
            [&](std::vector<Point_3>& column) {
              column = elevated_points(std::move(column), degree_v);
            }));
  }

private:
  template <typename Real>
  struct Parameters {
    Real u, one_minus_u, v, one_minus_v;
  };

  // On the boundary from the location alone, as the point may be rounded.
  template <typename Real>
  static Parameters<Real> parameters(const Real& u, const Real& v,
                                     const Domain_location<Real>& location) {
    const Real zero(0), one(1);
    if (!location.is_on_boundary())
      return {u, Real(one - u), v, Real(one - v)};
    // A vertex is where its side starts.
    const Real s = location.kind == Domain_location<Real>::Kind::side ? location.s : zero;
    const Real t = one - s;
    switch (location.index) {
    case 0:
      return {s, t, zero, one};
    case 1:
      return {one, zero, s, t};
    case 2:
      return {t, s, one, zero};
    default:
      return {zero, one, t, s};
    }
  }

  static std::vector<Point_3> elevated_points(std::vector<Point_3> points, std::size_t degree) {
    return Bezier_curve_3<Traits>(std::move(points)).elevated_to(degree).control_points();
  }

  // The first rows of the control net seen from each side. A ribbon with l layers is of degree
  // 2l - 1 across its side; inner rows are moved where the surface is of degree 2l, such that the
  // derivatives up to order l - 1 are the same.
  static Loop make_loop(std::size_t degree_u, std::size_t degree_v,
                        const std::vector<Point_3>& control_points) {
    check(degree_u, degree_v, control_points);
    std::vector<Bezier_ribbon_3<Traits>> ribbons;
    for (std::size_t side = 0; side < 4; ++side) {
      const std::size_t along = side % 2 == 0 ? degree_u : degree_v;
      const std::size_t across = side % 2 == 0 ? degree_v : degree_u;
      const std::size_t layers = (across + 1) / 2;
      const auto point = [&](std::size_t j, std::size_t k) {
        const std::size_t from_left = side == 0   ? j
                                      : side == 1 ? degree_u - k
                                      : side == 2 ? degree_u - j
                                                  : k;
        const std::size_t from_below = side == 0   ? k
                                       : side == 1 ? j
                                       : side == 2 ? degree_v - k
                                                   : degree_v - j;
        return control_points[from_below * (degree_u + 1) + from_left];
      };
      ribbons.emplace_back(
          along, layers,
          internal::change_cross_degree(along + 1, layers, point, across, 2 * layers - 1));
    }
    return Loop(std::move(ribbons));
  }

  static void check(std::size_t degree_u, std::size_t degree_v,
                    const std::vector<Point_3>& control_points) {
    constexpr std::size_t max_degree = internal::max_bernstein_degree<FT>();
    if ((std::min)(degree_u, degree_v) < 1 || (std::max)(degree_u, degree_v) > max_degree)
      throw Input_error("a tensor product patch needs degrees from 1 to " +
                        std::to_string(max_degree) + ", not " + std::to_string(degree_u) + " by " +
                        std::to_string(degree_v));
    const std::size_t expected = (degree_u + 1) * (degree_v + 1);
    if (control_points.size() != expected)
      throw Input_error("a tensor product patch of degree " + std::to_string(degree_u) + " by " +
                        std::to_string(degree_v) + " has " + std::to_string(expected) +
                        " control points, not " + std::to_string(control_points.size()));
    internal::check_finite(control_points, "a tensor product patch");
  }

  std::size_t degree_u_, degree_v_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_TENSOR_PRODUCT_PATCH_3_H
