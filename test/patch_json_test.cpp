// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"
#include "io_fixtures.h"

#include <CGAL/Multisided_patches/IO/patch_json.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

namespace IO = MP::IO;
using Json = nlohmann::json;
using Model = IO::Any_patch_model<Kernel>;
using Concave = IO::Concave_bezier_description_3<Kernel>;
using Generalized = IO::Generalized_bezier_description_3<Kernel>;
using S_patch = IO::S_patch_description_3<Kernel>;
using Tensor_product = MP::Tensor_product_patch_3<Kernel>;
using Triangle = MP::Bezier_triangle_3<Kernel>;

Model read(const std::string& text) {
  std::istringstream in(text);
  return IO::read_patch_json<Kernel>(in, "x.patch.json");
}

std::string written(const Model& model) {
  std::ostringstream out;
  IO::write_patch_json<Kernel>(out, model);
  return out.str();
}

std::string error_of(const std::string& text) {
  return input_error_of([&] { read(text); });
}

// Numbers that are hard to read and write.
double any_number(Random& random) {
  const double special[] = {-0.0, 5e-324, -1 / 3.0, 1e22, 9007199254740993.0, 123456, 1e-300};
  const std::size_t k = random.integer(0, 9);
  return k < 7 ? special[k] : random.in(-1e9, 1e9);
}

std::vector<Point_3> any_points(Random& random, std::size_t number) {
  std::vector<Point_3> points;
  for (std::size_t k = 0; k < number; ++k) {
    const double x = any_number(random), y = any_number(random), z = random.in(-1, 1);
    points.emplace_back(x, y, z);
  }
  return points;
}

Concave full_concave(Random& random) {
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

Generalized full_generalized(Random& random) {
  const std::size_t n = random.integer(3, 6), d = random.integer(1, 6);
  using Net = Generalized::Net;
  Generalized model(Net(n, d, any_points(random, Net::number_of_control_points(n, d))));
  model.coordinates = IO::Coordinates_choice::harmonic;
  model.domain_vertices = star_shaped_polygon(random, n, 0.3);
  return model;
}

S_patch full_s_patch(Random& random) {
  const std::size_t n = random.integer(3, 6), d = random.integer(1, 4);
  using Net = S_patch::Net;
  return S_patch(Net(n, d, any_points(random, Net::number_of_control_points(n, d))));
}

Tensor_product full_tensor_product(Random& random) {
  return Tensor_product(3, 2, any_points(random, 12));
}

Triangle full_triangle(Random& random) {
  return Triangle(3, any_points(random, 10), Domain(star_shaped_polygon(random, 3, 0.5)));
}

std::vector<Model> one_of_each(Random& random) {
  return {full_concave(random), full_generalized(random), full_s_patch(random),
          full_tensor_product(random), full_triangle(random)};
}

// A flat triangle with sides of degree 1 and one layer; the second one has degree 2.
const std::string small_concave = R"({
  "format": "multisided-patch", "version": 1, "type": "concave-bezier",
  "sides": [
    {"degree": 1, "layers": 1, "control_points": [[0, 0, 0], [4, 0, 0]]},
    {"degree": 2, "layers": 1, "control_points": [[4, 0, 0], [3, 3, 0.5], [0, 4, 0]]},
    {"degree": 1, "layers": 1, "control_points": [[0, 4, 0], [0, 0, 0]]}
  ]
})";

Json changed(const Json::json_pointer& where, const Json& value) {
  Json json = Json::parse(small_concave);
  json[where] = value;
  return json;
}

// The keys that the schema lists for objects by this name.
std::set<std::string> schema_keys(const Json& schema, const std::string& name) {
  std::set<std::string> keys;
  for (const auto& item : schema.at("$defs").at(name).at("properties").items())
    keys.insert(item.key());
  return keys;
}

std::set<std::string> keys_of(const Json& object) {
  std::set<std::string> keys;
  for (const auto& item : object.items())
    keys.insert(item.key());
  return keys;
}

Json schema() {
  std::ifstream in(std::string(MODELS_DIR) + "/../../doc/patch.schema.json");
  REQUIRE(in);
  return Json::parse(in);
}

} // namespace

TEST_CASE("The entries of a .patch.json file arrive where they belong") {
  const Concave plain = std::get<Concave>(read(small_concave));
  REQUIRE(plain.loop.size() == 3);
  CHECK(plain.loop[1].control_point(1, 0) == Point_3(3, 3, 0.5));
  // What is not said has the default of the class.
  const MP::Concave_bezier_model_3<Kernel> defaults(plain.loop);
  CHECK(plain.coordinates == IO::Coordinates_choice::harmonic);
  CHECK(plain.central_weight == defaults.central_weight);
  CHECK(!plain.central_point);
  CHECK(plain.domain.generator == defaults.domain.generator);
  CHECK(plain.domain.clearance == defaults.domain.clearance);
  CHECK(plain.parameter_dilation == defaults.parameter_dilation);
  CHECK(plain.reflex_weight == defaults.reflex_weight);

  Json json = Json::parse(small_concave);
  json["coordinates"] = "wachspress";
  json["domain"] = {{"vertices", {{0, 0}, {1, 0}, {0, 0.5}}}};
  json["central_weight"] = "adjacent-products";
  json["central_point"] = {1, 2, 3};
  json["parameter_dilation"] = 0.25;
  json["reflex_weight"] = 2;
  json["corner_control_points"] = {{{"side", 2}, {"point", {7, 8, 9}}}};
  const Concave model = std::get<Concave>(read(json.dump()));
  CHECK(model.coordinates == IO::Coordinates_choice::wachspress);
  CHECK(model.domain_vertices == std::vector<Point_2>{{0, 0}, {1, 0}, {0, 0.5}});
  CHECK(model.central_weight == MP::Central_weight::adjacent_products);
  CHECK(model.central_point == Point_3(1, 2, 3));
  CHECK(model.parameter_dilation == 0.25);
  CHECK(model.reflex_weight == 2);
  REQUIRE(model.corner_control_points.size() == 1);
  CHECK(model.corner_control_points[0].index == 2);
  CHECK(model.corner_control_points[0].point == Point_3(7, 8, 9));
}

TEST_CASE("Every option of a .patch.json file is read back as it was written") {
  for (const auto weight : IO::internal::all_central_weights)
    for (const auto generator : IO::internal::all_generators)
      for (const auto coordinates : IO::internal::all_coordinates) {
        Concave model = std::get<Concave>(read(small_concave));
        model.central_weight = weight;
        model.domain.generator = generator;
        model.coordinates = coordinates;
        const Concave again = std::get<Concave>(read(written(model)));
        CHECK(again.central_weight == weight);
        CHECK(again.domain.generator == generator);
        CHECK(again.coordinates == coordinates);
      }
}

TEST_CASE("Patches of every type are read back from JSON bit for bit") {
  const unsigned seed = GENERATE(range(1u, 21u));
  CAPTURE(seed);
  Random random(seed);
  const Global_locale locale(decimal_comma);
  for (const Model& model : one_of_each(random)) {
    const std::string text = written(model);
    CAPTURE(text);
    const Model again = read(text);
    CHECK(again.index() == model.index());
    // The text tells doubles apart, the two zeros among them.
    CHECK(written(again) == text);
    CHECK(Json::parse(text).at("type") == to_string(IO::patch_type<Kernel>(model)));
  }
  const Generalized model = full_generalized(random);
  const Generalized again = std::get<Generalized>(read(written(model)));
  CHECK(again.domain_vertices == model.domain_vertices);
  CHECK(again.net.control_points() == model.net.control_points());
  for (std::size_t k = 0; k < model.net.control_points().size(); ++k)
    for (int c = 0; c < 3; ++c)
      CHECK(std::signbit(again.net.control_points()[k][c]) ==
            std::signbit(model.net.control_points()[k][c]));
}

TEST_CASE("What is written has exactly the keys of the schema") {
  const Json all = schema();
  Random random(3);
  for (const Model& model : one_of_each(random)) {
    const Json json = Json::parse(written(model));
    const std::string type = json.at("type");
    INFO(type);
    CHECK(keys_of(json) == schema_keys(all, type));
    const Json& required = all["$defs"][type]["required"];
    for (const auto& key : required)
      CHECK(json.contains(key.get<std::string>()));
    if (json.contains("domain"))
      CHECK(keys_of(json["domain"]) ==
            schema_keys(all, json["domain"].contains("vertices") ? "polygon" : "generated"));
    if (type != "concave-bezier")
      continue;
    for (const Json& side : json["sides"])
      CHECK(keys_of(side) == schema_keys(all, "side"));
    for (const Json& corner : json["corner_control_points"])
      CHECK(keys_of(corner) == schema_keys(all, "corner"));
  }
}

TEST_CASE("The schema has the names and the limits of the reader") {
  const Json defs = schema()["$defs"];
  const auto check_names = [](const Json& names, const auto& values) {
    CHECK(names.size() == values.size());
    for (const auto value : values)
      CHECK(std::count(names.begin(), names.end(), Json(to_string(value))) == 1);
  };
  check_names(defs["coordinates"]["enum"], IO::internal::all_coordinates);
  check_names(defs["generated"]["properties"]["generator"]["enum"], IO::internal::all_generators);
  check_names(defs["concave-bezier"]["properties"]["central_weight"]["enum"],
              IO::internal::all_central_weights);
  for (const auto type : IO::internal::all_patch_types)
    CHECK(defs[to_string(type)]["properties"]["type"]["const"] == to_string(type));
  CHECK(defs["number_of_sides"]["maximum"] == IO::Patch_json_limits::max_sides);
  CHECK(defs["degree"]["maximum"] == IO::Patch_json_limits::max_degree);
  CHECK(defs["points"]["maxItems"] == IO::Patch_json_limits::max_control_points);
  CHECK(defs["side"]["properties"]["layers"]["maximum"] == IO::Patch_json_limits::max_layers);
}

TEST_CASE("Without a key that the schema requires a .patch.json file is refused, by its name") {
  const Json all = schema();
  Random random(5);
  for (const Model& model : one_of_each(random)) {
    const Json json = Json::parse(written(model));
    const Json& required = all["$defs"][json["type"].get<std::string>()]["required"];
    for (const auto& item : json.items()) {
      Json less = json;
      less.erase(item.key());
      CAPTURE(item.key());
      if (std::count(required.begin(), required.end(), Json(item.key())) > 0)
        CHECK_THAT(error_of(less.dump()), Contains("the key '" + item.key() + "'"));
      else
        CHECK(error_of(less.dump()) == "no error");
    }
  }
}

TEST_CASE("Errors in a .patch.json file name the place in the data and what was expected there") {
  struct Row {
    const char* where;
    Json value;
    std::string message;
  };
  const Row rows[] = {
      {"/format", "other", "/format: expected \"multisided-patch\""},
      {"/version", 2, "/version: expected an integer from 1 to 1, found 2"},
      {"/version", "1", "/version: expected an integer from 1 to 1, found \"1\""},
      {"/type", "sphere", "/type: expected one of concave-bezier, generalized-bezier, "},
      {"/centre", 1, "the key 'centre' is not known"},
      {"/cl\033[31m\xc3\xa9", 1,
       "the key 'cl?[31m?"
       "?' is not known"},
      {"/coordinates", "polar",
       "/coordinates: expected one of harmonic, mean-value, wachspress, "
       "found \"polar\""},
      {"/coordinates", nullptr, "/coordinates: expected one of harmonic"},
      {"/domain", 7, "/domain: expected an object, found 7"},
      {"/domain", Json::object(), "/domain: expected an object with the key 'generator'"},
      {"/domain",
       {{"generator", "regular"}, {"clearence", 1}},
       "/domain: the key 'clearence' is not known"},
      {"/domain",
       {{"generator", "regular"}, {"vertices", 1}},
       "/domain: the key 'generator' is not known"},
      {"/domain", {{"generator", "regular"}, {"clearance", -1}}, "/domain/clearance: expected a "},
      {"/domain",
       {{"vertices", {{0, 0}, {1, 0}}}},
       "/domain/vertices: expected 3 vertices, one for each side, found 2"},
      {"/domain", {{"vertices", {{0, 0}, {0, 1}, {1, 0}}}}, "/domain/vertices: "},
      {"/domain", {{"vertices", {{0, 0}, {1, 0}, {0}}}}, "/domain/vertices/2: expected 2 numbers"},
      {"/central_weight", 0, "/central_weight: expected one of weight-deficiency, "},
      {"/central_point", {1, 2}, "/central_point: expected 3 numbers"},
      {"/central_point", {1, 2, nullptr}, "/central_point: expected 3 numbers"},
      {"/parameter_dilation", true, "/parameter_dilation: expected a number, found true"},
      {"/reflex_weight", 0, "/reflex_weight: expected a positive number"},
      {"/sides", Json::object(), "/sides: expected an array of sides, found an object"},
      {"/sides", Json::array(), "/sides: expected 3 to 1000 sides, found 0"},
      {"/sides/1", nullptr, "/sides/1: expected an object, found null"},
      {"/sides/1/degree", 0, "/sides/1/degree: expected an integer from 1 to 100, found 0"},
      {"/sides/1/degree", -1, "/sides/1/degree: expected an integer from 1 to 100, found -1"},
      {"/sides/1/degree", 2.0, "/sides/1/degree: expected an integer from 1 to 100, found 2.0"},
      {"/sides/1/degree", 4e9, "/sides/1/degree: expected an integer from 1 to 100"},
      {"/sides/1/layers", 51, "/sides/1/layers: expected an integer from 1 to 50, found 51"},
      {"/sides/1/points", 1, "/sides/1: the key 'points' is not known"},
      {"/sides/1/degree", 3, "/sides/1/control_points: expected 4 points, found 3"},
      {"/sides/1/control_points/2", {1, 2, 3, 4}, "/sides/1/control_points/2: expected 3 numbers"},
      {"/sides/1/control_points/2", "here", "/sides/1/control_points/2: expected 3 numbers"},
      {"/sides/1/control_points/2", {9, 9, 9}, "/sides: the loop does not close: side 1 ends at"},
      {"/corner_control_points",
       {{{"side", 3}, {"point", {0, 0, 0}}}},
       "/corner_control_points/0/side: expected an integer from 0 to 2, found 3"},
  };
  for (const Row& row : rows) {
    INFO(row.where);
    const Json json = changed(Json::json_pointer(row.where), row.value);
    try {
      read(json.dump());
      CHECK(std::string("no error") == row.message);
    } catch (const MP::Input_error& error) {
      CHECK_THAT(error.what(), StartsWith("x.patch.json: " + row.message));
    }
  }
}

TEST_CASE("A .patch.json file that is cut off anywhere is refused") {
  Random random(11);
  for (const Model& model : one_of_each(random)) {
    const std::string text = written(model);
    for (std::size_t k = 0; k + 2 < text.size(); k += 1 + text.size() / 97)
      CHECK_THAT(error_of(text.substr(0, k)), StartsWith("x.patch.json:") && Contains("JSON"));
    CHECK_THAT(error_of(text + "7"), Contains("expected JSON, found "));
  }
}

TEST_CASE("Hostile .patch.json files are refused with a short message") {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = small_concave;
    return text.replace(text.find(from), from.size(), to);
  };
  CHECK_THAT(error_of(""), StartsWith("x.patch.json:1: expected JSON"));
  CHECK_THAT(error_of("[]"), Contains("expected an object with the key 'format'"));
  for (const std::string number : {"nan", "NaN", "inf", "Infinity", "0x10", "1.", ".5", "+1"})
    CHECK_THAT(error_of(with("3, 3, 0.5", "3, " + number + ", 0.5")),
               StartsWith("x.patch.json:5: expected JSON, found"));
  for (const std::string& number :
       {std::string("1e999"), std::string("-1e400"), "1" + std::string(1000, '0')})
    CHECK_THAT(error_of(with("3, 3, 0.5", "3, " + number + ", 0.5")),
               StartsWith("x.patch.json:5: expected JSON, found"));
  CHECK_THAT(error_of(with("\"degree\": 2", "\"degree\": 2, \"degree\": 2")),
             StartsWith("x.patch.json: /sides/1: the key 'degree' is there twice"));
  CHECK_THAT(error_of(std::string(100000, '[')), Contains("expected at most 8 levels"));
  std::string objects;
  for (int k = 0; k < 100000; ++k)
    objects += "{\"a\":";
  CHECK_THAT(error_of(objects), Contains("expected at most 8 levels"));
  CHECK_THAT(error_of("\"" + std::string(100000, 'x')), Contains("expected JSON"));
  CHECK_THAT(error_of("{\"" + std::string(100000, 'x') + "\": 1}"), Contains("'format'"));
  CHECK_THAT(error_of("\xff\xfe\x00"), Contains("expected JSON"));
  CHECK_THAT(error_of("{\"a\": \"\xc3\x28\"}"), Contains("expected JSON"));
  // Much is claimed and little is there.
  const std::string head = R"({"format": "multisided-patch", "version": 1, "type": )";
  CHECK_THAT(error_of(head + R"("s-patch", "number_of_sides": 1000, "depth": 100,)" +
                      R"("control_points": []})"),
             StartsWith("x.patch.json: /depth: "));
  CHECK_THAT(error_of(head + R"("generalized-bezier", "number_of_sides": 1000, "degree": 100,)" +
                      R"("control_points": []})"),
             StartsWith("x.patch.json: /control_points: expected at most 500000 points"));
}

TEST_CASE("Changed bytes of a .patch.json file do no harm") {
  const unsigned seed = GENERATE(range(1u, 6u));
  CAPTURE(seed);
  Random random(seed);
  for (const Model& model : one_of_each(random)) {
    const std::string text = written(model);
    for (int k = 0; k < 60; ++k) {
      std::string other = text;
      for (std::size_t changes = random.integer(1, 3); changes > 0; --changes)
        other[random.integer(0, other.size() - 1)] =
            "0123456789-.eE,:[]{}\"x \n\xff"[random.integer(0, 25)];
      CAPTURE(other);
      try {
        // What is accepted can be written and is the same then.
        const Model accepted = read(other);
        CHECK(written(read(written(accepted))) == written(accepted));
      } catch (const MP::Input_error& error) {
        CHECK_THAT(error.what(), StartsWith("x.patch.json:"));
      }
    }
  }
}

TEST_CASE("What a .patch.json file cannot hold is not written") {
  const Scratch_directory scratch;
  const std::string name = scratch / "a.patch.json";
  const Concave good = std::get<Concave>(read(small_concave));
  IO::write_patch_json<Kernel>(name, good);
  const std::string text = contents(name);
  CHECK(text == written(good));
  CHECK(written(IO::read_patch_json<Kernel>(name)) == text);
  std::vector<Concave> bad(4, good);
  bad[0].domain.clearance = -1;
  bad[1].parameter_dilation = std::nan("");
  bad[2].reflex_weight = 0;
  bad[3].corner_control_points.push_back({3, Point_3(0, 0, 0)});
  for (const Concave& model : bad) {
    CHECK_THAT(input_error_of([&] { IO::write_patch_json<Kernel>(name, model); }),
               Contains("does not fit the .patch.json format"));
    CHECK(contents(name) == text);
  }
  CHECK(scratch.files() == std::vector<std::string>{"a.patch.json"});
}
