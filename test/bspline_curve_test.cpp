// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "curve_fixtures.h"

#include <CGAL/Multisided_patches/ribbons/Bspline_curve_3.h>

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <random>
#include <vector>

using namespace curve_fixtures;

namespace {

using Curve = MP::Bspline_curve_3<Kernel>;
using Double_curve = MP::Bspline_curve_3<Double_kernel>;

constexpr unsigned seed = 20261126;

std::vector<Rational> rationals(std::initializer_list<int> numbers) {
  return std::vector<Rational>(numbers.begin(), numbers.end());
}

// Clamped and not, with simple and multiple knots inside, uneven, and with a first and a last
// control point that have no influence.
struct Example {
  std::size_t degree;
  std::vector<Rational> knots;
};
std::vector<Example> examples() {
  return {{1, rationals({0, 0, 1, 3, 4, 4})},
          {1, rationals({-1, 0, 2, 3})},
          {2, rationals({0, 0, 0, 1, 1, 3, 7, 7, 7})},
          {2, rationals({0, 1, 2, 2, 5, 6, 7, 9})},
          {2, rationals({0, 1, 1, 1, 2, 3, 3, 3, 4})},
          {3, rationals({0, 0, 0, 0, 1, 1, 1, 2, 4, 4, 4, 4})},
          {3, rationals({-3, -1, 0, 1, 2, 2, 5, 6, 7, 8})},
          {3, rationals({-2, 0, 0, 0, 3, 4, 4, 4, 5, 5})},
          {5, rationals({0, 0, 0, 0, 0, 0, 2, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4})}};
}

Curve random_curve(Random& random, const Example& e) {
  return Curve(e.degree, e.knots, random.points(e.knots.size() - e.degree - 1));
}

// The B-spline N_i of degree p by its recursion over half-open intervals, and 0/0 = 0 (de Boor).
Rational basis_function(const std::vector<Rational>& knots, std::size_t i, std::size_t p,
                        const Rational& t) {
  if (p == 0)
    return knots[i] <= t && t < knots[i + 1] ? 1 : 0;
  Rational sum(0);
  if (knots[i] < knots[i + p])
    sum += (t - knots[i]) / (knots[i + p] - knots[i]) * basis_function(knots, i, p - 1, t);
  if (knots[i + 1] < knots[i + p + 1])
    sum += (knots[i + p + 1] - t) / (knots[i + p + 1] - knots[i + 1]) *
           basis_function(knots, i + 1, p - 1, t);
  return sum;
}

// Parameters in the range, without its end: at every knot, and more between two of them than a
// polynomial of degree 5 can have zeros.
std::vector<Rational> parameters(const Curve& c) {
  std::vector<Rational> result;
  for (std::size_t k = c.degree(); k < c.control_points().size(); ++k)
    if (c.knots()[k] < c.knots()[k + 1])
      for (int j = 0; j < 6; ++j)
        result.push_back(c.knots()[k] + (c.knots()[k + 1] - c.knots()[k]) * Rational(j) / 6);
  return result;
}

} // namespace

TEST_CASE("The points of a B-spline curve are sums of B-splines times control points") {
  CAPTURE(seed);
  Random random(seed);
  for (const Example& e : examples()) {
    const Curve c = random_curve(random, e);
    for (const Rational& t : parameters(c)) {
      Vector_3 sum(0, 0, 0);
      Rational weights(0);
      for (std::size_t i = 0; i < c.control_points().size(); ++i) {
        const Rational weight = basis_function(c.knots(), i, c.degree(), t);
        sum = sum + weight * (c.control_points()[i] - CGAL::ORIGIN);
        weights += weight;
      }
      CHECK(weights == 1);
      CHECK(c.point(t) == CGAL::ORIGIN + sum);
    }
  }
}

TEST_CASE("A clamped B-spline curve runs from its first to its last control point") {
  CAPTURE(seed);
  Random random(seed);
  std::size_t clamped = 0;
  for (const Example& e : examples()) {
    const Curve c = random_curve(random, e);
    const auto [begin, end] = c.parameter_range();
    CHECK(begin == e.knots[e.degree]);
    CHECK(end == e.knots[e.knots.size() - e.degree - 1]);
    CHECK(c.is_clamped() == (c.multiplicity(e.knots.front()) == e.degree + 1 &&
                             c.multiplicity(e.knots.back()) == e.degree + 1));
    if (!c.is_clamped())
      continue;
    ++clamped;
    CHECK(c.point(begin) == c.control_points().front());
    CHECK(c.point(end) == c.control_points().back());
  }
  CHECK(clamped == 4);
}

TEST_CASE("A new knot leaves a B-spline curve what it is") {
  CAPTURE(seed);
  Random random(seed);
  for (const Example& e : examples()) {
    const Curve c = random_curve(random, e);
    std::vector<Rational> at = parameters(c);
    at.push_back(c.parameter_range().second);
    for (const Rational& t : at) {
      if (c.multiplicity(t) >= c.degree())
        continue;
      const Curve finer = c.with_knot(t);
      CHECK(finer.multiplicity(t) == c.multiplicity(t) + 1);
      CHECK(finer.control_points().size() == c.control_points().size() + 1);
      CHECK(finer.parameter_range() == c.parameter_range());
      for (const Rational& s : at)
        CHECK(finer.point(s) == c.point(s));
    }
  }
}

TEST_CASE("The Bezier pieces of a B-spline curve are the curve, and have its derivatives") {
  CAPTURE(seed);
  Random random(seed);
  for (const Example& e : examples()) {
    const Curve c = random_curve(random, e);
    const auto pieces = c.bezier_pieces();
    CHECK(pieces.front().begin == c.parameter_range().first);
    CHECK(pieces.back().end == c.parameter_range().second);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const auto& piece = pieces[k];
      CHECK(piece.curve.degree() == c.degree());
      CHECK(piece.begin < piece.end);
      if (k > 0)
        CHECK(pieces[k - 1].end == piece.begin);
      const Rational length = piece.end - piece.begin;
      // At its end there may be the next piece with other derivatives.
      for (int j = 0; j <= 6; ++j) {
        const Rational s = Rational(j) / 6, t = piece.begin + s * length;
        CHECK(piece.curve.point(s) == c.point(t));
        Rational scale(1);
        for (std::size_t order = 1; j < 6 && order <= c.degree() + 1; ++order) {
          scale *= length;
          CHECK(piece.curve.derivative(s, order) == scale * c.derivative(t, order));
        }
      }
    }
    const auto& last = pieces.back();
    CHECK(last.curve.derivative(1) ==
          (last.end - last.begin) * c.derivative(c.parameter_range().second));
  }
}

TEST_CASE("At a knot of multiplicity m the derivatives of order p - m are continuous, no more") {
  CAPTURE(seed);
  Random random(seed);
  std::size_t checked = 0;
  for (const Example& e : examples()) {
    const Curve c = random_curve(random, e);
    const auto pieces = c.bezier_pieces();
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
      const auto &before = pieces[k], &after = pieces[k + 1];
      const std::size_t smooth = c.degree() - c.multiplicity(after.begin);
      CHECK(before.curve.point(1) == after.curve.point(0));
      Rational scale_before(1), scale_after(1);
      for (std::size_t order = 1; order <= smooth + 1; ++order) {
        scale_before *= before.end - before.begin;
        scale_after *= after.end - after.begin;
        const bool same = before.curve.derivative(1, order) / scale_before ==
                          after.curve.derivative(0, order) / scale_after;
        CHECK(same == (order <= smooth));
        ++checked;
      }
    }
  }
  CHECK(checked > 20);
}

TEST_CASE("In double the pieces of a B-spline curve join bit for bit") {
  std::vector<double> knots{0, 0, 0, 0};
  std::vector<Double_point> points;
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> random(0.1, 1);
  for (int i = 0; i < 50; ++i)
    knots.push_back(knots.back() + random(engine));
  knots.insert(knots.end(), 4, knots.back() + 1);
  for (std::size_t i = 0; i + 4 < knots.size(); ++i)
    points.emplace_back(random(engine), random(engine), random(engine));
  const Double_curve c(3, knots, points);
  const auto pieces = c.bezier_pieces();
  CHECK(pieces.size() == 51);
  CHECK(pieces.front().curve.control_point(0) == points.front());
  CHECK(pieces.back().curve.control_point(3) == points.back());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (k > 0)
      CHECK(pieces[k - 1].curve.control_point(3) == pieces[k].curve.control_point(0));
    const double middle = (pieces[k].begin + pieces[k].end) / 2;
    CHECK((pieces[k].curve.point(0.5) - c.point(middle)).squared_length() < 1e-28);
  }
}

TEST_CASE("A B-spline curve refuses sizes that do not fit and knots that make no curve") {
  using Catch::Matchers::Contains;
  const auto make = [](std::size_t degree, std::initializer_list<int> knots, std::size_t n) {
    return Curve(degree, rationals(knots), std::vector<Point_3>(n, Point_3(0, 0, 0)));
  };
  CHECK_NOTHROW(make(2, {0, 0, 0, 1, 1, 1}, 3));
  CHECK_THROWS_WITH(make(0, {0, 1, 2}, 2), Contains("degree from 1 to 1000, not 0"));
  CHECK_THROWS_AS(make(std::numeric_limits<std::size_t>::max(), {0, 1}, 2), MP::Input_error);
  CHECK_THROWS_WITH(make(2, {0, 0, 0, 1, 1}, 2), Contains("at least 3 control points, not 2"));
  CHECK_THROWS_WITH(make(2, {0, 0, 1, 1, 1}, 3), Contains("needs 6 knots, not 5"));
  CHECK_THROWS_WITH(make(2, {0, 0, 0, 1, 2, 1}, 3), Contains("knot 5 is 1, after 2"));
  const std::vector<Double_point> two(2, {0, 0, 0});
  CHECK_THROWS_WITH(Double_curve(1, {-1e308, -1e308, 1e308, 1e308}, two),
                    Contains("too far apart"));
  CHECK_THROWS_WITH(Double_curve(1, {0, 0, 1e-320, 1}, two), Contains("knots 1 and 2"));
  CHECK_THROWS_WITH(make(2, {0, 1, 1, 1, 2, 3}, 3),
                    Contains("from knot 2 to knot 3, is the single number 1"));
  CHECK_THROWS_WITH(make(2, {0, 0, 0, 1, 1, 1, 2, 2, 2}, 6),
                    Contains("knot 1 of a B-spline curve of degree 2 is repeated 3 times, not at "
                             "most 2"));
  CHECK_THROWS_WITH(make(1, {0, 0, 0, 1, 1}, 3), Contains("repeated 3 times, not at most 2"));

  using P = Double_point;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(Double_curve(1, {0, 0, nan, 1}, {P(0, 0, 0), P(1, 0, 0)}),
                    Contains("knot 2 of a B-spline curve is not finite"));
  CHECK_THROWS_WITH(Double_curve(1, {0, 0, 1, 1}, {P(0, 0, 0), P(nan, 0, 0)}),
                    Contains("control point 1 of a B-spline curve is not finite"));
}
