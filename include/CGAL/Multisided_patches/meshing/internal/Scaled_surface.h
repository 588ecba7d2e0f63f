// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SCALED_SURFACE_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SCALED_SURFACE_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_2.h>
#include <CGAL/Multisided_patches/meshing/internal/even_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

template <typename Point_2>
std::string text_of_parameters(const Point_2& uv) {
  return "(u,v) = (" + to_short_text(CGAL::to_double(uv.x())) + ", " +
         to_short_text(CGAL::to_double(uv.y())) + ")";
}

// A patch in units in which its boundary has a diagonal of 1, so that areas and volumes neither
// overflow nor vanish, whatever its own units are.
template <typename Patch>
class Scaled_surface {
public:
  using Traits = typename Patch::Geom_traits;
  using Domain = Polygonal_domain_2<Traits>;
  using Location = typename Domain::Location;
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;
  using Point_3 = typename Traits::Point_3;

  explicit Scaled_surface(const Patch& patch)
      : patch_(patch), origin_(patch.point(domain().vertex(0), Location::on_vertex(0))) {
    constexpr std::size_t segments = 16; // a side; the size need not be exact
    Vec3 low{0, 0, 0}, high{0, 0, 0};
    for (std::size_t i = 0; i < domain().size(); ++i)
      for (const double s : even_parameters(segments)) {
        const Point_2 uv = domain().point_on_side(i, FT(s));
        const Vec3 p = position(uv, Location::on_side(i, FT(s)));
        check_finite(p, uv);
        for (int c = 0; c < 3; ++c) {
          low[c] = (std::min)(low[c], p[c]);
          high[c] = (std::max)(high[c], p[c]);
        }
      }
    const double diagonal = norm(difference(high, low));
    if (!(diagonal > 0) || !std::isfinite(diagonal))
      throw Numerical_error("the boundary of the patch has no length that could be divided");
    unit_ = diagonal;
  }

  const Domain& domain() const { return patch_.domain(); }
  // The length that counts as 1 (model units).
  double unit() const { return unit_; }

  // Not checked for being finite: of many points that are evaluated at once, it is always to be the
  // first that is complained about.
  Vec3 position(const Point_2& uv, const Location& location) const {
    const Vec3 v = to_vec3(patch_.point(uv, location) - origin_);
    return {v[0] / unit_, v[1] / unit_, v[2] / unit_};
  }
  static void check_finite(const Vec3& p, const Point_2& uv) {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      throw Numerical_error("the surface is not finite at " + text_of_parameters(uv));
  }

  // Inside the domain.
  Vec3 position(const Uv& uv) const { return position(to_point(uv), Location::interior()); }

  // The unit normal inside the domain; 0 where there is none.
  Vec3 normal(const Uv& uv) const {
    return to_vec3(patch_.point_and_normal(to_point(uv), Location::interior()).second);
  }

private:
  static Point_2 to_point(const Uv& uv) { return Point_2(FT(uv.x), FT(uv.y)); }

  const Patch& patch_;
  Point_3 origin_;
  double unit_ = 1;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SCALED_SURFACE_H
