// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "s_patch_fixtures.h"

#include <CGAL/Multisided_patches/analysis/continuity_report.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

using namespace s_patch_fixtures;

namespace {

Rational rational(Random& random) {
  return Rational(static_cast<int>(random.integer(0, 200)) - 100) / Rational(97);
}

template <typename Traits>
MP::S_patch_net_3<Traits> random_net(Random& random, std::size_t n, std::size_t depth) {
  std::vector<typename Traits::Point_3> points;
  const std::size_t size = MP::S_patch_net_3<Traits>::number_of_control_points(n, depth);
  for (std::size_t i = 0; i < size; ++i)
    points.emplace_back(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
  return {n, depth, points};
}

// Any numbers with the sum 1, some of them negative.
std::vector<Rational> random_lambda(Random& random, std::size_t n) {
  std::vector<Rational> lambda{Rational(1)};
  for (std::size_t k = 1; k < n; ++k) {
    lambda.push_back(rational(random));
    lambda[0] -= lambda[k];
  }
  return lambda;
}

// The basis times the net, at coordinates that need no domain: the basis asks only for its size.
template <typename T, typename Traits>
std::array<T, 3> combined(const MP::S_patch_net_3<Traits>& net, const std::vector<T>& lambda) {
  const MP::S_patch_basis basis(net.size(), net.depth());
  return basis.combine(lambda, lambda.data(), net.control_points());
}

int factorial(std::size_t n) {
  return n == 0 ? 1 : static_cast<int>(n) * factorial(n - 1);
}

template <typename Index>
Rational multinomial(const Index& i) {
  Rational result(factorial(std::accumulate(i.begin(), i.end(), std::size_t(0))));
  for (const std::size_t k : i)
    result /= Rational(factorial(k));
  return result;
}

Rational power(const Rational& x, std::size_t exponent) {
  return exponent == 0 ? Rational(1) : Rational(x * power(x, exponent - 1));
}

Rational bernstein(std::size_t degree, std::size_t k, const Rational& t) {
  return multinomial(Index{k, degree - k}) * power(t, k) * power(1 - t, degree - k);
}

using Exact_point = Exact::Point_3;
using Tensor_net = std::vector<std::vector<Exact_point>>;

std::array<Rational, 3> tensor_product_point(const Tensor_net& net, const Rational& u,
                                             const Rational& v) {
  std::array<Rational, 3> sum{};
  for (std::size_t a = 0; a < net.size(); ++a)
    for (std::size_t b = 0; b < net.size(); ++b)
      for (int c = 0; c < 3; ++c)
        sum[c] += bernstein(net.size() - 1, a, u) * bernstein(net.size() - 1, b, v) * net[a][b][c];
  return sum;
}

std::vector<Rational> bilinear(const Rational& u, const Rational& v) {
  return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
}

} // namespace

TEST_CASE("Control points of an S-patch come in descending order of their indices") {
  for (const std::size_t n : {3, 4, 6})
    for (const std::size_t depth : {1, 2, 5}) {
      Random random(1);
      const Net net = random_net<Kernel>(random, n, depth);
      std::size_t count = 0;
      Index before;
      net.for_each_control_point([&](const Index& index, const Point_3& p) {
        CHECK(index.size() == n);
        CHECK(std::accumulate(index.begin(), index.end(), std::size_t(0)) == depth);
        CHECK((count == 0 || index < before));
        CHECK(net.index(index) == count);
        CHECK(net.multi_index(count) == index);
        CHECK(net.control_point(index) == p);
        before = index;
        ++count;
      });
      CHECK(count == net.control_points().size());
      CHECK(before.back() == depth);
    }
  CHECK(Net::number_of_control_points(5, 8) == 495); // (12 choose 8)
  CHECK(Net::number_of_control_points(6, 5) == 252);
}

TEST_CASE("The basis of S-patches agrees with the algorithm of de Casteljau") {
  const unsigned seed = 7;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t n = 3; n <= 6; ++n)
    for (std::size_t depth = 1; depth <= 4; ++depth) {
      const Exact_net net = random_net<Exact>(random, n, depth);
      const std::vector<Rational> lambda = random_lambda(random, n);
      const std::array<Rational, 3> p = MP::s_patch_de_casteljau(net, lambda.data());
      CHECK(p == combined(net, lambda));

      const MP::S_patch_basis basis(n, depth);
      CHECK(basis.number_of_sides() == n);
      REQUIRE(basis.size() == net.control_points().size());
      std::vector<Rational> weights(basis.size());
      basis.evaluate(lambda, lambda.data(), weights.data());
      CHECK(std::accumulate(weights.begin(), weights.end(), Rational(0)) == 1);
      std::array<Rational, 3> sum{};
      for (std::size_t i = 0; i < weights.size(); ++i) {
        Rational weight = multinomial(net.multi_index(i));
        for (std::size_t k = 0; k < n; ++k)
          weight *= power(lambda[k], net.multi_index(i)[k]);
        CHECK(weights[i] == weight);
        for (int c = 0; c < 3; ++c)
          sum[c] += weights[i] * net.control_points()[i][c];
      }
      CHECK(sum == p);
    }
}

TEST_CASE("Depth elevation leaves an S-patch where it is") {
  const unsigned seed = 8;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t n = 3; n <= 6; ++n)
    for (std::size_t depth = 1; depth <= 3; ++depth) {
      const Exact_net net = random_net<Exact>(random, n, depth);
      const Exact_net elevated = net.elevated().elevated();
      CHECK(elevated.depth() == depth + 2);
      const std::vector<Rational> lambda = random_lambda(random, n);
      CHECK(combined(elevated, lambda) == combined(net, lambda));
      for (std::size_t i = 0; i < n; ++i)
        CHECK(elevated.boundary(i).control_points() ==
              net.boundary(i).elevated(depth + 2).control_points());
    }
}

TEST_CASE("A three-sided S-patch is a Bezier triangle") {
  const unsigned seed = 9;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t d = 1; d <= 6; ++d) {
    const Exact_net net = random_net<Exact>(random, 3, d);
    const std::vector<Rational> lambda = random_lambda(random, 3);
    std::array<Rational, 3> sum{};
    std::size_t point = 0;
    for (std::size_t i = d + 1; i-- > 0;)
      for (std::size_t j = d - i + 1; j-- > 0; ++point)
        for (int c = 0; c < 3; ++c)
          sum[c] += Rational(factorial(d)) / factorial(i) / factorial(j) / factorial(d - i - j) *
                    power(lambda[0], i) * power(lambda[1], j) * power(lambda[2], d - i - j) *
                    net.control_points()[point][c];
    CHECK(combined(net, lambda) == sum);
  }
}

TEST_CASE("A four-sided S-patch on a square is a tensor product patch") {
  const unsigned seed = 10;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t d = 1; d <= 4; ++d) {
    const Exact_net net = random_net<Exact>(random, 4, d);
    // u^a (1-u)^(d-a) v^b (1-v)^(d-b) is the product of coordinates for a = i_1 + i_2 and
    // b = i_2 + i_3; its coefficients add up.
    Tensor_net tensor(d + 1, std::vector<Exact_point>(d + 1, Exact_point(0, 0, 0)));
    net.for_each_control_point([&](const Index& i, const Exact_point& p) {
      const std::size_t a = i[1] + i[2], b = i[2] + i[3];
      const Rational share =
          multinomial(i) / (multinomial(Index{a, d - a}) * multinomial(Index{b, d - b}));
      tensor[a][b] = tensor[a][b] + share * (p - CGAL::ORIGIN);
    });
    const Rational u = rational(random), v = rational(random);
    CHECK(combined(net, bilinear(u, v)) == tensor_product_point(tensor, u, v));

    // The other way: all points with the same a and b at the place of the tensor point.
    std::vector<Exact_point> points;
    net.for_each_control_point([&](const Index& i, const Exact_point&) {
      points.push_back(tensor[i[1] + i[2]][i[2] + i[3]]);
    });
    CHECK(combined(net.with_control_points(points), bilinear(u, v)) ==
          tensor_product_point(tensor, u, v));

    // As a patch, Wachspress coordinates of the square are the bilinear ones.
    const MP::S_patch_3<Exact> patch(net);
    const Rational s = Rational(static_cast<int>(random.integer(1, 96))) / 97,
                   t = Rational(static_cast<int>(random.integer(1, 96))) / 97;
    const Exact_point p = patch(Exact::Point_2(s, t));
    CHECK(std::array<Rational, 3>{p.x(), p.y(), p.z()} == tensor_product_point(tensor, s, t));
  }
}

TEST_CASE("Jets give the derivatives of an S-patch") {
  const unsigned seed = 11;
  CAPTURE(seed);
  Random random(seed);
  using Jet = MP::Jet_2<Rational, 2>;
  const std::size_t n = 5, depth = 4;
  const Exact_net net = random_net<Exact>(random, n, depth);
  // Coordinates that are affine in u and v; so the patch is a polynomial of degree 4, for which
  // differences of five values are no approximations.
  const std::vector<Rational> at = random_lambda(random, n);
  std::vector<Rational> by_u = random_lambda(random, n), by_v = random_lambda(random, n);
  by_u[0] -= 1;
  by_v[0] -= 1;
  std::vector<Jet> lambda(n);
  for (std::size_t k = 0; k < n; ++k) {
    lambda[k] = Jet(at[k]);
    lambda[k][1] = by_u[k];
    lambda[k][2] = by_v[k];
  }
  const auto value = [&](int u, int v, std::size_t c) {
    std::vector<Rational> l(n);
    for (std::size_t k = 0; k < n; ++k)
      l[k] = at[k] + u * by_u[k] + v * by_v[k];
    return combined(net, l)[c];
  };
  const std::array<Rational, 5> first{Rational(1) / 12, Rational(-8) / 12, Rational(0),
                                      Rational(8) / 12, Rational(-1) / 12};
  const std::array<Rational, 5> second{Rational(-1) / 12, Rational(16) / 12, Rational(-30) / 12,
                                       Rational(16) / 12, Rational(-1) / 12};
  const std::array<Jet, 3> p = combined(net, lambda);
  for (std::size_t c = 0; c < 3; ++c) {
    Rational u(0), v(0), uu(0), uv(0), vv(0);
    for (int a = -2; a <= 2; ++a) {
      u += first[a + 2] * value(a, 0, c);
      v += first[a + 2] * value(0, a, c);
      uu += second[a + 2] * value(a, 0, c);
      vv += second[a + 2] * value(0, a, c);
      for (int b = -2; b <= 2; ++b)
        uv += first[a + 2] * first[b + 2] * value(a, b, c);
    }
    CHECK(p[c][0] == value(0, 0, c));
    CHECK(p[c][1] == u);
    CHECK(p[c][2] == v);
    CHECK(p[c][3] == uu);
    CHECK(p[c][4] == uv);
    CHECK(p[c][5] == vv);
  }
  // The weights sum to 1, and their derivatives to 0.
  const MP::S_patch_basis basis(n, depth);
  std::vector<Jet> weights(basis.size());
  basis.evaluate(lambda, lambda.data(), weights.data());
  const Jet sum = std::accumulate(weights.begin(), weights.end(), Jet());
  CHECK(sum.value() == 1);
  for (std::size_t k = 1; k < Jet::size; ++k)
    CHECK(sum[k] == 0);
}

TEST_CASE("Weights of great depth neither overflow nor lose their sum") {
  const MP::S_patch_basis basis(3, MP::S_patch_basis::max_depth);
  std::vector<double> weights(basis.size());
  for (const std::vector<double>& lambda :
       {std::vector<double>{0.5, 0.25, 0.25}, {1, 0, 0}, {0, 0.5, 0.5}, {0.01, 0.01, 0.98}}) {
    basis.evaluate(lambda, lambda.data(), weights.data());
    CHECK(std::accumulate(weights.begin(), weights.end(), 0.0) == Approx(1).epsilon(1e-11));
  }
}

TEST_CASE(
    "Second derivatives of the greatest depth are finite on small domains, near vertices too") {
  using Jet = MP::Jet_2<double, 2>;
  const std::size_t depth = MP::S_patch_basis::max_depth;
  const MP::S_patch_basis basis(3, depth);
  std::vector<Jet> weights(basis.size());
  for (const double side : {1.0, 1e-3, 1e-50})
    for (const double near : {0.0, 1e-9, 1e-3, 0.3}) {
      CAPTURE(side, near);
      std::vector<Jet> lambda{Jet(1 - 2 * near), Jet(near), Jet(near)};
      lambda[0][1] = lambda[0][2] = -1 / side;
      lambda[1][1] = lambda[2][2] = 1 / side;
      basis.evaluate(lambda, lambda.data(), weights.data());
      CHECK(std::all_of(weights.begin(), weights.end(), [](const Jet& w) {
        return std::all_of(&w[0], &w[0] + Jet::size, [](double x) { return std::isfinite(x); });
      }));
      // The net of a paraboloid, z = λ_1².
      std::vector<Point_3> points;
      const Net net(3, depth, std::vector<Point_3>(basis.size(), Point_3(0, 0, 0)));
      const double d = static_cast<double>(depth);
      net.for_each_control_point([&](const Index& i, const Point_3&) {
        const double k = static_cast<double>(i[1]);
        points.emplace_back(k / d, static_cast<double>(i[2]) / d, k * (k - 1) / (d * (d - 1)));
      });
      const std::array<Jet, 3> p = basis.combine(lambda, lambda.data(), points);
      const auto close_to = [&](double x) { return Approx(x).epsilon(0).margin(1e-8); };
      CHECK(p[0][1] * side == close_to(1));
      CHECK(p[1][1] * side == close_to(0));
      CHECK(p[2][1] * side == close_to(2 * near));
      CHECK(p[2][3] * side * side == close_to(2));
      CHECK(p[2][4] * side * side == close_to(0));
      CHECK(p[2][5] * side * side == close_to(0));
    }
}

TEST_CASE("The boundary of an S-patch is that of its net, in exact arithmetic") {
  const unsigned seed = 12;
  CAPTURE(seed);
  Random random(seed);
  const Exact_net net = random_net<Exact>(random, 5, 3);
  const MP::S_patch_3<Exact> patch(
      net, MP::Wachspress_coordinates_2<Exact>(MP::Polygonal_domain_2<Exact>(pentagon<Exact>())));
  for (std::size_t i = 0; i < 5; ++i)
    for (const Rational& s : parameters()) {
      const auto p = patch.evaluate<1>(patch.domain().point_on_side(i, s),
                                       patch.domain().location_on_side(i, s));
      const Exact_point expected = net.boundary(i).boundary_point(s);
      CHECK(Exact_point(p[0].value(), p[1].value(), p[2].value()) == expected);
      CHECK(patch.point_on_side(i, s) == expected);
    }
}

TEST_CASE("An S-patch over an L has the boundary curves of its net") {
  const unsigned seed = 13;
  CAPTURE(seed);
  Random random(seed);
  const Net net = random_net<Kernel>(random, 6, 3);
  const MP::S_patch_3<Kernel, Mean_value> patch(net, Mean_value(Domain(l_shape())));
  CHECK(MP::continuity_report(patch).largest_position().value < 1e-14);
  // Inside, it goes over into the boundary, at the reflex corner too.
  for (const double step : {1e-3, 1e-6, 1e-9})
    for (const double s : {0.0, 0.3, 0.8}) {
      const Point_2 on_side = patch.domain().point_on_side(2, s);
      CHECK(distance(patch(Point_2(on_side.x(), on_side.y() - step)), patch.point_on_side(2, s)) <
            50 * step);
    }
}

TEST_CASE("Nets of S-patches that do not fit are refused") {
  using Catch::Matchers::Contains;
  const std::vector<Point_3> ten(10, Point_3(0, 0, 0));
  CHECK_THROWS_AS(Net(2, 3, ten), MP::Input_error);
  CHECK_THROWS_AS(Net(3, 0, ten), MP::Input_error);
  CHECK_NOTHROW(Net(3, 3, ten));
  CHECK_THROWS_WITH(Net(4, 3, ten), Contains("has 20 points, not 10"));
  CHECK_THROWS_WITH(Net(20, 20, ten), Contains("more than 5000000"));
  constexpr std::size_t huge = std::numeric_limits<std::size_t>::max();
  CHECK_THROWS_AS(Net(huge, 3, ten), MP::Input_error);
  CHECK_THROWS_AS(Net(3, huge, ten), MP::Input_error);
  CHECK_THROWS_AS(Net(huge, huge, ten), MP::Input_error);
  CHECK_THROWS_AS(Net(1000, 200, ten), MP::Input_error);
  CHECK(Net::number_of_control_points(3, 200) == 20301);
  CHECK_THROWS_WITH(Net(3, 201, ten), Contains("beyond the largest, 1000 sides and depth 200"));
  CHECK(MP::S_patch_net_3<CGAL::Simple_cartesian<float>>::max_depth == 60);
  std::vector<Point_3> bad = ten;
  bad[7] = Point_3(0, std::numeric_limits<double>::infinity(), 0);
  CHECK_THROWS_WITH(Net(3, 3, bad), Contains("control point 7"));
  CHECK_THROWS_AS(Net(3, 3, ten).loop(), MP::Input_error); // all points coincide
}
