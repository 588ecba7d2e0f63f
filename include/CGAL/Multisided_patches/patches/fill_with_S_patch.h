// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_FILL_WITH_S_PATCH_H
#define CGAL_MULTISIDED_PATCHES_FILL_WITH_S_PATCH_H

#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/domains/make_regular_domain.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/patches/S_patch_3.h>
#include <CGAL/Multisided_patches/patches/internal/Cross_derivatives.h>
#include <CGAL/Multisided_patches/patches/internal/Free_point_placement.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>
#include <CGAL/Multisided_patches/ribbons/S_patch_net_3.h>
#include <CGAL/Multisided_patches/ribbons/internal/corner_geometry.h>

#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * What `fill_with_S_patch()` does with ribbons that no S-patch meets: because the tangent planes of
 * the two ribbons of a corner differ there, or the tangent planes turn differently along the two
 * sides (their twists are incompatible).
 */
enum class Incompatible_ribbons {
  //! it moves control points of their second rows along the normal of the corner, for the twists
  //! those of both sides by as much; a ribbon of degree 1 or 2 is elevated to 3 for this
  change,
  //! it throws, if the disagreement is more than rounding
  refuse
};

namespace internal {

// The net of an S-patch with prescribed boundary curves and derivatives across its sides.
template <typename Traits>
class S_patch_filler {
public:
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;
  using Loop = Ribbon_loop_3<Traits>;
  using Domain = Polygonal_domain_2<Traits>;
  using Net = S_patch_net_3<Traits>;

  // The largest net that is filled; its free points take minutes.
  static constexpr std::size_t max_control_points = 500000;
  // Domain corners that turn by less (radians) count as straight, as those of loops do: control
  // points move away from the loop with the inverse of the turn.
  static constexpr double min_domain_turn = straight_turn;

  S_patch_filler(const Loop& loop, const Domain& domain, Incompatible_ribbons incompatible)
      : domain_(domain),
        derivatives_(checked(loop, domain), domain, incompatible == Incompatible_ribbons::refuse),
        loop_(derivatives_.ribbons()), depth_(derivatives_.degree() + 3) {
    const std::size_t number = checked_number_of_control_points();
    points_.assign(number, Point_3(ORIGIN));
    is_fixed_.assign(number, false);
    for (std::size_t i = 0; i < loop.size(); ++i)
      set_panels(i);
    // Last, as points of panels on the boundary have been rounded once more.
    for (std::size_t i = 0; i < loop.size(); ++i)
      set_boundary(i);
    std::vector<Point_3> corners;
    for (std::size_t i = 0; i < loop.size(); ++i)
      corners.push_back(loop_.corner_point(i));
    Free_point_placement<Point_3>(corners, depth_, is_fixed_, loop_.diagonal())(points_);
  }

  //! the ribbons that are met
  const Loop& loop() const { return loop_; }
  Net net() const { return Net(loop_.size(), depth_, points_); }

private:
  static const Loop& checked(const Loop& loop, const Domain& domain) {
    if (domain.size() != loop.size() || domain.number_of_loops() != 1)
      throw Input_error("the domain of a patch with " + std::to_string(loop.size()) +
                        " sides needs as many vertices in one loop, not " +
                        std::to_string(domain.size()));
    for (std::size_t i = 0; i < domain.size(); ++i) {
      if (loop.corner_type(i) == Corner_type::straight)
        throw straight_corner(i, "loop");
      if (turn(domain, i) < min_domain_turn)
        throw straight_corner(i, "domain");
    }
    return loop;
  }

  static Input_error straight_corner(std::size_t i, const std::string& owner) {
    return Input_error("corner " + std::to_string(i) + " of the " + owner +
                       " is straight, or turns by less than 1 degree; an S-patch cannot be fitted "
                       "to the ribbons that meet there");
  }

  // The angle between the side of the domain that arrives at vertex i and the one that leaves.
  static double turn(const Domain& domain, std::size_t i) {
    const auto side = [&](std::size_t k) {
      const auto d = domain.vertex(domain.next(k)) - domain.vertex(k);
      return normalized({CGAL::to_double(d.x()), CGAL::to_double(d.y()), 0});
    };
    return angle_between(side(domain.prev(i)), side(i));
  }

  std::size_t checked_number_of_control_points() const {
    const std::size_t number = Net::number_of_control_points(loop_.size(), depth_);
    if (number > max_control_points)
      throw Input_error("to fill a loop with " + std::to_string(loop_.size()) +
                        " sides by an S-patch of depth " + std::to_string(depth_) + " takes " +
                        std::to_string(number) + " control points, more than " +
                        std::to_string(max_control_points));
    return number;
  }

  // the control points of boundary curve i, elevated to the depth
  std::vector<Point_3> boundary(std::size_t i) const {
    const Bezier_ribbon_3<Traits> elevated = loop_[i].elevated(depth_);
    return {elevated.control_points().begin(), elevated.control_points().begin() + depth_ + 1};
  }

  // the index (d - 1 - j) e_i + j e_{i+1} + e_k
  Multi_index panel_index(std::size_t i, std::size_t j, std::size_t k) const {
    Multi_index index(loop_.size(), 0);
    index[i] = depth_ - 1 - j;
    index[domain_.next(i)] = j;
    ++index[k];
    return index;
  }

  void set(const Multi_index& index, const Point_3& p) {
    const std::size_t rank = rank_of_multi_index(index);
    points_[rank] = p;
    is_fixed_[rank] = true;
  }

  void set_panels(std::size_t i) {
    const std::vector<Point_3> points = boundary(i);
    const std::vector<Vector_3> across = derivatives_.coefficients(i);
    const FT scale = FT(1) / FT(static_cast<int>(depth_));
    for (std::size_t k = 0; k < loop_.size(); ++k) {
      if (k == i || k == domain_.next(i))
        continue;
      const Side_coordinates<FT> v = side_coordinates(domain_, i, i, k);
      for (std::size_t j = 0; j < depth_; ++j)
        set(panel_index(i, j, k),
            points[j] + v.x * (points[j + 1] - points[j]) + FT(v.y * scale) * across[j]);
    }
  }

  void set_boundary(std::size_t i) {
    const std::vector<Point_3> points = boundary(i);
    for (std::size_t j = 0; j < depth_; ++j)
      set(panel_index(i, j, i), points[j]);
  }

  const Domain& domain_;
  Cross_derivatives<Traits> derivatives_;
  Loop loop_;
  std::size_t depth_;
  std::vector<Point_3> points_;
  std::vector<bool> is_fixed_;
};

} // namespace internal

/*!
 * fills a loop of ribbons with an S-patch that has their boundary curves and tangent planes.
 *
 * The depth is m + 3 for ribbons of degree up to m, as in Salvi, *G¹ hole filling with S-patches
 * made easy*, 2019. What fixes the boundary there holds for any domain and any coordinates λ with
 * derivatives on its sides, as follows.
 *
 * Let P_j, j = 0..d be the control points of side i, elevated to the depth d. Along the side, where
 * λ_i = 1 - t, λ_{i+1} = t and the other λ_k = 0, the derivative of the patch in a direction w is
 * d Σ_j B^{d-1}_j(t) Σ_k ∂λ_k/∂w P_{j,k} with the *panels* P_{j,k}, the control points with the
 * indices (d - 1 - j) e_i + j e_{i+1} + e_k: one for each vertex v_k of the domain. If panel j is
 * the image of the domain by an affine map with linear part A_j, then Σ_k ∂λ_k/∂w P_{j,k} = A_j w,
 * because Σ λ_k v_k is the point of the domain. So the derivative is the polynomial
 * d Σ_j B^{d-1}_j(t) A_j w, whatever the coordinates are. A_j maps the side v_{i+1} - v_i to
 * P_{j+1} - P_j, as it must for the boundary curve. The image of the inward normal of the side is
 * free: it is taken from a polynomial derivative across the side, of degree d - 1, that lies in the
 * tangent planes of the ribbon.
 *
 * That polynomial is α R_h + β R_s, for a ribbon R with parameters s along the side and h across
 * it. At a corner it has to fit the boundary curve of the neighbouring side, which determines α and
 * β there. Panels of the two sides share one more control point, with the index
 * e_{i-1} + (d - 2) e_i + e_{i+1}, and have to agree on it: that is the equation of the mixed
 * derivatives by both directions. In the tangent plane it is satisfied by the slopes of β. Along
 * the normal it is a condition on the ribbons. So α is linear and β cubic; the product with R_s, of
 * degree m - 1, has degree m + 2 = d - 1. (Salvi takes a quadratic α and a linear β, on a regular
 * domain and for ribbons that share the control points of their corners.)
 *
 * The other control points, inside, minimize a discrete biharmonic energy of the net, as in that
 * paper; here it is that of the displacements from the patch of depth 1 through the corners. So
 * boundary curves that are an affine image of the sides of the domain, with second rows in the same
 * plane and parallel to them, are filled with that affine image of the domain.
 *
 * \param loop ribbons with at least 2 layers, of which the first derivatives across the side count
 * \param coordinates coordinates with one vertex for each ribbon, on a domain whose corners are
 * reflex where those of the loop are
 * \param incompatible what to do with ribbons that no S-patch meets
 *
 * \return the patch; its `loop()` has the ribbons that it meets, with 2 layers. Its `net()` does
 * not have them: pass `loop()` on to a patch of the net when that has been elevated, or read back
 * from a file
 *
 * \throws Input_error if a ribbon has a single layer, or does not lead inwards at its ends as its
 * neighbours do; if a corner of the loop or of the domain is straight or turns by less than 1
 * degree; if the numbers of vertices and ribbons differ; if the depth is beyond that of
 * `S_patch_net_3`; or if the net would have more than 500,000 control points, as for ribbons of
 * degree 3 on more than 24 sides
 * \throws Numerical_error if the equations of the inner control points cannot be solved
 *
 * Complexity: there are N = (n + d - 1 choose d) control points for n sides and depth d. The inner
 * ones take the time: conjugate gradients, of O(N min(n, d)) for each iteration. The number of
 * iterations grows, too, about as n² for a given depth; so the time grows faster than N, and nearly
 * as N² once the caches are too small. Ribbons of degree 3 are practical up to about 16 sides,
 * where N is 54,264, in seconds; with 20 sides and 177,100 points they take tens of seconds, with
 * 24 and 475,020 more than a minute. As many points with few sides and a great depth take longer
 * still.
 */
template <typename Traits, typename Coordinates>
S_patch_3<Traits, Coordinates>
fill_with_S_patch(const Ribbon_loop_3<Traits>& loop, const Coordinates& coordinates,
                  Incompatible_ribbons incompatible = Incompatible_ribbons::change) {
  const internal::S_patch_filler<Traits> filler(loop, coordinates.domain(), incompatible);
  return S_patch_3<Traits, Coordinates>(filler.net(), filler.loop(), coordinates);
}

/*!
 * the same with Wachspress coordinates on a regular polygon.
 *
 * \throws Input_error in addition, if a corner of the loop is reflex
 */
template <typename Traits>
S_patch_3<Traits>
fill_with_S_patch(const Ribbon_loop_3<Traits>& loop,
                  Incompatible_ribbons incompatible = Incompatible_ribbons::change) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (loop.corner_type(i) == Corner_type::reflex)
      throw Input_error("corner " + std::to_string(i) +
                        " is reflex; to fill such a loop, pass coordinates on a concave domain");
  return fill_with_S_patch(
      loop, Wachspress_coordinates_2<Traits>(make_regular_domain<Traits>(loop.size())),
      incompatible);
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_FILL_WITH_S_PATCH_H
