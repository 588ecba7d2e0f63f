// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_PATCH_JSON_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_PATCH_JSON_FIXTURES_H

#include "catch.h"
#include "fixtures.h"
#include "io_fixtures.h"

#include <CGAL/Multisided_patches/IO/patch_json.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

// Patches in the `.patch.json` format.
namespace patch_json_fixtures {

using namespace fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace IO = MP::IO;
using Json = nlohmann::json;
using Model = IO::Any_patch_model<Kernel>;
using Concave = IO::Concave_bezier_description_3<Kernel>;
using Generalized = IO::Generalized_bezier_description_3<Kernel>;
using S_patch = IO::S_patch_description_3<Kernel>;
using Tensor_product = MP::Tensor_product_patch_3<Kernel>;
using Triangle = MP::Bezier_triangle_3<Kernel>;

inline Model read(const std::string& text) {
  std::istringstream in(text);
  return IO::read_patch_json<Kernel>(in, "x.patch.json");
}

inline std::string written(const Model& model) {
  std::ostringstream out;
  IO::write_patch_json<Kernel>(out, model);
  return out.str();
}

inline std::string error_of(const std::string& text) {
  return input_error_of([&] { read(text); });
}

// Numbers that are hard to read and write.
inline double any_number(Random& random) {
  const double special[] = {-0.0, 5e-324, -1 / 3.0, 1e22, 9007199254740993.0, 123456, 1e-300};
  const std::size_t k = random.integer(0, 9);
  return k < 7 ? special[k] : random.in(-1e9, 1e9);
}

inline std::vector<Point_3> any_points(Random& random, std::size_t number) {
  std::vector<Point_3> points;
  for (std::size_t k = 0; k < number; ++k) {
    const double x = any_number(random), y = any_number(random), z = random.in(-1, 1);
    points.emplace_back(x, y, z);
  }
  return points;
}

inline Concave full_concave(Random& random) {
  const std::size_t n = random.integer(3, 7);
  Concave model(MP::Concave_bezier_model_3<Kernel>(random_loop(random, n, 0.02)));
  model.coordinates = IO::Coordinates_choice::mean_value;
  model.central_weight = MP::Central_weight::full_product;
  model.central_point = any_points(random, 1)[0];
  model.domain = {MP::Domain_generator::circular, 1 / 7.0};
  model.parameter_dilation = -1e-17;
  model.reflex_weight = 1 / 3.0;
  model.corner_control_points.push_back({n - 1, any_points(random, 1)[0]});
  return model;
}

inline Generalized full_generalized(Random& random) {
  const std::size_t n = random.integer(3, 6), d = random.integer(1, 6);
  using Net = Generalized::Net;
  Generalized model(Net(n, d, any_points(random, Net::number_of_control_points(n, d))));
  model.coordinates = IO::Coordinates_choice::harmonic;
  model.domain_vertices = star_shaped_polygon(random, n, 0.3);
  return model;
}

inline S_patch full_s_patch(Random& random) {
  const std::size_t n = random.integer(3, 6), d = random.integer(1, 4);
  using Net = S_patch::Net;
  return S_patch(Net(n, d, any_points(random, Net::number_of_control_points(n, d))));
}

inline Tensor_product full_tensor_product(Random& random) {
  return Tensor_product(3, 2, any_points(random, 12));
}

inline Triangle full_triangle(Random& random) {
  return Triangle(3, any_points(random, 10), Domain(star_shaped_polygon(random, 3, 0.5)));
}

inline std::vector<Model> one_of_each(Random& random) {
  return {full_concave(random), full_generalized(random), full_s_patch(random),
          full_tensor_product(random), full_triangle(random)};
}

// A flat triangle with sides of degree 1 and one layer; the second one has degree 2.
inline const std::string small_concave = R"({
  "format": "multisided-patch", "version": 1, "type": "concave-bezier",
  "sides": [
    {"degree": 1, "layers": 1, "control_points": [[0, 0, 0], [4, 0, 0]]},
    {"degree": 2, "layers": 1, "control_points": [[4, 0, 0], [3, 3, 0.5], [0, 4, 0]]},
    {"degree": 1, "layers": 1, "control_points": [[0, 4, 0], [0, 0, 0]]}
  ]
})";

inline Json schema() {
  std::ifstream in(std::string(MODELS_DIR) + "/../../doc/patch.schema.json");
  REQUIRE(in);
  return Json::parse(in);
}

} // namespace patch_json_fixtures

#endif // MULTISIDED_PATCHES_TEST_PATCH_JSON_FIXTURES_H
