// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

using namespace fixtures;
using Coordinates = MP::Mean_value_coordinates_2<Kernel>;
using Patch = MP::Concave_bezier_patch_3<Kernel, Coordinates>;
using Model = Patch::Model;
using Location = Domain::Location;
using Jet = MP::Jet_2<double, 2>;

namespace {

double bowl(double x, double y) {
  return 0.3 * x * x - 0.2 * y * y + 0.1 * x * y;
}

// An L with one reflex corner, at vertex 3.
Model l_model() {
  return Model(lifted_loop(l_shape(), bowl));
}

std::vector<Jet> coordinates_at(const Patch& patch, const Point_2& p) {
  std::vector<Jet> lambda(patch.domain().size());
  patch.coordinates().evaluate<2>(p, patch.domain().locate(p), lambda.data());
  return lambda;
}

std::vector<Jet> weights_at(const Patch& patch, const Point_2& p) {
  const std::vector<Jet> lambda = coordinates_at(patch, p);
  std::vector<Jet> weights(patch.basis().size());
  patch.basis().evaluate(patch.domain(), lambda.data(), weights.data());
  return weights;
}

void check_that_it_meets_its_ribbons(const Patch& patch) {
  for (const auto& side : MP::continuity_report(patch).sides) {
    CAPTURE(side.side);
    CHECK(side.position.max < 1e-13);
    CHECK(side.tangent_plane->max < 1e-8);
  }
}

} // namespace

TEST_CASE("Whatever the weight of reflex corners, sides run at their pace and h is 0 on its side") {
  const Coordinates coordinates{Domain(l_shape())};
  const Domain& domain = coordinates.domain();
  std::vector<Jet> lambda(6);
  std::vector<MP::Side_parameter<Jet>> plain(6), weighted(6);
  for (std::size_t i = 0; i < 6; ++i)
    for (const double s : {0.1, 0.5, 0.8}) {
      coordinates.evaluate<2>(domain.point_on_side(i, s), Location::on_side(i, s), lambda.data());
      MP::compute_side_parameters(domain, lambda.data(), {0.2, 3, {3}}, weighted);
      CHECK(weighted[i].s.value() == Approx(s));
      CHECK(weighted[i].h.value() == 0);
      for (std::size_t j = 0; j < 6; ++j)
        if (j != i && j != domain.next(i) && j != domain.prev(i))
          CHECK(weighted[j].h.value() == Approx(1));
    }
  const Point_2 p(0.7, 0.6);
  coordinates.evaluate<2>(p, Location::interior(), lambda.data());
  MP::compute_side_parameters(domain, lambda.data(), {}, plain);
  MP::compute_side_parameters(domain, lambda.data(), {0, 3, {3}}, weighted);
  const double sum = 1 + 2 * lambda[3].value();
  CHECK(domain.corner_type(3) == MP::Corner_type::reflex);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(weighted[i].s.value() == plain[i].s.value());
    CHECK(weighted[i].h.value() + weighted[i].one_minus_h.value() == Approx(1));
    const double own = lambda[i].value() * (i == 3 ? 3 : 1),
                 next = lambda[(i + 1) % 6].value() * (i == 2 ? 3 : 1);
    CHECK(weighted[i].one_minus_h.value() == Approx((own + next) / sum));
  }
}

TEST_CASE("A weight of reflex corners keeps the contact with all ribbons and widens their reach") {
  Model model = l_model();
  const Patch plain(model);
  model.reflex_weight = 2.5;
  const Patch patch(model);
  check_that_it_meets_its_ribbons(patch);
  // The side that starts at the reflex corner, row 1: its weight grows away from the side.
  const Point_2 p =
      plain.domain().vertex(3) + 0.3 * (plain.domain().vertex(0) - plain.domain().vertex(3));
  const auto in_plain = weights_at(plain, p), in_patch = weights_at(patch, p);
  CHECK(in_patch[patch.basis().index(3, 1, 0)].value() >
        in_plain[plain.basis().index(3, 1, 0)].value());
}

TEST_CASE("A corner control point has the weight of its formula, and none on the boundary") {
  Model model = l_model();
  model.corner_control_points = model.default_corner_control_points();
  REQUIRE(model.corner_control_points.size() == 1);
  const std::size_t in = model.corner_control_points[0].index, out = in + 1;
  CHECK(model.loop.corner_type(out) == MP::Corner_type::reflex);
  const Patch patch(model);
  check_that_it_meets_its_ribbons(patch);

  const unsigned seed = 20260820;
  CAPTURE(seed);
  Random random(seed);
  std::vector<MP::Side_parameter<Jet>> parameters(6);
  for (int k = 0; k < 20; ++k) {
    const Point_2 p = interior_point(random, patch.domain());
    const auto lambda = coordinates_at(patch, p);
    MP::compute_side_parameters(patch.domain(), lambda.data(), {}, parameters);
    const auto weights = weights_at(patch, p);
    double sum = 0;
    for (const Jet& weight : weights)
      sum += weight.value();
    CHECK(sum == Approx(1).epsilon(1e-13));
    // Weights are divided by a common sum, so ratios tell: here with that of the corner point of
    // the side that arrives, μ B^3_3(s) B^3_0(h).
    const double a = parameters[in].h.value(), b = parameters[out].h.value();
    const double mu = b * b / (a * a + b * b);
    const auto second = [](double h) { return 3 * h * (1 - h) * (1 - h); };
    const double corner = 4.5 * mu * (1 - mu) * second(a) * second(b);
    const double reference = mu * std::pow(parameters[in].s.value(), 3) * std::pow(1 - a, 3);
    const double measured = weights[patch.basis().corner_index(0)].value(),
                 measured_reference = weights[patch.basis().index(in, 3, 0)].value();
    CHECK(measured * reference == Approx(corner * measured_reference).epsilon(1e-9));
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const Location location = Location::on_side(i, 0.375);
    std::vector<Jet> lambda(6), weights(patch.basis().size());
    patch.coordinates().evaluate<2>(patch.domain().point_on_side(i, 0.375), location,
                                    lambda.data());
    patch.basis().evaluate(patch.domain(), lambda.data(), weights.data());
    for (std::size_t e = 0; e < 3; ++e)
      CHECK(weights[patch.basis().corner_index(0)][e] == Approx(0).margin(1e-15));
  }
}

TEST_CASE("A corner control point pulls the patch by its weight") {
  Model model = l_model();
  model.corner_control_points = model.default_corner_control_points();
  const Patch low(model);
  model.corner_control_points[0].point = model.corner_control_points[0].point + Vector_3(0, 0, 2);
  const Patch high(model);
  const Point_2 p =
      low.domain().vertex(3) + 0.3 * (low.domain().vertex(0) - low.domain().vertex(3));
  const double weight = weights_at(low, p)[low.basis().corner_index(0)].value();
  CHECK(weight > 1e-3);
  CHECK(high(p).z() - low(p).z() == Approx(2 * weight).epsilon(1e-10));
}

TEST_CASE("Corner control points leave the boundary alone on loops of any number of sides") {
  Random random(20260821);
  for (std::size_t n = 3; n <= 7; ++n) {
    Model model(lifted_loop(convex_polygon(random, n), bowl));
    for (std::size_t i = 0; i < n; ++i)
      model.corner_control_points.push_back({i, Point_3(5, 5, 5)});
    CAPTURE(n);
    check_that_it_meets_its_ribbons(Patch(model));
  }
}

TEST_CASE("One layer next to a corner control point does not let it disturb other sides") {
  Loop loop = lifted_loop(l_shape(), bowl);
  std::vector<Ribbon> ribbons = loop.ribbons();
  const auto& points = ribbons[2].control_points();
  ribbons[2] = Ribbon(3, 1, std::vector<Point_3>(points.begin(), points.begin() + 4));
  Model model{Loop(ribbons)};
  CHECK(model.default_corner_control_points().empty());
  model.corner_control_points.push_back({2, Point_3(5, 5, 5)});
  const Patch patch(model);
  for (const auto& side : MP::continuity_report(patch).sides)
    CHECK(side.position.max < 1e-13);
}

TEST_CASE("Which corners are reflex is a matter of the loop, not of its rounded domain") {
  // The L with a straight corner in the middle of its first side, turned so that it is rounded.
  Random random(20260822);
  for (int k = 0; k < 20; ++k) {
    const double angle = random.in(0, 6.28), c = std::cos(angle), s = std::sin(angle);
    std::vector<Point_2> polygon = l_shape();
    polygon.insert(polygon.begin() + 1, Point_2(1, 0));
    for (Point_2& p : polygon)
      p = Point_2(c * p.x() - s * p.y(), s * p.x() + c * p.y());
    // Lifted by hand: ribbons of 1 layer, as those of the straight corner are not compatible.
    std::vector<Ribbon> ribbons;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point_2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      ribbons.emplace_back(
          1, 1, std::vector<Point_3>{Point_3(a.x(), a.y(), 0), Point_3(b.x(), b.y(), 0)});
    }
    const Loop loop(ribbons);
    REQUIRE(loop.corner_type(1) == MP::Corner_type::straight);
    Model model(loop);
    model.reflex_weight = 3;
    const Patch patch(model);
    CHECK(patch.basis().parameter_options().reflex_corners == std::vector<std::size_t>{4});
  }
}

TEST_CASE("Options that make no sense are refused") {
  using Catch::Matchers::Contains;
  const double nan = std::nan("");
  const auto refuses = [](const std::function<void(Model&)>& change, const std::string& message) {
    Model model = l_model();
    change(model);
    CHECK_THROWS_WITH(Patch(model), Contains(message));
  };
  for (const double weight : {0.0, -1.0, 1e-300, 1e300, nan})
    refuses([&](Model& model) { model.reflex_weight = weight; }, "weight of reflex corners");
  refuses([&](Model& model) { model.parameter_dilation = nan; }, "parameter dilation");
  refuses([&](Model& model) { model.central_point = Point_3(0, nan, 0); }, "central control point");
  const auto with_corners = [](std::vector<Model::Corner_control_point> corners) {
    return [=](Model& model) { model.corner_control_points = corners; };
  };
  refuses(with_corners({{6, Point_3(0, 0, 0)}}), "end of side 6, but no such side");
  refuses(with_corners({{2, Point_3(0, 0, nan)}}), "end of side 2 is not finite");
  refuses(with_corners({{2, Point_3(0, 0, 0)}, {2, Point_3(0, 0, 1)}}), "two extra control points");
}
