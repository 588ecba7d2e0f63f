// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Many points evaluated at once have the points, normals and derivatives of single ones, to the
// last bit.

#include "catch.h"
#include "control_net_fixtures.h"

#include <CGAL/Gmpq.h>

#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

using namespace fixtures;
using MP::internal::Number_pack;

namespace {

template <typename Surface_jet>
bool same_jets(const Surface_jet& a, const Surface_jet& b) {
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < a[c].size; ++k)
      if (!(a[c][k] == b[c][k]))
        return false;
  return true;
}

template <int Order, typename Patch>
void check_derivatives(const Patch& patch, const Samples<typename Patch::Geom_traits>& samples) {
  using Jets = typename Patch::template Surface_jet<Order>;
  std::vector<Jets> sequential(samples.points.size()), parallel;
  const auto end = patch.template evaluate_batch<Order, CGAL::Sequential_tag>(
      samples.points, samples.locations, sequential.begin());
  CHECK(end == sequential.end());
  patch.template evaluate_batch<Order>(samples.points, samples.locations,
                                       std::back_inserter(parallel));
  REQUIRE(parallel.size() == sequential.size());
  for (std::size_t k = 0; k < parallel.size(); ++k) {
    const Jets single = patch.template evaluate<Order>(samples.points[k], samples.locations[k]);
    CHECK(same_jets(sequential[k], single));
    CHECK(same_jets(parallel[k], single));
  }
}

template <typename Patch>
void check_points_and_normals(const Patch& patch,
                              const Samples<typename Patch::Geom_traits>& samples) {
  using Result = std::pair<typename Patch::Point_3, typename Patch::Vector_3>;
  std::vector<Result> sequential(samples.points.size()), parallel;
  patch.template points_and_normals<CGAL::Sequential_tag>(samples.points, samples.locations,
                                                          sequential.begin());
  patch.points_and_normals(samples.points, samples.locations, std::back_inserter(parallel));
  REQUIRE(parallel.size() == sequential.size());
  for (std::size_t k = 0; k < parallel.size(); ++k) {
    const Result single = patch.point_and_normal(samples.points[k], samples.locations[k]);
    CHECK(sequential[k] == single);
    CHECK(parallel[k] == single);
  }
}

template <typename Patch>
void check_batches(const Patch& patch, Random& random) {
  for (const std::size_t count : {0, 1, 2, 3, 150}) {
    const auto samples = random_samples(patch.domain(), random, count);
    check_derivatives<0>(patch, samples);
    check_derivatives<1>(patch, samples);
    check_derivatives<2>(patch, samples);
    check_points_and_normals(patch, samples);
  }
}

} // namespace

TEST_CASE("Batches of points of a concave patch have the results of single points") {
  const unsigned seed = 11;
  CAPTURE(seed);
  Random random(seed);
  for (const auto central :
       {MP::Central_weight::none, MP::Central_weight::weight_deficiency,
        MP::Central_weight::adjacent_products, MP::Central_weight::full_product}) {
    CAPTURE(to_string(central));
    check_batches(concave_patch(random, 7, central), random);
  }
  check_batches(concave_patch(random, 3, MP::Central_weight::adjacent_products), random);
}

TEST_CASE("Batches of points of a concave patch with all options have the results of single ones") {
  const unsigned seed = 12;
  CAPTURE(seed);
  Random random(seed);
  auto model = Concave_patch::Model(lifted_loop(
      l_shape(), [](double x, double y) { return 0.3 * x * x - 0.2 * y * y + 0.1 * x * y; }));
  model.parameter_dilation = 0.7;
  model.reflex_weight = 3;
  model.corner_control_points = model.default_corner_control_points();
  REQUIRE(model.corner_control_points.size() == 1);
  check_batches(Concave_patch(model, Mean_value(Domain(l_shape()))), random);
}

TEST_CASE("Batches of points of a generalized Bezier patch have the results of single points") {
  const unsigned seed = 13;
  CAPTURE(seed);
  Random random(seed);
  for (const auto& [n, degree] : {std::pair(3, 3), std::pair(4, 6), std::pair(5, 5)})
    check_batches(Generalized_patch(generalized_net<Kernel>(random, n, degree)), random);
}

TEST_CASE("Batches of points of an S-patch have the results of single points") {
  const unsigned seed = 14;
  CAPTURE(seed);
  Random random(seed);
  for (const auto& [n, depth] : {std::pair(3, 4), std::pair(5, 3)})
    check_batches(S_patch(s_net(random, n, depth)), random);
}

TEST_CASE("In exact arithmetic batches have the results of single points as well") {
  using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
  const unsigned seed = 15;
  CAPTURE(seed);
  Random random(seed);
  using Patch = MP::Generalized_bezier_patch_3<Exact>;
  const Patch::Domain square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Patch patch(generalized_net<Exact>(random, 4, 3), Patch::Coordinates(square));
  const auto samples = random_samples(square, random, 5);
  check_derivatives<1>(patch, samples);
  std::vector<Exact::Point_3> points;
  patch.evaluate_points<CGAL::Sequential_tag>(samples.points, std::back_inserter(points));
  REQUIRE(points.size() == samples.points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    CHECK(points[k] == patch(samples.points[k]));
}

TEST_CASE("Points do not depend on what else is evaluated with them") {
  const unsigned seed = 16;
  CAPTURE(seed);
  Random random(seed);
  const Concave_patch patch = concave_patch(random, 6, MP::Central_weight::weight_deficiency);
  const auto samples = random_samples(patch.domain(), random, 40);
  std::vector<Concave_patch::Surface_jet<1>> all(samples.points.size()), few(4);
  patch.evaluate_batch<1>(samples.points, samples.locations, all.begin());
  for (int round = 0; round < 50; ++round) {
    std::array<std::size_t, 4> chosen;
    Samples<Kernel> part;
    for (std::size_t& k : chosen) {
      k = random.integer(0, samples.points.size() - 1);
      part.points.push_back(samples.points[k]);
      part.locations.push_back(samples.locations[k]);
    }
    patch.evaluate_batch<1>(part.points, part.locations, few.begin());
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(same_jets(few[i], all[chosen[i]]));
  }
}

TEST_CASE("Near corners derivatives of batches are as accurate as in exact arithmetic") {
  // Each pack has points near different corners, where another corner is the better origin.
  const unsigned seed = 17;
  CAPTURE(seed);
  Random random(seed);
  const Concave_patch patch = concave_patch(random, 5, MP::Central_weight::none);
  Samples<Kernel> samples;
  const std::size_t n = patch.domain().size();
  for (std::size_t i = 0; i < 4 * n; ++i) {
    const auto &corner = patch.domain().vertex(i % n), centre = Point_2(0, 0);
    samples.add(patch.domain(), corner + std::pow(10.0, -random.in(5, 11)) * (centre - corner));
  }
  std::vector<Concave_patch::Surface_jet<1>> jets(samples.points.size());
  patch.evaluate_batch<1>(samples.points, samples.locations, jets.begin());
  using Exact_jet = MP::Jet_2<CGAL::Gmpq, 1>;
  for (std::size_t k = 0; k < jets.size(); ++k) {
    std::vector<MP::Jet_2<double, 1>> lambda(n);
    patch.coordinates().evaluate<1>(samples.points[k], samples.locations[k], lambda.data());
    std::vector<Exact_jet> exact(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t e = 0; e < 3; ++e)
        exact[i][e] = CGAL::Gmpq(lambda[i][e]);
    const auto expected = patch.combine(exact.data());
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t e = 0; e < 3; ++e)
        CHECK(jets[k][c][e] == Approx(CGAL::to_double(expected[c][e])).epsilon(0).margin(1e-9));
  }
}

TEST_CASE("A point outside the domain is noticed") {
  const unsigned seed = 18;
  CAPTURE(seed);
  Random random(seed);
  const Concave_patch patch = concave_patch(random, 5, MP::Central_weight::none);
  std::vector<Point_3> points;
  CHECK_THROWS_AS(
      patch.evaluate_points(std::vector<Point_2>{{0, 0}, {5, 5}}, std::back_inserter(points)),
      MP::Outside_domain_error);
}

TEST_CASE("A pack of numbers computes in each lane what a number does") {
  const unsigned seed = 19;
  CAPTURE(seed);
  Random random(seed);
  for (int round = 0; round < 100; ++round) {
    std::array<double, 2> a{random.in(-2, 2), random.in(-2, 2)}, b{random.in(-2, 2), a[1]};
    const Number_pack x = Number_pack::load(a.data()), y = Number_pack::load(b.data());
    for (std::size_t l = 0; l < 2; ++l) {
      CHECK((x + y)[l] == a[l] + b[l]);
      CHECK((x - y)[l] == a[l] - b[l]);
      CHECK((x * y)[l] == a[l] * b[l]);
      CHECK((x / y)[l] == a[l] / b[l]);
      CHECK((-x)[l] == -a[l]);
      CHECK(sqrt(x * x)[l] == std::sqrt(a[l] * a[l]));
      CHECK((x < y)[l] == (a[l] < b[l]));
      CHECK((x <= y)[l] == (a[l] <= b[l]));
      CHECK((x == y)[l] == (a[l] == b[l]));
      CHECK(select(x < y, x, y)[l] == (std::min)(a[l], b[l]));
    }
    CHECK(any(x < y) == (a[0] < b[0]));
    CHECK(any(x == y));
    CHECK(!any(x == x + Number_pack(1)));
  }
}
