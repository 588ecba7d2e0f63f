// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_POLYGONAL_DOMAIN_2_H
#define CGAL_MULTISIDED_PATCHES_POLYGONAL_DOMAIN_2_H

#include <CGAL/Multisided_patches/domains/Domain_location.h>
#include <CGAL/Multisided_patches/domains/internal/polygon_checks.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/ribbons/Corner_type.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * A polygon, possibly with holes, in the (u,v) plane: the domain of a patch.
 *
 * The outer loop runs counterclockwise and the holes clockwise, so that the interior is always on
 * the left. The vertices of all loops are numbered through, the outer loop first; side `i` runs
 * from vertex `i` to vertex `next(i)`, as in `CGAL::Polygon_2::edge(i)`. A domain is valid from its
 * construction on, and never changes: every loop is simple, has no side of length zero and the
 * right orientation, the loops do not touch each other and the holes lie inside the outer loop and
 * outside each other. All of this is decided with the predicates of the traits class, which
 * therefore must be exact.
 *
 * \tparam Traits a CGAL kernel with exact predicates
 */
template <typename Traits>
class Polygonal_domain_2 {
public:
  using Geom_traits = Traits;
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;
  using Vector_2 = typename Traits::Vector_2;
  using Segment_2 = typename Traits::Segment_2;
  using Location = Domain_location<FT>;

  static_assert(Traits::Has_filtered_predicates || Algebraic_structure_traits<FT>::Is_exact::value,
                "domains need a kernel with exact predicates, such as "
                "CGAL::Exact_predicates_inexact_constructions_kernel");

  /*!
   * checks and stores a polygon.
   *
   * \param outer the vertices of the outer loop, counterclockwise, at least 3 (domain units)
   * \param holes the vertices of each hole, clockwise, at least 3 a hole
   *
   * \throws Input_error if the loops do not bound a valid domain; the message names the offending
   * vertex, side or loop
   *
   * Complexity: O(n log n) for n vertices and one loop; every hole adds a comparison with all sides
   * of the other loops.
   */
  explicit Polygonal_domain_2(std::vector<Point_2> outer,
                              const std::vector<std::vector<Point_2>>& holes = {})
      : vertices_(std::move(outer)), loop_begins_{0, vertices_.size()} {
    for (const std::vector<Point_2>& hole : holes) {
      vertices_.insert(vertices_.end(), hole.begin(), hole.end());
      loop_begins_.push_back(vertices_.size());
    }
    internal::check_polygon_with_holes<Traits>(vertices_, loop_begins_);
    loop_of_.reserve(size());
    for (std::size_t loop = 0; loop < number_of_loops(); ++loop)
      loop_of_.resize(loop_begins_[loop + 1], loop);
  }

  //! the number of vertices, which is that of sides, of all loops
  std::size_t size() const { return vertices_.size(); }
  //! 1 + the number of holes
  std::size_t number_of_loops() const { return loop_begins_.size() - 1; }
  //! the index of the first vertex of a loop; `loop == number_of_loops()` gives `size()`
  std::size_t loop_begin(std::size_t loop) const { return loop_begins_[loop]; }

  const Point_2& vertex(std::size_t i) const { return vertices_[i]; }
  const std::vector<Point_2>& vertices() const { return vertices_; }

  //! the vertex (and side) that follows `i` in its loop
  std::size_t next(std::size_t i) const {
    const std::size_t loop = loop_of_[i];
    return i + 1 == loop_begins_[loop + 1] ? loop_begins_[loop] : i + 1;
  }
  //! the vertex (and side) that precedes `i` in its loop
  std::size_t prev(std::size_t i) const {
    const std::size_t loop = loop_of_[i];
    return i == loop_begins_[loop] ? loop_begins_[loop + 1] - 1 : i - 1;
  }

  Segment_2 side(std::size_t i) const { return Segment_2(vertex(i), vertex(next(i))); }
  /*!
   * the point at parameter `s` in [0,1] of side `i`. With inexact arithmetic it is rounded, and
   * then lies inside or outside as likely as on the side; `location_on_side()` says where it is
   * meant to be.
   */
  Point_2 point_on_side(std::size_t i, const FT& s) const {
    const Point_2 &a = vertex(i), &b = vertex(next(i));
    return Point_2((FT(1) - s) * a.x() + s * b.x(), (FT(1) - s) * a.y() + s * b.y());
  }
  //! the location of the point at parameter `s` in [0,1] of side `i`, a vertex if `s` is 0 or 1
  Location location_on_side(std::size_t i, const FT& s) const {
    CGAL_precondition(FT(0) <= s && s <= FT(1));
    return s == FT(0)   ? Location::on_vertex(i)
           : s == FT(1) ? Location::on_vertex(next(i))
                        : Location::on_side(i, s);
  }
  //! the length of side `i` (domain units)
  double side_length(std::size_t i) const {
    const Vector_2 d = vertex(next(i)) - vertex(i);
    return std::hypot(CGAL::to_double(d.x()), CGAL::to_double(d.y()));
  }

  //! how the boundary turns at vertex `i`, decided exactly
  Corner_type corner_type(std::size_t i) const {
    switch (orientation(vertex(prev(i)), vertex(i), vertex(next(i)))) {
    case LEFT_TURN:
      return Corner_type::convex;
    case RIGHT_TURN:
      return Corner_type::reflex;
    default:
      return Corner_type::straight;
    }
  }
  //! whether the domain has no hole and every corner is convex; a straight corner spoils it
  bool is_strictly_convex() const {
    bool convex = number_of_loops() == 1;
    for (std::size_t i = 0; convex && i < size(); ++i)
      convex = corner_type(i) == Corner_type::convex;
    return convex;
  }

  //! the area enclosed (squared domain units)
  FT area() const {
    const Point_2& o = vertex(0);
    FT twice(0);
    for (std::size_t i = 0; i < size(); ++i) {
      const Vector_2 a = vertex(i) - o, b = vertex(next(i)) - o;
      twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / FT(2);
  }
  //! the diagonal of the bounding box (domain units)
  double diameter() const {
    const Bbox_2 box = bbox();
    return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  }
  Bbox_2 bbox() const {
    Bbox_2 box = vertex(0).bbox();
    for (const Point_2& p : vertices_)
      box += p.bbox();
    return box;
  }

  /*!
   * the smallest distance between two sides that share no vertex (domain units); infinity for a
   * triangle, which has none. Complexity: O(n²).
   */
  double clearance() const {
    double squared = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < size(); ++i)
      for (std::size_t j = i + 1; j < size(); ++j)
        if (next(i) != j && next(j) != i)
          squared = (std::min)(squared, CGAL::to_double(squared_distance(side(i), side(j))));
    return std::sqrt(squared);
  }

  /*!
   * tells where `p` lies: inside, outside, at a vertex or on a side, decided exactly. The parameter
   * on a side is computed with the arithmetic of `FT`. A point that is not finite is outside.
   *
   * Complexity: O(n), without division.
   */
  Location locate(const Point_2& p) const {
    if (!CGAL::is_finite(p.x()) || !CGAL::is_finite(p.y()))
      return Location::outside();
    bool inside = false;
    for (std::size_t i = 0; i < size(); ++i) {
      const Point_2 &a = vertex(i), &b = vertex(next(i));
      if (p == a)
        return Location::on_vertex(i);
      const Comparison_result ya = compare(a.y(), p.y()), yb = compare(b.y(), p.y());
      if (ya == EQUAL && yb == EQUAL) {
        if (compare(a.x(), p.x()) * compare(b.x(), p.x()) == SMALLER)
          return Location::on_side(i, parameter_on_side(i, p));
        continue;
      }
      if (ya == yb || compare(a.y(), p.y()) * compare(b.y(), p.y()) == LARGER)
        continue;
      const Orientation turn = orientation(a, b, p);
      if (turn == COLLINEAR && p != b)
        return Location::on_side(i, parameter_on_side(i, p));
      // A ray to the right crosses the half-open side [lower, upper).
      const bool upward = ya != LARGER && yb == LARGER;
      const bool downward = yb != LARGER && ya == LARGER;
      if ((upward && turn == LEFT_TURN) || (downward && turn == RIGHT_TURN))
        inside = !inside;
    }
    return inside ? Location::interior() : Location::outside();
  }

  //! the same for a point that must not be outside. \throws Outside_domain_error if it is
  Location locate_inside(const Point_2& p) const {
    const Location location = locate(p);
    if (location.kind == Location::Kind::outside)
      throw Outside_domain_error(
          "the point (" + internal::to_short_text(CGAL::to_double(p.x())) + ", " +
          internal::to_short_text(CGAL::to_double(p.y())) +
          ") lies outside the domain; a point on a side needs its location, as it is rounded");
    return location;
  }

private:
  FT parameter_on_side(std::size_t i, const Point_2& p) const {
    const Vector_2 d = vertex(next(i)) - vertex(i), e = p - vertex(i);
    return CGAL::abs(d.x()) < CGAL::abs(d.y()) ? FT(e.y() / d.y()) : FT(e.x() / d.x());
  }

  std::vector<Point_2> vertices_;
  std::vector<std::size_t> loop_begins_; // and one past the last loop
  std::vector<std::size_t> loop_of_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_POLYGONAL_DOMAIN_2_H
