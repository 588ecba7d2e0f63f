// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_CROSS_DERIVATIVES_H
#define CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_CROSS_DERIVATIVES_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A vector of the domain in the frame of a side: x times the side e, plus y times e turned inwards
// by a right angle.
template <typename FT>
struct Side_coordinates {
  FT x, y;
};

template <typename Traits>
Side_coordinates<typename Traits::FT> side_coordinates(const Polygonal_domain_2<Traits>& domain,
                                                       std::size_t side, std::size_t from,
                                                       std::size_t to) {
  const auto e = domain.vertex(domain.next(side)) - domain.vertex(side);
  const auto w = domain.vertex(to) - domain.vertex(from);
  const typename Traits::FT squared = e.x() * e.x() + e.y() * e.y();
  return {(w.x() * e.x() + w.y() * e.y()) / squared, (e.x() * w.y() - e.y() * w.x()) / squared};
}

/*!
 * Derivatives across the sides of a domain that a surface with polynomial derivatives can have and
 * that lie in the tangent planes of ribbons.
 *
 * Let E = R_s be the derivative along a side and H = R_h that across it, of its ribbon. The
 * derivative of the surface by the inward normal of the side in the domain (of the length of the
 * side) has to be G = α H + β E with α > 0. At both ends the derivatives along the neighbouring
 * sides determine G, and so α and β: α is linear, and positive if it is so at both ends. β is the
 * cubic with these values whose slopes at the ends make the two mixed derivatives equal that the
 * two sides of a corner give: their slopes take care of the components in the tangent plane, along
 * the one and the other side. The component along the normal of the mixed derivatives is that of
 * the ribbons, which have to agree in it, as in the tangent plane; otherwise they are changed.
 *
 * Where the boundary curves are an affine image of the sides, in a plane, and the second rows run
 * parallel to them, G is constant, as it is for that affine map.
 */
template <typename Traits>
class Cross_derivatives {
public:
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;
  using Domain = Polygonal_domain_2<Traits>;
  using Loop = Ribbon_loop_3<Traits>;
  using Ribbon = Bezier_ribbon_3<Traits>;

  /*!
   * \param refuse_to_change whether to throw where ribbons do not agree
   *
   * \throws Input_error if a ribbon has a single layer or does not lead inwards, or the two of a
   * corner span no tangent plane
   */
  Cross_derivatives(const Loop& loop, const Domain& domain, bool refuse_to_change)
      : domain_(domain), refuse_to_change_(refuse_to_change),
        point_error_(4 * coordinate_rounding(loop)), ends_(loop.size()) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      ribbons_.push_back(two_layers(loop[i], i));
    for (std::size_t i = 0; i < loop.size(); ++i)
      set_tangent_plane(i);
    for (std::size_t i = 0; i < loop.size(); ++i)
      for (const std::size_t end : {0, 1})
        set_factors(i, end);
    for (std::size_t i = 0; i < loop.size(); ++i)
      set_slopes(i);
  }

  //! the ribbons with 2 layers that are met
  const std::vector<Ribbon>& ribbons() const { return ribbons_; }
  //! the largest degree of the ribbons
  std::size_t degree() const {
    std::size_t degree = 0;
    for (const Ribbon& r : ribbons_)
      degree = (std::max)(degree, r.degree());
    return degree;
  }

  //! the Bézier coefficients of G for side `i`, a polynomial of degree `degree() + 2`
  std::vector<Vector_3> coefficients(std::size_t i) const {
    const std::size_t m = degree();
    const Ribbon r = ribbons_[i].elevated(m);
    std::vector<Vector_3> h, e;
    for (std::size_t j = 0; j <= m; ++j)
      h.push_back(cross_degree() * (r.control_point(j, 1) - r.control_point(j, 0)));
    for (std::size_t j = 0; j < m; ++j)
      e.push_back(number(m) * (r.control_point(j + 1, 0) - r.control_point(j, 0)));
    const End &a = ends_[i][0], &b = ends_[i][1];
    const FT third = FT(1) / FT(3), mean_slope = b.beta - a.beta;
    // Of degree 2 rather than 1, such that both products have the same degree.
    const std::vector<FT> alpha{a.alpha, (a.alpha + b.alpha) / FT(2), b.alpha},
        beta{a.beta, a.beta + third * (mean_slope + a.extra_slope),
             b.beta - third * (mean_slope + b.extra_slope), b.beta};
    std::vector<Vector_3> sum = product(alpha, h);
    const std::vector<Vector_3> second = product(beta, e);
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] = sum[k] + second[k];
    return sum;
  }

private:
  // Relative to lengths of the ribbons, and in addition to what rounded coordinates explain.
  // Differences above the first are refused, if any are; below the second they are rounding errors,
  // which are no reason to elevate a ribbon.
  static constexpr double agreement = 1e-9, rounding = 1e-13;

  // What is known of a side at one of its ends: α, β, and what β' is more there than if β were
  // linear.
  struct End {
    FT alpha{0}, beta{0}, extra_slope{0};
  };

  static FT number(std::size_t i) { return FT(static_cast<int>(i)); }
  static FT cross_degree() { return FT(3); }
  static double length(const Vector_3& v) { return norm(to_vec3(v)); }

  // Of vectors of about unit length, as its square has to stay in range; zero if one of them is.
  static Vector_3 scaled_cross_product(const Vector_3& a, const Vector_3& b) {
    const double size_a = length(a), size_b = length(b);
    if (!(size_a > 0 && size_b > 0))
      return Vector_3(FT(0), FT(0), FT(0));
    return cross_product(a / FT(size_a), b / FT(size_b));
  }

  std::size_t next(std::size_t i) const { return domain_.next(i); }
  std::size_t prev(std::size_t i) const { return domain_.prev(i); }

  static Ribbon two_layers(const Ribbon& r, std::size_t side) {
    if (r.layers() < 2)
      throw Input_error("the ribbon of side " + std::to_string(side) +
                        " has a single layer; tangent planes need 2");
    // The same derivative across the side: (2l - 1) / 3 times the step to the second row.
    const FT scale = number(r.cross_degree()) / cross_degree();
    std::vector<Point_3> points(r.control_points().begin(),
                                r.control_points().begin() + 2 * (r.degree() + 1));
    for (std::size_t j = 0; r.layers() > 2 && j <= r.degree(); ++j)
      points[r.degree() + 1 + j] =
          r.control_point(j, 0) + scale * (r.control_point(j, 1) - r.control_point(j, 0));
    return Ribbon(r.degree(), 2, std::move(points));
  }

  void move_inner_point(std::size_t side, std::size_t j, const Vector_3& by) {
    const Ribbon& r = ribbons_[side];
    std::vector<Point_3> points = r.control_points();
    points[r.degree() + 1 + j] = points[r.degree() + 1 + j] + by;
    ribbons_[side] = Ribbon(r.degree(), 2, std::move(points));
  }

  // C_{a,row} at end 0, C_{d-a,row} at end 1
  const Point_3& from_end(std::size_t side, std::size_t end, std::size_t a, std::size_t row) const {
    const Ribbon& r = ribbons_[side];
    return r.control_point(end == 0 ? a : r.degree() - a, row);
  }
  // E and its derivative, H and its derivative, at an end
  Vector_3 along(std::size_t side, std::size_t end) const {
    const Vector_3 step = from_end(side, end, 1, 0) - from_end(side, end, 0, 0);
    return number(ribbons_[side].degree()) * (end == 0 ? step : -step);
  }
  Vector_3 along_slope(std::size_t side, std::size_t end) const {
    const std::size_t d = ribbons_[side].degree();
    if (d < 2)
      return Vector_3(FT(0), FT(0), FT(0));
    return number(d * (d - 1)) * ((from_end(side, end, 2, 0) - from_end(side, end, 1, 0)) -
                                  (from_end(side, end, 1, 0) - from_end(side, end, 0, 0)));
  }
  Vector_3 inwards(std::size_t side, std::size_t end, std::size_t a) const {
    return cross_degree() * (from_end(side, end, a, 1) - from_end(side, end, a, 0));
  }
  Vector_3 inwards_slope(std::size_t side, std::size_t end) const {
    const Vector_3 step = inwards(side, end, 1) - inwards(side, end, 0);
    return number(ribbons_[side].degree()) * (end == 0 ? step : -step);
  }

  // At corner i, the derivatives towards the next and the previous corner.
  Vector_3 to_next(std::size_t i) const { return along(i, 0); }
  Vector_3 to_prev(std::size_t i) const { return -along(prev(i), 1); }

  // The corner at an end of a side, its other neighbour, and where this is in the frame of the
  // side.
  std::size_t corner(std::size_t side, std::size_t end) const {
    return end == 0 ? side : next(side);
  }
  Side_coordinates<FT> other_side(std::size_t side, std::size_t end) const {
    const std::size_t i = corner(side, end);
    return side_coordinates(domain_, side, i, end == 0 ? prev(i) : next(i));
  }

  void set_tangent_plane(std::size_t i) {
    const Vector_3 n = scaled_cross_product(to_next(i), to_prev(i));
    if (!(length(n) > agreement))
      throw Input_error("the sides that meet at corner " + std::to_string(i) +
                        " span no tangent plane there");
    normals_.push_back(n);
    for (const std::size_t end : {0, 1}) {
      const std::size_t side = end == 0 ? i : prev(i);
      const Vector_3 h = inwards(side, end, 0);
      const FT off = h * n;
      const double tolerance =
          (agreement * length(n) + direction_error(i)) * length(h) + 3 * point_error_ * length(n);
      if (refuse_to_change_ && std::abs(CGAL::to_double(off)) > tolerance)
        throw Input_error("the ribbon of side " + std::to_string(side) + " leaves corner " +
                          std::to_string(i) + " out of the plane of the two boundary curves");
      move_inner_point(side, end == 0 ? 0 : ribbons_[side].degree(),
                       FT(-off / (cross_degree() * (n * n))) * n);
    }
  }

  void set_factors(std::size_t side, std::size_t end) {
    const std::size_t i = corner(side, end);
    const Side_coordinates<FT> w = other_side(side, end);
    const Vector_3 n = normals_[i], e = along(side, end), h = inwards(side, end, 0);
    const Vector_3 g = FT(FT(1) / w.y) * ((end == 0 ? to_prev(i) : to_next(i)) - w.x * e);
    const FT area = cross_product(e, h) * n;
    const FT alpha = cross_product(e, g) * n / (area == FT(0) ? FT(1) : area);
    if (area == FT(0) || !(alpha > FT(0)))
      throw Input_error("the ribbon of side " + std::to_string(side) +
                        " does not lead into the surface at corner " + std::to_string(i));
    ends_[side][end] = {alpha, cross_product(g, h) * n / area, FT(0)};
  }

  // The mixed derivative by the directions of the two sides of a corner, from the polynomials of
  // the one side.
  Vector_3 twist(std::size_t side, std::size_t end) const {
    const std::array<End, 2>& ends = ends_[side];
    const Side_coordinates<FT> w = other_side(side, end);
    const FT alpha_slope = ends[1].alpha - ends[0].alpha, beta_slope = ends[1].beta - ends[0].beta;
    const Vector_3 e_slope = along_slope(side, end);
    const Vector_3 g_slope =
        alpha_slope * inwards(side, end, 0) + ends[end].alpha * inwards_slope(side, end) +
        FT(beta_slope + ends[end].extra_slope) * along(side, end) + ends[end].beta * e_slope;
    const Vector_3 sum = w.x * e_slope + w.y * g_slope;
    return end == 0 ? sum : -sum;
  }

  // What rounded coordinates make of the directions of the boundary at corner i, as an angle.
  double direction_error(std::size_t i) const {
    return point_error_ * (double(ribbons_[i].degree()) / length(to_next(i)) +
                           double(ribbons_[prev(i)].degree()) / length(to_prev(i)));
  }

  // Their effect on `twist()`: of every term the relative error of its first derivatives, from
  // which α, β and the normal come as well, and the absolute one of its second differences.
  double twist_error(std::size_t side, std::size_t end) const {
    const std::array<End, 2>& ends = ends_[side];
    const double d = double(ribbons_[side].degree()), e = length(along(side, end));
    const double h0 = length(inwards(side, 0, 0)), h1 = length(inwards(side, 1, 0));
    const double h = (std::max)(h0, h1);
    const double relative =
        direction_error(side) + direction_error(next(side)) + 3 * point_error_ * (1 / h0 + 1 / h1);
    const auto size = [](const FT& a, const FT& b) {
      return std::abs(CGAL::to_double(a)) + std::abs(CGAL::to_double(b));
    };
    const double alpha = size(ends[0].alpha, ends[1].alpha);
    const double beta = size(ends[0].beta, ends[1].beta) + alpha * h / e;
    const double of_e_slope = relative * length(along_slope(side, end)) + 4 * d * d * point_error_;
    const double of_h_slope = relative * length(inwards_slope(side, end)) + 12 * d * point_error_;
    const Side_coordinates<FT> w = other_side(side, end);
    return size(w.y, FT(0)) *
               (alpha * (relative * h + of_h_slope) + beta * (relative * e + of_e_slope)) +
           size(w.x, FT(0)) * of_e_slope;
  }

  void set_slopes(std::size_t i) {
    const std::size_t before = prev(i);
    reconcile_twists(i);
    const Vector_3 n = normals_[i], gap = twist(i, 0) - twist(before, 1);
    // gap = next_part * to_next(i) + prev_part * to_prev(i)
    const FT area = cross_product(to_next(i), to_prev(i)) * n;
    const FT next_part = cross_product(gap, to_prev(i)) * n / area;
    const FT prev_part = cross_product(to_next(i), gap) * n / area;
    ends_[i][0].extra_slope = -next_part / other_side(i, 0).y;
    ends_[before][1].extra_slope = prev_part / other_side(before, 1).y;
  }

  // Moves the inner points next to a corner along the normal, both sides doing half of it.
  void reconcile_twists(std::size_t i) {
    const std::size_t before = prev(i);
    const Vector_3& n = normals_[i];
    const FT difference = (twist(before, 1) - twist(i, 0)) * n;
    const double scale = length(n) * (length(to_next(i)) + length(to_prev(i)));
    const double gap = std::abs(CGAL::to_double(difference)) / scale;
    const double error = (twist_error(before, 1) + twist_error(i, 0)) / scale;
    if (refuse_to_change_ && gap > agreement + error)
      throw Input_error("the twists of the ribbons that meet at corner " + std::to_string(i) +
                        " do not agree: along the two sides the normal turns differently, by " +
                        to_short_text(gap) + " of the lengths of the derivatives");
    for (const std::size_t end : {0, 1}) {
      const std::size_t side = end == 0 ? i : before;
      if (ribbons_[side].degree() < 3) {
        // Its two ends have no inner points of their own.
        if (!(gap > rounding + error))
          continue;
        ribbons_[side] = ribbons_[side].elevated(3);
      }
      const FT rate = other_side(side, end).y * ends_[side][end].alpha *
                      number(ribbons_[side].degree()) * cross_degree() * (n * n);
      const FT half = difference / FT(end == 0 ? 2 : -2);
      move_inner_point(side, end == 0 ? 1 : ribbons_[side].degree() - 1, FT(half / rate) * n);
    }
  }

  // The Bézier coefficients of a product of polynomials.
  static std::vector<Vector_3> product(const std::vector<FT>& f, const std::vector<Vector_3>& g) {
    const std::size_t p = f.size() - 1, q = g.size() - 1;
    const std::vector<FT> of_f = binomials(p), of_g = binomials(q), of_product = binomials(p + q);
    std::vector<Vector_3> result(p + q + 1, Vector_3(FT(0), FT(0), FT(0)));
    for (std::size_t a = 0; a <= p; ++a)
      for (std::size_t b = 0; b <= q; ++b)
        result[a + b] = result[a + b] + FT(of_f[a] * (of_g[b] / of_product[a + b]) * f[a]) * g[b];
    return result;
  }
  static std::vector<FT> binomials(std::size_t n) {
    std::vector<FT> result{FT(1)};
    for (std::size_t k = 0; k < n; ++k)
      result.push_back(result.back() * number(n - k) / number(k + 1));
    return result;
  }

  const Domain& domain_;
  bool refuse_to_change_;
  double point_error_; // of a difference of points: a few roundings of the largest coordinate
  std::vector<Ribbon> ribbons_;
  std::vector<std::array<End, 2>> ends_; // of each side
  std::vector<Vector_3> normals_;        // at each corner, of any length
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_CROSS_DERIVATIVES_H
