// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Nets with other degrees, and from ribbons. What should stay stays exactly: there is no tolerance.

#include "catch.h"
#include "exact_fixtures.h"

#include <CGAL/Multisided_patches/bases/Generalized_bezier_basis.h>
#include <CGAL/Multisided_patches/ribbons/elevate_net.h>
#include <CGAL/Multisided_patches/ribbons/make_generalized_bezier_net.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

using namespace exact_fixtures;

namespace {

using Net = MP::Generalized_bezier_net_3<Exact>;

Net random_net(Random& random, std::size_t n, std::size_t degree) {
  return Net(n, degree, random_points(random, Net::number_of_control_points(n, degree)));
}

// The control point of a tensor product patch that is C^i_{j,k} of its net.
const Point& seen_from_side(const Grid& grid, std::size_t i, std::size_t j, std::size_t k) {
  const std::size_t d = grid.size() - 1;
  return i == 0   ? grid[j][k]
         : i == 1 ? grid[d - k][j]
         : i == 2 ? grid[d - j][d - k]
                  : grid[k][d - j];
}

// The net of a tensor product patch. Nothing depends on `central_point` if the degree is odd; it is
// not used if it is even.
Net tensor_product_net(const Grid& grid, const Point& central_point) {
  const std::size_t d = grid.size() - 1;
  Net net(4, d, std::vector<Point>(Net::number_of_control_points(4, d), central_point));
  std::vector<Point> points = net.control_points();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < net.layers(); ++k)
      for (std::size_t j = 0; j <= d; ++j)
        points[net.index(i, j, k)] = seen_from_side(grid, i, j, k);
  if (d % 2 == 0)
    points.back() = grid[d / 2][d / 2];
  return net.with_control_points(points);
}

Grid random_grid(Random& random, std::size_t degree) {
  Grid grid;
  for (std::size_t a = 0; a <= degree; ++a)
    grid.push_back(random_points(random, degree + 1));
  return grid;
}

// By the formula for curves, along v and then along u.
Grid elevated_grid(const Grid& grid) {
  const std::size_t d = grid.size();
  const auto share = [&](std::size_t i) { return FT(FT(to_int(i)) / FT(to_int(d))); };
  const auto mix = [&](std::size_t i, const Point& before, const Point& at) {
    return CGAL::ORIGIN +
           (share(i) * (before - CGAL::ORIGIN) + (1 - share(i)) * (at - CGAL::ORIGIN));
  };
  Grid along_v(d, std::vector<Point>(d + 1)), result(d + 1, std::vector<Point>(d + 1));
  for (std::size_t a = 0; a < d; ++a)
    for (std::size_t b = 0; b <= d; ++b)
      along_v[a][b] = mix(b, grid[a][b == 0 ? 0 : b - 1], grid[a][b == d ? d - 1 : b]);
  for (std::size_t a = 0; a <= d; ++a)
    for (std::size_t b = 0; b <= d; ++b)
      result[a][b] = mix(a, along_v[a == 0 ? 0 : a - 1][b], along_v[a == d ? d - 1 : a][b]);
  return result;
}

// Whether the patch depends on the central control point at all.
bool central_point_matters(std::size_t n, std::size_t d) {
  return d != 1 && (n != 4 || d % 2 == 0) && (n != 3 || d != 2);
}

bool same_but_for_idle_central_point(const Net& a, const Net& b) {
  std::vector<Point> p = a.control_points(), q = b.control_points();
  if (!central_point_matters(a.size(), a.degree()))
    p.back() = q.back();
  return p == q;
}

} // namespace

TEST_CASE("An elevated net has the same boundary curves and derivatives across its sides") {
  Random random(6);
  for (std::size_t n = 3; n <= 6; ++n)
    for (std::size_t d = 1; d <= 6; ++d) {
      CAPTURE(n, d);
      const Net net = random_net(random, n, d), elevated = MP::elevate_net(net);
      REQUIRE(elevated.degree() == d + 1);
      const Loop before = net.loop(), after = elevated.loop();
      for (std::size_t i = 0; i < n; ++i) {
        CHECK(after[i].with_layers(net.layers()).control_points() ==
              before[i].elevated(d + 1).control_points());
        for (std::size_t order = 0; order < net.layers(); ++order)
          CHECK(same_derivatives(before[i], after[i], order));
      }
    }
}

TEST_CASE("On four sides elevating a net is elevating a tensor product patch") {
  Random random(7);
  for (std::size_t d = 1; d <= 7; ++d) {
    CAPTURE(d);
    const Grid grid = random_grid(random, d);
    const Net net = tensor_product_net(grid, random_point(random));
    CHECK(same_but_for_idle_central_point(MP::elevate_net(net),
                                          tensor_product_net(elevated_grid(grid), Point(0, 0, 0))));
  }
}

TEST_CASE("A degree that a net cannot get is refused at once, by its name") {
  Random random(3);
  const Net net = random_net(random, 5, 3);
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(MP::elevate_net(net, 5000), Contains("degree 5000"));
  CHECK_THROWS_WITH(MP::elevate_net(net, 2), Contains("of degree 3") && Contains("degree 2"));
  CHECK_THROWS_WITH(MP::reduce_net(net, 4), Contains("of degree 3") && Contains("degree 4"));
  CHECK_THROWS_AS(MP::reduce_net(net, 0), MP::Input_error);
  CHECK(MP::elevate_net(net, 3).control_points() == net.control_points());
  CHECK(MP::reduce_net(net, 3).control_points() == net.control_points());
}

TEST_CASE("A central point without influence on a patch has none on the elevated one") {
  Random random(17);
  const std::vector<std::pair<std::size_t, std::size_t>> cases{{3, 1}, {3, 2}, {5, 1}, {4, 3}};
  for (const auto& [n, d] : cases) {
    const Net net = random_net(random, n, d);
    std::vector<Point> points = net.control_points();
    points.back() = Point(123456, 0, -654321);
    for (std::size_t degree = d + 1; degree < d + 4; ++degree)
      CHECK(MP::elevate_net(net, degree).control_points() ==
            MP::elevate_net(net.with_control_points(points), degree).control_points());
  }
}

TEST_CASE("Reducing a net inverts elevation") {
  Random random(8);
  for (std::size_t n = 3; n <= 7; ++n)
    for (std::size_t d = 1; d <= 6; ++d) {
      CAPTURE(n, d);
      const Net net = random_net(random, n, d);
      CHECK(same_but_for_idle_central_point(MP::reduce_net(MP::elevate_net(net)), net));
      if (n <= 5)
        CHECK(same_but_for_idle_central_point(MP::reduce_net(MP::elevate_net(net, d + 3), d), net));
    }
}

TEST_CASE("Reducing any net reduces its boundary curves") {
  Random random(9);
  for (std::size_t d = 2; d <= 7; ++d) {
    CAPTURE(d);
    const Net net = random_net(random, 5, d), reduced = MP::reduce_net(net);
    for (std::size_t i = 0; i < 5; ++i)
      CHECK(reduced.loop()[i].with_layers(1).control_points() ==
            net.loop()[i].with_layers(1).reduced(d - 1).control_points());
  }
}

TEST_CASE("Where all barycentric coordinates are the same an elevated patch has the same point") {
  Random random(17);
  using Jet = MP::Jet_2<FT, 0>;
  const auto middle_of = [](const Net& net) {
    const std::vector<Exact::Point_2> corners{{0, 0}, {4, -1}, {6, 2}, {5, 5}, {2, 7}, {-1, 3}};
    const auto n = static_cast<std::ptrdiff_t>(net.size());
    const MP::Polygonal_domain_2<Exact> domain({corners.begin(), corners.begin() + n});
    const std::vector<Jet> lambda(net.size(), Jet(FT(1) / FT(to_int(net.size()))));
    std::vector<std::array<FT, 3>> points;
    for (const Point& p : net.control_points())
      points.push_back({p.x(), p.y(), p.z()});
    const auto sum = MP::Generalized_bezier_basis(net).combine(domain, lambda.data(), points);
    return Point(sum[0].value(), sum[1].value(), sum[2].value());
  };
  for (std::size_t n = 3; n <= 6; ++n)
    for (std::size_t d = 1; d <= 5; ++d) {
      CAPTURE(n, d);
      const Net net = random_net(random, n, d);
      CHECK(middle_of(MP::elevate_net(net)) == middle_of(net));
    }
}

TEST_CASE("Nets in one plane stay in it") {
  Random random(10);
  for (std::size_t n = 3; n <= 6; ++n) {
    std::vector<Point> points = random_points(random, Net::number_of_control_points(n, 3));
    for (Point& p : points)
      p = Point(p.x(), p.y(), 1 + 2 * p.x() - p.y());
    const Net elevated = MP::elevate_net(Net(n, 3, points), 6);
    for (const Point& p : elevated.control_points())
      CHECK(p.z() == 1 + 2 * p.x() - p.y());
  }
}

TEST_CASE("The net from the ribbons of a tensor product patch is that of the patch") {
  Random random(11);
  for (const std::size_t d : {1, 3, 5}) {
    CAPTURE(d);
    const Grid grid = random_grid(random, d);
    const Loop loop = fixtures::tensor_product_loop<Exact>(grid);
    REQUIRE(MP::smallest_net_degree(loop) == d);
    CHECK(same_but_for_idle_central_point(MP::make_generalized_bezier_net(loop),
                                          tensor_product_net(grid, Point(0, 0, 0))));
    CHECK(same_but_for_idle_central_point(MP::make_generalized_bezier_net(loop, d + 1),
                                          tensor_product_net(elevated_grid(grid), Point(0, 0, 0))));
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(MP::ribbon_mismatch(loop, i) == 0);
  }
}

TEST_CASE("Ribbons of higher degree than the patch they come from give the patch") {
  Random random(12);
  const Grid grid = random_grid(random, 3);
  std::vector<Ribbon> ribbons = fixtures::tensor_product_loop<Exact>(grid).ribbons();
  ribbons[1] = ribbons[1].elevated(5);
  ribbons[2] = ribbons[2].elevated(4);
  const Net net = MP::make_generalized_bezier_net(Loop(ribbons));
  REQUIRE(net.degree() == 5);
  CHECK(same_but_for_idle_central_point(
      net, tensor_product_net(elevated_grid(elevated_grid(grid)), Point(0, 0, 0))));
}

TEST_CASE("A control point of a loop moves with what its neighbours share, as in a control net") {
  Random random(15);
  for (const std::size_t n : {3, 4, 5})
    for (const std::size_t d : {1, 3, 5}) { // ribbons have the points of the net
      const Net net = random_net(random, n, d);
      const Loop loop = net.loop();
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < net.layers(); ++k)
          for (std::size_t j = 0; j <= d; ++j) {
            CAPTURE(n, d, i, j, k);
            const Point p = random_point(random);
            std::vector<Point> points = net.control_points();
            points[net.index(i, j, k)] = p;
            const Loop moved = loop.with_control_point(i, j, k, p),
                       expected = net.with_control_points(points).loop();
            for (std::size_t side = 0; side < n; ++side)
              CHECK(moved[side].control_points() == expected[side].control_points());
          }
    }
}

TEST_CASE("A net has the ribbons from which it was made, whatever their degrees and layers") {
  const unsigned seed = GENERATE(range(1u, 9u));
  CAPTURE(seed);
  Random random(seed);
  // Ribbons that agree at the corners: some of the rows of a net.
  const std::size_t n = random.integer(3, 6), d = random.integer(3, 6);
  CAPTURE(n, d);
  std::vector<Ribbon> ribbons = random_net(random, n, d).loop().ribbons();
  for (Ribbon& r : ribbons)
    r = r.with_layers(random.integer(1, r.layers()));
  const Loop loop(ribbons);
  const Net net = MP::make_generalized_bezier_net(loop, d + random.integer(0, 2));
  for (std::size_t i = 0; i < n; ++i) {
    CHECK(MP::ribbon_mismatch(loop, i) == 0);
    CHECK(net.loop()[i].with_layers(ribbons[i].layers()).control_points() ==
          ribbons[i].elevated(net.degree()).control_points());
  }
}

TEST_CASE("Where ribbons contradict each other a net keeps the boundary and takes means") {
  Random random(13);
  const Grid grid = random_grid(random, 3);
  std::vector<Ribbon> ribbons = fixtures::tensor_product_loop<Exact>(grid).ribbons();
  std::vector<Point> points = ribbons[0].control_points();
  points[4] = points[4] + Vector(0, 0, 3);  // next to the start of the side before
  points[6] = points[6] + Vector(0, 10, 0); // the twist point at the end
  ribbons[0] = Ribbon(3, 2, points);
  const Loop loop(ribbons);
  CHECK(MP::ribbon_mismatch(loop, 0) == 3);
  CHECK(MP::ribbon_mismatch(loop, 1) == 10);
  CHECK(MP::ribbon_mismatch(loop, 2) == 0);
  const Net net = MP::make_generalized_bezier_net(loop);
  CHECK(net.control_point(0, 0, 1) == grid[0][1]);
  CHECK(net.control_point(0, 2, 1) == grid[2][1] + Vector(0, 5, 0));
}

TEST_CASE("Two layers or a high degree raise the degree of the net of a loop") {
  Random random(14);
  std::vector<Ribbon> ribbons;
  const std::vector<Point> corners = random_points(random, 3);
  for (std::size_t i = 0; i < 3; ++i)
    ribbons.emplace_back(1, 1, std::vector<Point>{corners[i], corners[(i + 1) % 3]});
  CHECK(MP::smallest_net_degree(Loop(ribbons)) == 1);
  CHECK(MP::make_generalized_bezier_net(Loop(ribbons)).control_point(1, 0, 0) == corners[1]);
  ribbons[0] = ribbons[0].with_layers(2);
  CHECK(MP::smallest_net_degree(Loop(ribbons)) == 3);
  ribbons[1] = ribbons[1].elevated(4);
  CHECK(MP::make_generalized_bezier_net(Loop(ribbons)).degree() == 4);
}
