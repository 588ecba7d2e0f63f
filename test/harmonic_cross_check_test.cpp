// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Harmonic coordinates, computed by two methods that share nothing but the domain.

#include "Lightning_coordinates.h"
#include "catch.h"
#include "polygon_fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>

#include <iterator>

using namespace fixtures;

namespace {

using Harmonic_coordinates_2 = MP::Harmonic_coordinates_2<Kernel>;
using Vector_2 = Kernel::Vector_2;

struct Named_domain {
  const char* name;
  Domain domain;
};

std::vector<Named_domain> shapes() {
  return {{"L", Domain(l_shape())},
          {"U", Domain(unit_u_shape())},
          {"comb", Domain(comb())},
          {"star", Domain(star())},
          {"spiral", Domain(spiral(9))}, // one turn
          {"square with a hole", square_with_square_hole()}};
}

Vector_2 inwards(const Domain& domain, std::size_t side) {
  const Vector_2 d = domain.side(side).to_vector() / domain.side_length(side);
  return {-d.y(), d.x()};
}

// Points inside, at distances of 1e-1 to 1e-10 from corners and from sides.
Points points_near_boundary(const Domain& domain) {
  Random random(1);
  Points points;
  const auto add = [&](const Point_2& p) {
    if (domain.locate(p).kind == Domain::Location::Kind::interior)
      points.push_back(p);
  };
  for (std::size_t k = 0; k < domain.size(); ++k) {
    const double sign = domain.corner_type(k) == MP::Corner_type::reflex ? -1 : 1;
    const Vector_2 bisector =
        sign * (domain.side(k).to_vector() / domain.side_length(k) -
                domain.side(domain.prev(k)).to_vector() / domain.side_length(domain.prev(k)));
    for (int exponent = -10; exponent < 0; ++exponent) {
      const double distance = std::pow(10, exponent);
      add(domain.vertex(k) + distance * bisector);
      add(domain.point_on_side(k, random.in(0, 1)) + distance * inwards(domain, k));
      add(domain.point_on_side(k, distance) + distance * inwards(domain, k));
    }
  }
  return points;
}

Points test_points(const Domain& domain, std::size_t count) {
  Points points = random_points_inside(domain, count);
  const Points near = points_near_boundary(domain);
  points.insert(points.end(), near.begin(), near.end());
  return points;
}

using Values = std::vector<std::vector<double>>;

Values values(const Lightning_coordinates& lightning, const Points& points) {
  Values result;
  for (const Point_2& p : points)
    result.push_back(lightning(p));
  return result;
}

Values values(const Harmonic_coordinates_2& harmonic, const Points& points) {
  Values result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    harmonic(points[i], std::back_inserter(result[i]));
  return result;
}

// infinity if anything is not a number
double largest_difference(const Values& a, const Values& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a[i].size(); ++j) {
      const double difference = std::abs(a[i][j] - b[i][j]);
      largest = difference >= 0 ? (std::max)(largest, difference)
                                : std::numeric_limits<double>::infinity();
    }
  return largest;
}

// sum of f(v_i) lambda_i
template <typename Function>
double interpolate(const Domain& domain, const std::vector<double>& lambda, const Function& f) {
  double sum = 0;
  for (std::size_t i = 0; i < domain.size(); ++i)
    sum += f(domain.vertex(i)) * lambda[i];
  return sum;
}

// how far errors of coordinates can get in the sum of f(v_i) lambda_i; and rounding
template <typename Function>
double tolerance(const Domain& domain, double error, const Function& f) {
  double sum = 0;
  for (const Point_2& p : domain.vertices())
    sum += std::abs(f(p));
  return sum * (error + 1e-14);
}

} // namespace

TEST_CASE("lightning coordinates reproduce linear functions", "[harmonic]") {
  for (const unsigned seed : {1, 2, 3}) {
    INFO("seed " << seed);
    Random random(seed);
    const Domain domain(random_polygon(random, 5));
    const Lightning_coordinates lightning(domain, 1e-8, 700);
    const auto one = [](const Point_2&) { return 1.; };
    const auto linear = [](const Point_2& p) { return 2 * p.x() - 3 * p.y() + 1; };
    for (const Point_2& p : test_points(domain, 50)) {
      const std::vector<double> lambda = lightning(p);
      CHECK(std::abs(interpolate(domain, lambda, one) - 1) <=
            tolerance(domain, lightning.error_bound(), one));
      CHECK(std::abs(interpolate(domain, lambda, linear) - linear(p)) <=
            tolerance(domain, lightning.error_bound(), linear));
    }
  }
}

TEST_CASE("lightning coordinates of a square are bilinear", "[harmonic]") {
  const Domain domain(square());
  const Lightning_coordinates lightning(domain, 1e-13);
  CHECK(lightning.error_bound() < 1e-13);
  for (const Point_2& p : test_points(domain, 50)) {
    const std::vector<double> lambda = lightning(p);
    const double x = p.x(), y = p.y();
    CHECK(std::abs(lambda[0] - (1 - x) * (1 - y)) < 1e-13);
    CHECK(std::abs(lambda[1] - x * (1 - y)) < 1e-13);
    CHECK(std::abs(lambda[2] - x * y) < 1e-13);
    CHECK(std::abs(lambda[3] - (1 - x) * y) < 1e-13);
  }
}

TEST_CASE("lightning coordinates reproduce xy on rectilinear domains with holes", "[harmonic]") {
  for (const Domain& domain : {square_with_square_hole(), square_with_two_holes()}) {
    const Lightning_coordinates lightning(domain, 1e-8);
    REQUIRE(lightning.error_bound() < 1e-8);
    const auto xy = [](const Point_2& p) { return p.x() * p.y(); };
    for (const Point_2& p : test_points(domain, 50))
      CHECK(std::abs(interpolate(domain, lightning(p), xy) - xy(p)) <=
            tolerance(domain, lightning.error_bound(), xy));
  }
}

TEST_CASE("two independent methods agree on harmonic coordinates, and on their errors",
          "[harmonic]") {
  for (const Named_domain& shape : shapes()) {
    INFO(shape.name);
    const Points points = test_points(shape.domain, 300);
    const Lightning_coordinates lightning(shape.domain, 3e-11);
    REQUIRE(lightning.error_bound() <= 3e-11);
    const Values expected = values(lightning, points);
    CHECK(largest_difference(values(Harmonic_coordinates_2(shape.domain, 1e-11), points),
                             expected) < 1e-10);
    for (const double target : {1e-4, 1e-6, 1e-8}) {
      INFO("target error " << target);
      const Harmonic_coordinates_2 harmonic(shape.domain, target);
      CHECK(largest_difference(values(harmonic, points), expected) <=
            harmonic.error_bound() + lightning.error_bound());
    }
  }
}

TEST_CASE("two independent methods agree on random domains", "[harmonic]") {
  struct Kind {
    unsigned domains;
    std::size_t sides, holes;
  };
  int good = 0;
  for (const Kind& kind : {Kind{8, 3, 0}, Kind{8, 5, 0}, Kind{4, 4, 1}, Kind{2, 8, 0}})
    for (unsigned seed = 1; seed <= kind.domains; ++seed) {
      INFO(kind.sides << " sides, " << kind.holes << " holes, seed " << seed);
      Random random(seed);
      const Domain domain = random_domain(random, kind.sides, kind.holes);
      const Lightning_coordinates lightning(domain, 1e-8, 700);
      const Harmonic_coordinates_2 harmonic(domain, 1e-9);
      const Points points = test_points(domain, 100);
      CHECK(largest_difference(values(harmonic, points), values(lightning, points)) <=
            harmonic.error_bound() + lightning.error_bound());
      good += lightning.error_bound() < 1e-7 ? 1 : 0;
    }
  // Spikes and slots are too much for the lightning method. Of many domains of these kinds, 100,
  // 93, 80 and 72 percent were good, of these 22 all but 1.
  CHECK(good >= 15);
}
