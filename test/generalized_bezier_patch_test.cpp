// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Generalized_bezier_patch_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

using namespace fixtures;
using Net = MP::Generalized_bezier_net_3<Kernel>;
using Patch = MP::Generalized_bezier_patch_3<Kernel>;
using Location = Domain::Location;

namespace {

using Rational = CGAL::Exact_rational;
using Rational_kernel = CGAL::Simple_cartesian<Rational>;
using Rational_net = MP::Generalized_bezier_net_3<Rational_kernel>;
using Rational_patch = MP::Generalized_bezier_patch_3<Rational_kernel>;
using Exact_jet = MP::Jet_2<Rational, 2>;

// A bumpy cap: rings of control points around the origin, moved at random.
template <typename Traits>
MP::Generalized_bezier_net_3<Traits> random_net(Random& random, std::size_t n, std::size_t d) {
  using Point = typename Traits::Point_3;
  using N = MP::Generalized_bezier_net_3<Traits>;
  const N places(n, d, std::vector<Point>(N::number_of_control_points(n, d), CGAL::ORIGIN));
  std::vector<Point> points(places.control_points());
  const auto jitter = [&] { return random.in(-0.03, 0.03); };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < places.layers(); ++k)
      for (std::size_t j = 0; j <= d; ++j) {
        const double s = double(j) / double(d), r = 1 - double(k) / double(d);
        const double a = 2 * CGAL_PI * double(i) / double(n), b = a + 2 * CGAL_PI / double(n);
        points[places.index(i, j, k)] =
            Point(r * ((1 - s) * std::cos(a) + s * std::cos(b)) + jitter(),
                  r * ((1 - s) * std::sin(a) + s * std::sin(b)) + jitter(), 5 * jitter());
      }
  points.back() = Point(jitter(), jitter(), 0.5);
  return places.with_control_points(points);
}

// The control net of a tensor product patch; `grid[a][b]` is the point of B_a(u) B_b(v).
template <typename Traits>
MP::Generalized_bezier_net_3<Traits>
net_of_grid(const std::vector<std::vector<typename Traits::Point_3>>& grid) {
  using N = MP::Generalized_bezier_net_3<Traits>;
  using Point = typename Traits::Point_3;
  const std::size_t d = grid.size() - 1;
  const N places(4, d, std::vector<Point>(N::number_of_control_points(4, d), CGAL::ORIGIN));
  std::vector<Point> points(places.control_points());
  for (std::size_t k = 0; k < places.layers(); ++k)
    for (std::size_t j = 0; j <= d; ++j) {
      points[places.index(0, j, k)] = grid[j][k];
      points[places.index(1, j, k)] = grid[d - k][j];
      points[places.index(2, j, k)] = grid[d - j][d - k];
      points[places.index(3, j, k)] = grid[k][d - j];
    }
  points.back() = d % 2 == 0 ? grid[d / 2][d / 2] : Point(100, 100, 100);
  return places.with_control_points(points);
}

std::vector<std::vector<Rational_kernel::Point_3>> random_grid(Random& random, std::size_t d) {
  std::vector<std::vector<Rational_kernel::Point_3>> grid(d + 1);
  for (std::size_t a = 0; a <= d; ++a)
    for (std::size_t b = 0; b <= d; ++b)
      grid[a].emplace_back(Rational(double(a)) + Rational(random.in(-0.3, 0.3)),
                           Rational(double(b)) + Rational(random.in(-0.3, 0.3)),
                           Rational(random.in(-1, 1)));
  return grid;
}

std::array<Exact_jet, 3>
tensor_product_surface(const std::vector<std::vector<Rational_kernel::Point_3>>& grid,
                       const Exact_jet& u, const Exact_jet& v) {
  const std::size_t d = grid.size() - 1;
  std::vector<Exact_jet> bu(d + 1), bv(d + 1);
  MP::internal::bernstein_polynomials(d, u, bu.data());
  MP::internal::bernstein_polynomials(d, v, bv.data());
  std::array<Exact_jet, 3> sum;
  for (std::size_t a = 0; a <= d; ++a)
    for (std::size_t b = 0; b <= d; ++b)
      for (int c = 0; c < 3; ++c)
        sum[c] += bu[a] * bv[b] * grid[a][b][c];
  return sum;
}

double worst(const MP::Continuity_report& report,
             const std::function<double(const MP::Side_continuity&)>& deviation) {
  double result = 0;
  for (const auto& side : report.sides)
    result = (std::max)(result, deviation(side));
  return result;
}

} // namespace

TEST_CASE("A net stores every point once, ring by ring, and the central one last") {
  for (std::size_t n = 3; n < 8; ++n)
    for (std::size_t d = 1; d < 10; ++d) {
      const Net net(n, d, std::vector<Point_3>(Net::number_of_control_points(n, d), CGAL::ORIGIN));
      std::vector<int> uses(net.control_points().size());
      std::size_t expected = 0;
      for (std::size_t k = 0; k < net.layers(); ++k)
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t j = 0; j <= d; ++j) {
            ++uses[net.index(i, j, k)];
            if (j >= k && j < d - k)
              CHECK(net.index(i, j, k) == expected++);
            if (j + net.layers() > d) // the same point seen from the next side
              CHECK(net.index(i, j, k) == net.index(net.next(i), k, d - j));
          }
      CHECK(expected == net.central_index());
      for (std::size_t c = 0; c < net.central_index(); ++c)
        CHECK((uses[c] == 1 || uses[c] == 2));
      CHECK(uses.back() == 0);
    }
}

TEST_CASE("On a square the generalized Bezier patch is exactly the tensor product patch") {
  const unsigned seed = 20260811;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t d = 1; d <= 6; ++d) {
    const auto grid = random_grid(random, d);
    const Rational_patch patch(net_of_grid<Rational_kernel>(grid));
    CHECK(patch.domain().vertex(2) == Rational_kernel::Point_2(1, 1));
    for (int k = 0; k < 5; ++k) {
      const Rational u(random.in(0.01, 0.99)), v(random.in(0.01, 0.99));
      const auto surface =
          patch.evaluate<2, Rational>(u, v, MP::Domain_location<Rational>::interior());
      const auto expected =
          tensor_product_surface(grid, Exact_jet::u_variable(u), Exact_jet::v_variable(v));
      for (int c = 0; c < 3; ++c)
        for (std::size_t e = 0; e < Exact_jet::size; ++e)
          CHECK(surface[c][e] == expected[c][e]);
    }
  }
}

TEST_CASE(
    "On a triangle of degree 1 and 2 it is the Bezier triangle, and the centre has no weight") {
  const unsigned seed = 20260812;
  CAPTURE(seed);
  Random random(seed);
  const MP::Wachspress_coordinates_2<Rational_kernel> coordinates{
      MP::Polygonal_domain_2<Rational_kernel>({{0, 0}, {1, 0}, {0, 1}})};
  for (std::size_t d = 1; d <= 3; ++d) {
    const auto net = random_net<Rational_kernel>(random, 3, d);
    const Rational_patch patch(net, coordinates);
    const Rational u(random.in(0.1, 0.4)), v(random.in(0.1, 0.4));
    const std::array<Rational, 3> lambda{Rational(1) - u - v, u, v};
    Rational expected(0);
    if (d == 1)
      for (std::size_t i = 0; i < 3; ++i)
        expected += lambda[i] * net.control_point(i, 0, 0).z();
    else // the boundary points are all that there are up to degree 2
      for (std::size_t i = 0; i < 3; ++i)
        expected += lambda[i] * lambda[i] * net.control_point(i, 0, 0).z() +
                    2 * lambda[i] * lambda[(i + 1) % 3] * net.control_point(i, 1, 0).z();
    std::vector<MP::Jet_2<Rational, 0>> at(3), weights(patch.basis().size());
    coordinates.evaluate<0, Rational>(u, v, MP::Domain_location<Rational>::interior(), at.data());
    patch.basis().evaluate(patch.domain(), at.data(), weights.data());
    const bool same = patch.combine(at.data())[2].value() == expected;
    CHECK(same == (d < 3));
    CHECK((weights.back().value() == 0) == (d < 3));
  }
}

TEST_CASE("The weights sum to one, and control net and weights give the patch") {
  const unsigned seed = 20260813;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t n : {3, 5, 6})
    for (std::size_t d : {1, 2, 3, 4, 7}) {
      const auto net = random_net<Rational_kernel>(random, n, d);
      // Regular polygons have no rational vertices.
      std::vector<Rational_kernel::Point_2> polygon;
      for (const Point_2& p : convex_polygon(random, n))
        polygon.emplace_back(Rational(p.x()), Rational(p.y()));
      const Rational_patch patch(net, MP::Wachspress_coordinates_2<Rational_kernel>(
                                          MP::Polygonal_domain_2<Rational_kernel>(polygon)));
      std::vector<Exact_jet> lambda(n), weights(patch.basis().size());
      patch.coordinates().evaluate<2, Rational>(
          Rational(random.in(-0.1, 0.1)), Rational(random.in(-0.1, 0.1)),
          MP::Domain_location<Rational>::interior(), lambda.data());
      patch.basis().evaluate(patch.domain(), lambda.data(), weights.data());
      const auto surface = patch.combine(lambda.data());
      Exact_jet sum, x;
      for (std::size_t c = 0; c < weights.size(); ++c) {
        sum += weights[c];
        x += weights[c] * net.control_points()[c].x();
      }
      for (std::size_t e = 0; e < Exact_jet::size; ++e) {
        CHECK(sum[e] == Rational(e == 0 ? 1 : 0));
        CHECK(x[e] == surface[0][e]);
      }
    }
}

TEST_CASE("A generalized Bezier patch meets its ribbons with the order of its layers") {
  const unsigned seed = 20260814;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t n : {3, 4, 5, 6, 9})
    for (std::size_t d = 1; d <= 8; ++d) {
      CAPTURE(n, d);
      const Patch patch(random_net<Kernel>(random, n, d));
      const auto report = MP::continuity_report(patch);
      CHECK(worst(report, [](const auto& side) { return side.position.max; }) < 1e-14);
      CHECK(report.sides[0].tangent_plane.has_value() == (d >= 3));
      CHECK(report.sides[0].normal_curvature.has_value() == (d >= 5));
      if (d >= 3)
        CHECK(worst(report, [](const auto& side) { return side.tangent_plane->max; }) < 1e-11);
      if (d >= 5)
        CHECK(worst(report, [](const auto& side) { return side.normal_curvature->max; }) < 1e-11);
    }
}

TEST_CASE("Its ribbons have the derivatives across the sides that the net asks for") {
  const unsigned seed = 20260815;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t d = 3; d <= 8; ++d) {
    const auto net = random_net<Rational_kernel>(random, 5, d);
    const auto ribbon = net.loop()[2];
    CHECK(ribbon.layers() == net.layers());
    for (std::size_t j = 0; j <= d; ++j) {
      const auto derivative = [](const auto& a, const auto& b, std::size_t m) -> Rational {
        return Rational(int(m)) * (b.z() - a.z());
      };
      CHECK(derivative(ribbon.control_point(j, 0), ribbon.control_point(j, 1),
                       ribbon.cross_degree()) ==
            derivative(net.control_point(2, j, 0), net.control_point(2, j, 1), d));
    }
    if (d < 5)
      continue;
    const auto second = [](const Rational& a, const Rational& b, const Rational& c,
                           std::size_t m) -> Rational {
      return Rational(int(m * (m - 1))) * (a - 2 * b + c);
    };
    CHECK(second(ribbon.control_point(1, 0).z(), ribbon.control_point(1, 1).z(),
                 ribbon.control_point(1, 2).z(), ribbon.cross_degree()) ==
          second(net.control_point(2, 1, 0).z(), net.control_point(2, 1, 1).z(),
                 net.control_point(2, 1, 2).z(), d));
  }
}

TEST_CASE("The centre of a patch lies where its central point and weight say") {
  Random random(5);
  const Net net = random_net<Kernel>(random, 5, 3);
  std::vector<Point_3> raised = net.control_points();
  raised.back() = raised.back() + Vector_3(0, 0, 1);
  const Patch patch(net), high(net.with_control_points(raised));
  const Point_2 p(0.45, 0.55);
  std::vector<MP::Jet_2<double, 0>> lambda(5), weights(patch.basis().size());
  patch.coordinates().evaluate<0>(p, Location::interior(), lambda.data());
  patch.basis().evaluate(patch.domain(), lambda.data(), weights.data());
  const double weight = weights[patch.basis().central_index()].value();
  CHECK(weight > 0.05);
  CHECK(high(p).z() - patch(p).z() == Approx(weight).epsilon(1e-12));
}

TEST_CASE("Any coordinates can carry it, on a domain of the user's choice") {
  Random random(6);
  using Mean_value_patch =
      MP::Generalized_bezier_patch_3<Kernel, MP::Mean_value_coordinates_2<Kernel>>;
  const Net net = random_net<Kernel>(random, 6, 5);
  MP::Domain_options options;
  options.generator = MP::Domain_generator::similarity;
  const Mean_value_patch patch(net, options);
  CHECK(patch.domain_report().used == MP::Domain_generator::similarity);
  const auto report = MP::continuity_report(patch);
  CHECK(worst(report, [](const auto& side) { return side.position.max; }) < 1e-14);
  CHECK(worst(report, [](const auto& side) { return side.tangent_plane->max; }) < 1e-9);
}

TEST_CASE("Nets that are none are refused with what was expected") {
  const auto points = [](std::size_t count) { return std::vector<Point_3>(count, CGAL::ORIGIN); };
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(Net(2, 3, points(9)), Contains("from 3 to"));
  const std::size_t huge = std::size_t(1) << 62; // where the number of points overflows
  CHECK_THROWS_WITH(Net(huge + 3, 3, points(13)), Contains("4611686018427387907 sides"));
  CHECK_THROWS_WITH(Net::number_of_control_points(3, std::size_t(-1)), Contains("largest degree"));
  CHECK_THROWS_WITH(Net(5, 0, points(1)), Contains("degree 0"));
  CHECK_THROWS_WITH(Net(5, 5, points(45)), Contains("has 46 points, not 45"));
  CHECK_THROWS_WITH(Net(5, 2000, points(45)), Contains("largest degree"));
  auto broken = points(46);
  broken[7] = Point_3(0, std::nan(""), 0);
  CHECK_THROWS_WITH(Net(5, 5, broken), Contains("control point 7"));
  CHECK_THROWS_WITH(Patch(Net(5, 5, points(46))), Contains("too close"));
  Random random(7);
  const MP::Wachspress_coordinates_2<Kernel> square{Domain({{0, 0}, {1, 0}, {1, 1}, {0, 1}})};
  CHECK_THROWS_WITH(Patch(random_net<Kernel>(random, 5, 3), square), Contains("5 sides"));
}
