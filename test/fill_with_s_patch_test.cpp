// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "s_patch_fixtures.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/patches/fill_with_S_patch.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <utility>
#include <vector>

using namespace s_patch_fixtures;

namespace {

/*
 * The graph of z = q(x,y), a quadratic polynomial, along the sides of a polygon: ribbons of degree
 * 2 whose cross-derivatives lie in its tangent planes. As they come from a smooth surface, ribbons
 * agree at the corners.
 */
template <typename Traits>
class Graph {
public:
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;
  using Vector_2 = typename Traits::Vector_2;
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;

  FT xx{1}, xy{0}, yy{-1}, x{0}, y{0};
  FT growth{2}; // of the width of the ribbons, from start to end

  // the polar form, q(p,p) = q(p)
  FT polar(const Point_2& p, const Point_2& r) const {
    return xx * p.x() * r.x() + xy * (p.x() * r.y() + p.y() * r.x()) / FT(2) + yy * p.y() * r.y() +
           (x * (p.x() + r.x()) + y * (p.y() + r.y())) / FT(2);
  }
  // the derivative at p in the direction w
  FT derivative(const Point_2& p, const Vector_2& w) const {
    return FT(2) * (polar(p, p + w) - polar(p, p));
  }
  Vector_3 normal(const Point_2& p) const {
    return {-derivative(p, Vector_2(1, 0)), -derivative(p, Vector_2(0, 1)), FT(1)};
  }

  MP::Bezier_ribbon_3<Traits> ribbon(const std::vector<Point_2>& polygon, std::size_t i) const {
    const std::size_t n = polygon.size();
    const Point_2 &a = polygon[i], &b = polygon[(i + 1) % n];
    // Into the polygon at both ends, but not along the neighbouring sides.
    const Vector_2 inwards(a.y() - b.y(), b.x() - a.x());
    const std::array<Vector_2, 2> w{inwards + FT(1) / FT(5) * (b - a),
                                    growth * inwards - FT(1) / FT(3) * (b - a)};
    std::vector<Point_3> points;
    const std::array<Point_2, 3> plan{a, CGAL::midpoint(a, b), b};
    const std::array<FT, 3> height{polar(a, a), polar(a, b), polar(b, b)};
    for (std::size_t j = 0; j < 3; ++j)
      points.emplace_back(plan[j].x(), plan[j].y(), height[j]);
    const std::array<Vector_2, 3> across{w[0], FT(1) / FT(2) * (w[0] + w[1]), w[1]};
    const std::array<FT, 3> rise{derivative(a, w[0]),
                                 (derivative(a, w[1]) + derivative(b, w[0])) / FT(2),
                                 derivative(b, w[1])};
    for (std::size_t j = 0; j < 3; ++j)
      points.push_back(points[j] +
                       FT(1) / FT(12) * Vector_3(across[j].x(), across[j].y(), rise[j]));
    return {2, 2, points};
  }

  // Ribbons of degrees 2 and 3 in turn.
  MP::Ribbon_loop_3<Traits> loop(const std::vector<Point_2>& polygon) const {
    std::vector<MP::Bezier_ribbon_3<Traits>> ribbons;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      ribbons.push_back(ribbon(polygon, i).elevated(2 + i % 2));
    return MP::Ribbon_loop_3<Traits>(std::move(ribbons));
  }
};

template <typename Patch>
void check_that_it_meets_its_ribbons(const Patch& patch) {
  const MP::Continuity_report report = MP::continuity_report(patch, 8);
  CHECK(report.largest_position().value < 1e-9 * patch.loop().diagonal());
  CHECK(report.sides[0].tangent_plane);
  CHECK(report.largest_tangent_plane().value < 1e-6);
}

bool is_convex(const Loop& loop) {
  return loop.number_of_corners(MP::Corner_type::convex) == loop.size();
}

std::vector<Loop> convex_models() {
  std::vector<Loop> loops;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(MODELS_DIR))
    if (entry.path().extension() == ".cgb") {
      const Loop loop = MP::IO::read_CGB<Kernel>(entry.path().string()).loop;
      if (is_convex(loop))
        loops.push_back(loop);
    }
  return loops;
}

} // namespace

TEST_CASE("Filling convex models of the examples meets their ribbons") {
  const std::vector<Loop> loops = convex_models();
  REQUIRE(loops.size() >= 5);
  for (const Loop& loop : loops) {
    // Nothing needs to be changed.
    const Patch patch = MP::fill_with_S_patch(loop, MP::Incompatible_ribbons::refuse);
    CHECK(patch.net().depth() == 6);
    check_that_it_meets_its_ribbons(patch);
    // The ribbons of the model itself are the ones.
    check_that_it_meets_its_ribbons(Patch(patch.net(), loop, patch.coordinates()));
    for (std::size_t i = 0; i < loop.size(); ++i)
      CHECK(patch.point_on_side(i, 0.3) == loop[i].boundary_point(0.3));
  }
}

TEST_CASE("In exact arithmetic a filling has exactly the tangent planes of its ribbons") {
  const Graph<Exact> graph{2, 1, -1, 0, 3};
  const std::vector<Exact::Point_2> plan = pentagon<Exact>();
  // Not the polygon of the ribbons, nor an affine image of it.
  const MP::Wachspress_coordinates_2<Exact> coordinates(MP::Polygonal_domain_2<Exact>(
      {{0, 0}, {1, 0}, {Rational(5) / 4, 1}, {Rational(1) / 2, 2}, {Rational(-1) / 3, 1}}));
  const auto patch = MP::fill_with_S_patch(graph.loop(plan), coordinates);
  CHECK(patch.net().depth() == 6);
  for (std::size_t i = 0; i < 5; ++i)
    for (const Rational& s : parameters()) {
      const auto p = patch.evaluate<1>(patch.domain().point_on_side(i, s),
                                       patch.domain().location_on_side(i, s));
      const Exact::Point_2 on_plan = plan[i] + s * (plan[(i + 1) % 5] - plan[i]);
      CHECK(p[0].value() == on_plan.x());
      CHECK(p[1].value() == on_plan.y());
      CHECK(p[2].value() == graph.polar(on_plan, on_plan));
      const Exact::Vector_3 u(p[0][1], p[1][1], p[2][1]), v(p[0][2], p[1][2], p[2][2]);
      const Exact::Vector_3 normal = CGAL::cross_product(u, v), wanted = graph.normal(on_plan);
      CHECK(CGAL::cross_product(normal, wanted) == CGAL::NULL_VECTOR);
      CHECK(normal * wanted > 0);
    }
}

TEST_CASE("Ribbons of constant width in an affine image of the domain are filled with that image") {
  const std::vector<Point_2> plan = pentagon<Kernel>();
  const Graph<Kernel> plane{0, 0, 0, 0.3, -0.7, 1};
  const Patch patch =
      MP::fill_with_S_patch(plane.loop(plan), MP::Wachspress_coordinates_2<Kernel>(Domain(plan)));
  patch.net().for_each_control_point([&](const Index& i, const Point_3& p) {
    Vector_3 expected(0, 0, 0);
    for (std::size_t k = 0; k < 5; ++k)
      expected = expected + static_cast<double>(i[k]) / static_cast<double>(patch.net().depth()) *
                                (patch.loop().corner_point(k) - CGAL::ORIGIN);
    // The ribbons lead askew, and differently along a side; but β makes up for that.
    CHECK(distance(p, CGAL::ORIGIN + expected) < 1e-12);
  });
}

TEST_CASE("Loops of any size are filled") {
  const Loop loop = Graph<Kernel>{0.2, 0.1, -0.3, 0, 0.5}.loop(pentagon<Kernel>());
  for (const double size : {1e-140, 1e-20, 1e20, 1e140}) {
    CAPTURE(size);
    std::vector<Ribbon> ribbons;
    for (const Ribbon& r : loop.ribbons()) {
      std::vector<Point_3> points;
      for (const Point_3& p : r.control_points())
        points.push_back(CGAL::ORIGIN + size * (p - CGAL::ORIGIN));
      ribbons.emplace_back(r.degree(), r.layers(), points);
    }
    check_that_it_meets_its_ribbons(
        MP::fill_with_S_patch(Loop(ribbons), MP::Incompatible_ribbons::refuse));
  }
}

TEST_CASE("Ribbons far from the origin agree up to rounding") {
  const Graph<Kernel> graph{0.2, 0.1, -0.3, 0.7, 0.5};
  std::vector<Point_2> plan;
  for (const Point_2& p : pentagon<Kernel>())
    plan.emplace_back(p.x() / 3, p.y() / 3);
  const Loop loop = graph.loop(plan);
  for (const double far : {1e4, 1e7, 1e9}) {
    CAPTURE(far);
    const auto moved_ribbons = [&] {
      std::vector<Ribbon> ribbons;
      for (const Ribbon& r : loop.ribbons()) {
        std::vector<Point_3> points;
        for (const Point_3& p : r.control_points())
          points.push_back(p + far * Vector_3(1, -2, 3));
        ribbons.emplace_back(r.degree(), r.layers(), points);
      }
      return ribbons;
    };
    const Loop away(moved_ribbons());
    const Patch patch = MP::fill_with_S_patch(away, MP::Incompatible_ribbons::refuse);
    CHECK_NOTHROW(Patch(patch.net(), away, patch.coordinates()));
    const Patch near = MP::fill_with_S_patch(loop);
    for (std::size_t i = 0; i < 5; ++i)
      CHECK(patch.loop()[i].degree() == loop[i].degree());
    const Point_2 center = CGAL::midpoint(patch.domain().vertex(0), patch.domain().vertex(2));
    CHECK(distance(patch(center), near(center) + far * Vector_3(1, -2, 3)) < 1e-13 * far);
    // What is no rounding error is refused as ever.
    for (const std::size_t j : {0, 1}) {
      std::vector<Ribbon> ribbons = moved_ribbons();
      std::vector<Point_3> points = ribbons[1].control_points();
      points[4 + j] = points[4 + j] + Vector_3(0, 0, 0.1);
      ribbons[1] = Ribbon(3, 2, points);
      CHECK_THROWS_WITH(MP::fill_with_S_patch(Loop(ribbons), MP::Incompatible_ribbons::refuse),
                        Catch::Matchers::Contains("corner 1"));
    }
  }
}

TEST_CASE("A patch of an elevated net has the ribbons that are passed on, and else its boundary") {
  const Patch patch = MP::fill_with_S_patch(convex_models().front());
  const Net elevated = patch.net().elevated();
  CHECK(Patch(elevated).loop()[0].layers() == 1);
  const Patch again(elevated, patch.loop(), patch.coordinates());
  CHECK(again.loop()[0].layers() == 2);
  check_that_it_meets_its_ribbons(again);
}

TEST_CASE("Of ribbons with three layers the tangent planes are met") {
  const unsigned seed = 15;
  CAPTURE(seed);
  Random random(seed);
  const Loop two_layers = Graph<Kernel>().loop(pentagon<Kernel>());
  std::vector<Ribbon> ribbons;
  for (const Ribbon& r : two_layers.ribbons()) {
    // The derivative across the side is 5 steps from row to row instead of 3, or anything.
    std::vector<Point_3> points(r.control_points());
    const double scale = random.in(0.5, 2);
    for (std::size_t j = 0; j <= r.degree(); ++j) {
      points[r.degree() + 1 + j] = points[j] + scale * (points[r.degree() + 1 + j] - points[j]);
      points.emplace_back(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
    }
    ribbons.emplace_back(r.degree(), 3, points);
  }
  const Loop loop(ribbons);
  const Patch patch = MP::fill_with_S_patch(loop, MP::Incompatible_ribbons::refuse);
  check_that_it_meets_its_ribbons(patch);
  check_that_it_meets_its_ribbons(Patch(patch.net(), loop, patch.coordinates()));
  for (std::size_t i = 0; i < 5; ++i)
    CHECK((patch.loop()[i].cross_derivative(0.3) - loop[i].cross_derivative(0.3)).squared_length() <
          1e-24);
}

TEST_CASE("Concave loops are filled on a concave domain") {
  const Graph<Kernel> graph{0.2, 0.1, -0.3, 0, 0.5};
  const Loop loop = graph.loop(l_shape());
  REQUIRE(loop.number_of_corners(MP::Corner_type::reflex) == 1);
  CHECK_THROWS_WITH(MP::fill_with_S_patch(loop), Catch::Matchers::Contains("corner 3 is reflex"));
  // The domain is another L.
  const Mean_value coordinates(Domain({{0, 0}, {3, 0}, {3, 1}, {1, 1.2}, {1, 2}, {0, 2}}));
  const auto patch = MP::fill_with_S_patch(loop, coordinates, MP::Incompatible_ribbons::refuse);
  check_that_it_meets_its_ribbons(patch);
}

TEST_CASE("Ribbons that no patch meets are refused, or changed in their second rows") {
  using Catch::Matchers::Contains;
  const unsigned seed = 14;
  CAPTURE(seed);
  Random random(seed);
  const Loop loop = Graph<Kernel>{0.2, 0.1, -0.3, 0, 0.5}.loop(pentagon<Kernel>());
  // Side 1 is of degree 3, so that its point (1,1) has to do with the twist at corner 1 alone; the
  // point (0,1) is that of the tangent plane.
  for (const std::size_t j : {0, 1}) {
    std::vector<Ribbon> ribbons = loop.ribbons();
    std::vector<Point_3> points = ribbons[1].control_points();
    points[4 + j] = points[4 + j] + Vector_3(0, 0, 0.1);
    ribbons[1] = Ribbon(3, 2, points);
    const Loop bad(ribbons);
    CHECK_THROWS_WITH(MP::fill_with_S_patch(bad, MP::Incompatible_ribbons::refuse),
                      Contains("corner 1"));
    const Patch patch = MP::fill_with_S_patch(bad);
    check_that_it_meets_its_ribbons(patch);
    CHECK(MP::continuity_report(Patch(patch.net(), bad, patch.coordinates()))
              .largest_tangent_plane()
              .value > 0.01);
    // Ribbon 0 needs a point for its twist at one end that has no effect at the other.
    CHECK(patch.loop()[0].degree() == 3);
    CHECK(patch.loop()[4].degree() == 2);
    for (std::size_t i = 0; i < 5; ++i) {
      const Ribbon before = bad[i].elevated(3), after = patch.loop()[i].elevated(3);
      for (std::size_t k = 0; k < 4; ++k) {
        CHECK(distance(before.control_point(k, 0), after.control_point(k, 0)) < 1e-14);
        const bool may_move = (i == 1 && k <= 1) || (i == 0 && k == 2);
        CHECK(
            (distance(before.control_point(k, 1), after.control_point(k, 1)) < 1e-13 || may_move));
      }
    }
  }
}

TEST_CASE("S-patches refuse ribbons and domains that do not fit") {
  using Catch::Matchers::Contains;
  const Loop loop = Graph<Kernel>().loop(pentagon<Kernel>());
  const Patch patch = MP::fill_with_S_patch(loop);
  // a loop with another boundary, one of too high a degree, and one with another number of sides
  const Loop other = Graph<Kernel>{1, 0, -1, 0.001, 0}.loop(pentagon<Kernel>());
  CHECK_THROWS_WITH(Patch(patch.net(), other, patch.coordinates()),
                    Contains("not that of the ribbon of side 0"));
  std::vector<Ribbon> ribbons = loop.ribbons();
  ribbons[2] = ribbons[2].elevated(7);
  CHECK_THROWS_WITH(Patch(patch.net(), Loop(ribbons), patch.coordinates()),
                    Contains("the ribbon of side 2 has degree 7"));
  const Loop square = Graph<Kernel>().loop({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK_THROWS_AS(Patch(patch.net(), square, patch.coordinates()), MP::Input_error);
  CHECK_THROWS_AS(Patch(MP::fill_with_S_patch(square).net(), patch.coordinates()), MP::Input_error);
  CHECK_THROWS_AS(MP::fill_with_S_patch(square, patch.coordinates()), MP::Input_error);

  ribbons = loop.ribbons();
  ribbons[3] =
      Ribbon(3, 1, {ribbons[3].control_points().begin(), ribbons[3].control_points().begin() + 4});
  CHECK_THROWS_WITH(MP::fill_with_S_patch(Loop(ribbons)), Contains("side 3 has a single layer"));
  // a ribbon that leads outwards
  ribbons = loop.ribbons();
  std::vector<Point_3> points = ribbons[1].control_points();
  for (std::size_t j = 0; j < 4; ++j)
    points[4 + j] = points[j] - (points[4 + j] - points[j]);
  ribbons[1] = Ribbon(3, 2, points);
  CHECK_THROWS_AS(MP::fill_with_S_patch(Loop(ribbons), patch.coordinates()), MP::Input_error);
  // corners at which the boundary goes straight on, of the domain and of the loop
  // or nearly so, or not quite
  for (const double turn : {0.0, 1e-15, 1e-8, 1e-3, 1.7e-2, 1.8e-2}) {
    CAPTURE(turn);
    const std::vector<Point_2> plan{{0, 0}, {1, -std::tan(turn / 2)}, {2, 0}, {2, 2}, {0, 2}};
    const Mean_value coordinates{Domain(plan)};
    const Loop with_turn = Graph<Kernel>{0, 0, 0, 0, 0}.loop(plan);
    if (turn > 1.75e-2) { // of a degree and more
      CHECK_NOTHROW(MP::fill_with_S_patch(loop, coordinates));
      CHECK_NOTHROW(MP::fill_with_S_patch(with_turn));
      continue;
    }
    CHECK_THROWS_WITH(MP::fill_with_S_patch(loop, coordinates),
                      Contains("corner 1 of the domain is straight"));
    REQUIRE(with_turn.number_of_corners(MP::Corner_type::straight) == 1);
    CHECK_THROWS_WITH(MP::fill_with_S_patch(with_turn),
                      Contains("corner 1 of the loop is straight"));
  }
  // a net that would be too large
  std::vector<Point_2> many;
  for (int k = 0; k < 25; ++k)
    many.emplace_back(std::cos(k * CGAL_PI / 12.5), std::sin(k * CGAL_PI / 12.5));
  CHECK_THROWS_WITH(MP::fill_with_S_patch(Graph<Kernel>().loop(many)),
                    Contains("593775 control points, more than 500000"));
}
