// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_RIBBON_LOOP_3_H
#define CGAL_MULTISIDED_PATCHES_RIBBON_LOOP_3_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/ribbons/Bezier_ribbon_3.h>
#include <CGAL/Multisided_patches/ribbons/Corner_type.h>
#include <CGAL/Multisided_patches/ribbons/internal/corner_geometry.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The ribbons around one hole, in order, with the surface on their left.
 *
 * Ribbon `i` starts at corner `i` and ends at corner `next(i)`. Adjacent ribbons may differ in
 * degree and in their number of layers. A loop is checked at its construction and never changes.
 *
 * A corner is *convex*, *reflex* or *straight* according to the turn from the end tangent of the
 * ribbon that arrives to the start tangent of the one that leaves, seen from the side to which the
 * surface normal points; the normal comes from the cross-derivatives of the two ribbons or, where
 * neither has any, from the area vector of the whole boundary. A turn of less than one degree is
 * straight.
 *
 * \tparam Traits a CGAL kernel
 */
template <typename Traits>
class Ribbon_loop_3 {
public:
  using Geom_traits = Traits;
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;
  using Ribbon = Bezier_ribbon_3<Traits>;

  //! The sizes of loops between which squares of lengths neither vanish nor overflow.
  static constexpr double min_diagonal = 1e-152, max_diagonal = 1e152;

  /*!
   * checks and stores the ribbons of a loop.
   *
   * \param ribbons at least 3 ribbons; the last point of row 0 of each is the first of the next one
   * \param relative_tolerance how far two points that should be the same corner may be apart, as a
   * fraction of the diagonal of the bounding box; the end of the earlier ribbon is moved onto the
   * start of the later one, so that the loop closes exactly
   *
   * \throws Input_error if there are fewer than 3 ribbons, the loop does not close, the boundary
   * curve of a side is a single point, or the size of the loop is out of range
   */
  explicit Ribbon_loop_3(std::vector<Ribbon> ribbons, double relative_tolerance = 1e-9)
      : ribbons_(std::move(ribbons)) {
    if (size() < 3)
      throw Input_error("a loop needs at least 3 ribbons, not " + std::to_string(size()));
    measure();
    for (std::size_t i = 0; i < size(); ++i)
      close_corner(i, relative_tolerance * diagonal());
    measure(); // a corner that was closed may have shrunk the bounding box
    for (std::size_t i = 0; i < size(); ++i)
      if (internal::norm(internal::start_direction(ribbons_[i])) == 0)
        throw Input_error("the boundary curve of side " + std::to_string(i) +
                          " is a single point: all its control points coincide");
    const internal::Vec3 up = area_vector();
    for (std::size_t i = 0; i < size(); ++i)
      corners_.push_back(internal::corner_geometry(ribbons_[prev(i)], ribbons_[i], up));
  }

  //! the number of ribbons, which is that of corners
  std::size_t size() const { return ribbons_.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  std::size_t prev(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }

  const Ribbon& operator[](std::size_t i) const { return ribbons_[i]; }
  const std::vector<Ribbon>& ribbons() const { return ribbons_; }

  //! the point where ribbon `prev(i)` ends and ribbon `i` starts
  const Point_3& corner_point(std::size_t i) const { return ribbons_[i].control_point(0, 0); }
  Corner_type corner_type(std::size_t i) const { return corners_[i].type; }
  //! the interior angle at corner `i`, between the end tangents (radians, in [0,2π]; at a cusp 0 or
  //! 2π)
  double corner_angle(std::size_t i) const { return corners_[i].angle; }
  //! the unit normal at corner `i`, or the zero vector if neither ribbon has cross-derivatives
  //! there
  Vector_3 corner_normal(std::size_t i) const {
    const internal::Vec3& n = corners_[i].normal;
    return Vector_3(FT(n[0]), FT(n[1]), FT(n[2]));
  }
  /*!
   * the angle between the tangent planes that the two ribbons of corner `i` give there (radians, in
   * [0,π]); 0 if one of them gives none. A patch can meet both only if it is 0.
   */
  double corner_normal_mismatch(std::size_t i) const { return corners_[i].normal_mismatch; }
  //! the number of corners of a type
  std::size_t number_of_corners(Corner_type type) const {
    std::size_t count = 0;
    for (const internal::Corner_geometry& c : corners_)
      count += c.type == type;
    return count;
  }

  //! the bounding box of all control points (model units)
  const Bbox_3& bbox() const { return bbox_; }
  //! the diagonal of the bounding box (model units), between `min_diagonal` and `max_diagonal`
  double diagonal() const {
    return internal::norm(
        {bbox_.xmax() - bbox_.xmin(), bbox_.ymax() - bbox_.ymin(), bbox_.zmax() - bbox_.zmin()});
  }

  /*!
   * the same loop with control point C_{j,k} of ribbon `i` at `p` (model units).
   *
   * What the neighbours have in common with it moves along: of ribbon `next(i)` control point
   * C_{k,d-j} for the degree d of ribbon `i`, and of ribbon `prev(i)`, with its degree e,
   * C_{e-k,j}, where these are the same point, bit for bit. At a corner of the loop they always
   * are. Next to corners they are where the ribbons come from a control net of odd degree or share
   * their points in the same way, and then tangent planes that agree at corners go on to do so.
   * Elsewhere they may not, which `corner_normal_mismatch()` tells. To move a point of one ribbon
   * only, change that with `Bezier_ribbon_3::with_control_point()` and make a new loop.
   *
   * \pre `j` and `k` are in the range of ribbon `i`
   *
   * \throws Input_error if `p` is not finite, or there is no such loop
   *
   * Complexity: linear in the number of control points.
   */
  Ribbon_loop_3 with_control_point(std::size_t i, std::size_t j, std::size_t k,
                                   const Point_3& p) const {
    CGAL_precondition(i < size());
    const Point_3 old = ribbons_[i].control_point(j, k);
    std::vector<Ribbon> ribbons(ribbons_);
    if (old != p)
      move_shared_point(ribbons, i, j, k, old, p);
    return Ribbon_loop_3(std::move(ribbons));
  }

private:
  // Moves C_{j,k} of ribbon i, if that is the point `old`, and what the neighbours share of it.
  // Each place is changed once, as it is not `old` any more.
  void move_shared_point(std::vector<Ribbon>& ribbons, std::size_t i, std::size_t j, std::size_t k,
                         const Point_3& old, const Point_3& p) const {
    const std::size_t degree = ribbons[i].degree(), before = ribbons[prev(i)].degree();
    if (j > degree || k >= ribbons[i].layers() || ribbons[i].control_point(j, k) != old)
      return;
    ribbons[i] = ribbons[i].with_control_point(j, k, p);
    move_shared_point(ribbons, next(i), k, degree - j, old, p);
    if (k <= before)
      move_shared_point(ribbons, prev(i), before - k, j, old, p);
  }

  void measure() {
    bbox_ = Bbox_3();
    for (const Ribbon& r : ribbons_)
      for (const Point_3& p : r.control_points())
        bbox_ += p.bbox();
    if (!(diagonal() > min_diagonal && diagonal() < max_diagonal))
      throw Input_error("the control points are too far apart or too close to each other: the "
                        "diagonal of their bounding box is " +
                        internal::to_short_text(diagonal()) + ", not between 1e-152 and 1e152");
  }

  void close_corner(std::size_t i, double tolerance) {
    const Ribbon& r = ribbons_[i];
    const Point_3& start = corner_point(next(i));
    const Point_3& end = r.control_point(r.degree(), 0);
    if (end == start)
      return;
    const double gap = internal::norm(internal::to_vec3(start - end));
    if (!(gap <= tolerance))
      throw Input_error("the loop does not close: side " + std::to_string(i) + " ends at " +
                        text(end) + ", " + internal::to_short_text(gap) +
                        " away from the start of side " + std::to_string(next(i)) + " at " +
                        text(start) + hint(i));
    std::vector<Point_3> points = r.control_points();
    points[r.degree()] = start;
    ribbons_[i] = Ribbon(r.degree(), r.layers(), std::move(points));
  }

  static std::string text(const Point_3& p) {
    return '(' + internal::to_short_text(CGAL::to_double(p.x())) + ", " +
           internal::to_short_text(CGAL::to_double(p.y())) + ", " +
           internal::to_short_text(CGAL::to_double(p.z())) + ')';
  }

  const Point_3& end_point(std::size_t i) const {
    return ribbons_[i].control_point(ribbons_[i].degree(), 0);
  }

  // Whether every side begins where the next one ends.
  bool is_in_reverse_order() const {
    for (std::size_t i = 0; i < size(); ++i)
      if (corner_point(i) != end_point(next(i)))
        return false;
    return true;
  }

  // What is likely to be wrong with a side and the next one, which do not follow each other.
  std::string hint(std::size_t i) const {
    const Ribbon& next = ribbons_[this->next(i)];
    const Point_3 &end = end_point(i), &next_end = next.control_point(next.degree(), 0);
    if (end == next_end)
      return "; the second of them seems to run the other way";
    if (is_in_reverse_order())
      return "; the sides seem to come in clockwise order";
    if (corner_point(i) == next_end)
      return "; the second of them ends where the first one starts, as if they were swapped";
    if (end == next.control_point(0, next.layers() - 1) && next.layers() > 1)
      return "; the second of them seems to have its rows in reverse, the boundary is row 0";
    return "; control points come row by row, the boundary first";
  }

  // Newell's area vector of the closed control polygon of the boundary: the side on which the
  // boundary runs counterclockwise on the whole.
  internal::Vec3 area_vector() const {
    internal::Vec3 area{0, 0, 0};
    const Point_3& origin = corner_point(0);
    for (const Ribbon& r : ribbons_)
      for (std::size_t j = 0; j < r.degree(); ++j) {
        const internal::Vec3 a = internal::to_vec3(r.control_point(j, 0) - origin),
                             b = internal::to_vec3(r.control_point(j + 1, 0) - origin);
        area = internal::sum(area, internal::cross(a, b));
      }
    return internal::normalized(area);
  }

  std::vector<Ribbon> ribbons_;
  std::vector<internal::Corner_geometry> corners_;
  Bbox_3 bbox_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_RIBBON_LOOP_3_H
