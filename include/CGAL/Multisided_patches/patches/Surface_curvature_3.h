// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_SURFACE_CURVATURE_3_H
#define CGAL_MULTISIDED_PATCHES_SURFACE_CURVATURE_3_H

#include <CGAL/Multisided_patches/patches/internal/surface_derivatives.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The curvatures of a surface at one point, where it has a tangent plane. Curvatures are in 1 /
 * model units, the Gaussian one in 1 / squared model units. They are positive where the surface
 * bends towards its normal: a sphere of radius r has the curvatures -1/r if the normal points
 * outwards.
 *
 * All computations are in `double`. They start from the shape operator in an orthonormal basis of
 * the tangent plane (do Carmo, *Differential Geometry of Curves and Surfaces*, 1976, section 3.2),
 * a symmetric matrix (p q; q r), whose eigenvalues (p + r)/2 ± hypot((p - r)/2, q) are free of the
 * cancellation in H ± √(H² - K). Their errors are some rounding errors of the larger one.
 *
 * \tparam Traits a CGAL kernel
 */
template <typename Traits>
class Surface_curvature_3 {
public:
  using FT = typename Traits::FT;
  using Vector_2 = typename Traits::Vector_2;
  using Vector_3 = typename Traits::Vector_3;

  /*!
   * computes the curvatures from derivatives; users get them from `surface_geometry()`.
   *
   * \pre `normal` is the unit normal of the plane that the first derivatives span
   */
  Surface_curvature_3(const internal::Surface_derivatives& derivatives,
                      const internal::Vec3& normal)
      : frame_(derivatives, normal), shape_(derivatives, normal, frame_) {
    const double half_difference = (shape_.p - shape_.r) / 2;
    const double radius = std::hypot(half_difference, shape_.q);
    max_ = mean() + radius;
    min_ = mean() - radius;
    // The one closer to 0 follows from the product: where that is 0, so is the curvature.
    if (mean() > 0)
      min_ = (std::min)(gaussian() / max_, max_);
    else if (mean() < 0)
      max_ = (std::max)(gaussian() / min_, min_);
    const double angle = std::atan2(shape_.q, half_difference) / 2;
    cos_ = std::cos(angle);
    sin_ = std::sin(angle);
  }

  //! the mean curvature H = (k1 + k2) / 2
  double mean() const { return (shape_.p + shape_.r) / 2; }
  //! the Gaussian curvature K = k1 k2
  double gaussian() const {
    // p r - q², with the rounding errors of the products put back in: Kahan's algorithm.
    const double square = shape_.q * shape_.q, error = std::fma(-shape_.q, shape_.q, square);
    return std::fma(shape_.p, shape_.r, -square) + error;
  }
  //! the larger principal curvature, k1
  double max_curvature() const { return max_; }
  //! the smaller principal curvature, k2
  double min_curvature() const { return min_; }

  /*!
   * the principal direction of k1, a unit tangent vector. It is determined up to its sign, and at
   * an umbilic (k1 = k2) any tangent vector would do.
   */
  Vector_3 max_direction() const { return in_space(cos_, sin_); }
  //! that of k2: `max_direction()` turned by a right angle, counterclockwise as seen from the tip
  //! of the normal
  Vector_3 min_direction() const { return in_space(-sin_, cos_); }

  //! the principal directions in the (u,v) plane, also of unit length: the surface takes them to
  //! positive multiples of `max_direction()` and `min_direction()`
  Vector_2 max_parameter_direction() const { return in_plane(cos_, sin_); }
  Vector_2 min_parameter_direction() const { return in_plane(-sin_, cos_); }

  /*!
   * the normal curvature in a direction: that of the curve in which the plane through the normal
   * and the direction cuts the surface.
   *
   * \param direction a vector of any length; only its component in the tangent plane counts
   *
   * \pre `direction` is not parallel to the normal
   */
  double normal_curvature(const Vector_3& direction) const {
    const internal::Vec3 d = internal::to_vec3(direction);
    return normal_curvature(internal::dot(d, frame_.e1), internal::dot(d, frame_.e2));
  }
  //! the same for a direction in the (u,v) plane. \pre it is not the zero vector
  double normal_curvature(const Vector_2& direction) const {
    const double u = CGAL::to_double(direction.x()), v = CGAL::to_double(direction.y());
    return normal_curvature(frame_.a * u + frame_.b * v, frame_.c * v);
  }

private:
  double normal_curvature(double x, double y) const {
    CGAL_precondition(x != 0 || y != 0);
    return shape_.normal_curvature(x, y);
  }

  Vector_3 in_space(double x, double y) const {
    const auto coordinate = [&](std::size_t c) { return FT(x * frame_.e1[c] + y * frame_.e2[c]); };
    return Vector_3(coordinate(0), coordinate(1), coordinate(2));
  }

  Vector_2 in_plane(double x, double y) const {
    const double v = y / frame_.c, u = (x - frame_.b * v) / frame_.a, length = std::hypot(u, v);
    return Vector_2(FT(u / length), FT(v / length));
  }

  internal::Tangent_frame frame_;
  internal::Shape_operator shape_;
  double max_, min_;
  double cos_, sin_; // of the angle from e1 to the direction of max_
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_SURFACE_CURVATURE_3_H
