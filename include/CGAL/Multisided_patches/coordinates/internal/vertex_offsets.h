// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_VERTEX_OFFSETS_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_VERTEX_OFFSETS_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/domains/Domain_location.h>

#include <boost/container/small_vector.hpp>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The vectors v_j - p from a point of a domain to all vertices, and what is made of two of them,
// with derivatives by p = (u,v).
//
// On a side and at a vertex the vectors come from the location, not from p: this is rounded and not
// quite on the side, which so close to a vertex may be seen in another direction.
template <typename Real>
class Vertex_offsets {
public:
  template <typename Domain>
  Vertex_offsets(const Domain& domain, const Real& u, const Real& v,
                 const Domain_location<Real>& location)
      : x_(domain.size()), y_(domain.size()) {
    using Kind = typename Domain_location<Real>::Kind;
    const auto x = [&](std::size_t j) { return Real(domain.vertex(j).x()); };
    const auto y = [&](std::size_t j) { return Real(domain.vertex(j).y()); };
    const std::size_t i = location.index;
    const Real origin_x = location.is_on_boundary() ? x(i) : u,
               origin_y = location.is_on_boundary() ? y(i) : v;
    for (std::size_t j = 0; j < x_.size(); ++j) {
      x_[j] = x(j) - origin_x;
      y_[j] = y(j) - origin_y;
    }
    if (location.kind != Kind::side)
      return;
    const std::size_t k = domain.next(i);
    const Real dx = x_[k], dy = y_[k], rest = Real(1) - location.s;
    for (std::size_t j = 0; j < x_.size(); ++j) {
      x_[j] = j == k ? Real(rest * dx) : Real(x_[j] - location.s * dx);
      y_[j] = j == k ? Real(rest * dy) : Real(y_[j] - location.s * dy);
    }
  }

  // |v_j - p|. At v_j itself it has no derivatives.
  template <int Order>
  Jet_2<Real, Order> distance(std::size_t j) const {
    using std::sqrt;
    const Real &x = x_[j], &y = y_[j];
    Jet_2<Real, Order> r;
    r[0] = sqrt(Real(x * x + y * y));
    if constexpr (Order >= 1) {
      r[1] = -x / r[0];
      r[2] = -y / r[0];
    }
    if constexpr (Order >= 2) {
      r[3] = r[2] * r[2] / r[0];
      r[4] = -r[1] * r[2] / r[0];
      r[5] = r[1] * r[1] / r[0];
    }
    return r;
  }

  // the cross product of the vectors to v_j and v_k
  template <int Order>
  Jet_2<Real, Order> cross(std::size_t j, std::size_t k) const {
    Jet_2<Real, Order> r;
    r[0] = x_[j] * y_[k] - x_[k] * y_[j];
    if constexpr (Order >= 1) {
      r[1] = y_[j] - y_[k];
      r[2] = x_[k] - x_[j];
    }
    return r;
  }

  // the dot product
  template <int Order>
  Jet_2<Real, Order> dot(std::size_t j, std::size_t k) const {
    Jet_2<Real, Order> r;
    r[0] = x_[j] * x_[k] + y_[j] * y_[k];
    if constexpr (Order >= 1) {
      r[1] = -(x_[j] + x_[k]);
      r[2] = -(y_[j] + y_[k]);
    }
    if constexpr (Order >= 2)
      r[3] = r[5] = Real(2);
    return r;
  }

private:
  boost::container::small_vector<Real, 32> x_, y_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_INTERNAL_VERTEX_OFFSETS_H
