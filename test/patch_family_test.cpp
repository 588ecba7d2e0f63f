// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What holds for every member of the family of control-point patches: they meet their ribbons on
// all example models that they can fill, and the same mesher meshes them.

#include "catch.h"
#include "meshing_fixtures.h"

#include <CGAL/Multisided_patches/analysis/check_mesh.h>
#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/analysis/fairness_report.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/meshing/triangulate_domain.h>
#include <CGAL/Multisided_patches/patches/Bezier_triangle_3.h>
#include <CGAL/Multisided_patches/patches/Generalized_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/S_patch_3.h>
#include <CGAL/Multisided_patches/patches/Tensor_product_patch_3.h>
#include <CGAL/Multisided_patches/ribbons/make_generalized_bezier_net.h>

using namespace fixtures;
using Generalized_patch = MP::Generalized_bezier_patch_3<Kernel>;
using Net = MP::Generalized_bezier_net_3<Kernel>;
using S_patch = MP::S_patch_3<Kernel>;
using S_net = MP::S_patch_net_3<Kernel>;

namespace {

template <typename Any_patch>
void check_that_it_can_be_meshed(const Any_patch& patch, std::size_t sides) {
  Mesh mesh;
  MP::tessellate(patch, mesh, MP::Mesh_density::triangles(400));
  const auto check = MP::check_mesh(mesh);
  CHECK(check.is_disk());
  CHECK(check.degenerate_triangles == 0);
  CHECK(check.folded_edges == 0);
  CHECK(mesh.number_of_faces() == Approx(400).epsilon(0.15));
  CHECK(patch.loop().size() == sides);
}

template <typename Any_patch>
void check_that_it_meets_its_ribbons(const Any_patch& patch) {
  const double size = patch.loop().diagonal();
  for (const auto& side : MP::continuity_report(patch).sides) {
    CAPTURE(side.side);
    CHECK(side.position.max < 1e-12 * size);
    if (side.tangent_plane)
      CHECK(side.tangent_plane->max < 1e-6);
    if (side.normal_curvature)
      CHECK(side.normal_curvature->max < 1e-6);
  }
}

double height(const Point_2& p) {
  return 0.2 * p.x() * p.x() - 0.3 * p.x() * p.y();
}

} // namespace

TEST_CASE("Every model whose corners are convex becomes a generalized Bezier patch that meets it") {
  std::size_t filled = 0;
  for (const std::string& name : model_names()) {
    const Loop loop = read_model(name).loop;
    if (loop.number_of_corners(MP::Corner_type::convex) < loop.size())
      continue;
    CAPTURE(name);
    ++filled;
    const Net net = MP::make_generalized_bezier_net(loop);
    const Generalized_patch patch(net);
    check_that_it_meets_its_ribbons(patch);
    // The boundary is that of the model: the ribbons of the net are elevated ones.
    for (std::size_t i = 0; i < loop.size(); ++i)
      for (const double s : {0.0, 0.3, 0.5, 1.0})
        CHECK(CGAL::squared_distance(patch.point_on_side(i, s), loop[i].boundary_point(s)) <
              1e-24 * loop.diagonal() * loop.diagonal());
    check_that_it_can_be_meshed(patch, loop.size());
  }
  CHECK(filled >= 3);
}

TEST_CASE("Every member of the family can be meshed") {
  const std::size_t depth = 3, sides = 5;
  const S_net places(sides, depth,
                     std::vector<Point_3>(S_net::number_of_control_points(sides, depth)));
  std::vector<Point_3> points(places.control_points());
  const auto domain = MP::make_regular_domain<Kernel>(sides);
  for (std::size_t k = 0; k < points.size(); ++k) {
    // Each point over the mean of the vertices of its index.
    const auto index = places.multi_index(k);
    Kernel::Vector_2 sum(0, 0);
    for (std::size_t i = 0; i < sides; ++i)
      sum = sum + double(index[i]) / double(depth) * (domain.vertex(i) - CGAL::ORIGIN);
    const Point_2 p = CGAL::ORIGIN + sum;
    points[k] = Point_3(p.x(), p.y(), height(p));
  }
  check_that_it_can_be_meshed(S_patch(places.with_control_points(points)), sides);

  std::vector<Point_3> grid;
  for (int b = 0; b <= 2; ++b)
    for (int a = 0; a <= 3; ++a)
      grid.emplace_back(a, b, height(Point_2(a, b)));
  check_that_it_can_be_meshed(MP::Tensor_product_patch_3<Kernel>(3, 2, grid), 4);

  const MP::Bezier_triangle_3<Kernel> triangle(
      2, {{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {2, 0, 0}, {1, 1, 1}, {0, 2, 0}});
  check_that_it_can_be_meshed(triangle, 3);
}

TEST_CASE("The fairness of a sphere and of a plane is what it should be") {
  const double r = 2;
  const auto sphere =
      Formula_patch(Domain({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}), [=](auto u, auto v) {
        return std::array{u, v, sqrt(r * r - u * u - v * v)};
      });
  const auto report = MP::fairness_report(sphere, 4000);
  // ∫∫ r / sqrt(r² - u² - v²) over the square of half-width 1
  const double area =
      4 * r * (2 * std::asin(1 / std::sqrt(r * r - 1)) - r * std::asin(1 / (r * r - 1)));
  CHECK(report.area == Approx(area).epsilon(1e-3));
  CHECK(report.bending_energy == Approx(2 / (r * r) * area).epsilon(1e-3));
  CHECK(report.curvature_99 == Approx(1 / r).epsilon(1e-9));
  CHECK(report.largest_curvature == Approx(1 / r).epsilon(1e-9));
  CHECK(report.undefined == 0);
  CHECK(report.samples == Approx(4000).epsilon(0.1));

  const auto plane = Formula_patch(Domain({{0, 0}, {3, 0}, {0, 1}}), [](auto u, auto v) {
    return std::array{u, v, u - v};
  });
  const auto flat = MP::fairness_report(plane, 500);
  CHECK(flat.area == Approx(1.5 * std::sqrt(3.0)).epsilon(1e-12));
  CHECK(flat.bending_energy == 0);
  CHECK(flat.curvature_99 == 0);
}

TEST_CASE("99 percent of the area bend no more than the curvature that is said") {
  // z = u³ / 6 over a square of half-width 1, nearly flat: the curvature is |u|, up to a factor of
  // (1 + u⁴ a² / 4)^{3/2} that a small amplitude makes 1.
  const double amplitude = 1e-3;
  const auto cubic =
      Formula_patch(Domain({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}), [=](auto u, auto v) {
        return std::array{u, v, u * u * u * (amplitude / 6)};
      });
  const auto report = MP::fairness_report(cubic, 20000);
  CHECK(report.curvature_99 == Approx(0.99 * amplitude).epsilon(0.005));
  CHECK(report.largest_curvature == Approx(amplitude).epsilon(0.02));
  CHECK(std::abs(report.sharpest_point.x()) > 0.98);
  // ∫ u² du dv = 4/3
  CHECK(report.bending_energy == Approx(4.0 / 3 * amplitude * amplitude).epsilon(0.01));
}

TEST_CASE("Where a surface has no curvatures it has an area all the same") {
  // Half of the square is mapped to a sheet that is flat; the other half to its edge, a line.
  const auto sheet = Formula_patch(Domain({{-1, 0}, {1, 0}, {1, 1}, {-1, 1}}), [](auto u, auto v) {
    const auto x = u.value() < 0 ? u * 0.0 : u;
    return std::array{x, v, v * 0.0};
  });
  const MP::Domain_mesh_2<Kernel> mesh =
      MP::triangulate_domain(sheet.domain(), {20, 10, 20, 10}, 0.1);
  const auto report = MP::fairness_report(sheet, mesh);
  CHECK(report.area == Approx(1).epsilon(0.1)); // triangles across the fold belong to one half
  CHECK(report.undefined > report.samples / 3);
  CHECK(report.bending_energy == 0);
}

TEST_CASE("A narrow bump is meshed as finely as it takes") {
  const unsigned seed = 5;
  CAPTURE(seed);
  Random random(seed);
  for (int k = 0; k < 12; ++k) {
    const double width = std::pow(10, random.in(-3.3, -1.7)),
                 height = width * std::pow(10, random.in(-1, 1)),
                 bound = height * std::pow(10, random.in(-2.5, -1)), x0 = random.in(0.25, 0.75),
                 y0 = random.in(0.25, 0.75);
    CAPTURE(width, height, bound);
    const auto bump = Formula_patch(Domain({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), [=](auto u, auto v) {
      const auto x = u - x0, y = v - y0;
      const auto exponent = (x * x + y * y) * (-1 / (2 * width * width));
      const double f = height * std::exp(exponent.value());
      return std::array{u, v, exponent.composed(f, f, f)};
    });
    CHECK_NOTHROW(MP::mesh_domain(bump, MP::Mesh_density::chordal_deviation(bound)));
  }
}
