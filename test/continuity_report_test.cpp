// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <algorithm>
#include <filesystem>
#include <limits>

using namespace fixtures;
using Square_patch = MP::Concave_bezier_patch_3<Kernel, MP::Wachspress_coordinates_2<Kernel>>;
using Net = std::vector<std::vector<Point_3>>;

namespace {

constexpr double pi = MP::internal::pi;

Square_patch square_patch(const Loop& loop) {
  return Square_patch(Square_patch::Model(loop), MP::Wachspress_coordinates_2<Kernel>(
                                                     Domain({{0, 0}, {1, 0}, {1, 1}, {0, 1}})));
}

// The net of degree 5 of (x, y, a + b x + c x² + e y), with x = x0 + u and y = v: straight lines
// x = const, and 3 layers.
Loop cylinder_loop(double x0, double b = 0.3, double c = 0.2, double e = -0.4) {
  Net net(6);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      const double u = double(i) / 5, v = double(j) / 5, uu = double(i) * (double(i) - 1) / 20;
      net[i].emplace_back(x0 + u, v, b * (x0 + u) + c * (x0 * x0 + 2 * x0 * u + uu) + e * v);
    }
  return tensor_product_loop<Kernel>(net);
}

// The loop as seen from the other side of the surface; side i becomes side 3 - i.
Loop turned_over(const Loop& loop) {
  std::vector<Ribbon> ribbons;
  for (const Ribbon& r : loop.ribbons())
    ribbons.insert(ribbons.begin(), r.reversed());
  return Loop(ribbons);
}

// The ribbon with row `k` replaced by what `move` makes of its points.
template <typename Move>
Ribbon with_row(const Ribbon& r, std::size_t k, const Move& move) {
  std::vector<Point_3> points = r.control_points();
  for (std::size_t j = 0; j <= r.degree(); ++j)
    points[k * (r.degree() + 1) + j] = move(j, r.control_point(j, k));
  return Ribbon(r.degree(), r.layers(), points);
}

template <typename Move>
Loop with_row(const Loop& loop, std::size_t side, std::size_t k, const Move& move) {
  std::vector<Ribbon> ribbons = loop.ribbons();
  ribbons[side] = with_row(ribbons[side], k, move);
  return Loop(ribbons);
}

// p, turned about the line through the ends of a ribbon's straight boundary; this takes the
// surface on the left of the line up.
Point_3 turned(const Ribbon& r, const Point_3& p, double degrees) {
  const Point_3& o = r.control_point(0, 0);
  Vector_3 axis = r.control_point(r.degree(), 0) - o;
  axis = axis / std::sqrt(axis.squared_length());
  const double t = degrees * pi / 180;
  const Vector_3 d = p - o, along = (d * axis) * axis, away = d - along;
  return o + along + std::cos(t) * away + std::sin(t) * CGAL::cross_product(axis, away);
}

// A patch that is compared with ribbons other than its own.
class With_other_ribbons {
public:
  using FT = double;

  With_other_ribbons(const Square_patch& patch, const Loop& loop) : patch_(patch), loop_(loop) {}
  const Domain& domain() const { return patch_.domain(); }
  const Loop& loop() const { return loop_; }
  template <int Order>
  auto evaluate(const Point_2& uv, const Domain::Location& location) const {
    return patch_.evaluate<Order>(uv, location);
  }

private:
  Square_patch patch_;
  Loop loop_;
};

template <typename Model>
bool only_two_layers(const Model& model) {
  bool two = true;
  for (const Ribbon& r : model.loop.ribbons())
    two = two && r.layers() == 2;
  return two;
}

} // namespace

TEST_CASE("The examples meet their ribbons with tangent planes, and with curvatures where asked") {
  int with_planes = 0, with_curvatures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MODELS_DIR)) {
    if (entry.path().extension() != ".cgb" || entry.path().stem() == "mixed_duct")
      continue; // a side of degree 2 in mixed_duct keeps its neighbours from their tangent planes
    INFO(entry.path().stem().string());
    const auto model = MP::IO::read_CGB<Kernel>(entry.path().string());
    const MP::Concave_bezier_patch_3<Kernel> patch(model);
    const auto report = MP::continuity_report(patch);
    CHECK(report.sides.size() == patch.loop().size());
    CHECK(report.largest_position().value < 1e-14 * patch.loop().diagonal());
    CHECK(report.largest_tangent_plane().value < 1e-9);
    CHECK(report.largest_normal_curvature().value < 1e-6);
    ++(only_two_layers(model) ? with_planes : with_curvatures);
  }
  CHECK(with_planes >= 10);
  CHECK(with_curvatures >= 1);
}

TEST_CASE("Ribbons of too low a degree are not met, and the report says so") {
  const MP::Concave_bezier_patch_3<Kernel> patch(
      MP::IO::read_CGB<Kernel>(MODELS_DIR "/mixed_duct.cgb"));
  const auto report = MP::continuity_report(patch);
  for (const MP::Side_continuity& side : report.sides) {
    CHECK(side.position.max < 1e-14 * patch.loop().diagonal());
    REQUIRE(side.tangent_plane);
    CHECK(side.normal_curvature.has_value() == (patch.loop()[side.side].layers() >= 3));
    // Side 5 has degree 2.
    if (side.side == 4 || side.side == 6)
      CHECK(side.tangent_plane->max > 1);
    else
      CHECK(side.tangent_plane->max < 1e-9);
  }
  const auto worst = report.largest_tangent_plane();
  CHECK((worst.side == 4 || worst.side == 6));
  CHECK(worst.value == report.sides[worst.side].tangent_plane->max);
  CHECK(worst.s == report.sides[worst.side].tangent_plane->s);
}

TEST_CASE("Wild loops are met to the order that their degrees and layers allow, and no further") {
  const unsigned seed = 20260302;
  CAPTURE(seed);
  Random random(seed);
  std::size_t planes = 0, no_planes = 0, curvatures = 0, no_curvatures = 0;
  for (int k = 0; k < 30; ++k) {
    const Loop loop = random_loop(random, random.integer(3, 8), 0.1);
    for (const Loop& l : {loop, MP::elevated_for_contact(loop)}) {
      const MP::Concave_bezier_patch_3<Kernel> patch(l);
      for (const MP::Side_continuity& side : MP::continuity_report(patch).sides) {
        CAPTURE(k, side.side);
        const std::size_t order = MP::contact_order(l, side.side);
        CHECK(side.position.max < 1e-14 * l.diagonal());
        if (side.tangent_plane) {
          CHECK((side.tangent_plane->max < 1e-9) == (order >= 1));
          ++(order >= 1 ? planes : no_planes);
        }
        if (side.normal_curvature) {
          CHECK((side.normal_curvature->max < 1e-6) == (order >= 2));
          ++(order >= 2 ? curvatures : no_curvatures);
        }
      }
    }
  }
  CAPTURE(planes, no_planes, curvatures, no_curvatures);
  CHECK((std::min)({planes, no_planes, curvatures, no_curvatures}) >= 5);
}

TEST_CASE("Samples lie where they are asked for") {
  const Square_patch patch = square_patch(cylinder_loop(0));
  // The distance is a Bernstein polynomial: it is known where it is largest, and on average.
  const double height = 1e-3;
  const Loop bumpy = with_row(patch.loop(), 2, 0, [&](std::size_t j, const Point_3& p) {
    return p + (j == 1 ? height : 0) * Vector_3(0, 0, 1);
  });
  const auto report = MP::continuity_report(With_other_ribbons(patch, bumpy), 1000);
  const auto worst = report.largest_position();
  CHECK(worst.side == 2);
  CHECK(worst.s == Approx(0.2).margin(5e-4));
  CHECK(worst.value == Approx(height * 5 * 0.2 * std::pow(0.8, 4)).epsilon(1e-4));
  CHECK(report.sides[2].position.mean == Approx(height / 6).epsilon(1e-4));

  // The slope is largest at the very end.
  const Loop steep = with_row(patch.loop(), 2, 1, [&](std::size_t j, const Point_3& p) {
    return p + (j == 0 ? height : 0) * Vector_3(0, 0, 1);
  });
  MP::Side_samples samples(10);
  for (const std::size_t decades : {0, 1, 3, 9}) {
    samples.decades = decades;
    const auto planes = MP::continuity_report(With_other_ribbons(patch, steep), samples);
    const auto largest = planes.largest_tangent_plane();
    CHECK(largest.s ==
          Approx(decades < 2 ? 0.05 : std::pow(10, -static_cast<double>(decades))).epsilon(1e-9));
    CHECK(planes.sides[2].tangent_plane->mean < largest.value);
  }
}

TEST_CASE("A ribbon that is moved in space or turned is not met, by just as much") {
  const Square_patch patch = square_patch(cylinder_loop(0));
  for (const std::size_t side : {1, 3}) {
    const Ribbon& ribbon = patch.loop()[side];
    for (const double degrees : {1e-10, 5.0, 90.0, 170.0}) {
      const Loop loop = with_row(patch.loop(), side, 1, [&](std::size_t, const Point_3& p) {
        return turned(ribbon, p, degrees);
      });
      const auto report = MP::continuity_report(With_other_ribbons(patch, loop));
      for (const MP::Side_continuity& c : report.sides) {
        CHECK(c.position.max < 1e-14);
        const double expected = c.side == side ? degrees : 0;
        CHECK(c.tangent_plane->max == Approx(expected).margin(5e-13).epsilon(1e-12));
        CHECK(c.tangent_plane->mean == Approx(expected).margin(5e-13).epsilon(1e-12));
      }
    }
    std::vector<Ribbon> ribbons = patch.loop().ribbons();
    for (Ribbon& r : ribbons)
      for (std::size_t k = 0; k < 3; ++k)
        r = with_row(r, k, [](std::size_t, const Point_3& p) { return p + Vector_3(3, 0, 4); });
    const auto moved = MP::continuity_report(With_other_ribbons(patch, Loop(ribbons)));
    CHECK(moved.largest_position().value == Approx(5).epsilon(1e-13));
    CHECK(moved.sides[side].position.mean == Approx(5).epsilon(1e-13));
    CHECK(moved.largest_tangent_plane().value < 1e-12);
  }
}

TEST_CASE("A third row that is moved shows in the curvature only") {
  const Square_patch flat = square_patch(cylinder_loop(0, 0, 0, 0));
  const Square_patch bent = square_patch(cylinder_loop(0, 0, 0.2, 0));
  for (const double lift : {1e-8, 1e-2, 0.1}) {
    const auto lifted = [&](const Loop& loop) {
      return with_row(loop, 3, 2,
                      [&](std::size_t, const Point_3& p) { return p + Vector_3(0, 0, lift); });
    };
    // The first rows are 1/5 apart, and second differences count 5 · 4 times.
    const double curvature = 20 * lift;
    const double diagonal = lifted(flat.loop()).diagonal();
    const auto on_flat = MP::continuity_report(With_other_ribbons(flat, lifted(flat.loop())));
    CHECK(on_flat.largest_position().value < 1e-15);
    CHECK(on_flat.largest_tangent_plane().value < 1e-12);
    const double expected = curvature / (std::max)(curvature, 1 / diagonal);
    CHECK(on_flat.sides[3].normal_curvature->max == Approx(expected).epsilon(1e-8));
    CHECK(on_flat.sides[3].normal_curvature->mean == Approx(expected).epsilon(1e-8));
    CHECK(on_flat.sides[1].normal_curvature->max < 1e-12);

    const auto on_bent = MP::continuity_report(With_other_ribbons(bent, lifted(bent.loop())));
    const double floor = 1 / lifted(bent.loop()).diagonal();
    const double relative = curvature / (std::max)(0.4 + curvature, floor);
    CHECK(on_bent.sides[3].normal_curvature->max == Approx(relative).margin(1e-12));
    CHECK(on_bent.sides[0].normal_curvature->max < 1e-12);
  }
}

TEST_CASE("Curvatures are compared across the side, however the ribbons lean and stretch") {
  // The same cylinder, with rows at other distances that lean along the side: what is the same is
  // the surface, not its parametrization.
  const Square_patch patch = square_patch(cylinder_loop(0, 0, 0.2, 0));
  std::vector<Point_3> points;
  const double step = 0.13, lean = 0.07;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 6; ++j) // side 3 is x = 0, from y = 1 to 0
      points.emplace_back(step * k, 1 - j / 5. + lean * k,
                          0.2 * 25 * step * step * k * (k - 1) / 20);
  std::vector<Ribbon> ribbons = patch.loop().ribbons();
  ribbons[3] = Ribbon(5, 3, points);
  const auto report = MP::continuity_report(With_other_ribbons(patch, Loop(ribbons)));
  CHECK(report.sides[3].tangent_plane->max < 1e-12);
  CHECK(report.sides[3].normal_curvature->max < 1e-12);
}

TEST_CASE("Two halves of one surface meet smoothly, in whichever direction they run") {
  const Square_patch left = square_patch(cylinder_loop(0)), right = square_patch(cylinder_loop(1));
  const Square_patch right_over = square_patch(turned_over(cylinder_loop(1)));
  const auto check = [](const MP::Seam_continuity& seam, bool reversed) {
    CHECK(seam.reversed == reversed);
    CHECK(seam.position.max < 1e-14);
    REQUIRE(seam.tangent_plane);
    CHECK(seam.tangent_plane->max < 1e-12);
    REQUIRE(seam.normal_curvature);
    CHECK(seam.normal_curvature->max < 1e-11);
  };
  const auto seam = MP::continuity_report(left, 1, right, 3);
  CHECK((seam.side_a == 1 && seam.side_b == 3));
  check(seam, true);
  check(MP::continuity_report(right, 3, left, 1), true);
  check(MP::continuity_report(left, 1, right_over, 0), false);
  check(MP::continuity_report(right_over, 0, left, 1, 5), false);
}

TEST_CASE("A neighbour that is turned by five degrees is seen to be turned by five degrees") {
  const Square_patch left = square_patch(cylinder_loop(0));
  const Loop right = cylinder_loop(1);
  const Loop broken =
      with_row(right, 3, 1, [&](std::size_t, const Point_3& p) { return turned(right[3], p, 5); });
  for (const Square_patch& other : {square_patch(broken), square_patch(turned_over(broken))}) {
    const std::size_t side =
        other.loop()[3].control_point(0, 0) == right[3].control_point(0, 0) ? 3 : 0;
    const auto seam = MP::continuity_report(left, 1, other, side);
    CHECK(seam.position.max < 1e-14);
    CHECK(seam.tangent_plane->max == Approx(5).epsilon(1e-11));
    CHECK(seam.tangent_plane->mean == Approx(5).epsilon(1e-11));
    // The patch itself keeps to its broken ribbon.
    CHECK(MP::continuity_report(other).largest_tangent_plane().value < 1e-9);
  }
}

TEST_CASE("A neighbour with another curvature or a gap is found out") {
  const Square_patch left = square_patch(cylinder_loop(0, 0, 0.2, 0));
  const Loop right = cylinder_loop(1, 0, 0.2, 0);
  const double gap = 1e-3;
  std::vector<Ribbon> ribbons;
  for (Ribbon r : right.ribbons()) {
    for (std::size_t k = 0; k < 3; ++k)
      r = with_row(r, k, [&](std::size_t, const Point_3& p) { return p + Vector_3(0, 0, gap); });
    ribbons.push_back(r);
  }
  const auto seam = MP::continuity_report(left, 1, square_patch(Loop(ribbons)), 3);
  CHECK(seam.position.max == Approx(gap).epsilon(1e-11));
  CHECK(seam.position.mean == Approx(gap).epsilon(1e-11));
  CHECK(seam.tangent_plane->max < 1e-12);

  // Rows in line with each other continue the parabola straight on.
  const Square_patch straight =
      square_patch(with_row(right, 3, 2, [&](std::size_t j, const Point_3&) {
        const Point_3 &a = right[3].control_point(j, 0), &b = right[3].control_point(j, 1);
        return b + (b - a);
      }));
  const auto bent = MP::continuity_report(left, 1, straight, 3);
  CHECK(bent.tangent_plane->max < 1e-12);
  const double curvature = 0.4 / std::pow(1 + 0.16, 1.5);
  const double floor = 1 / (std::max)(left.loop().diagonal(), straight.loop().diagonal());
  CHECK(bent.normal_curvature->max == Approx(curvature / (std::max)(curvature, floor)));
}

TEST_CASE(
    "What ribbons do not determine is not compared, what a patch lacks is as wrong as can be") {
  const Square_patch patch = square_patch(cylinder_loop(0));
  std::vector<Ribbon> ribbons = patch.loop().ribbons();
  const auto& points = ribbons[1].control_points();
  ribbons[1] = Ribbon(5, 1, std::vector<Point_3>(points.begin(), points.begin() + 6));
  ribbons[2] = with_row(ribbons[2], 1, [&](std::size_t j, const Point_3&) {
    return ribbons[2].control_point(j, 0); // no direction across
  });
  const auto report = MP::continuity_report(With_other_ribbons(patch, Loop(ribbons)));
  CHECK_FALSE(report.sides[1].tangent_plane);
  CHECK_FALSE(report.sides[1].normal_curvature);
  CHECK_FALSE(report.sides[2].tangent_plane);
  CHECK(report.sides[0].normal_curvature);

  const Square_patch collapsed = square_patch(Loop(ribbons));
  const auto other = MP::continuity_report(With_other_ribbons(collapsed, patch.loop()));
  CHECK(other.sides[2].tangent_plane->max == 180);
  CHECK(other.sides[2].normal_curvature->max == 2);
}

TEST_CASE("Points that are not numbers are infinitely far away") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const MP::internal::Vec3 x{1, 0, 0}, y{0, 1, 0}, zero{0, 0, 0}, bad{nan, nan, nan};
  const MP::internal::Surface_derivatives plane{zero, x, y, zero, zero, zero};
  const MP::internal::Contact contact =
      MP::internal::measure_contact({bad, bad, bad, bad, bad, bad}, plane, x, {3, false, 1});
  CHECK(contact.position == std::numeric_limits<double>::infinity());
  CHECK(contact.tangent_plane == 180);
  CHECK(contact.normal_curvature == 2);
  const MP::internal::Contact second =
      MP::internal::measure_contact({zero, x, y, bad, bad, bad}, plane, x, {3, false, 1});
  CHECK(second.tangent_plane == 0);
  CHECK(second.normal_curvature == 2);
}

TEST_CASE("A neighbour without tangent planes is no smooth one, whichever patch comes first") {
  const Square_patch patch = square_patch(cylinder_loop(0));
  // On side 3 of the neighbour both inner rows lie on the boundary.
  const Loop right = cylinder_loop(1);
  const auto onto_boundary = [&](std::size_t j, const Point_3&) {
    return right[3].control_point(j, 0);
  };
  const Square_patch flat =
      square_patch(with_row(with_row(right, 3, 1, onto_boundary), 3, 2, onto_boundary));
  for (const auto& seam :
       {MP::continuity_report(patch, 1, flat, 3), MP::continuity_report(flat, 3, patch, 1)}) {
    CHECK(seam.position.max < 1e-14);
    REQUIRE(seam.tangent_plane);
    CHECK(seam.tangent_plane->max == 180);
    REQUIRE(seam.normal_curvature);
    CHECK(seam.normal_curvature->max == 2);
  }
}
