// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_PARAMETRIC_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_PARAMETRIC_FIXTURES_H

#include "Rational_random.h"
#include "catch.h"
#include "exact_fixtures.h"

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/analysis/continuity_report.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// What the tests of Bézier triangles and of tensor product patches share.
namespace parametric_fixtures {

namespace MP = CGAL::Multisided_patches;
using exact_fixtures::ratio;
using Rational = exact_fixtures::FT;
using Kernel = exact_fixtures::Exact;
using Point_2 = Kernel::Point_2;
using Vector_2 = Kernel::Vector_2;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Domain = MP::Polygonal_domain_2<Kernel>;
using Jet = MP::Jet_2<Rational, 2>;
using Surface = std::array<Jet, 3>;
using Double_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Double_point = Double_kernel::Point_3;
using Random = fixtures::Rational_random<Kernel>;

inline std::vector<Double_point> doubles(unsigned seed, std::size_t n) {
  fixtures::Random random(seed);
  std::vector<Double_point> points;
  for (std::size_t i = 0; i < n; ++i)
    points.emplace_back(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
  return points;
}

// Three points inside, one on each side, and all vertices.
inline std::vector<Point_2> samples(const Domain& domain) {
  const std::size_t n = domain.size();
  std::vector<Point_2> points(domain.vertices());
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(domain.point_on_side(i, ratio(2, 7)));
  const Point_2 centre = CGAL::midpoint(domain.vertex(0), domain.point_on_side(1, ratio(3, 7)));
  for (std::size_t i = 0; i < 3; ++i)
    points.push_back(centre + ratio(1, 3) * (domain.vertex(i) - centre));
  return points;
}

inline bool same(const Surface& a, const Surface& b) {
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < Jet::size; ++k)
      if (a[c][k] != b[c][k])
        return false;
  return true;
}

inline void add(Surface& sum, const Jet& weight, const Point_3& p) {
  for (int c = 0; c < 3; ++c)
    sum[static_cast<std::size_t>(c)] += weight * p[c];
}

inline Rational factorial(std::size_t n) {
  Rational f(1);
  for (std::size_t i = 2; i <= n; ++i)
    f *= Rational(static_cast<int>(i));
  return f;
}

// `polynomial(patch, uv)` is what the surface and its derivatives should be.
template <typename Patch, typename Polynomial>
void check_polynomial(const Patch& patch, const Polynomial& polynomial) {
  for (const Point_2& uv : samples(patch.domain())) {
    const Surface s = polynomial(patch, uv);
    CHECK(same(patch.template evaluate<2>(uv), s));
    CHECK(patch(uv) == Point_3(s[0].value(), s[1].value(), s[2].value()));
  }
}

template <typename Patch>
void check_same_surface(const Patch& a, const Patch& b) {
  for (const Point_2& uv : samples(a.domain()))
    CHECK(same(a.template evaluate<2>(uv), b.template evaluate<2>(uv)));
}

// The directional derivative of a surface, of order 0, 1 or 2.
inline Vector_3 along(const Surface& surface, const Vector_2& w, std::size_t order) {
  const auto coordinate = [&](const Jet& f) -> Rational {
    if (order == 0)
      return f[0];
    if (order == 1)
      return f[1] * w.x() + f[2] * w.y();
    return f[3] * w.x() * w.x() + 2 * f[4] * w.x() * w.y() + f[5] * w.y() * w.y();
  };
  return Vector_3(coordinate(surface[0]), coordinate(surface[1]), coordinate(surface[2]));
}

// The ribbons have the derivatives of the surface in the direction `inwards(i, p)` across side i at
// point p of the domain, all that they have layers for, up to the second.
template <typename Patch, typename Inwards>
void check_ribbons(const Patch& patch, const Inwards& inwards) {
  const Domain& domain = patch.domain();
  for (std::size_t i = 0; i < domain.size(); ++i) {
    const auto& ribbon = patch.loop()[i];
    for (const Rational& s : {Rational(0), ratio(1, 9), ratio(3, 5), Rational(1)}) {
      const Point_2 p = domain.point_on_side(i, s);
      const Surface surface = patch.template evaluate<2>(p);
      CHECK(ribbon.boundary_derivative(s) == along(surface, domain.side(i).to_vector(), 1));
      for (std::size_t order = 0; order < (std::min<std::size_t>)(ribbon.layers(), 3); ++order)
        CHECK(exact_fixtures::cross_derivative(ribbon, s, order) ==
              along(surface, inwards(i, p), order));
    }
  }
}

template <typename Patch>
void check_continuity(const Patch& patch) {
  const auto report = MP::continuity_report(patch, 8);
  CHECK(report.largest_position().value < 1e-10);
  CHECK(report.largest_tangent_plane().value < 1e-7);
  CHECK(report.largest_normal_curvature().value < 1e-7);
  for (const MP::Side_continuity& side : report.sides) {
    CHECK(side.tangent_plane.has_value() == (patch.loop()[side.side].layers() >= 2));
    CHECK(side.normal_curvature.has_value() == (patch.loop()[side.side].layers() >= 3));
  }
}

inline std::vector<Point_3> converted(const std::vector<Double_point>& points) {
  std::vector<Point_3> result;
  for (const Double_point& p : points)
    result.emplace_back(Rational(p.x()), Rational(p.y()), Rational(p.z()));
  return result;
}

// Of a patch with the surface z = xy over its domain.
template <typename Patch>
void check_normals_of_saddle(const Patch& patch) {
  for (const Point_2& uv : samples(patch.domain())) {
    const double x = CGAL::to_double(uv.x()), y = CGAL::to_double(uv.y());
    const double length = std::sqrt(x * x + y * y + 1);
    const Vector_3 n = patch.normal(uv);
    CHECK(patch(uv) == Point_3(uv.x(), uv.y(), uv.x() * uv.y()));
    CHECK(CGAL::to_double(n.x()) == Approx(-y / length).epsilon(0).margin(1e-15));
    CHECK(CGAL::to_double(n.y()) == Approx(-x / length).epsilon(0).margin(1e-15));
    CHECK(CGAL::to_double(n.z()) == Approx(1 / length).epsilon(1e-15));
  }
}

// Of a patch over doubles, and the same one over rationals.
template <typename Patch, typename Exact_patch>
void check_evaluation_in_rationals(const Patch& patch, const Exact_patch& exact) {
  using Location = typename Patch::Location;
  for (const Point_2& uv : samples(exact.domain())) {
    const auto location = exact.domain().locate_inside(uv);
    const Surface expected = exact.template evaluate<2>(uv, location);
    CHECK(same(patch.template evaluate<2, Rational>(uv.x(), uv.y(), location), expected));
    // In double the point is rounded, and its location, too.
    const Location rounded{static_cast<typename Location::Kind>(location.kind), location.index,
                           CGAL::to_double(location.s)};
    const auto in_double =
        patch.template evaluate<2>({CGAL::to_double(uv.x()), CGAL::to_double(uv.y())}, rounded);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < Jet::size; ++k)
        CHECK(in_double[c][k] ==
              Approx(CGAL::to_double(expected[c][k])).epsilon(0).margin(k == 0 ? 1e-14 : 1e-11));
  }
}

} // namespace parametric_fixtures

#endif // MULTISIDED_PATCHES_TEST_PARAMETRIC_FIXTURES_H
