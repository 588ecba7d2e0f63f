// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/Generalized_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/central_control_point.h>

#include <cmath>
#include <cstddef>
#include <vector>

using namespace fixtures;

TEST_CASE("A central control point is found with which a patch goes through a point") {
  using MP::Central_weight;
  const auto weight = GENERATE(Central_weight::weight_deficiency, Central_weight::adjacent_products,
                               Central_weight::full_product);
  const auto check = [&](auto coordinates, const std::vector<Point_2>& polygon, const Point_2& uv) {
    using Patch = MP::Concave_bezier_patch_3<Kernel, decltype(coordinates)>;
    MP::Concave_bezier_model_3<Kernel> model(
        lifted_loop(polygon, [](double x, double y) { return 0.3 * x * x - 0.2 * x * y; }));
    model.central_weight = weight;
    const Patch patch(model, coordinates);
    const Point_3 target = patch(uv) + Vector_3(0.1, -0.2, 0.5);
    REQUIRE(std::abs(MP::central_weight_at(patch, uv)) > 1e-4);
    model.central_point = MP::central_point_for(patch, model, uv, target);
    const Patch moved(model, coordinates);
    CHECK(std::sqrt(CGAL::squared_distance(moved(uv), target)) < 1e-12);
    // Once more, from the central control point that the model has now.
    model.central_point = MP::central_point_for(moved, model, uv, target + Vector_3(0, 0, 1));
    CHECK(std::sqrt(CGAL::squared_distance(Patch(model, coordinates)(uv),
                                           target + Vector_3(0, 0, 1))) < 1e-12);
  };
  Random random(15);
  const std::vector<Point_2> pentagon = convex_polygon(random, 5);
  check(MP::Wachspress_coordinates_2<Kernel>(Domain(pentagon)), pentagon, Point_2(0.1, 0.05));
  check(MP::Mean_value_coordinates_2<Kernel>(Domain(l_shape())), l_shape(), Point_2(0.6, 0.5));
}

TEST_CASE("The central point of a net is found with which its patch goes through a point") {
  Random random(18);
  std::vector<Point_3> points;
  for (std::size_t i = 0; i < 46; ++i)
    points.emplace_back(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
  const MP::Generalized_bezier_net_3<Kernel> net(5, 5, points);
  const Point_3 target(0.3, 0.2, 0.1);
  const MP::Generalized_bezier_patch_3<Kernel> patch(net);
  const CGAL::Bbox_2 box = patch.domain().bbox();
  const Point_2 uv(0.4 * box.xmin() + 0.6 * box.xmax(), (box.ymin() + box.ymax()) / 2);
  points.back() = MP::central_point_for(patch, net, uv, target);
  const MP::Generalized_bezier_patch_3<Kernel> moved(net.with_control_points(points));
  CHECK(std::sqrt(CGAL::squared_distance(moved(uv), target)) < 1e-12);
}

TEST_CASE("No central control point moves a patch where it has no weight") {
  Random random(16);
  const std::vector<Point_2> pentagon = convex_polygon(random, 5);
  MP::Concave_bezier_model_3<Kernel> model(lifted_loop(pentagon, [](double, double) { return 0; }));
  const MP::Wachspress_coordinates_2<Kernel> coordinates{Domain(pentagon)};
  using Patch = MP::Concave_bezier_patch_3<Kernel, MP::Wachspress_coordinates_2<Kernel>>;
  const Point_3 point(0, 0, 1);
  CHECK_THROWS_AS(MP::central_point_for(Patch(model, coordinates), model, Point_2(0.1, 0), point),
                  MP::Input_error);
  model.central_weight = MP::Central_weight::full_product;
  const Patch patch(model, coordinates);
  CHECK_NOTHROW(MP::central_point_for(patch, model, Point_2(0.1, 0), point));
  CHECK_THROWS_AS(MP::central_point_for(patch, model, pentagon[0], point), MP::Input_error);
  CHECK_THROWS_AS(MP::central_point_for(patch, model, Point_2(9, 0), point),
                  MP::Outside_domain_error);
}
