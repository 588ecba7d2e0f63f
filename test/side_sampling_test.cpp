// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/meshing/sample_side.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <limits>

using namespace fixtures;
using MP::Side_sampling;
using MP::internal::Curve_3;
using MP::internal::Vec3;
using Parameters = std::vector<double>;

namespace {

Ribbon curve(std::vector<Point_3> points) {
  const std::size_t degree = points.size() - 1;
  return Ribbon(degree, 1, std::move(points));
}

Ribbon random_curve(Random& random, std::size_t degree) {
  std::vector<Point_3> points;
  for (std::size_t i = 0; i <= degree; ++i)
    points.emplace_back(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
  return curve(points);
}

Ribbon scaled(const Ribbon& r, double factor) {
  std::vector<Point_3> points;
  for (const Point_3& p : r.control_points())
    points.emplace_back(factor * p.x(), factor * p.y(), factor * p.z());
  return curve(points);
}

Vec3 point_of(const Ribbon& r, double s) {
  return MP::internal::to_vec3(r.boundary_point(s));
}

Parameters sample(const Curve_3& point, const Side_sampling& rule) {
  return MP::internal::sample_curve(point, rule, "side 7");
}
Parameters sample(const Ribbon& r, const Side_sampling& rule) {
  return sample([&](double s) { return point_of(r, s); }, rule);
}

Side_sampling edge_length(double length) {
  return {length, {}, {}};
}
Side_sampling deviation(double distance) {
  return {{}, distance, {}};
}
Side_sampling turn(double degrees) {
  return {{}, {}, degrees};
}

Parameters mirrored(Parameters samples) {
  std::reverse(samples.begin(), samples.end());
  for (double& s : samples)
    s = 1 - s;
  return samples;
}

void check_increasing(const Parameters& samples) {
  double last = 0;
  for (const double s : samples) {
    REQUIRE(s > last);
    REQUIRE(s == std::ldexp(std::floor(std::ldexp(s, 53)), -53));
    last = s;
  }
  REQUIRE(last < 1);
}

Parameters with_ends(Parameters samples) {
  samples.insert(samples.begin(), 0);
  samples.push_back(1);
  return samples;
}

// The length of the curve between parameters, by Gauss quadrature of its derivative.
double length_between(const Ribbon& r, double a, double b) {
  static const auto rule = MP::internal::gauss_legendre(15);
  double sum = 0;
  for (const auto& node : rule)
    sum += node.weight *
           MP::internal::norm(MP::internal::to_vec3(r.boundary_derivative(a + node.t * (b - a))));
  return sum * (b - a);
}

// The largest length of a segment's curve, relative to the smallest, less 1.
double unevenness(const Ribbon& r, const Parameters& samples) {
  const Parameters all = with_ends(samples);
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (std::size_t k = 0; k + 1 < all.size(); ++k) {
    double length = 0;
    for (int j = 0; j < 16; ++j) {
      const double h = (all[k + 1] - all[k]) / 16;
      length += length_between(r, all[k] + j * h, all[k] + (j + 1) * h);
    }
    smallest = (std::min)(smallest, length);
    largest = (std::max)(largest, length);
  }
  return largest / smallest - 1;
}

double largest_deviation(const Ribbon& r, const Parameters& samples) {
  const Parameters all = with_ends(samples);
  double largest = 0;
  for (std::size_t k = 0; k + 1 < all.size(); ++k) {
    const Kernel::Point_3 a = r.boundary_point(all[k]), b = r.boundary_point(all[k + 1]);
    for (int j = 1; j < 50; ++j) {
      const Vec3 p = point_of(r, all[k] + (all[k + 1] - all[k]) * j / 50);
      largest = (std::max)(largest, MP::internal::distance_to_segment(p, MP::internal::to_vec3(a),
                                                                      MP::internal::to_vec3(b)));
    }
  }
  return largest;
}

// Curves that stop, turn back, cross themselves or close.
std::vector<Ribbon> degenerate_curves() {
  const Point_3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), d(1, 1, 1);
  return {
      curve({o, o, x}),                                                    // stops at its start
      curve({o, o, o, o, x}),                                              // more so
      curve({x, o, o, o, o, y}),                                           // stops in the middle
      curve({{-1, 1, 0}, {1, -1.0 / 3, 0}, {-1, -1.0 / 3, 0}, d}),         // almost a cusp
      curve({{-1, 1, 0}, {1, -1.0 / 3, 0}, {-1, -1.0 / 3, 0}, {1, 1, 0}}), // a cusp
      curve({o, {3, 1, 0}, {-2, 1, 0}, x}),                                // a loop
      curve({o, {3, 0, 0}, {-2, 0, 0}, x}), // a straight line, three times
      curve({o, x, y, o}),                  // closed
      curve({o, x, d, y, o}),               // closed, and in space
      curve({o, x, d, d, o}),
  };
}

// Curves that run back the way they came.
std::vector<Ribbon> folded_curves() {
  const Point_3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), d(0.3, 0.7, 0.1);
  return {curve({o, x, o}), curve({o, x, y, x, o}), curve({d, x, x, d}), curve({d, o, y, y, o, d}),
          curve({d, x, o, y, y, o, x, d})};
}

} // namespace

TEST_CASE("A curve and its reverse are sampled at bitwise the same points") {
  const unsigned seed = 1;
  CAPTURE(seed);
  Random random(seed);
  std::vector<Ribbon> curves = degenerate_curves();
  for (std::size_t degree = 1; degree <= 9; ++degree)
    for (int k = 0; k < 5; ++k)
      curves.push_back(random_curve(random, degree));
  for (const Ribbon& r : curves)
    for (const Side_sampling& rule :
         {edge_length(0.03), deviation(1e-3), turn(5), Side_sampling{0.1, 1e-2, 10.0}}) {
      const Ribbon back = r.reversed();
      const Parameters samples = sample(r, rule), reverse = sample(back, rule);
      check_increasing(samples);
      REQUIRE(samples.size() > 1);
      REQUIRE(reverse == mirrored(samples));
      for (const double s : samples)
        REQUIRE(r.boundary_point(s) == back.boundary_point(1 - s));
    }
}

TEST_CASE("A curve that runs back the way it came is sampled symmetrically") {
  for (const Ribbon& r : folded_curves())
    for (const Side_sampling& rule : {edge_length(0.03), deviation(1e-3), turn(5)}) {
      const Parameters samples = sample(r, rule);
      check_increasing(samples);
      CHECK(samples.size() > 5);
      CHECK(samples == mirrored(samples));
      CHECK(samples[samples.size() / 2] == 0.5);
    }
}

TEST_CASE("Mirror images of curves are sampled alike, but for rounding") {
  const Ribbon arch = curve({{0, 0, 0}, {0.2, 1, 0}, {0.8, 1, 0}, {1, 0, 0}});
  for (const Side_sampling& rule : {edge_length(0.03), deviation(1e-3), turn(5)}) {
    const Parameters samples = sample(arch, rule), mirror = mirrored(samples);
    for (std::size_t k = 0; k < samples.size(); ++k)
      CHECK(samples[k] == Approx(mirror[k]).epsilon(0).margin(1e-12));
  }
}

TEST_CASE("Patches that share a curve sample it at bitwise the same points") {
  const std::vector<Point_2> polygon = l_shape();
  const auto height = [](double x, double y) { return std::sin(2 * x) * std::cos(3 * y); };
  using Patch = MP::Concave_bezier_patch_3<Kernel, MP::Mean_value_coordinates_2<Kernel>>;
  const Loop loop = lifted_loop(polygon, height);
  const Patch patch(loop, MP::Mean_value_coordinates_2<Kernel>(Domain(polygon)));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Side_sampling rule{0.1, 1e-3, {}};
    const Parameters samples = MP::sample_side(patch, i, rule);
    CHECK(samples.size() > 5);
    CHECK(sample(loop[i].reversed(), rule) == mirrored(samples));
  }
}

TEST_CASE("Samples with a largest edge length divide curves into equal lengths") {
  const unsigned seed = 2;
  CAPTURE(seed);
  Random random(seed);
  std::vector<Ribbon> curves{
      curve({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 2, 1}}),
      curve({{0, 0, 0}, {0.001, 0, 0}, {0.01, 0, 0}, {1, 0, 0}}),
      curve({{0, 0, 0}, {0.001, 0, 0}, {0.01, 0.1, 0}, {1, 0, 0.5}}),
      curve({{0, 0, 0}, {1e-6, 0, 0}, {0.5, 0.1, 0}, {1, 0, 0.5}}),
      curve({{0, 0, 0}, {0.01, 0.1, 0}, {0, 0.1, 0.1}, {0.5, 0, 0}, {1, 0, 0.5}, {9, 0, 1}})};
  for (std::size_t degree = 1; degree <= 9; ++degree)
    curves.push_back(random_curve(random, degree));
  for (const Ribbon& r : curves)
    for (const double share : {0.3, 0.1, 0.02, 0.001}) {
      const Parameters samples = sample(r, edge_length(share * r.arc_length()));
      CAPTURE(r.degree(), share);
      CHECK(unevenness(r, samples) < 1e-3);
      CHECK(static_cast<double>(samples.size() + 1) ==
            Approx(std::ceil(1 / share)).epsilon(0).margin(1));
    }
}

TEST_CASE("Samples of a straight line are evenly spaced, whatever its parameters are") {
  const Ribbon line = curve({{1, 2, 3}, {3, 5, 9}});
  const Parameters fourths = sample(line, edge_length(7.0 / 4));
  REQUIRE(fourths.size() == 3);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(fourths[k] == Approx(0.25 * static_cast<double>(k + 1)).epsilon(0).margin(1e-12));
  const Ribbon slow = curve({{0, 0, 0}, {1e-4, 2e-4, 2e-4}, {1e-4, 2e-4, 2e-4}, {1, 2, 2}});
  const Parameters samples = sample(slow, edge_length(0.03));
  REQUIRE(samples.size() == 99);
  for (std::size_t k = 0; k < samples.size(); ++k)
    CHECK(point_of(slow, samples[k])[0] ==
          Approx(static_cast<double>(k + 1) / 100).epsilon(0).margin(1e-5));
}

TEST_CASE("Segments keep to a chordal deviation") {
  const unsigned seed = 3;
  CAPTURE(seed);
  Random random(seed);
  std::vector<Ribbon> curves = degenerate_curves();
  for (const Ribbon& r : folded_curves())
    curves.push_back(r);
  for (std::size_t degree = 2; degree <= 9; ++degree)
    for (int k = 0; k < 5; ++k)
      curves.push_back(random_curve(random, degree));
  for (const Ribbon& r : curves)
    for (const double bound : {0.3, 0.03, 1e-3, 1e-5}) {
      CAPTURE(r.degree(), bound);
      CHECK(largest_deviation(r, sample(r, deviation(bound))) <= bound);
    }
}

TEST_CASE("An arc needs few more segments than the best polyline for a chordal deviation") {
  // A quarter of a circle, to 3e-4 of its radius.
  const double k = 0.5522847498;
  const Ribbon arc = curve({{5, 0, 0}, {5, 5 * k, 0}, {5 * k, 5, 0}, {0, 5, 0}});
  for (const double bound : {1e-2, 1e-3, 1e-4, 1e-6}) {
    const double best = arc.arc_length() / std::sqrt(8 * bound * 5);
    const double segments = static_cast<double>(sample(arc, deviation(bound)).size() + 1);
    CAPTURE(bound, best, segments);
    CHECK(segments < 1.2 * best + 1);
  }
}

TEST_CASE("A straight side counts as bent like an arc of its length") {
  const Ribbon line = curve({{0, 0, 0}, {2, 0, 0}});
  const auto segments = [&](const Side_sampling& rule) {
    return static_cast<double>(sample(line, rule).size() + 1);
  };
  CHECK(segments(deviation(1e-4)) == Approx(2 / std::sqrt(8e-4 * 2)).epsilon(0.05));
  CHECK(segments(turn(1)) == std::ceil(180 / MP::internal::pi));
}

TEST_CASE("Segments of a curve turn by about the largest turn, and none by more than 1.1 of it") {
  const Ribbon r = curve({{0, 0, 0}, {0, 3, 0}, {1, 3, 1}, {1, 0, 0}});
  for (const double degrees : {30.0, 5.0, 0.5}) {
    const Parameters all = with_ends(sample(r, turn(degrees)));
    double largest = 0;
    for (std::size_t k = 0; k + 1 < all.size(); ++k)
      largest = (std::max)(largest, MP::internal::angle_between(
                                        MP::internal::to_vec3(r.boundary_derivative(all[k])),
                                        MP::internal::to_vec3(r.boundary_derivative(all[k + 1]))));
    largest *= 180 / MP::internal::pi;
    CHECK(largest < 1.1 * degrees);
    CHECK(largest > 0.7 * degrees);
  }
}

TEST_CASE("Neighbouring segments differ by a factor of at most 1.5") {
  const unsigned seed = 4;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t degree = 2; degree <= 9; ++degree) {
    const Ribbon r = random_curve(random, degree);
    for (const Side_sampling& rule : {deviation(1e-3), deviation(1e-5), turn(5), turn(1)}) {
      const Parameters all = with_ends(sample(r, rule));
      for (std::size_t k = 0; k + 2 < all.size(); ++k) {
        const double ratio =
            length_between(r, all[k], all[k + 1]) / length_between(r, all[k + 1], all[k + 2]);
        CHECK(ratio < 1.5);
        CHECK(ratio > 1 / 1.5);
      }
    }
  }
}

TEST_CASE("Curves of any size are sampled alike") {
  const unsigned seed = 5;
  CAPTURE(seed);
  Random random(seed);
  std::vector<Ribbon> curves = degenerate_curves();
  curves.push_back(random_curve(random, 6));
  for (const Ribbon& r : curves) {
    const Side_sampling rule{0.1, 1e-3, 10.0};
    const Parameters samples = sample(r, rule);
    for (const int k : {-400, -1, 3, 400}) {
      const double factor = std::ldexp(1, k);
      CHECK(sample(scaled(r, factor), {0.1 * factor, 1e-3 * factor, 10.0}) == samples);
    }
    for (const double factor : {1e-150, 1e150, 1e-300, 1e300}) {
      const Parameters others = sample(scaled(r, factor), {0.1 * factor, 1e-3 * factor, 10.0});
      REQUIRE(others.size() == samples.size());
      for (std::size_t k = 0; k < samples.size(); ++k)
        CHECK(others[k] == Approx(samples[k]).epsilon(0).margin(1e-6));
    }
  }
}

TEST_CASE("A curve far from the origin is sampled like near it, as far as rounding allows") {
  const Ribbon r = curve({{0, 0, 0}, {0, 3, 0}, {1, 3, 1}, {1, 0, 0}});
  std::vector<Point_3> points;
  for (const Point_3& p : r.control_points())
    points.push_back(p + Vector_3(1e8, -1e8, 1e8));
  const Ribbon far = curve(points);
  for (const Side_sampling& rule : {edge_length(0.1), deviation(1e-3), turn(5)}) {
    const double there = static_cast<double>(sample(far, rule).size());
    CHECK(there == Approx(static_cast<double>(sample(r, rule).size())).epsilon(0.02).margin(1));
  }
}

TEST_CASE("Curves without length or bounds have no samples") {
  const Ribbon point = curve({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}),
               line = curve({{0, 0, 0}, {1, 0, 0}});
  CHECK(sample(point, {1e-3, 1e-6, 1.0}).empty());
  CHECK(sample(line, {}).empty());
  CHECK(sample(line, edge_length(1)).empty());
  CHECK(sample(line, edge_length(0.5)) == Parameters{0.5});
}

TEST_CASE("Sampling refuses what it cannot do") {
  using Catch::Matchers::Contains;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Ribbon line = curve({{0, 0, 0}, {1, 0, 0}}),
               arch = curve({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}});
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(sample(line, edge_length(bad)), MP::Input_error);
    CHECK_THROWS_WITH(sample(line, deviation(bad)), Contains("largest deviation"));
    CHECK_THROWS_WITH(sample(line, turn(bad)), Contains("largest turn"));
  }
  CHECK_THROWS_AS(sample(line, edge_length(1e-9)), MP::Input_error);
  CHECK_THROWS_WITH(sample(line, edge_length(1e-300)), Contains("side 7") && Contains("limit"));
  const auto broken = [&](double s) { return Vec3{s, s > 0.7 ? nan : 0, 0}; };
  CHECK_THROWS_WITH(sample(broken, edge_length(0.1)), Contains("side 7") && Contains("not finite"));
  // Points that are rounded to multiples of 1e-6 keep no smaller distance from their segments.
  const auto rounded = [&](double s) {
    const Vec3 p = point_of(arch, s);
    return Vec3{p[0], std::round(p[1] * 1e6) / 1e6, 0};
  };
  CHECK_THROWS_AS(sample(rounded, deviation(1e-8)), MP::Accuracy_error);
}
