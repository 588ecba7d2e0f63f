// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MAKE_PROJECTED_DOMAIN_H
#define CGAL_MULTISIDED_PATCHES_MAKE_PROJECTED_DOMAIN_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/domains/internal/polygon_shape.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cstddef>

namespace CGAL {
namespace Multisided_patches {

/*!
 * projects the corner points of a loop onto their least-squares plane, from the side from which
 * they run counterclockwise.
 *
 * \return the domain, in the unit square
 * \throws Input_error if the projected polygon is not simple or has a side of length zero
 */
template <typename Traits>
Polygonal_domain_2<Traits> make_projected_domain(const Ribbon_loop_3<Traits>& loop) {
  const auto n = static_cast<Eigen::Index>(loop.size());
  Eigen::MatrixX3d corners(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const internal::Vec3 p =
        internal::to_vec3(loop.corner_point(static_cast<std::size_t>(i)) - loop.corner_point(0));
    corners.row(i) = Eigen::RowVector3d(p[0], p[1], p[2]);
  }
  corners.rowwise() -= corners.colwise().mean().eval();
  // The plane is spanned by the two directions in which the corners spread most; dividing by the
  // size keeps the squares in range.
  const double size = corners.cwiseAbs().maxCoeff();
  if (!(size > 0))
    throw Input_error("all corner points coincide");
  corners /= size;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(corners.transpose() * corners);
  const Eigen::MatrixX2d planar = corners * solver.eigenvectors().rightCols(2);

  internal::Polygon polygon;
  double twice_area = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index j = i + 1 == n ? 0 : i + 1;
    polygon.push_back({planar(i, 0), planar(i, 1)});
    twice_area += planar(i, 0) * planar(j, 1) - planar(i, 1) * planar(j, 0);
  }
  if (twice_area < 0)
    for (internal::Vec2& p : polygon)
      p[1] = -p[1];
  return Polygonal_domain_2<Traits>(internal::to_unit_box<Traits>(polygon));
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MAKE_PROJECTED_DOMAIN_H
