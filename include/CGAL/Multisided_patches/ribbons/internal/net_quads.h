// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_NET_QUADS_H
#define CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_NET_QUADS_H

#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/ribbons/Generalized_bezier_net_3.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

/*
 * The net of n sides of degree d seen as n quads: that of corner i has the points (a,b), a and b
 * from 0 to ⌊d/2⌋, where a counts from the corner along side i and b inwards from it, which is from
 * the corner back along side i-1. For even d adjacent quads share the middle column of a side, and
 * all of them the central point, (d/2,d/2).
 */
template <typename Traits>
const typename Traits::Point_3& quad_point(const Generalized_bezier_net_3<Traits>& net,
                                           std::size_t corner, std::size_t a, std::size_t b) {
  const std::size_t d = net.degree(), l = net.layers();
  CGAL_precondition(2 * a <= d && 2 * b <= d);
  if (b < l)
    return net.control_point(corner, a, b);
  if (a < l)
    return net.control_point(net.prev(corner), d - b, a);
  return net.central_point();
}

// The net whose points are point(corner,a,b), and the central one. Middle columns are taken from
// the corner where their side starts.
template <typename Traits, typename Point>
Generalized_bezier_net_3<Traits> net_from_quads(std::size_t n, std::size_t d, const Point& point,
                                                const typename Traits::Point_3& central_point) {
  std::vector<typename Traits::Point_3> points;
  points.reserve(Generalized_bezier_net_3<Traits>::number_of_control_points(n, d));
  for (std::size_t k = 0; k < (d + 1) / 2; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = k; j < d - k; ++j)
        points.push_back(2 * j <= d ? point(i, j, k) : point(i + 1 == n ? 0 : i + 1, k, d - j));
  points.push_back(central_point);
  return Generalized_bezier_net_3<Traits>(n, d, std::move(points));
}

template <typename Traits>
Generalized_bezier_net_3<Traits> with_central_point(const Generalized_bezier_net_3<Traits>& net,
                                                    const typename Traits::Point_3& central_point) {
  std::vector<typename Traits::Point_3> points = net.control_points();
  points.back() = central_point;
  return net.with_control_points(std::move(points));
}

// The mean of the points of the innermost row.
template <typename Traits>
typename Traits::Point_3 innermost_mean(const Generalized_bezier_net_3<Traits>& net) {
  using FT = typename Traits::FT;
  const std::size_t last = net.central_index(), l = net.layers();
  const std::size_t count = net.size() * (net.degree() - 2 * (l - 1));
  const typename Traits::Point_3& origin = net.control_points()[last - count];
  typename Traits::Vector_3 sum(FT(0), FT(0), FT(0));
  for (std::size_t i = last - count; i < last; ++i)
    sum = sum + (net.control_points()[i] - origin);
  return origin + sum / FT(static_cast<int>(count));
}

/*
 * The weights of control points where all barycentric coordinates are 1/n, the middle of a regular
 * domain: there s = 1/2 and h = 1 - 2/n on all sides, and all corner weights are 1/2, but for
 * middle columns, where they are 1.
 */
template <typename FT>
class Middle_weights {
public:
  Middle_weights(std::size_t n, std::size_t d) : along_(d + 1), across_((d + 1) / 2) {
    const FT one_minus_h = FT(2) / FT(static_cast<int>(n));
    bernstein_polynomials(d, FT(FT(1) / FT(2)), along_.data());
    bernstein_polynomials(d, across_.size(), FT(FT(1) - one_minus_h), one_minus_h, across_.data());
    FT sum(0);
    for (std::size_t j = 0; j <= d; ++j) {
      if (2 * j != d)
        along_[j] = along_[j] / FT(2);
      for (const FT& across : across_)
        sum += along_[j] * across;
    }
    central_ = FT(1) - FT(static_cast<int>(n)) * sum;
    // Here the patch is a polygon with Wachspress-like weights, a tensor product or a triangle, and
    // the central point has no weight anywhere.
    if (d == 1 || (n == 4 && d % 2 != 0) || (n == 3 && d == 2))
      central_ = FT(0);
  }

  // of point (j,k) of one side; points that belong to two sides have two weights
  FT operator()(std::size_t j, std::size_t k) const { return along_[j] * across_[k]; }
  // of the central point
  const FT& central() const { return central_; }
  bool central_point_matters() const { return central_ != FT(0); }

private:
  std::vector<FT> along_, across_;
  FT central_;
};

// The point of the patch in the middle of a regular domain.
template <typename Traits>
typename Traits::Point_3 middle_point(const Generalized_bezier_net_3<Traits>& net) {
  using FT = typename Traits::FT;
  const Middle_weights<FT> weights(net.size(), net.degree());
  // All weights together are 1, so any point may be the origin.
  const typename Traits::Point_3& origin = net.control_points().front();
  typename Traits::Vector_3 sum = weights.central() * (net.central_point() - origin);
  for (std::size_t k = 0; k < net.layers(); ++k)
    for (std::size_t j = 0; j <= net.degree(); ++j) {
      typename Traits::Vector_3 around(FT(0), FT(0), FT(0));
      for (std::size_t i = 0; i < net.size(); ++i)
        around = around + (net.control_point(i, j, k) - origin);
      sum = sum + weights(j, k) * around;
    }
  return origin + sum;
}

// The net with the central point that makes `middle` the middle of the patch, if that depends on
// it; if not, with the mean of the innermost row.
template <typename Traits>
Generalized_bezier_net_3<Traits> with_middle_point(const Generalized_bezier_net_3<Traits>& net,
                                                   const typename Traits::Point_3& middle) {
  const Middle_weights<typename Traits::FT> weights(net.size(), net.degree());
  const typename Traits::Point_3 mean = innermost_mean(net);
  const Generalized_bezier_net_3<Traits> start = with_central_point(net, mean);
  if (!weights.central_point_matters())
    return start;
  return with_central_point(start, mean + (middle - middle_point(start)) / weights.central());
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_NET_QUADS_H
