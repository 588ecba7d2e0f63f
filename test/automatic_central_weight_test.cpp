// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/bases/automatic_central_weight.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>
#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/central_control_point.h>
#include <CGAL/Multisided_patches/patches/fair_central_point.h>
#include <CGAL/Multisided_patches/patches/with_resolved_central_weight.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace fixtures;
using MP::Central_weight;

namespace {

using Coordinates = MP::Mean_value_coordinates_2<Kernel>;
using Patch = MP::Concave_bezier_patch_3<Kernel, Coordinates>;
using Model = Patch::Model;
using Polygon = std::vector<Point_2>;

// A star with this many rays of length 1; its reflex corners are at the distance `inner`.
Polygon star(std::size_t rays, double inner) {
  Polygon polygon;
  for (std::size_t i = 0; i < 2 * rays; ++i) {
    const double angle = MP::internal::pi * static_cast<double>(i) / static_cast<double>(rays),
                 radius = i % 2 == 0 ? 1 : inner;
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

Polygon cross() {
  return {{-1, -3}, {1, -3}, {1, -1}, {3, -1}, {3, 1},   {1, 1},
          {1, 3},   {-1, 3}, {-1, 1}, {-3, 1}, {-3, -1}, {-1, -1}};
}

// Two crosses that share an arm.
Polygon two_crosses() {
  return {{-1, -3}, {1, -3}, {1, -1}, {8, -1}, {8, -3},  {10, -3}, {10, -1},
          {12, -1}, {12, 1}, {10, 1}, {10, 3}, {8, 3},   {8, 1},   {1, 1},
          {1, 3},   {-1, 3}, {-1, 1}, {-3, 1}, {-3, -1}, {-1, -1}};
}

double dome(double x, double y) {
  return -0.05 * x * x - 0.08 * y * y;
}

Model over(const Polygon& polygon) {
  Model model(lifted_loop(polygon, dome));
  model.domain.generator = MP::Domain_generator::projected;
  return model;
}

Central_weight chosen(const Model& model) {
  return Patch(model).basis().central_weight();
}

// The points of a patch at some places inside.
std::vector<Point_3> points(const Patch& patch) {
  Random random(7);
  std::vector<Point_3> result;
  for (int k = 0; k < 20; ++k)
    result.push_back(patch(interior_point(random, patch.domain())));
  return result;
}

// What fair_central_point() minimizes, as a function of the central point. Written anew.
double bending(const Model& given, const Patch& patch, const Point_3& central_point) {
  Model model = given;
  model.central_weight = patch.basis().central_weight();
  model.central_point = central_point;
  const Patch moved(model, patch.coordinates());
  const CGAL::Bbox_2 box = patch.domain().bbox();
  double sum = 0;
  for (int row = 0; row < 16; ++row)
    for (int column = 0; column < 16; ++column) {
      const Point_2 p(box.xmin() + (box.xmax() - box.xmin()) * (column + 0.5) / 16,
                      box.ymin() + (box.ymax() - box.ymin()) * (row + 0.5) / 16);
      const auto location = patch.domain().locate(p);
      if (location.kind != Domain::Location::Kind::interior)
        continue;
      const double weight = MP::central_weight_at(patch, p);
      if (weight > 0)
        for (const auto& x : moved.evaluate<2>(p, location))
          sum += weight * (x[3] * x[3] + 2 * x[4] * x[4] + x[5] * x[5]);
    }
  return sum;
}

} // namespace

TEST_CASE("A central point is chosen for compact stars, and for nothing else") {
  const std::vector<std::pair<Polygon, Central_weight>> rows{
      {cross(), Central_weight::weight_deficiency},
      {star(5, 0.6), Central_weight::weight_deficiency},
      {star(6, 0.6), Central_weight::weight_deficiency},
      {star(3, 0.6), Central_weight::none},  // the ribbons have nearly all weights
      {star(8, 1), Central_weight::none},    // a regular polygon: there is no reflex corner
      {two_crosses(), Central_weight::none}, // there are two places for one point
      {l_shape(), Central_weight::none},
      {u_shape(), Central_weight::none}};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    CAPTURE(k);
    CHECK(chosen(over(rows[k].first)) == rows[k].second);
  }
  // With harmonic coordinates the deficiency is negative in the necks of long rays.
  const auto with_harmonic = [](const Polygon& polygon) {
    const MP::Harmonic_coordinates_2<Kernel> coordinates(Domain(polygon), 1e-5);
    return MP::automatic_central_weight(over(polygon).loop, coordinates);
  };
  CHECK(with_harmonic(star(6, 0.6)) == Central_weight::weight_deficiency);
  CHECK(with_harmonic(star(6, 0.35)) == Central_weight::none);
}

TEST_CASE("The choice is that of the domain, wherever it lies and however large it is") {
  for (const auto& polygon : {cross(), star(6, 0.6), star(6, 0.15), l_shape()}) {
    const Central_weight expected = chosen(over(polygon));
    for (const double scale : {1e-3, 1.0, 1e6}) {
      Polygon moved;
      for (const Point_2& p : polygon)
        moved.emplace_back(scale * (p.x() + 5), scale * (p.y() - 3));
      const Coordinates coordinates{Domain(moved)};
      CHECK(MP::automatic_central_weight(over(polygon).loop, coordinates) == expected);
    }
  }
}

TEST_CASE("Two of the example models get a central point, with the weight that suits them") {
  const std::set<std::string> stars{"plus_hub", "star_knob"};
  for (const std::string name :
       {"g2_blend", "l_bracket", "mixed_duct", "plus_hub", "saddle_seat", "split_side_panel",
        "star_knob", "t_junction", "twisted_handle_root", "u_vent"}) {
    CAPTURE(name);
    Model model = MP::IO::read_CGB<Kernel>(std::string(MODELS_DIR) + '/' + name + ".cgb");
    const bool has_corner_points = !model.corner_control_points.empty();
    const Central_weight in_file = model.central_weight;
    CHECK(chosen(model) == in_file); // what a file says is as it says
    model.central_weight = Central_weight::automatic;
    CHECK(chosen(model) == (stars.count(name) == 0 ? Central_weight::none
                            : has_corner_points    ? Central_weight::full_product
                                                   : Central_weight::weight_deficiency));
    if (stars.count(name) != 0)
      CHECK(chosen(model) == in_file);
  }
}

TEST_CASE("Whether there is a central point depends on the domain, whatever the ribbons") {
  for (const std::string name : {"g2_blend", "l_bracket", "mixed_duct", "plus_hub", "saddle_seat",
                                 "spiral_volute", "star_knob", "t_junction", "u_vent"}) {
    CAPTURE(name);
    Model model = MP::IO::read_CGB<Kernel>(std::string(MODELS_DIR) + '/' + name + ".cgb");
    model.central_weight = Central_weight::automatic;
    model.corner_control_points.clear();
    const bool is_star = name == "plus_hub" || name == "star_knob";
    CHECK(chosen(model) == (is_star ? Central_weight::weight_deficiency : Central_weight::none));
    const Coordinates coordinates = Patch(model).coordinates();
    for (std::size_t degree = 3; degree <= 8; ++degree)
      for (const std::size_t layers : {2, 3, 4}) {
        CAPTURE(degree, layers);
        std::vector<Ribbon> ribbons;
        for (const Ribbon& ribbon : model.loop.ribbons())
          ribbons.push_back(
              ribbon.elevated((std::max)(degree, ribbon.degree())).with_layers(layers));
        const Loop loop(ribbons);
        // The deficiency of even degrees is negative in places; contact comes first.
        const bool has_product = degree % 2 == 0 && MP::contact_order(loop, 0) <= 1;
        CHECK(MP::automatic_central_weight(loop, coordinates) ==
              (!is_star      ? Central_weight::none
               : has_product ? Central_weight::full_product
                             : Central_weight::weight_deficiency));
      }
  }
}

TEST_CASE("A model gets the weight that its patch has, or the error of making that") {
  Model model = over(cross());
  const MP::Concave_bezier_patch_3<Kernel> patch(model);
  const Model resolved = MP::with_resolved_central_weight(model);
  CHECK(resolved.central_weight == Central_weight::weight_deficiency);
  CHECK(resolved.central_point == patch.control_point(patch.basis().central_index()));
  CHECK(MP::with_resolved_central_weight<Kernel>(over(l_shape()).loop).central_weight ==
        Central_weight::none);
  model.reflex_weight = -1;
  CHECK_THROWS_AS(MP::with_resolved_central_weight(model), MP::Input_error);
  model.central_weight = Central_weight::adjacent_products; // is as it is
  CHECK(MP::with_resolved_central_weight(model).central_weight ==
        Central_weight::adjacent_products);
}

TEST_CASE("Automatic is the default, and means the same as the weight that it stands for") {
  CHECK(Model(lifted_loop(l_shape(), dome)).central_weight == Central_weight::automatic);
  for (const auto& polygon : {cross(), star(6, 0.15)})
    for (const auto& point : {std::optional<Point_3>(), std::optional<Point_3>({0, 0, 1})}) {
      Model model = over(polygon);
      model.central_point = point;
      const Patch automatic(model);
      model.central_weight = automatic.basis().central_weight();
      REQUIRE(model.central_weight != Central_weight::automatic);
      model.central_point = automatic.control_point(automatic.basis().central_index());
      CHECK(points(Patch(model)) == points(automatic));
      if (point)
        CHECK(*model.central_point == *point);
    }
}

TEST_CASE("No contact is given up for a central point") {
  Model model = over(star(6, 0.6));
  model.corner_control_points = model.default_corner_control_points();
  CHECK(chosen(model) == Central_weight::full_product);
  // That would keep the curvatures of ribbons with 3 layers from being met.
  std::vector<Ribbon> ribbons;
  for (const Ribbon& ribbon : model.loop.ribbons())
    ribbons.push_back(ribbon.elevated(5).with_layers(3));
  model.loop = Loop(ribbons);
  REQUIRE(MP::contact_order(model.loop, 0, Central_weight::full_product) == 1);
  CHECK(chosen(model) == Central_weight::none);
  model.corner_control_points.clear();
  CHECK(chosen(model) == Central_weight::weight_deficiency);

  const Loop plain = over(star(6, 0.6)).loop;
  for (const std::size_t layers : {1, 2, 3})
    for (const std::size_t degree : {1, 2, 3, 5}) {
      CAPTURE(layers, degree);
      ribbons.clear();
      for (const Ribbon& ribbon : plain.ribbons())
        ribbons.push_back(
            (degree < 3 ? ribbon.reduced(degree) : ribbon.elevated(degree)).with_layers(layers));
      Model other{Loop(ribbons)};
      other.domain.generator = MP::Domain_generator::projected;
      const Patch patch(other);
      for (std::size_t i = 0; i < ribbons.size(); ++i) {
        const std::size_t promised = MP::contact_order(other.loop, i);
        CHECK(MP::contact_order(other.loop, i, patch.basis().central_weight()) == promised);
        CHECK(MP::contact_order(other.loop, i, Central_weight::automatic) == promised);
        CHECK(MP::continuity_report(patch).sides[i].position.max < 1e-12);
        if (promised > 0)
          CHECK(MP::continuity_report(patch).sides[i].tangent_plane->max < 1e-6);
      }
    }
}

TEST_CASE("The choice is made in all number types") {
  using Rational_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  using Exact = MP::Wachspress_coordinates_2<Rational_kernel>;
  using Rounded = MP::Wachspress_coordinates_2<Kernel>;
  Random random(20261122);
  const Polygon polygon = convex_polygon(random, 7);
  std::vector<Rational_kernel::Point_2> vertices;
  for (const Point_2& p : polygon)
    vertices.emplace_back(p.x(), p.y());
  const Exact exact{MP::Polygonal_domain_2<Rational_kernel>(vertices)};
  const Rounded rounded{Domain(polygon)};
  const MP::Concave_bezier_basis basis(
      std::vector<std::pair<std::size_t, std::size_t>>(7, {std::size_t(5), std::size_t(3)}));
  const auto a = MP::internal::weight_deficiency(basis, exact),
             b = MP::internal::weight_deficiency(basis, rounded);
  CHECK(a.largest > 0.1);
  CHECK(a.largest == Approx(b.largest).epsilon(1e-12));
  CHECK(a.spread == Approx(b.spread).epsilon(1e-12));
  CHECK(MP::automatic_central_weight(lifted_loop(polygon, dome), exact) == Central_weight::none);
}

TEST_CASE("The fair central point bends the patch least, and moves with it") {
  const Model model = over(cross());
  const Patch patch(model);
  const Point_3 fair = patch.control_point(patch.basis().central_index());
  const Point_3 found = MP::fair_central_point(patch);
  CHECK(std::sqrt(CGAL::squared_distance(found, fair)) < 1e-10); // it is where it should be
  const double least = bending(model, patch, fair);
  CHECK(least < bending(model, patch, model.default_central_point()));
  for (const Vector_3& d : {Vector_3(0.01, 0, 0), Vector_3(0, 0.01, 0), Vector_3(0, 0, 0.01)})
    for (const double sign : {-1.0, 1.0})
      CHECK(bending(model, patch, fair + sign * d) > least);

  // Of ribbons in a plane it is in that plane.
  Model flat(lifted_loop(cross(), [](double x, double y) { return 0.2 * x - 0.1 * y + 1; }));
  flat.domain.generator = MP::Domain_generator::projected;
  const Patch plane(flat);
  const Point_3 p = plane.control_point(plane.basis().central_index());
  CHECK(plane.basis().central_weight() == Central_weight::weight_deficiency);
  CHECK(p.z() == Approx(0.2 * p.x() - 0.1 * p.y() + 1).margin(1e-10));

  // Without weight there is no better one than that of the patch.
  Model none = model;
  none.central_weight = Central_weight::none;
  none.central_point = Point_3(1, 2, 3);
  CHECK(MP::fair_central_point(Patch(none)) == Point_3(1, 2, 3));
}

TEST_CASE("The inverse question is answered for a central point that the patch has chosen") {
  const Model model = over(cross());
  const Patch patch(model);
  const Point_2 uv = CGAL::centroid(patch.domain().vertices().begin(),
                                    patch.domain().vertices().end(), CGAL::Dimension_tag<0>());
  Model moved = model;
  moved.central_point = MP::central_point_for(patch, model, uv, Point_3(0, 0, 2));
  const Point_3 there = Patch(moved, patch.coordinates())(uv);
  CHECK(std::sqrt(CGAL::squared_distance(there, Point_3(0, 0, 2))) < 1e-12);
}
