// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_BEZIER_TRIANGLE_3_H
#define CGAL_MULTISIDED_PATCHES_BEZIER_TRIANGLE_3_H

#include <CGAL/Multisided_patches/domains/Domain_location.h>
#include <CGAL/Multisided_patches/domains/make_regular_domain.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/internal/check_finite.h>
#include <CGAL/Multisided_patches/patches/internal/Polynomial_patch.h>
#include <CGAL/Multisided_patches/ribbons/Bezier_curve_3.h>
#include <CGAL/Multisided_patches/ribbons/internal/degree_change.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * A triangular Bézier surface of degree d: S = Σ d!/(i! j! k!) λ_0^i λ_1^j λ_2^k b_{ijk} over
 * i + j + k = d, where λ are the barycentric coordinates of the domain, a triangle (Farin,
 * *Triangular Bernstein-Bézier patches*, Computer Aided Geometric Design 3, 1986).
 *
 * Control points come row by row, parallel to side 0: for k = 0..d, and in each row for
 * j = 0..d-k. So the first d + 1 are those of the boundary curve from vertex 0 to vertex 1, and the
 * last one is at vertex 2.
 *
 * \cgalModels{MultisidedPatch_3}
 *
 * \tparam Traits a CGAL kernel with exact predicates
 */
template <typename Traits>
class Bezier_triangle_3 : public internal::Polynomial_patch<Bezier_triangle_3<Traits>, Traits> {
  using Base = internal::Polynomial_patch<Bezier_triangle_3<Traits>, Traits>;

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
   * makes a patch over an equilateral triangle.
   *
   * \param degree d, from 1 to 1000 (120 in `float`)
   * \param control_points (d + 1) (d + 2) / 2 points in the order above (model units)
   *
   * \throws Input_error if the sizes do not fit together, a coordinate is not finite, or the
   * boundary curve of a side is a single point
   */
  Bezier_triangle_3(std::size_t degree, std::vector<Point_3> control_points)
      : Bezier_triangle_3(degree, std::move(control_points), make_regular_domain<Traits>(3)) {}

  //! the same over a domain of the caller's choice. \throws Input_error if that is no triangle, too
  Bezier_triangle_3(std::size_t degree, std::vector<Point_3> control_points, Domain domain)
      : Base(make_loop(degree, control_points), std::move(control_points), std::move(domain)),
        degree_(degree) {
    if (this->domain().size() != 3)
      throw Input_error("the domain of a Bezier triangle needs 3 vertices, not " +
                        std::to_string(this->domain().size()));
  }

  //! the number of control points of a triangle of that degree
  static std::size_t number_of_control_points(std::size_t degree) {
    return (degree + 1) * (degree + 2) / 2;
  }

  //! d
  std::size_t degree() const { return degree_; }
  //! b_{ijk}. \pre `i + j + k == degree()`
  const Point_3& control_point(std::size_t i, std::size_t j, std::size_t k) const {
    CGAL_precondition(i + j + k == degree_);
    return this->control_points()[index(degree_, j, k)];
  }

  using Base::evaluate;

  /*!
   * the point and its derivatives by the algorithm of de Casteljau, in another number type, into
   * which the coordinates of the domain and of the control points convert without loss.
   *
   * \tparam Real a field number type
   *
   * Complexity: O(d³).
   */
  template <int Order, typename Real>
  Surface_jet<Order, Real> evaluate(const Real& u, const Real& v,
                                    const Domain_location<Real>& location) const {
    using Jet = Jet_2<Real, Order>;
    const std::array<Jet, 3> lambda = barycentric_coordinates<Order>(u, v, location);
    std::vector<Surface_jet<Order, Real>> b;
    b.reserve(this->control_points().size());
    for (const Point_3& p : this->control_points())
      b.push_back({Jet(Real(p.x())), Jet(Real(p.y())), Jet(Real(p.z()))});
    for (std::size_t n = degree_; n > 0; --n)
      de_casteljau_step(n, b, [&](const auto& at_0, const auto& at_1, const auto& at_2) {
        Surface_jet<Order, Real> sum;
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] = lambda[0] * at_0[c] + lambda[1] * at_1[c] + lambda[2] * at_2[c];
        return sum;
      });
    return b[0];
  }

  /*!
   * the three parts of the surface that meet at `uv`: part i is over the triangle of the vertices
   * i and i + 1 of this domain and of `uv`, in this order. At every point of it, it is this
   * surface.
   *
   * \throws Input_error if `uv` does not lie inside the domain, or a part has a side that is a
   * single point
   *
   * Complexity: O(d³).
   */
  std::array<Bezier_triangle_3, 3> subdivided(const Point_2& uv) const {
    const Domain& domain = this->domain();
    const Location location = domain.locate_inside(uv);
    if (location.is_on_boundary())
      throw Input_error("a Bezier triangle is subdivided at a point inside its domain, not on a "
                        "side or at a vertex");
    const auto lambda = barycentric_coordinates<0>(uv.x(), uv.y(), location);
    std::array<std::vector<Point_3>, 3> parts;
    std::vector<Point_3> b = this->control_points();
    // The steps of the algorithm leave the rows of the parts on their sides, one after the other.
    for (std::size_t n = degree_;; --n) {
      for (std::size_t side = 0; side < 3; ++side)
        for (std::size_t j = 0; j <= n; ++j)
          parts[side].push_back(b[index_at_side(n, side, j, 0)]);
      if (n == 0)
        break;
      de_casteljau_step(n, b, [&](const Point_3& p, const Point_3& q, const Point_3& r) {
        return combined(p, q, r, lambda[0].value(), lambda[1].value(), lambda[2].value());
      });
    }
    const auto part = [&](std::size_t i) {
      return Bezier_triangle_3(degree_, std::move(parts[i]),
                               Domain({domain.vertex(i), domain.vertex(domain.next(i)), uv}));
    };
    return {{part(0), part(1), part(2)}};
  }

  //! the same surface with its degree raised by 1; see `elevated_to()`
  Bezier_triangle_3 elevated() const { return elevated_to(degree_ + 1); }

  /*!
   * the same surface with a higher degree. Complexity: the number of degrees raised times that of
   * control points. \pre `degree >= this->degree()`
   */
  Bezier_triangle_3 elevated_to(std::size_t degree) const {
    CGAL_precondition(degree >= degree_);
    std::vector<Point_3> b = this->control_points();
    for (std::size_t n = degree_ + 1; n <= degree; ++n)
      b = elevated_by_one(n, b);
    return Bezier_triangle_3(degree, std::move(b), this->domain());
  }

private:
  // The index of b_{ijk} among the points of degree n.
  static std::size_t index(std::size_t n, std::size_t j, std::size_t k) {
    return k * (2 * n + 3 - k) / 2 + j;
  }
  // The same seen from a side: column j along it, in row k from it.
  static std::size_t index_at_side(std::size_t n, std::size_t side, std::size_t j, std::size_t k) {
    const std::size_t i = n - j - k;
    return side == 0 ? index(n, j, k) : side == 1 ? index(n, i, j) : index(n, k, i);
  }

  static Point_3 combined(const Point_3& p, const Point_3& q, const Point_3& r, const FT& a,
                          const FT& b, const FT& c) {
    return Point_3(FT(a * p.x() + b * q.x() + c * r.x()), FT(a * p.y() + b * q.y() + c * r.y()),
                   FT(a * p.z() + b * q.z() + c * r.z()));
  }

  // From the points of degree n to those of degree n - 1, in place.
  template <typename Value, typename Combine>
  static void de_casteljau_step(std::size_t n, std::vector<Value>& b, const Combine& combine) {
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 0; j + k < n; ++j)
        b[index(n - 1, j, k)] =
            combine(b[index(n, j, k)], b[index(n, j + 1, k)], b[index(n, j, k + 1)]);
  }

  // From the points of degree n - 1 to those of degree n.
  static std::vector<Point_3> elevated_by_one(std::size_t n, const std::vector<Point_3>& b) {
    const auto share = [n](std::size_t i) -> FT {
      return FT(static_cast<int>(i)) / FT(static_cast<int>(n));
    };
    std::vector<Point_3> points;
    for (std::size_t k = 0; k <= n; ++k)
      for (std::size_t j = 0; j + k <= n; ++j) {
        const std::size_t i = n - j - k;
        // A point that does not exist has weight 0, and any other stands for it.
        const Point_3& at_0 = i > 0 ? b[index(n - 1, j, k)] : b[0];
        const Point_3& at_1 = j > 0 ? b[index(n - 1, j - 1, k)] : b[0];
        const Point_3& at_2 = k > 0 ? b[index(n - 1, j, k - 1)] : b[0];
        points.push_back(combined(at_0, at_1, at_2, share(i), share(j), share(k)));
      }
    return points;
  }

  // On the boundary from the location alone, as the point may be rounded.
  template <int Order, typename Real>
  std::array<Jet_2<Real, Order>, 3>
  barycentric_coordinates(const Real& u, const Real& v,
                          const Domain_location<Real>& location) const {
    using Kind = typename Domain_location<Real>::Kind;
    std::array<Real, 3> x, y;
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = Real(this->domain().vertex(i).x());
      y[i] = Real(this->domain().vertex(i).y());
    }
    const Real twice_area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    std::array<Jet_2<Real, Order>, 3> lambda;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      if (location.kind == Kind::vertex)
        lambda[i][0] = Real(i == location.index ? 1 : 0);
      else if (location.kind == Kind::interior)
        lambda[i][0] = ((x[j] - u) * (y[k] - v) - (x[k] - u) * (y[j] - v)) / twice_area;
      else
        lambda[i][0] = i == location.index   ? Real(Real(1) - location.s)
                       : k == location.index ? location.s
                                             : Real(0);
      if constexpr (Order >= 1) {
        lambda[i][1] = (y[j] - y[k]) / twice_area;
        lambda[i][2] = (x[k] - x[j]) / twice_area;
      }
    }
    return lambda;
  }

  /*
   * Seen from a side, with s along it and h = λ of the vertex opposite, the surface is
   * Σ B^d_k(h) r_k(s), with the curves r_k of degree d - k whose control points are those of row k
   * (every line to that vertex has a constant s). With all rows elevated to degree d this is a
   * tensor product surface of degree d by d, and ribbons are its first rows. At least two, though:
   * degrees less than 3 across the side are elevated to 3. So a ribbon has the tangent planes of
   * the surface, and one of l layers all its derivatives up to order l - 1.
   */
  static Loop make_loop(std::size_t degree, const std::vector<Point_3>& control_points) {
    check(degree, control_points);
    const std::size_t layers = (std::max<std::size_t>)(2, (degree + 1) / 2);
    std::vector<Bezier_ribbon_3<Traits>> ribbons;
    for (std::size_t side = 0; side < 3; ++side) {
      std::vector<std::vector<Point_3>> rows;
      for (std::size_t k = 0; k < layers; ++k)
        rows.push_back(elevated_row(degree, control_points, side, k));
      const auto point = [&](std::size_t j, std::size_t k) { return rows[k][j]; };
      ribbons.emplace_back(
          degree, layers,
          internal::change_cross_degree(degree + 1, layers, point, degree, 2 * layers - 1));
    }
    return Loop(std::move(ribbons));
  }

  static void check(std::size_t degree, const std::vector<Point_3>& control_points) {
    constexpr std::size_t max_degree = internal::max_bernstein_degree<FT>();
    if (degree < 1 || degree > max_degree)
      throw Input_error("a Bezier triangle needs a degree from 1 to " + std::to_string(max_degree) +
                        ", not " + std::to_string(degree));
    if (control_points.size() != number_of_control_points(degree))
      throw Input_error("a Bezier triangle of degree " + std::to_string(degree) + " has " +
                        std::to_string(number_of_control_points(degree)) + " control points, not " +
                        std::to_string(control_points.size()));
    internal::check_finite(control_points, "a Bezier triangle");
  }

  // Row k seen from a side as a curve of degree d.
  static std::vector<Point_3> elevated_row(std::size_t degree, const std::vector<Point_3>& points,
                                           std::size_t side, std::size_t k) {
    std::vector<Point_3> row;
    for (std::size_t j = 0; j + k <= degree; ++j)
      row.push_back(points[index_at_side(degree, side, j, k)]);
    if (row.size() == 1)
      return std::vector<Point_3>(degree + 1, row[0]);
    return Bezier_curve_3<Traits>(std::move(row)).elevated_to(degree).control_points();
  }

  std::size_t degree_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_BEZIER_TRIANGLE_3_H
