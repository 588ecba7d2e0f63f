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

#include <algorithm>
#include <cstddef>
#include <vector>

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
  std::vector<Eigen::Vector3d> corners;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const internal::Vec3 p = internal::to_vec3(loop.corner_point(i) - loop.corner_point(0));
    corners.emplace_back(p[0], p[1], p[2]);
    mean += corners.back() / static_cast<double>(loop.size());
  }
  double size = 0;
  for (Eigen::Vector3d& p : corners) {
    p -= mean;
    size = (std::max)(size, p.cwiseAbs().maxCoeff());
  }
  if (!(size > 0))
    throw Input_error("all corner points coincide");
  // The plane is spanned by the two directions in which the corners spread most; dividing by the
  // size keeps the squares in range.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (Eigen::Vector3d& p : corners) {
    p /= size;
    covariance += p * p.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d u = solver.eigenvectors().col(2), v = solver.eigenvectors().col(1);

  internal::Polygon polygon;
  double twice_area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    polygon.push_back({corners[i].dot(u), corners[i].dot(v)});
    const Eigen::Vector3d& next = corners[loop.next(i)];
    twice_area += polygon[i][0] * next.dot(v) - polygon[i][1] * next.dot(u);
  }
  if (twice_area < 0)
    for (internal::Vec2& p : polygon)
      p[1] = -p[1];
  return Polygonal_domain_2<Traits>(internal::to_unit_box<Traits>(polygon));
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MAKE_PROJECTED_DOMAIN_H
