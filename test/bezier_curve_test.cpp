// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "curve_fixtures.h"

#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/ribbons/Bezier_curve_3.h>

#include <CGAL/Exact_rational.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

using namespace curve_fixtures;

namespace {

using Curve = MP::Bezier_curve_3<Kernel>;
using Double_curve = MP::Bezier_curve_3<Double_kernel>;

constexpr unsigned seed = 20261125;

Curve random_curve(Random& random, std::size_t degree) {
  return Curve(random.points(degree + 1));
}

// More parameters than a polynomial of degree 9 can have zeros: two polynomials that agree on all
// of them are the same.
std::vector<Rational> parameters() {
  std::vector<Rational> s;
  for (int k = 0; k <= 10; ++k)
    s.push_back(Rational(k) / Rational(10));
  return s;
}

Rational binomial(std::size_t n, std::size_t k) {
  Rational b(1);
  for (std::size_t i = 1; i <= k; ++i)
    b = b * Rational(static_cast<int>(n + 1 - i)) / Rational(static_cast<int>(i));
  return b;
}

// The coefficients of the powers of s: (d over k) times the k-th difference of the first points.
std::vector<Vector_3> power_coefficients(const Curve& c) {
  std::vector<Vector_3> coefficients;
  for (std::size_t k = 0; k <= c.degree(); ++k) {
    Vector_3 difference(0, 0, 0);
    for (std::size_t j = 0; j <= k; ++j) {
      const Vector_3 term = binomial(k, j) * (c.control_point(j) - CGAL::ORIGIN);
      difference = (k - j) % 2 == 0 ? difference + term : difference - term;
    }
    coefficients.push_back(binomial(c.degree(), k) * difference);
  }
  return coefficients;
}

std::vector<Vector_3> derivative(const std::vector<Vector_3>& coefficients) {
  std::vector<Vector_3> result;
  for (std::size_t k = 1; k < coefficients.size(); ++k)
    result.push_back(Rational(static_cast<int>(k)) * coefficients[k]);
  return result;
}

Vector_3 value(const std::vector<Vector_3>& coefficients, const Rational& s) {
  Vector_3 sum(0, 0, 0);
  for (std::size_t k = coefficients.size(); k > 0; --k)
    sum = s * sum + coefficients[k - 1];
  return sum;
}

Rational squared_distance(const Curve& a, const Curve& b) {
  Rational sum(0);
  for (std::size_t j = 0; j <= a.degree(); ++j)
    sum += (a.control_point(j) - b.control_point(j)).squared_length();
  return sum;
}

} // namespace

TEST_CASE("The points of a Bezier curve are Bernstein sums of its control points") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t degree = 1; degree <= 9; ++degree) {
    const Curve c = random_curve(random, degree);
    for (const Rational& s : parameters()) {
      std::vector<Rational> b(degree + 1);
      MP::internal::bernstein_polynomials(degree, s, b.data());
      Vector_3 sum(0, 0, 0);
      for (std::size_t j = 0; j <= degree; ++j)
        sum = sum + b[j] * (c.control_point(j) - CGAL::ORIGIN);
      CHECK(c.point(s) == CGAL::ORIGIN + sum);
      CHECK(c.reversed().point(1 - s) == c.point(s));
    }
  }
}

TEST_CASE("The derivatives of a Bezier curve are those of its polynomial, of all orders") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t degree = 1; degree <= 6; ++degree) {
    const Curve c = random_curve(random, degree);
    std::vector<Vector_3> coefficients = power_coefficients(c);
    for (const Rational& s : parameters())
      CHECK(c.point(s) == CGAL::ORIGIN + value(coefficients, s));
    for (std::size_t order = 1; order <= degree + 2; ++order) {
      coefficients = derivative(coefficients);
      for (const Rational& s : parameters())
        CHECK(c.derivative(s, order) == value(coefficients, s));
    }
  }
}

TEST_CASE("The pieces of a Bezier curve are the curve") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t degree = 1; degree <= 9; ++degree) {
    const Curve c = random_curve(random, degree);
    for (const Rational& m : {Rational(0), Rational(2) / 7, Rational(1)}) {
      const auto [left, right] = c.subdivided(m);
      CHECK(left.degree() == degree);
      for (const Rational& s : parameters()) {
        CHECK(left.point(s) == c.point(m * s));
        CHECK(right.point(s) == c.point(m + (1 - m) * s));
      }
    }
    for (const Rational& a : {Rational(0), Rational(2) / 7, Rational(1)})
      for (const Rational& b : {Rational(0), Rational(3) / 5, Rational(1)}) {
        if (a == b)
          continue;
        const Curve piece = c.restricted(a, b);
        CHECK(piece.degree() == degree);
        for (const Rational& s : parameters())
          CHECK(piece.point(s) == c.point(a + (b - a) * s));
      }
  }
}

TEST_CASE("A Bezier curve of a higher degree is the same curve, and is reduced to it again") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t degree = 1; degree <= 8; ++degree) {
    const Curve c = random_curve(random, degree), higher = c.elevated();
    CHECK(higher.degree() == degree + 1);
    for (const Rational& s : parameters())
      CHECK(higher.point(s) == c.point(s));
    CHECK(higher.reduced().control_points() == c.control_points());
    CHECK(c.elevated_to(degree + 3).control_points() ==
          higher.elevated().elevated().control_points());
    CHECK(c.elevated_to(degree).control_points() == c.control_points());
  }
}

// Differences and quotients of some number types are expressions that refer to their operands.
TEST_CASE("A Bezier curve is elevated and reduced in numbers that are computed late") {
  using Late_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const MP::Bezier_curve_3<Late_kernel> c({{0, 1, 2}, {3, 5, 8}, {13, 21, 34}, {-1, 1, 7}});
  CHECK(c.elevated_to(6).reduced().reduced().reduced().control_points() == c.control_points());
}

TEST_CASE("No other curve of the lower degree has an elevation closer to a Bezier curve") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t degree = 2; degree <= 9; ++degree) {
    const Curve c = random_curve(random, degree), reduced = c.reduced();
    CHECK(reduced.degree() == degree - 1);
    CHECK(reduced.control_point(0) == c.control_point(0));
    CHECK(reduced.control_point(degree - 1) == c.control_point(degree));
    CHECK(reduced.reversed().control_points() == c.reversed().reduced().control_points());
    const Rational closest = squared_distance(reduced.elevated(), c);
    CHECK(closest > 0);
    // The distance is a quadratic function of the control points: it is smallest where it grows by
    // the same in opposite directions.
    for (std::size_t j = 1; j + 1 < degree; ++j) {
      const Vector_3 step = random.point() - CGAL::ORIGIN;
      std::vector<Point_3> there = reduced.control_points(), back = there;
      there[j] = there[j] + step;
      back[j] = back[j] - step;
      const Rational d = squared_distance(Curve(there).elevated(), c);
      CHECK(d > closest);
      CHECK(d == squared_distance(Curve(back).elevated(), c));
    }
  }
}

TEST_CASE("Reduction is stable at degrees whose binomial coefficients are huge") {
  std::vector<Double_point> points;
  for (int j = 0; j <= 1000; ++j)
    points.emplace_back(j, std::sin(j / 100.), 1);
  const Double_curve c(points), reduced = c.reduced();
  for (const double s : {0., 0.1, 0.5, 0.97, 1.}) {
    const auto p = c.point(s), q = reduced.point(s);
    CHECK(p.x() == Approx(1000 * s).epsilon(0).margin(1e-9));
    CHECK((p - q).squared_length() < 1e-18);
  }
}

TEST_CASE("A Bezier curve in double starts and ends exactly at its end points, as do its pieces") {
  const Double_curve c({{0.1, 0.2, 1e9}, {0.7, 1. / 3, 5}, {1e-9, 3, 0.3}, {1. / 7, 8, 1e-3}});
  CHECK(c.point(0) == c.control_point(0));
  CHECK(c.point(1) == c.control_point(3));
  const auto [left, right] = c.subdivided(0.3);
  CHECK(left.control_point(0) == c.control_point(0));
  CHECK(left.control_point(3) == right.control_point(0));
  CHECK(right.control_point(3) == c.control_point(3));
}

TEST_CASE("Where control points of a Bezier curve in double coincide, its pieces stay") {
  CAPTURE(seed);
  Random random(seed);
  const auto number = [&] { return CGAL::to_double(random.number()); };
  for (std::size_t degree = 1; degree <= 9; ++degree) {
    const Double_point p(number(), number(), number());
    const std::vector<Double_point> points(degree + 1, p);
    const Double_curve c(points);
    for (const double s : {0., 0.1, 0.3, 0.5, 0.7, 1.}) {
      CHECK(c.point(s) == p);
      CHECK(c.subdivided(s).first.control_points() == points);
      CHECK(c.subdivided(s).second.control_points() == points);
    }
  }
}

TEST_CASE("The pieces of a Bezier curve in double are the curve but for rounding") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t degree = 1; degree <= 9; ++degree) {
    const Curve exact = random_curve(random, degree);
    std::vector<Double_point> points;
    std::vector<Point_3> rounded;
    for (const Point_3& p : exact.control_points()) {
      points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      rounded.emplace_back(points.back().x(), points.back().y(), points.back().z());
    }
    const Double_curve piece = Double_curve(points).restricted(0.3, 0.8);
    const Curve expected = Curve(rounded).restricted(0.3, 0.8);
    for (std::size_t j = 0; j <= degree; ++j)
      for (int c = 0; c < 3; ++c)
        CHECK(piece.control_point(j)[c] ==
              Approx(CGAL::to_double(expected.control_point(j)[c])).epsilon(0).margin(2e-13));
  }
}

TEST_CASE("The length of a Bezier curve is that of its pieces together") {
  const Double_curve parabola({{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}}); // y = x²
  const double length = std::sqrt(5.0) / 2 + std::asinh(2.0) / 4;
  CHECK(parabola.arc_length() == Approx(length).epsilon(1e-12));
  const auto [left, right] = parabola.subdivided(0.3);
  CHECK(left.arc_length() + right.arc_length() == Approx(length).epsilon(1e-12));
}

TEST_CASE("A Bezier curve refuses too few or too many points, and such as are not finite") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(Curve({}), Contains("at least 2 control points, not 0"));
  CHECK_THROWS_AS(Curve({Point_3(0, 0, 0)}), MP::Input_error);
  CHECK_THROWS_WITH(Curve(std::vector<Point_3>(1002, Point_3(0, 0, 0))),
                    Contains("degree 1001") && Contains("1000"));
  CHECK_THROWS_AS(Curve(std::vector<Point_3>(1001, Point_3(0, 0, 0))).elevated(), MP::Input_error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(Double_curve({{0, 0, 0}, {0, nan, 0}}),
                    Contains("control point 1 of a Bezier curve is not finite"));
}
