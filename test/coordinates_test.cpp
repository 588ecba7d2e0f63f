// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>

#include <CGAL/Barycentric_coordinates_2/Mean_value_coordinates_2.h>
#include <CGAL/Barycentric_coordinates_2/Wachspress_coordinates_2.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <iterator>

using namespace fixtures;
using Harmonic = MP::Harmonic_coordinates_2<Kernel>;
using Mean_value = MP::Mean_value_coordinates_2<Kernel>;
using Wachspress = MP::Wachspress_coordinates_2<Kernel>;
template <int Order>
using Jet = MP::Jet_2<double, Order>;

namespace {

template <typename Coordinates>
constexpr bool needs_convex = std::is_same<Coordinates, Wachspress>::value;

template <typename Coordinates>
std::vector<Domain> zoo(Random& random) {
  std::vector<Domain> domains;
  for (std::size_t n : {3, 4, 5, 8, 13})
    domains.emplace_back(convex_polygon(random, n));
  if (!needs_convex<Coordinates>) {
    domains.emplace_back(l_shape());
    domains.emplace_back(u_shape());
    for (std::size_t n : {6, 10, 15})
      domains.emplace_back(star_shaped_polygon(random, n, 0.3));
    domains.emplace_back(
        Domain({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}));
  }
  return domains;
}

template <int Order, typename Coordinates>
std::vector<Jet<Order>> jets(const Coordinates& coordinates, const Point_2& p) {
  std::vector<Jet<Order>> lambda(coordinates.domain().size());
  coordinates.template evaluate<Order>(p, coordinates.domain().locate(p), lambda.data());
  return lambda;
}

template <typename Coordinates>
std::vector<double> values(const Coordinates& coordinates, const Point_2& p) {
  std::vector<double> result;
  coordinates(p, std::back_inserter(result));
  return result;
}

} // namespace

TEMPLATE_TEST_CASE("Coordinates sum to one and reproduce the point, with all derivatives", "",
                   Wachspress, Mean_value, Harmonic) {
  const unsigned seed = 20260103;
  CAPTURE(seed);
  Random random(seed);
  for (const Domain& domain : zoo<TestType>(random)) {
    CAPTURE(domain.size());
    const TestType coordinates(domain);
    for (int k = 0; k < 20; ++k) {
      const Point_2 p = interior_point(random, domain);
      Jet<2> one, u, v;
      double size = 1; // derivatives grow near the boundary, and their rounding with them
      const auto lambda = jets<2>(coordinates, p);
      for (std::size_t i = 0; i < domain.size(); ++i) {
        one += lambda[i];
        u += lambda[i] * domain.vertex(i).x();
        v += lambda[i] * domain.vertex(i).y();
        for (std::size_t e = 0; e < 6; ++e)
          size = (std::max)(size, std::abs(lambda[i][e]));
      }
      one -= Jet<2>(1);
      u -= Jet<2>::u_variable(p.x());
      v -= Jet<2>::v_variable(p.y());
      for (std::size_t e = 0; e < 6; ++e) {
        CHECK(std::abs(one[e]) < 1e-12 * size);
        CHECK(std::abs(u[e]) < 1e-12 * size);
        CHECK(std::abs(v[e]) < 1e-12 * size);
      }
    }
  }
}

TEMPLATE_TEST_CASE("On a side coordinates are exactly linear, at a vertex exactly 0 and 1", "",
                   Wachspress, Mean_value, Harmonic) {
  Random random(7);
  for (const Domain& domain : zoo<TestType>(random)) {
    const TestType coordinates(domain);
    for (std::size_t i = 0; i < domain.size(); ++i) {
      const auto at_vertex = values(coordinates, domain.vertex(i));
      for (std::size_t j = 0; j < domain.size(); ++j)
        CHECK(at_vertex[j] == (i == j ? 1 : 0));
      const double s = random.in(0.01, 0.99);
      std::vector<Jet<1>> on_side(domain.size());
      coordinates.template evaluate<1>(domain.point_on_side(i, s), Domain::Location::on_side(i, s),
                                       on_side.data());
      for (std::size_t j = 0; j < domain.size(); ++j)
        CHECK(on_side[j].value() == (j == i ? 1 - s : j == domain.next(i) ? s : 0));
    }
  }
}

TEMPLATE_TEST_CASE("Derivatives are the limits of differences", "", Wachspress, Mean_value,
                   Harmonic) {
  const unsigned seed = 20260104;
  CAPTURE(seed);
  Random random(seed);
  for (const Domain& domain : zoo<TestType>(random)) {
    const TestType coordinates(domain);
    for (int k = 0; k < 10; ++k) {
      const Point_2 p = interior_point(random, domain);
      // Everything varies on the scale of the distance to the boundary.
      double scale = 1;
      for (std::size_t i = 0; i < domain.size(); ++i)
        scale = (std::min)(scale, std::sqrt(CGAL::squared_distance(p, domain.side(i))));
      // Entry e of all coordinates, differentiated in a direction: Richardson's extrapolation.
      const auto difference = [&](std::size_t e, const Kernel::Vector_2& direction) {
        std::vector<double> result(domain.size());
        for (const double step : {0.02 * scale, 0.01 * scale}) {
          const auto ahead = jets<1>(coordinates, p + step * direction);
          const auto behind = jets<1>(coordinates, p - step * direction);
          for (std::size_t i = 0; i < domain.size(); ++i)
            result[i] +=
                (step < 0.015 * scale ? 4 : -1) * (ahead[i][e] - behind[i][e]) / (6 * step);
        }
        return result;
      };
      const Kernel::Vector_2 u(1, 0), v(0, 1);
      const std::vector<double> expected[5] = {difference(0, u), difference(0, v), difference(1, u),
                                               difference(1, v), difference(2, v)};
      const auto at = jets<2>(coordinates, p);
      for (std::size_t i = 0; i < domain.size(); ++i)
        for (std::size_t e = 1; e < 6; ++e) {
          const double unit = e < 3 ? 1 / scale : 1 / (scale * scale);
          CHECK(std::abs(at[i][e] - expected[e - 1][i]) < 3e-6 * unit);
        }
    }
  }
}

TEMPLATE_TEST_CASE("Gradients on a side are the limits of gradients inside", "", Wachspress,
                   Mean_value, Harmonic) {
  Random random(8);
  for (const Domain& domain : zoo<TestType>(random)) {
    const TestType coordinates(domain);
    for (std::size_t i = 0; i < domain.size(); ++i) {
      const double s = random.in(0.3, 0.7), depth = 1e-7;
      const Point_2 p = domain.point_on_side(i, s);
      const auto direction = domain.vertex(domain.next(i)) - domain.vertex(i);
      const double length = domain.side_length(i);
      const Point_2 inside(p.x() - depth * direction.y() / length,
                           p.y() + depth * direction.x() / length);
      std::vector<Jet<1>> on_side(domain.size());
      coordinates.template evaluate<1>(p, Domain::Location::on_side(i, s), on_side.data());
      const auto near_side = jets<2>(coordinates, inside);
      for (std::size_t j = 0; j < domain.size(); ++j)
        for (std::size_t e = 1; e <= 2; ++e) {
          const double change =
              std::abs(near_side[j][3]) + std::abs(near_side[j][4]) + std::abs(near_side[j][5]);
          CHECK(on_side[j][e] == Approx(near_side[j][e]).margin(1e-6 + 3 * depth * change));
        }
    }
  }
}

TEMPLATE_TEST_CASE("Outside the domain there are no coordinates, and an exception says so", "",
                   Wachspress, Mean_value, Harmonic) {
  Random random(9);
  const Domain domain(convex_polygon(random, 6));
  const double nan = std::nan("");
  CHECK_THROWS_AS(values(TestType(domain), Point_2(2, 2)), MP::Outside_domain_error);
  CHECK_THROWS_AS(values(TestType(domain), Point_2(nan, 0)), MP::Outside_domain_error);
  CHECK_THROWS_AS(values(TestType(domain), Point_2(0, HUGE_VAL)), MP::Outside_domain_error);
}

TEST_CASE("Wachspress and mean value coordinates agree with CGAL's") {
  const unsigned seed = 20260105;
  CAPTURE(seed);
  Random random(seed);
  namespace BC = CGAL::Barycentric_coordinates;
  for (std::size_t n = 3; n < 12; ++n) {
    const auto convex = convex_polygon(random, n), star = star_shaped_polygon(random, n, 0.4);
    const Wachspress ours{Domain(convex)};
    const Mean_value ours_star{Domain(star)};
    BC::Wachspress_coordinates_2<std::vector<Point_2>, Kernel> theirs(convex);
    BC::Mean_value_coordinates_2<std::vector<Point_2>, Kernel> theirs_star(star);
    for (int k = 0; k < 20; ++k) {
      const Point_2 p = interior_point(random, ours.domain());
      const Point_2 q = interior_point(random, ours_star.domain());
      std::vector<double> expected, expected_star;
      theirs(p, std::back_inserter(expected));
      theirs_star(q, std::back_inserter(expected_star));
      const auto found = values(ours, p), found_star = values(ours_star, q);
      for (std::size_t i = 0; i < n; ++i) {
        CHECK(found[i] == Approx(expected[i]).margin(1e-12));
        CHECK(found_star[i] == Approx(expected_star[i]).margin(1e-10));
      }
    }
  }
}

TEST_CASE("Wachspress coordinates in exact arithmetic are exact") {
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  using FT = Exact::FT;
  const std::vector<Exact::Point_2> pentagon{{0, 0}, {3, -1}, {5, 2}, {2, 5}, {-1, 3}};
  const MP::Polygonal_domain_2<Exact> domain(pentagon);
  const MP::Wachspress_coordinates_2<Exact> coordinates(domain);
  const Exact::Point_2 p(FT(7) / FT(3), FT(11) / FT(13));
  std::vector<FT> lambda;
  coordinates(p, std::back_inserter(lambda));
  FT one(0), u(0), v(0);
  for (std::size_t i = 0; i < 5; ++i) {
    one += lambda[i];
    u += lambda[i] * pentagon[i].x();
    v += lambda[i] * pentagon[i].y();
  }
  CHECK(one == 1);
  CHECK(u == p.x());
  CHECK(v == p.y());
}

TEST_CASE("Wachspress coordinates refuse domains that are not strictly convex") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(Wachspress(Domain(l_shape())), Contains("corner 3 is reflex"));
  CHECK_THROWS_WITH(Wachspress(Domain({{0, 0}, {1, 0}, {2, 0}, {1, 1}})),
                    Contains("corner 1 is straight"));
  CHECK_THROWS_WITH(
      Wachspress(Domain({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}})),
      Contains("without holes"));
}

TEST_CASE("Wachspress coordinates work on a square with a corner rounded by hundreds of sides") {
  for (const std::size_t pieces : {1, 10, 100, 1000}) {
    std::vector<Point_2> polygon{{0, 0}, {1, 0}};
    const double radius = 1e-3;
    for (std::size_t k = 0; k <= pieces; ++k) {
      const double angle =
          MP::internal::pi / 2 * static_cast<double>(k) / static_cast<double>(pieces);
      polygon.emplace_back(1 - radius + radius * std::cos(angle),
                           1 - radius + radius * std::sin(angle));
    }
    polygon.emplace_back(0, 1);
    const Wachspress coordinates{Domain(polygon)};
    double one = 0, u = 0, v = 0;
    const auto lambda = values(coordinates, {0.3, 0.4});
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      one += lambda[i];
      u += lambda[i] * polygon[i].x();
      v += lambda[i] * polygon[i].y();
    }
    CHECK(one == Approx(1).epsilon(1e-12));
    CHECK(u == Approx(0.3).epsilon(1e-12));
    CHECK(v == Approx(0.4).epsilon(1e-12));
  }
}
