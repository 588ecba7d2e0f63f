// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The same formulas in exact arithmetic, with 100 digits, in double and in float.

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Filtered_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

using namespace fixtures;

namespace {

using Rational = CGAL::Exact_rational;
using Rational_kernel = CGAL::Simple_cartesian<Rational>;
using Lazy_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Float_kernel = CGAL::Filtered_kernel<CGAL::Simple_cartesian<float>>;
// 100 digits
using Multiple = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                               boost::multiprecision::et_off>;
template <typename Traits>
using Convex_patch = MP::Concave_bezier_patch_3<Traits, MP::Wachspress_coordinates_2<Traits>>;
using Mean_value_patch = MP::Concave_bezier_patch_3<Kernel, MP::Mean_value_coordinates_2<Kernel>>;

template <typename Traits>
MP::Wachspress_coordinates_2<Traits> on_unit_square() {
  using Point = typename Traits::Point_2;
  return MP::Wachspress_coordinates_2<Traits>(
      MP::Polygonal_domain_2<Traits>({Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)}));
}

template <typename Traits>
std::vector<std::vector<typename Traits::Point_3>> random_net(Random& random, std::size_t degree) {
  std::vector<std::vector<typename Traits::Point_3>> net(degree + 1);
  for (auto& row : net)
    for (std::size_t b = 0; b <= degree; ++b)
      row.emplace_back(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
  return net;
}

// Σ B_a(u) B_b(v) net[a][b], with derivatives
template <typename FT, typename Point>
std::array<MP::Jet_2<FT, 2>, 3> tensor_product(const std::vector<std::vector<Point>>& net,
                                               const FT& u, const FT& v) {
  using Jet = MP::Jet_2<FT, 2>;
  std::vector<Jet> bu(net.size()), bv(net.size());
  MP::internal::bernstein_polynomials(net.size() - 1, Jet::u_variable(u), bu.data());
  MP::internal::bernstein_polynomials(net.size() - 1, Jet::v_variable(v), bv.data());
  std::array<Jet, 3> sum;
  for (std::size_t a = 0; a < net.size(); ++a)
    for (std::size_t b = 0; b < net.size(); ++b)
      for (int c = 0; c < 3; ++c)
        sum[c] += bu[a] * bv[b] * net[a][b][c];
  return sum;
}

// A loop and a domain, in another kernel.
template <typename To>
Convex_patch<To> converted(const Loop& loop, const std::vector<Point_2>& polygon) {
  using FT = typename To::FT;
  std::vector<MP::Bezier_ribbon_3<To>> ribbons;
  for (const Ribbon& r : loop.ribbons()) {
    std::vector<typename To::Point_3> points;
    for (const Point_3& p : r.control_points())
      points.emplace_back(FT(p.x()), FT(p.y()), FT(p.z()));
    ribbons.emplace_back(r.degree(), r.layers(), points);
  }
  std::vector<typename To::Point_2> vertices;
  for (const Point_2& p : polygon)
    vertices.emplace_back(FT(p.x()), FT(p.y()));
  return Convex_patch<To>(MP::Ribbon_loop_3<To>(ribbons),
                          MP::Wachspress_coordinates_2<To>(MP::Polygonal_domain_2<To>(vertices)));
}

template <typename Patch>
typename Patch::template Surface_jet<2> at(const Patch& patch, double u, double v) {
  using FT = typename Patch::FT;
  return patch.template evaluate<2>({FT(u), FT(v)});
}

double relative_difference(double a, double b) {
  return std::abs(a - b) / (std::max)(1., std::abs(b));
}

} // namespace

// The degree along a side of the square is that across the next, 2l - 1, so it is odd.
TEMPLATE_TEST_CASE("On a square the patch is exactly the tensor product, with its derivatives", "",
                   Rational_kernel, Lazy_kernel) {
  using FT = typename TestType::FT;
  Random random(12);
  for (const std::size_t degree : {1, 3, 5, 7, 9}) {
    const auto net = random_net<TestType>(random, degree);
    const Convex_patch<TestType> patch(
        MP::Concave_bezier_model_3<TestType>(tensor_product_loop<TestType>(net)),
        on_unit_square<TestType>());
    // inside, on all sides, and at two vertices
    for (const auto& uv : std::vector<std::array<FT, 2>>{{FT(3) / FT(7), FT(5) / FT(11)},
                                                         {FT(1) / FT(3), FT(0)},
                                                         {FT(1), FT(2) / FT(5)},
                                                         {FT(1) / FT(3), FT(1)},
                                                         {FT(0), FT(2) / FT(5)},
                                                         {FT(0), FT(0)},
                                                         {FT(1), FT(1)}}) {
      const auto surface = patch.template evaluate<2>({uv[0], uv[1]});
      const auto expected = tensor_product(net, uv[0], uv[1]);
      for (int c = 0; c < 3; ++c)
        for (std::size_t k = 0; k < 6; ++k)
          CHECK(surface[c][k] == expected[c][k]);
    }
  }
}

TEST_CASE("The weights sum to one, exactly, for all degrees and layers") {
  using Jet = MP::Jet_2<Rational, 2>;
  const auto square = on_unit_square<Rational_kernel>();
  const std::vector<Rational_kernel::Point_2> pentagon{{0, 0}, {4, 0}, {5, 3}, {2, 5}, {-1, 2}};
  const MP::Wachspress_coordinates_2<Rational_kernel> on_pentagon(
      (MP::Polygonal_domain_2<Rational_kernel>(pentagon)));
  for (const auto& coordinates : {square, on_pentagon})
    for (std::size_t degree = 1; degree <= 9; ++degree)
      for (const auto central :
           {MP::Central_weight::none, MP::Central_weight::weight_deficiency,
            MP::Central_weight::adjacent_products, MP::Central_weight::full_product}) {
        const std::size_t n = coordinates.domain().size();
        const MP::Concave_bezier_basis basis(
            std::vector<std::pair<std::size_t, std::size_t>>(n, {degree, (degree + 1) / 2}),
            central);
        std::vector<Jet> lambda(n), weights(basis.size());
        const Rational_kernel::Point_2 p(Rational(2) / 7, Rational(1) / 3);
        coordinates.evaluate<2>(p, coordinates.domain().locate_inside(p), lambda.data());
        basis.evaluate(coordinates.domain(), lambda.data(), weights.data());
        Jet sum;
        for (const Jet& w : weights)
          sum += w;
        CHECK(sum[0] == 1);
        for (std::size_t k = 1; k < 6; ++k)
          CHECK(sum[k] == 0);
      }
}

TEST_CASE("All kernels give the same patch, as exactly as their numbers are") {
  const unsigned seed = 20261122;
  CAPTURE(seed);
  Random random(seed);
  for (const std::size_t n : {3, 4, 6}) {
    const auto polygon = convex_polygon(random, n);
    const Loop loop = lifted_loop(polygon, [](double x, double y) { return x * x - x * y; });
    const auto patch = converted<Kernel>(loop, polygon);
    const auto exact = converted<Rational_kernel>(loop, polygon);
    const auto lazy = converted<Lazy_kernel>(loop, polygon);
    const auto single = converted<Float_kernel>(loop, polygon);
    for (int k = 0; k < 3; ++k) {
      const Point_2 p = interior_point(random, patch.domain());
      // Values that float holds, too.
      const double u = static_cast<float>(p.x()), v = static_cast<float>(p.y());
      const auto in_double = at(patch, u, v);
      const auto in_rational = at(exact, u, v);
      const auto in_lazy = at(lazy, u, v);
      const auto in_float = at(single, u, v);
      for (int c = 0; c < 3; ++c)
        for (std::size_t e = 0; e < 6; ++e) {
          const double expected = CGAL::to_double(in_rational[c][e]);
          CHECK(in_lazy[c][e].exact() == in_rational[c][e]);
          CHECK(relative_difference(in_double[c][e], expected) < 1e-12);
          CHECK(relative_difference(in_float[c][e], expected) < 1e-2);
        }
      CHECK(relative_difference(in_float[0].value(), CGAL::to_double(in_rational[0].value())) <
            1e-5);
    }
  }
}

TEST_CASE("Ribbons of all degrees that a number type allows are evaluated in it") {
  const auto line = [](auto x) {
    using Traits = typename CGAL::Kernel_traits<decltype(x)>::Kernel;
    const std::size_t max = MP::internal::max_bernstein_degree<typename Traits::FT>();
    using R = MP::Bezier_ribbon_3<Traits>;
    CHECK_THROWS_AS(R(max + 1, 1, std::vector<decltype(x)>(max + 2, x)), MP::Input_error);
    const R ribbon(max, 1, std::vector<decltype(x)>(max + 1, x));
    return CGAL::to_double(ribbon.boundary_point(typename Traits::FT(0.5)).x());
  };
  CHECK(line(Float_kernel::Point_3(3, 0, 0)) == Approx(3).epsilon(1e-4));
  CHECK(line(Point_3(3, 0, 0)) == Approx(3).epsilon(1e-12));
}

TEST_CASE("A patch over doubles is evaluated in rationals at once") {
  Random random(14);
  const auto polygon = convex_polygon(random, 5);
  const Loop loop = lifted_loop(polygon, [](double x, double y) { return x * y; });
  const auto patch = converted<Kernel>(loop, polygon);
  const auto exact = converted<Rational_kernel>(loop, polygon);
  const Point_2 p = interior_point(random, patch.domain());
  const Rational u(p.x()), v(p.y());
  const auto surface = patch.evaluate<2, Rational>(u, v, MP::Domain_location<Rational>::interior());
  const auto expected = exact.evaluate<2>({u, v});
  for (int c = 0; c < 3; ++c)
    for (std::size_t e = 0; e < 6; ++e)
      CHECK(surface[c][e] == expected[c][e]);
}

// Central differences with step 1e-30 have errors of 1e-60 times third and fourth derivatives.
TEST_CASE("Derivatives agree with differences of 100 digits") {
  const unsigned seed = 20261123;
  CAPTURE(seed);
  Random random(seed);
  const auto polygon = l_shape();
  const Loop loop = lifted_loop(polygon, [](double x, double y) { return x * x + y; });
  const Mean_value_patch concave(loop, MP::Mean_value_coordinates_2<Kernel>(Domain(polygon)));
  const auto convex_plan = convex_polygon(random, 6);
  const auto convex = converted<Kernel>(
      lifted_loop(convex_plan, [](double x, double y) { return x * x + y; }), convex_plan);
  const auto check = [&](const auto& patch) {
    for (int k = 0; k < 5; ++k) {
      const Point_2 p = interior_point(random, patch.domain());
      const auto interior = MP::Domain_location<Multiple>::interior();
      const Multiple u(p.x()), v(p.y()), h("1e-30");
      const auto jet = patch.template evaluate<2, Multiple>(u, v, interior);
      const auto value = [&](int du, int dv, int c) {
        return patch.template evaluate<0, Multiple>(u + du * h, v + dv * h, interior)[c].value();
      };
      for (int c = 0; c < 3; ++c) {
        const Multiple f = value(0, 0, c);
        const Multiple differences[6] = {
            f,
            (value(1, 0, c) - value(-1, 0, c)) / (2 * h),
            (value(0, 1, c) - value(0, -1, c)) / (2 * h),
            (value(1, 0, c) - 2 * f + value(-1, 0, c)) / (h * h),
            (value(1, 1, c) - value(1, -1, c) - value(-1, 1, c) + value(-1, -1, c)) / (4 * h * h),
            (value(0, 1, c) - 2 * f + value(0, -1, c)) / (h * h)};
        for (std::size_t e = 0; e < 6; ++e)
          CHECK(abs(jet[c][e] - differences[e]) < 1e-20);
      }
    }
  };
  check(concave);
  check(convex);
}

// On the sides and at vertices the formulas have a form of their own; their results have to be the
// limits from inside.
TEST_CASE("Derivatives on sides and at vertices are limits") {
  const unsigned seed = 20261124;
  CAPTURE(seed);
  Random random(seed);
  const auto compare = [](const auto& patch, std::size_t side, const Multiple& s, int order) {
    using Location = MP::Domain_location<Multiple>;
    const Domain& domain = patch.domain();
    const std::size_t k = domain.next(side);
    const Multiple ax(domain.vertex(side).x()), ay(domain.vertex(side).y()),
        dx = Multiple(domain.vertex(k).x()) - ax, dy = Multiple(domain.vertex(k).y()) - ay;
    const Multiple u = ax + s * dx, v = ay + s * dy;
    // from the corner towards the middle of the polygon, elsewhere perpendicular to the side
    const Multiple tx = s == 0 ? Multiple(dx / 2 - dy / 2) : Multiple(-dy),
                   ty = s == 0 ? Multiple(dy / 2 + dx / 2) : dx;
    const Multiple h("1e-40");
    const auto inside =
        patch.template evaluate<2, Multiple>(u + h * tx, v + h * ty, Location::interior());
    const auto limit = patch.template evaluate<2, Multiple>(
        u, v, s == 0 ? Location::on_vertex(side) : Location::on_side(side, s));
    for (int c = 0; c < 3; ++c)
      for (std::size_t e = 0; e < (order == 2 ? 6 : 3); ++e)
        CHECK(abs(inside[c][e] - limit[c][e]) < 1e-12);
  };
  const auto polygon = convex_polygon(random, 5);
  // At this depth the boundary curves have the cross-derivatives of the adjacent ribbons.
  const auto smooth =
      converted<Kernel>(lifted_loop(
                            polygon, [](double x, double y) { return x * x + y; }, 1. / 3),
                        polygon);
  for (std::size_t side = 0; side < 5; ++side)
    compare(smooth, side, Multiple(0), 1);
  // Degrees from 1 and layers from 1 on: with one layer, other sides matter to second order.
  for (int k = 0; k < 20; ++k) {
    const auto wild = converted<Kernel>(random_loop(random, 5, 0.3), polygon);
    for (std::size_t side = 0; side < 5; ++side)
      for (const char* s : {"0.3", "1e-6"})
        compare(wild, side, Multiple(s), 2);
  }
  // The same on sides of a concave domain; there is no corner where all mean values are smooth.
  const Mean_value_patch concave(lifted_loop(l_shape(), [](double x, double y) { return x * y; }),
                                 MP::Mean_value_coordinates_2<Kernel>(Domain(l_shape())));
  for (std::size_t side = 0; side < 6; ++side)
    compare(concave, side, Multiple("0.4"), 2);
}
