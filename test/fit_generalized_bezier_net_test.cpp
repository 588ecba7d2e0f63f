// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/patches/Generalized_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/closest_parameters.h>
#include <CGAL/Multisided_patches/patches/fit_generalized_bezier_net.h>

#include <CGAL/centroid.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

using namespace fixtures;

namespace {

using Patch = MP::Generalized_bezier_patch_3<Kernel>;
using Net = Patch::Net;

// A net over a regular polygon, with random heights.
Net random_net(Random& random, std::size_t n, std::size_t degree, double roughness) {
  std::vector<Point_3> points;
  const auto corner = [&](std::size_t i) {
    const double angle = 2 * MP::internal::pi * static_cast<double>(i % n) / static_cast<double>(n);
    return Vector_3(std::cos(angle), std::sin(angle), 0);
  };
  for (std::size_t k = 0; k < (degree + 1) / 2; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = k; j < degree - k; ++j) {
        const double t = static_cast<double>(j - k) / static_cast<double>(degree - 2 * k),
                     radius = 1 - 2 * static_cast<double>(k) / static_cast<double>(degree + 1);
        const Vector_3 p = radius * ((1 - t) * corner(i) + t * corner(i + 1));
        points.emplace_back(p.x(), p.y(), random.in(-roughness, roughness));
      }
  points.emplace_back(0, 0, random.in(-roughness, roughness));
  return Net(n, degree, points);
}

// The same in the rows that are kept, other points inside.
Net changed_inside(Random& random, const Net& net, std::size_t fixed_layers) {
  std::vector<Point_3> points = net.control_points();
  std::vector<bool> is_fixed(points.size(), false);
  for (std::size_t k = 0; k < (std::min)(fixed_layers, net.layers()); ++k)
    for (std::size_t i = 0; i < net.size(); ++i)
      for (std::size_t j = 0; j <= net.degree(); ++j)
        is_fixed[net.index(i, j, k)] = true;
  for (std::size_t c = 0; c < points.size(); ++c)
    if (!is_fixed[c])
      points[c] =
          points[c] + Vector_3(random.in(-0.1, 0.1), random.in(-0.1, 0.1), random.in(-0.3, 0.3));
  return net.with_control_points(points);
}

std::vector<Point_2> places(Random& random, const Patch& patch, std::size_t count) {
  std::vector<Point_2> result;
  for (std::size_t k = 0; k < count; ++k)
    result.push_back(interior_point(random, patch.domain()));
  return result;
}

Point_2 middle_of(const Patch& patch) {
  const auto& vertices = patch.domain().vertices();
  return CGAL::centroid(vertices.begin(), vertices.end(), CGAL::Dimension_tag<0>());
}

std::vector<Point_3> at(const Patch& patch, const std::vector<Point_2>& parameters) {
  std::vector<Point_3> result;
  for (const Point_2& p : parameters)
    result.push_back(patch(p));
  return result;
}

double mean_square(const std::vector<Point_3>& a, const std::vector<Point_3>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    sum += CGAL::squared_distance(a[k], b[k]);
  return sum / static_cast<double>(a.size());
}

double largest_distance(const Net& a, const Net& b) {
  double largest = 0;
  for (std::size_t c = 0; c < a.control_points().size(); ++c)
    largest = (std::max)(
        largest, std::sqrt(CGAL::squared_distance(a.control_points()[c], b.control_points()[c])));
  return largest;
}

} // namespace

TEST_CASE("A net is fitted back to the points of the patch from which they are") {
  const unsigned seed = 20261122;
  CAPTURE(seed);
  Random random(seed);
  for (const std::size_t n : {3, 5, 6})
    for (const std::size_t degree : {3, 4, 5, 6})
      for (const std::size_t fixed_layers : {1, 2}) {
        CAPTURE(n, degree, fixed_layers);
        const Net goal = random_net(random, n, degree, 0.3);
        const Patch patch(goal), start(changed_inside(random, goal, fixed_layers));
        const auto parameters = places(random, patch, 300);
        const Net fitted = MP::fit_generalized_bezier_net(start, parameters, at(patch, parameters),
                                                          {fixed_layers, 0});
        CHECK(largest_distance(start.net(), goal) > 1e-3);
        CHECK(largest_distance(fitted, goal) < 1e-8);
        for (std::size_t k = 0; k < (std::min)(fixed_layers, goal.layers()); ++k)
          for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j <= degree; ++j)
              CHECK(fitted.control_point(i, j, k) == start.net().control_point(i, j, k));
      }
}

TEST_CASE("No net with the same outer rows is closer to the points than the fitted one") {
  Random random(5);
  const Patch start(random_net(random, 5, 5, 0.3));
  const auto parameters = places(random, start, 200);
  std::vector<Point_3> noisy = at(start, parameters);
  for (Point_3& p : noisy)
    p = p + Vector_3(0, 0, random.in(-0.1, 0.1));
  const Net fitted = MP::fit_generalized_bezier_net(start, parameters, noisy);
  const double least = mean_square(at(Patch(fitted), parameters), noisy);
  CHECK(least < mean_square(at(start, parameters), noisy));
  for (int k = 0; k < 20; ++k)
    CHECK(least < mean_square(at(Patch(changed_inside(random, fitted, 2)), parameters), noisy));
}

TEST_CASE("Smoothing makes points the mean of their neighbours, and a flat net stays flat") {
  Random random(6);
  for (const std::size_t degree : {4, 5, 6, 7}) {
    CAPTURE(degree);
    // The boundary is flat; all inside is to be.
    const Net flat = random_net(random, 5, degree, 0);
    std::vector<Point_3> rough = changed_inside(random, flat, 1).control_points();
    const Patch start(flat.with_control_points(rough));
    const std::vector<Point_2> one{middle_of(start)};
    const std::vector<Point_3> target{Point_3(0, 0, 0)};
    const Net smooth = MP::fit_generalized_bezier_net(start, one, target, {1, 10});
    for (const Point_3& p : smooth.control_points())
      CHECK(std::abs(p.z()) < 1e-10);
    const double jump = std::sqrt(CGAL::squared_distance(smooth.central_point(), Point_3(0, 0, 0)));
    CHECK(jump < 1e-10); // by symmetry
  }
}

TEST_CASE("What no point determines stays where it is") {
  Random random(7);
  const Patch start(random_net(random, 4, 3, 0.3)); // its central point has no weight
  const auto parameters = places(random, start, 50);
  const std::vector<Point_3> raised(50, Point_3(0, 0, 1));
  const Net fitted = MP::fit_generalized_bezier_net(start, parameters, raised, {1, 0});
  CHECK(fitted.central_point().z() == Approx(start.net().central_point().z()).epsilon(1e-9));
  CHECK(fitted.control_point(0, 1, 1).z() > start.net().control_point(0, 1, 1).z());
}

TEST_CASE("Closest places are found on the patch, and a cloud of points is fitted in turns") {
  Random random(8);
  const Net goal = random_net(random, 5, 5, 0.15);
  const Patch patch(goal);
  const auto parameters = places(random, patch, 300);
  const auto points = at(patch, parameters);
  CHECK(mean_square(at(patch, MP::closest_parameters(patch, points)), points) < 1e-20);
  // A point off the patch: the connection to the closest one is perpendicular.
  const Point_2 middle = middle_of(patch) + Kernel::Vector_2(0.1, 0.05);
  const Point_3 off = patch(middle) + 0.05 * patch.normal(middle);
  const Point_2 found = MP::closest_parameters(patch, std::vector<Point_3>{off})[0];
  CHECK(CGAL::squared_distance(found, middle) < 1e-10);

  Net net = changed_inside(random, goal, 2);
  const auto distance = [&] {
    const Patch now(net);
    return mean_square(at(now, MP::closest_parameters(now, points)), points);
  };
  const double before = distance();
  for (int turn = 0; turn < 6; ++turn) {
    const Patch now(net);
    net =
        MP::fit_generalized_bezier_net(now, MP::closest_parameters(now, points), points, {2, 1e-8});
  }
  CHECK(before > 1e-4);
  CHECK(distance() < before / 100);
}

TEST_CASE("Points without a finite distance have no closest places, and are named") {
  Random random(10);
  const Patch patch(random_net(random, 5, 3, 0.1));
  const double infinity = std::numeric_limits<double>::infinity(),
               nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {nan, infinity, -infinity, 1e200}) {
    CAPTURE(x);
    const std::vector<Point_3> points{Point_3(0, 0, 0), Point_3(0, x, 0)};
    CHECK_THROWS_WITH(MP::closest_parameters(patch, points),
                      Catch::Matchers::Contains("point 1 has no finite distance"));
  }
  CHECK(MP::closest_parameters(patch, std::vector<Point_3>{Point_3(1e150, 0, 0)}).size() == 1);
}

TEST_CASE("Least squares have the same solution by blocks of rows as at once") {
  using Matrix = Eigen::MatrixXd;
  const unsigned seed = 20261123;
  CAPTURE(seed);
  Random random(seed);
  for (const Eigen::Index unknowns : {1, 2, 7, 20})
    for (const Eigen::Index rows : {1, 6, 41, 400})
      for (const Eigen::Index rank : {unknowns, (unknowns + 1) / 2}) {
        CAPTURE(unknowns, rows, rank);
        const auto random_matrix = [&](Eigen::Index m, Eigen::Index n) {
          return Matrix(Matrix::NullaryExpr(m, n, [&] { return random.in(-1, 1); }));
        };
        const Matrix a = random_matrix(rows, rank) * random_matrix(rank, unknowns),
                     b = random_matrix(rows, 3);
        MP::internal::Least_squares_rows by_blocks(static_cast<std::size_t>(unknowns));
        for (Eigen::Index r = 0; r < rows; ++r)
          by_blocks.add_row() << a.row(r), b.row(r);
        // Of all solutions the smallest: that of the pseudoinverse.
        const Matrix expected = a.completeOrthogonalDecomposition().solve(b);
        CHECK((by_blocks.solve() - expected).norm() <= 1e-9 * (1 + expected.norm()));
      }
}

TEST_CASE("A fit says what is wrong with its points") {
  Random random(9);
  const Patch patch(random_net(random, 5, 3, 0.1));
  const std::vector<Point_2> two(2, middle_of(patch)), none;
  const std::vector<Point_3> one{Point_3(0, 0, 0)};
  CHECK_THROWS_AS(MP::fit_generalized_bezier_net(patch, two, one), MP::Input_error);
  CHECK_THROWS_AS(MP::fit_generalized_bezier_net(patch, none, std::vector<Point_3>()),
                  MP::Input_error);
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(MP::fit_generalized_bezier_net(patch, std::vector<Point_2>{two[0]},
                                                 std::vector<Point_3>{Point_3(0, infinity, 0)}),
                  MP::Input_error);
  CHECK_THROWS_AS(MP::fit_generalized_bezier_net(patch, std::vector<Point_2>{Point_2(9, 9)}, one),
                  MP::Outside_domain_error);
}
