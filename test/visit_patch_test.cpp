// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "patch_json_fixtures.h"

#include <CGAL/Multisided_patches/IO/visit_patch.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

using namespace patch_json_fixtures;

namespace {

using Coordinates = IO::Any_coordinates_2<Kernel>;

std::vector<double> coordinates_at(const Coordinates& coordinates, const Point_2& p) {
  std::vector<double> lambda;
  coordinates(p, std::back_inserter(lambda));
  return lambda;
}

// Which class the function was called with.
struct Class_of {
  std::string operator()(const MP::Concave_bezier_patch_3<Kernel, Coordinates>&) const {
    return "concave-bezier";
  }
  std::string operator()(const MP::Generalized_bezier_patch_3<Kernel, Coordinates>&) const {
    return "generalized-bezier";
  }
  std::string operator()(const MP::S_patch_3<Kernel, Coordinates>&) const { return "s-patch"; }
  std::string operator()(const Tensor_product&) const { return "tensor-product"; }
  std::string operator()(const Triangle&) const { return "bezier-triangle"; }
};

Generalized pentagon_net() {
  const std::vector<Point_2> plan{{0, 0}, {4, -1}, {6, 2}, {3, 5}, {-1, 3}};
  std::vector<Point_3> points;
  for (const Point_2& p : plan)
    points.emplace_back(p.x(), p.y(), p.x() * p.y());
  points.emplace_back(2, 2, 1);
  return Generalized(Generalized::Net(5, 1, points));
}

} // namespace

TEST_CASE("The coordinates that a file asks for are those of the class that it names") {
  const Domain square({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  const Point_2 p(0.6, 0.3);
  const auto expected = [&](const auto& coordinates) {
    std::vector<double> lambda;
    coordinates(p, std::back_inserter(lambda));
    return lambda;
  };
  using Choice = IO::Coordinates_choice;
  CHECK(coordinates_at(Coordinates(square), p) ==
        expected(MP::Harmonic_coordinates_2<Kernel>(square, 1e-8, 1e-3)));
  CHECK(coordinates_at(Coordinates(square, Choice::mean_value), p) ==
        expected(MP::Mean_value_coordinates_2<Kernel>(square)));
  CHECK(coordinates_at(Coordinates(square, Choice::wachspress), p) ==
        expected(MP::Wachspress_coordinates_2<Kernel>(square)));
  for (const Choice choice : {Choice::harmonic, Choice::mean_value, Choice::wachspress}) {
    CHECK(Coordinates(square, choice).choice() == choice);
    CHECK(Coordinates(square, choice).domain().vertices() == square.vertices());
  }
  CHECK_THROWS_AS(Coordinates(Domain(l_shape()), Choice::wachspress), MP::Input_error);
}

TEST_CASE("A description of each type becomes a patch of its class") {
  for (const std::string type :
       {"concave-bezier", "generalized-bezier", "s-patch", "tensor-product", "bezier-triangle"}) {
    Random random(1);
    const std::vector<Model> models{
        Concave(MP::Concave_bezier_model_3<Kernel>(random_loop(random, 5, 0.02))), pentagon_net(),
        S_patch(S_patch::Net(3, 1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 1}})), full_tensor_product(random),
        full_triangle(random)};
    for (const Model& model : models)
      if (to_string(IO::patch_type<Kernel>(model)) == type)
        CHECK(IO::visit_patch(model, Class_of()) == type);
  }
}

TEST_CASE("A patch has the domain, the coordinates and the options of its description") {
  Generalized description = pentagon_net();
  CHECK(IO::make_domain(Model(description)).report.used == MP::Domain_generator::regular);
  description.domain_vertices = {{0, 0}, {4, -1}, {6, 2}, {3, 5}, {-1, 3}};
  description.coordinates = IO::Coordinates_choice::mean_value;
  CHECK(IO::make_domain(Model(description)).domain.vertices() == description.domain_vertices);
  const Point_2 p(2, 2);
  const MP::Generalized_bezier_patch_3<Kernel, MP::Mean_value_coordinates_2<Kernel>> expected(
      description.net, MP::Mean_value_coordinates_2<Kernel>(Domain(description.domain_vertices)));
  CHECK(IO::visit_patch(Model(description), [&](const auto& patch) { return patch(p); }) ==
        expected(p));
  description.domain_vertices.clear();
  description.domain.generator = MP::Domain_generator::projected;
  CHECK(IO::make_domain(Model(description)).domain.vertices() ==
        MP::make_domain(description.net.loop(), description.domain).domain.vertices());

  // A concave patch has its options, too.
  Concave concave(MP::Concave_bezier_model_3<Kernel>(
      lifted_loop(l_shape(), [](double x, double y) { return x * y; })));
  concave.domain_vertices = l_shape();
  concave.central_weight = MP::Central_weight::full_product;
  concave.central_point = Point_3(1, 2, 3);
  concave.coordinates = IO::Coordinates_choice::mean_value;
  const MP::Concave_bezier_patch_3<Kernel, MP::Mean_value_coordinates_2<Kernel>> patch(
      concave, MP::Mean_value_coordinates_2<Kernel>(Domain(l_shape())));
  const Point_2 q(0.5, 0.7);
  CHECK(IO::visit_patch(Model(concave), [&](const auto& made) { return made(q); }) == patch(q));
  CHECK(IO::visit_patch(Model(concave), [&](const auto& made) {
          return made.template evaluate<2>(q)[2][3];
        }) == patch.evaluate<2>(q)[2][3]);
}

TEST_CASE("What has no patch is an error when the patch is made, not before") {
  Generalized description = pentagon_net();
  description.domain_vertices = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  bool called = false;
  CHECK_THROWS_AS(IO::visit_patch(Model(description), [&](const auto&) { called = true; }),
                  MP::Input_error); // these are Wachspress coordinates
  description.domain_vertices.pop_back();
  CHECK_THROWS_AS(IO::visit_patch(Model(description), [&](const auto&) { called = true; }),
                  MP::Input_error);
  CHECK(!called);
}
