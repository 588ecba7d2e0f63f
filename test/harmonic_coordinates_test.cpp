// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "harmonic_fixtures.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

using namespace fixtures;

TEST_CASE("Harmonic coordinates sum to one and reproduce linear functions", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-8)) {
    const Domain& domain = h.domain();
    const double size = domain.diameter();
    for (const Point_2& p : random_points_inside(domain, 100)) {
      const auto lambda = evaluate<2>(h, p);
      Jet<2> sum, x, y;
      double scale = 1; // derivatives are large near reflex corners, and cancel
      for (std::size_t i = 0; i < domain.size(); ++i) {
        sum += lambda[i];
        x += lambda[i] * domain.vertex(i).x();
        y += lambda[i] * domain.vertex(i).y();
        for (std::size_t k = 1; k < 6; ++k)
          scale = (std::max)(scale, std::abs(lambda[i][k]));
      }
      CHECK(std::abs(sum[0] - 1) < 1e-14);
      CHECK(std::abs(x[0] - p.x()) < 1e-14 * size);
      CHECK(std::abs(y[0] - p.y()) < 1e-14 * size);
      const Jet<2> u = Jet<2>::u_variable(p.x()), v = Jet<2>::v_variable(p.y());
      for (std::size_t k = 1; k < 6; ++k) {
        CHECK(std::abs(sum[k]) < 1e-13 * scale);
        CHECK(std::abs(x[k] - u[k]) < 1e-13 * scale * size);
        CHECK(std::abs(y[k] - v[k]) < 1e-13 * scale * size);
      }
    }
  }
}

TEST_CASE("Harmonic coordinates are exact at the vertices and on the sides", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-6)) {
    const Domain& domain = h.domain();
    for (std::size_t k = 0; k < domain.size(); ++k) {
      const auto at_vertex = evaluate<1>(h, domain.vertex(k), Location::on_vertex(k));
      const auto on_side =
          evaluate<1>(h, domain.point_on_side(k, 0.25), Location::on_side(k, 0.25));
      for (std::size_t i = 0; i < domain.size(); ++i) {
        CHECK(at_vertex[i][0] == (i == k ? 1 : 0));
        CHECK(on_side[i][0] == (i == k ? 0.75 : i == domain.next(k) ? 0.25 : 0));
      }
    }
  }
}

TEST_CASE("Harmonic coordinates approach their boundary values from the inside", "[harmonic]") {
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-8)) {
    const Domain& domain = h.domain();
    // Values rise from 0 to 1 across a gap; the point is 1e-12 side lengths away from the side.
    const double tolerance = 1e-10 + 1e-11 * domain.diameter() / domain.clearance();
    for (std::size_t k = 0; k < domain.size(); ++k)
      for (const double s : {0.1, 0.5, 0.8}) {
        const Point_2 p = domain.point_on_side(k, s);
        const auto d = domain.vertex(domain.next(k)) - domain.vertex(k);
        const Point_2 q(p.x() - 1e-12 * d.y(), p.y() + 1e-12 * d.x());
        if (domain.locate(q).kind != Location::Kind::interior)
          continue;
        const auto lambda = evaluate<0>(h, q);
        for (std::size_t i = 0; i < domain.size(); ++i) {
          const double boundary = i == k ? 1 - s : i == domain.next(k) ? s : 0;
          CHECK(std::abs(lambda[i][0] - boundary) < tolerance);
        }
      }
  }
}

TEST_CASE("Harmonic coordinates are never negative, and never above one", "[harmonic]") {
  for (const double target : {1e-3, 1e-8, 1e-11})
    for (const Harmonic_coordinates_2& h : on_all_domains(target))
      for (const Point_2& p : random_points_inside(h.domain(), 500)) {
        double sum = 0;
        for (const Jet<0>& lambda : evaluate<0>(h, p)) {
          CHECK(lambda[0] >= 0);
          CHECK(lambda[0] < 1 + 1e-14);
          sum += lambda[0];
        }
        CHECK(std::abs(sum - 1) < 1e-14);
      }
}

TEST_CASE("Where approximations are negative, values change little, and reproduce linear functions",
          "[harmonic]") {
  std::size_t changed = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const Harmonic_coordinates_2 h(random_domain(random, 20, seed % 3), 1e-3);
    const Domain& domain = h.domain();
    for (const Point_2& p : random_points_inside(domain, 300)) {
      std::vector<Jet<0>> raw(domain.size());
      h.evaluate_extended(p.x(), p.y(), raw.data());
      const bool negative =
          std::any_of(raw.begin(), raw.end(), [](const Jet<0>& l) { return l[0] < -1e-15; });
      changed += negative;
      const auto lambda = evaluate<0>(h, p);
      CHECK(largest_difference(lambda, raw) <= h.error_bound());
      double sum = 0, x = 0, y = 0;
      for (std::size_t i = 0; i < domain.size(); ++i) {
        CHECK(lambda[i][0] >= 0);
        sum += lambda[i][0];
        x += lambda[i][0] * domain.vertex(i).x();
        y += lambda[i][0] * domain.vertex(i).y();
      }
      CHECK(std::abs(sum - 1) < 1e-14);
      CHECK(std::abs(x - p.x()) < 1e-14);
      CHECK(std::abs(y - p.y()) < 1e-14);
    }
  }
  CHECK(changed > 20);
}

TEST_CASE("On triangles and rectangles harmonic coordinates are polynomials", "[harmonic]") {
  const Harmonic_coordinates_2 triangle(Domain({{0, 0}, {2, 0}, {0, 1}}));
  const auto t = evaluate<2>(triangle, {0.3, 0.4});
  const double barycentric[6] = {0.15, 0.5, 0, 0, 0, 0};
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(t[1][k] == Approx(barycentric[k]).epsilon(0).margin(1e-13));

  const Harmonic_coordinates_2 unit_square{Domain(square())};
  for (const Point_2& p : random_points_inside(unit_square.domain(), 50)) {
    const auto lambda = evaluate<2>(unit_square, p);
    const double bilinear[6] = {p.x() * p.y(), p.y(), p.x(), 0, 1, 0}; // λ_2 = xy
    for (std::size_t k = 0; k < 6; ++k)
      CHECK(lambda[2][k] == Approx(bilinear[k]).epsilon(0).margin(1e-11));
  }
}

// xy is harmonic, and linear on every side parallel to an axis.
// The bilinear ones; the width is a power of two, as are the distances from the origin.
TEST_CASE("On a thin rectangle anywhere, harmonic coordinates are those at the origin",
          "[harmonic]") {
  for (const double width : {0x1p-10, 0x1p-20, 0x1p-30})
    for (const double offset : {0., 1., 2., 4., 1024.}) {
      const Harmonic_coordinates_2 h(Domain({{offset, offset},
                                             {offset + 1, offset},
                                             {offset + 1, offset + width},
                                             {offset, offset + width}}));
      for (const double s : {0.125, 0.5, 0.75})
        for (const double t : {0.25, 0.5, 0.875}) {
          const auto lambda = evaluate<0>(h, {offset + s, offset + t * width});
          const double expected[4] = {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
          for (std::size_t i = 0; i < 4; ++i)
            CHECK(lambda[i][0] == Approx(expected[i]).epsilon(0).margin(1e-13));
        }
    }
}

TEST_CASE("Between sides parallel to the axes, the function xy is reproduced", "[harmonic]") {
  for (const Domain& domain : rectilinear_domains()) {
    const Harmonic_coordinates_2 h(domain);
    for (const Point_2& p : random_points_inside(domain, 100)) {
      const auto lambda = evaluate<2>(h, p);
      Jet<2> sum;
      for (std::size_t i = 0; i < domain.size(); ++i)
        sum += lambda[i] * (domain.vertex(i).x() * domain.vertex(i).y());
      const double exact[6] = {p.x() * p.y(), p.y(), p.x(), 0, 1, 0};
      const double tolerance[6] = {1e-8, 1e-6, 1e-6, 1e-4, 1e-4, 1e-4};
      for (std::size_t k = 0; k < 6; ++k)
        CHECK(sum[k] == Approx(exact[k]).epsilon(0).margin(10 * tolerance[k]));
    }
  }
}

TEST_CASE("Harmonic coordinates are as symmetric as the domain", "[harmonic]") {
  for (const int n : {3, 4, 5, 8, 13}) {
    const Harmonic_coordinates_2 h(Domain(regular_polygon(n)), 1e-11);
    for (const Jet<0>& lambda : evaluate<0>(h, {0, 0}))
      CHECK(lambda[0] == Approx(1. / n).epsilon(0).margin(1e-11));
  }
  const Harmonic_coordinates_2 h(Domain(l_shape()), 1e-11);
  const std::size_t mirrored[6] = {0, 5, 4, 3, 2, 1};
  for (const Point_2& p : random_points_inside(h.domain(), 50)) {
    const auto a = evaluate<0>(h, p), b = evaluate<0>(h, {p.y(), p.x()});
    for (std::size_t i = 0; i < 6; ++i)
      CHECK(a[i][0] == Approx(b[mirrored[i]][0]).epsilon(0).margin(1e-10));
  }
}

TEST_CASE("Harmonic coordinates do not depend on scale, position and rotation", "[harmonic]") {
  struct Similarity {
    double scale, angle, x, y;
    Point_2 operator()(const Point_2& p) const {
      const double c = scale * std::cos(angle), s = scale * std::sin(angle);
      return {c * p.x() - s * p.y() + x, s * p.x() + c * p.y() + y};
    }
  };
  for (const Points& polygon : {l_shape(), unit_u_shape(), star(), comb(), regular_polygon(7)}) {
    const Domain domain(polygon);
    const Harmonic_coordinates_2 h(domain, 1e-12);
    // Far away coordinates have fewer digits; there only integers are moved as they are.
    for (const Similarity& map :
         {Similarity{1e-9, 0, 0, 0}, Similarity{1e9, 0, 0, 0}, Similarity{1, 1, 0, 0},
          Similarity{1e9, 2.5, 0, 0}, Similarity{1e-9, -0.3, 0, 0}, Similarity{3, 2, 0.7, -1},
          Similarity{0x1p20, 0, 0x1p60, -0x1p50}}) {
      const bool far = map.x > 1e6;
      if (far && polygon[1] != Point_2(std::round(polygon[1].x()), std::round(polygon[1].y())))
        continue;
      Points image;
      for (const Point_2& p : domain.vertices())
        image.push_back(map(p));
      const Harmonic_coordinates_2 g(Domain(image), 1e-12);
      for (Point_2 p : random_points_inside(domain, 30)) {
        if (far)
          p = Point_2(std::round(256 * p.x()) / 256, std::round(256 * p.y()) / 256);
        if (far && domain.locate(p).kind != Location::Kind::interior)
          continue;
        INFO("scale " << map.scale << ", angle " << map.angle << ", point " << p);
        const auto a = evaluate<1>(h, p), b = evaluate<1>(g, map(p));
        for (std::size_t i = 0; i < domain.size(); ++i) {
          CHECK(std::abs(a[i][0] - b[i][0]) < 1e-12);
          const double length = std::hypot(a[i][1], a[i][2]);
          CHECK(length ==
                Approx(map.scale * std::hypot(b[i][1], b[i][2])).epsilon(1e-8).margin(1e-8));
        }
      }
    }
  }
}

TEST_CASE("The output iterator gets one value a vertex, and points outside are refused",
          "[harmonic]") {
  const Harmonic_coordinates_2 h(square_with_triangular_hole(), 1e-6);
  std::vector<double> values;
  h({0.5, 0.5}, std::back_inserter(values));
  CHECK(values.size() == 7);
  CHECK_THROWS_AS(h({1.5, 1.5}, std::back_inserter(values)), MP::Outside_domain_error);
}

TEST_CASE("Errors that nothing can have are refused", "[harmonic]") {
  const Domain domain(l_shape());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, infinity, std::nan("")})
    CHECK_THROWS_AS(Harmonic_coordinates_2(domain, bad), MP::Input_error);
  for (const double bad : {-1.0, infinity, std::nan("")})
    CHECK_THROWS_AS(Harmonic_coordinates_2(domain, 1e-8, bad), MP::Input_error);
}

TEST_CASE("Domains whose size or its inverse overflows are refused", "[harmonic]") {
  const auto square = [](double low, double high) {
    return Domain(Points{{low, low}, {high, low}, {high, high}, {low, high}});
  };
  for (const Domain& domain : {square(0, 1e-310), square(-1e308, 1e308)})
    CHECK_THROWS_AS(Harmonic_coordinates_2(domain), MP::Numerical_error);
  for (const double size : {1e-307, 1e307}) {
    const auto lambda = evaluate<1>(Harmonic_coordinates_2(square(0, size)), {size / 4, size / 2});
    CHECK(lambda[2].value() == Approx(0.125));
    CHECK(lambda[2][1] * size == Approx(0.5));
  }
}

TEST_CASE("Hessians are as large as the domain is small, as long as numbers go", "[harmonic]") {
  const double size = 1e-153;
  const Harmonic_coordinates_2 h(Domain(Points{{0, 0}, {size, 0}, {size, size}, {0, size}}));
  const auto lambda = evaluate<2>(h, {size / 4, size / 2});
  CHECK(size * (size * lambda[2][4]) == Approx(1)); // lambda[2] is uv / size^2
  CHECK(std::abs(size * (size * lambda[2][3])) < 1e-8);
}

TEST_CASE("Nothing is evaluated at locations outside the domain", "[harmonic]") {
  const Domain domain(l_shape());
  const Harmonic_coordinates_2 coordinates(domain);
  const Point_2 p(100, 100);
  std::vector<MP::Jet_2<double, 1>> jets(domain.size());
  CHECK_THROWS_AS(coordinates.evaluate<1>(p, domain.locate(p), jets.data()),
                  MP::Outside_domain_error);
  const std::vector<Point_2> points{domain.vertex(0), p};
  const std::vector<Domain::Location> locations{domain.locate(points[0]), domain.locate(p)};
  CHECK_THROWS_AS(coordinates.evaluate_batch<0>(points, locations), MP::Outside_domain_error);
}
