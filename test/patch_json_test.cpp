// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "patch_json_fixtures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

using namespace patch_json_fixtures;

namespace {

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
