// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "patch_json_fixtures.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

using namespace patch_json_fixtures;

namespace {

Json changed(const Json::json_pointer& where, const Json& value) {
  Json json = Json::parse(small_concave);
  json[where] = value;
  return json;
}

} // namespace

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
       "/domain: the key 'clearence' is not known; is 'clearance' meant?"},
      {"/domain",
       {{"generator", "regular"}, {"vertices", 1}},
       "/domain: the key 'generator' is not known"},
      {"/domain", {{"generator", "regular"}, {"clearance", -1}}, "/domain/clearance: expected a "},
      {"/domain",
       {{"vertices", {{0, 0}, {1, 0}}}},
       "/domain/vertices: expected 3 vertices, one for each side, found 2"},
      {"/domain", {{"vertices", {{0, 0}, {0, 1}, {1, 0}}}}, "/domain/vertices: "},
      {"/domain",
       {{"vertices", {{0, 0}, {1, 0}, {0}}}},
       "/domain/vertices/2: expected 2 numbers, found an array of 1"},
      {"/central_weight", 0, "/central_weight: expected one of weight-deficiency, "},
      {"/central_point", {1, 2}, "/central_point: expected 3 numbers, found an array of 2"},
      {"/central_point",
       {1, 2, nullptr},
       "/central_point: expected 3 numbers, found null among them"},
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
      {"/sides/1/points", 1, "/sides/1: the key 'points' is not known; is 'control_points' meant?"},
      {"/sides/1/degree", 3, "/sides/1/control_points: expected 4 points, found 3"},
      {"/sides/1/control_points/2", {1, 2, 3, 4}, "/sides/1/control_points/2: expected 3 numbers"},
      {"/sides/1/control_points/2", "here",
       "/sides/1/control_points/2: expected 3 numbers, found \"here\""},
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

TEST_CASE("For a key that is misspelt the known one is told that is closest to it") {
  using MP::internal::edit_distance;
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("abc", "") == 3);
  CHECK(edit_distance("degree", "degree") == 0);
  CHECK(edit_distance("degre", "degree") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("sitting", "kitten") == 3);

  const std::vector<std::string> keys{"degree", "degree_u", "control_points",
                                      "corner_control_points"};
  const auto meant = [&](const std::string& key) { return MP::internal::similar_word(key, keys); };
  CHECK(meant("degre") == "degree");
  CHECK(meant("Degree_U") == "degree_u");
  CHECK(meant("controlPoints") == "control_points");
  CHECK(meant("points") == "control_points");
  CHECK(meant("corner") == "corner_control_points");
  CHECK(meant("the_degree_of_it") == "degree");
  CHECK(meant("e").empty());
  CHECK(meant("layers").empty());
  CHECK(meant("").empty());
  CHECK(meant(std::string(100000, 'e')).empty());

  Json json = Json::parse(small_concave);
  json["sides"][1]["Layers"] = 1;
  CHECK(error_of(json.dump()) ==
        "x.patch.json: /sides/1: the key 'Layers' is not known; is 'layers' meant?");
}

TEST_CASE("A text that is no JSON is refused at the line and the column where it stops being so") {
  struct Row {
    std::string text, message;
  };
  const Row rows[] = {
      {"", "1: expected JSON, found the end of the file at column 1: "},
      {"{\n  \"a\": 1,\n", "3: expected JSON, found the end of the file at column 1: "},
      {"{\n  \"a\": 1,\n}", "3: expected JSON, found '}' at column 1: "},
      {"{\n  \"a\" 1\n}", "2: expected JSON, found '1' at column 7: "},
      {"[1,\n 2 3]", "2: expected JSON, found '3' at column 4: "},
      {"[1e400]", "1: expected JSON, found '1e400' at column 6: "},
      {"{\"a\": 'b'}", "1: expected JSON, found ''' at column 7: "},
      {"{\"a\": nan}", "1: expected JSON, found 'nan' at column 8: "},
      {"{\"a\": 3., \"b\": 1}", "1: expected JSON, found '3.' at column 9: "},
      {"{\"a\" \"b,c\"}", "1: expected JSON, found '\"b,c\"' at column 10: "},
      {"[1}", "1: expected JSON, found '}' at column 3: "},
      {"{\"a\": \"b\n\"}", "1: expected JSON, found '\"b<U+000A>' at column 9: "},
  };
  for (const Row& row : rows)
    CHECK_THAT(error_of(row.text), StartsWith("x.patch.json:" + row.message));
  // What is wrong comes in the words of the JSON library, of which we expect the main ones.
  CHECK_THAT(error_of("[1,\n 2 3]"),
             Contains("unexpected number literal") && Contains("expected ']'"));
  CHECK_THAT(error_of("{\"a\" 1}"), Contains("expected ':'") && !Contains("json.exception"));
  CHECK_THAT(error_of("{\"a\": tru}"), Contains("invalid literal") && !Contains("last read"));
  CHECK_THAT(error_of("[1e400]"), Contains("number overflow") && !Contains("parsing"));
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
