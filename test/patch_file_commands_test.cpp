// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the commands that read and write patches say, keep and leave out, as a user sees it. POSIX
// only.

#include "catch.h"
#include "patch_file_fixtures.h"

#include <cstddef>
#include <string>
#include <utility>

using namespace patch_file_fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

TEST_CASE(
    "Where there is nothing to elevate the patch stays, whatever its type, and that is said") {
  const Scratch work("elevate_nothing");
  write_one_of_each(work);
  work.run_well("convert -q five.gbp five.cgb");
  for (const std::string input :
       {"five.gbp", "five.cgb", "s.patch.json", "tensor.patch.json", "triangle.patch.json"}) {
    INFO(input);
    const std::string name = input == "five.cgb" ? "a.cgb" : "a.patch.json";
    work.run_well("convert -q " + input + ' ' + name);
    CHECK_THAT(work.run_well("elevate " + input + " -o b" + name.substr(1) + " --degree 1"),
               Contains("\n  nothing was raised: "));
    CHECK((contents(work / ("b" + name.substr(1))) == contents(work / name)));
  }
}

TEST_CASE("Elevation of layers warns of the degrees that they need") {
  const Scratch work("elevate_layers");
  work.run_well("convert -q '" + std::string(MODELS_DIR) + "/l_bracket.cgb' a.cgb");
  const Result low = work.run("elevate a.cgb -o b.cgb --layers 3");
  CHECK(low.status == 0);
  CHECK_THAT(low.err, StartsWith("multipatch: warning: side 0 promises curvature continuity") &&
                          EndsWith("multipatch: with --degree 5 no degree is missing\n"));
  CHECK(work.run("elevate a.cgb -o b.cgb --layers 3 --degree 5").err.empty());
  CHECK(work.run("elevate a.cgb -o b.cgb --layers 3 -q").err.empty());
  CHECK(work.run("elevate a.cgb -o b.cgb --degree 4").err.empty());
}

TEST_CASE(
    "Merging keeps the options on which both patches agree, and says which others there were") {
  const Scratch work("merge_options");
  work.write("a.cgb", cgb({{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
  work.write("b.cgb", cgb({{0, 1}, {2, 1}, {2, 2}, {0, 2}}));
  for (const std::string name : {"a", "b"}) {
    work.run_well("convert -q " + name + ".cgb " + name + ".patch.json");
    Json json = json_of(work, name + ".patch.json");
    json["central_weight"] = "full-product";
    json["domain"] = {{"generator", "projected"}, {"clearance", name == "a" ? 0.2 : 0.3}};
    json["parameter_dilation"] = 0.25;
    work.write(name + ".patch.json", json.dump());
  }
  const Result merged = work.run("merge a.patch.json b.patch.json -o c.patch.json");
  CHECK(merged.status == 0);
  CHECK_THAT(merged.err,
             Contains("do not agree on the clearance; the merged patch has the default") &&
                 Contains("not taken over: central control points"));
  const Json json = json_of(work, "c.patch.json");
  CHECK(json["central_weight"] == "full-product");
  CHECK(json["domain"]["generator"] == "projected");
  CHECK(json["domain"]["clearance"] == 0.05);
  CHECK(json["parameter_dilation"] == 0.25);
  CHECK(work.run("merge a.cgb b.cgb -o c.cgb").err.empty()); // they agree, and have no more
}

namespace {

// A flat patch on a rectangle: the description of a control net with the default options.
Json rectangle(double x0, double y0, double x1, double y1, std::size_t degree = 1) {
  const std::pair<double, double> corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  const double x = (x0 + x1) / 2, y = (y0 + y1) / 2;
  Json points = Json::array();
  for (std::size_t k = 0; k < (degree + 1) / 2; ++k)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = k; j < degree - k; ++j) {
        const auto &a = corners[i], &b = corners[(i + 1) % 4];
        const double t = static_cast<double>(j - k) / static_cast<double>(degree - 2 * k),
                     r = 1 - 2 * static_cast<double>(k) / static_cast<double>(degree + 1);
        points.push_back({x + r * (a.first + t * (b.first - a.first) - x),
                          y + r * (a.second + t * (b.second - a.second) - y), 0});
      }
  points.push_back({x, y, 0});
  Json json = Json::parse(head + R"("generalized-bezier", "number_of_sides": 4})");
  json["degree"] = degree;
  json["control_points"] = points;
  return json;
}

Json with_options(Json json, const std::string& coordinates, const Json& domain) {
  json["coordinates"] = coordinates;
  json["domain"] = domain;
  return json;
}

} // namespace

TEST_CASE("Merging takes over what descriptions of any type say and no other one contradicts") {
  const Scratch work("merge_nets");
  const Json projected = {{"generator", "projected"}, {"clearance", 0.1}};
  const Json above = rectangle(0, 0, 2, 1), below = rectangle(0, -1, 2, 0);
  work.write("a.patch.json", with_options(above, "mean-value", projected).dump());
  work.write("b.patch.json", with_options(below, "mean-value", projected).dump());
  work.write("plain.patch.json", below.dump());
  work.run_well("convert -q plain.patch.json b.gbp");
  work.write("b.cgb", cgb({{0, -1}, {2, -1}, {2, 0}, {0, 0}}));

  for (const std::string other : {"b.patch.json", "b.gbp"}) { // a .gbp file cannot say anything
    INFO(other);
    work.run_well("merge a.patch.json " + other + " -o c.patch.json");
    const Json json = json_of(work, "c.patch.json");
    CHECK(json["coordinates"] == "mean-value");
    CHECK(json["domain"] == projected);
    CHECK(json["central_weight"] == "automatic");
  }
  work.run_well("merge b.gbp a.patch.json -o c.patch.json");
  CHECK(json_of(work, "c.patch.json")["domain"] == projected);

  // What one of the types does not have is no disagreement.
  const Result mixed = work.run("merge a.patch.json b.cgb -o c.patch.json");
  CHECK(mixed.status == 0);
  CHECK_THAT(mixed.err, EndsWith("do not agree on the domain generator, the clearance and the "
                                 "coordinates; the merged patch has the default\n"));
  CHECK(json_of(work, "c.patch.json")["coordinates"] == "harmonic");
  CHECK(json_of(work, "c.patch.json")["central_weight"] == "none");
}

TEST_CASE("Merging names what it leaves out of patches of any type") {
  const Scratch work("merge_losses");
  const Json regular = {{"generator", "regular"}, {"clearance", 0.05}};
  work.write("a.patch.json", with_options(rectangle(0, 0, 2, 1), "wachspress", regular).dump());
  const auto warning = [&](const Json& other) {
    work.write("b.patch.json", other.dump());
    const Result result = work.run("merge a.patch.json b.patch.json -o c.patch.json");
    CHECK(result.status == 0);
    return result.err;
  };
  CHECK(warning(rectangle(0, -1, 2, 0)).empty());
  CHECK(json_of(work, "c.patch.json")["coordinates"] == "wachspress");
  CHECK(json_of(work, "c.patch.json")["domain"] == regular);

  const std::string convex = "not taken over: wachspress coordinates, which need a convex domain\n";
  CHECK_THAT(warning(rectangle(0, -1, 1, 0)), EndsWith(convex));
  CHECK(json_of(work, "c.patch.json")["coordinates"] == "harmonic");
  work.run_well("mesh -q c.patch.json -o c.ply --triangles 50");

  const Json vertices = {{"vertices", {{0, 0}, {2, 0}, {2, 1}, {0, 1}}}};
  CHECK_THAT(warning(with_options(rectangle(0, -1, 2, 0), "wachspress", vertices)),
             EndsWith("warning: not taken over: vertices of domains\n"));
  CHECK(json_of(work, "c.patch.json")["domain"] == regular);
  CHECK_THAT(warning(rectangle(0, -1, 2, 0, 2)),
             EndsWith("warning: not taken over: central control points\n"));

  // The inner control points of an S-patch are not in its ribbons.
  Json s = Json::parse(head + R"("s-patch", "number_of_sides": 4, "depth": 1})");
  s["control_points"] = {{0, -1, 0}, {2, -1, 0}, {2, 0, 0}, {0, 0, 0}};
  CHECK_THAT(warning(s), Contains("b.patch.json: the sides of an S-patch have one layer") &&
                             !Contains("promise"));
  work.write("a.patch.json", rectangle(0, 0, 2, 1, 3).dump());
  CHECK_THAT(warning(s),
             Contains("warning: side 0 promises tangent plane continuity by its 2 layers") &&
                 Contains("2 layers on sides"));
}

TEST_CASE("A central weight that a .cgb file cannot name and nothing tells is an error") {
  const Scratch work("unresolved");
  work.write("a.cgb", cgb({{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
  work.run_well("convert -q a.cgb a.patch.json");
  Json json = json_of(work, "a.patch.json");
  json["central_weight"] = "automatic";
  work.write("a.patch.json", json.dump());
  work.run_well("convert -q a.patch.json b.cgb");
  CHECK_THAT(contents(work / "b.cgb"), StartsWith("1\n"));
  json["corner_control_points"] = {{{"side", 1}, {"point", {1, 1, 1}}},
                                   {{"side", 1}, {"point", {1, 1, 2}}}};
  work.write("a.patch.json", json.dump());
  const Result result = work.run("convert a.patch.json c.cgb");
  CHECK(result.status == 1);
  CHECK_THAT(result.err, Contains("c.cgb: what the automatic central weight stands for"));
  CHECK(!fs::exists(work / "c.cgb"));
}

TEST_CASE("A central point without influence gets none in a .cgb file") {
  const Scratch work("convert_weightless");
  const auto weight = [&](std::size_t sides, std::size_t degree) {
    work.write("a.gbp", gbp(sides, degree));
    work.run_well("convert -q a.gbp b.cgb");
    return contents(work / "b.cgb").substr(0, 2);
  };
  CHECK(weight(3, 2) == "1\n"); // none
  CHECK(weight(4, 3) == "1\n");
  CHECK(weight(5, 1) == "1\n");
  CHECK(weight(3, 3) == "0\n"); // the deficiency
  CHECK(weight(4, 2) == "0\n");
  CHECK(weight(5, 2) == "0\n");
}

TEST_CASE("An automatic central weight is reported as what it stands for") {
  const Scratch work("automatic");
  const std::string hub = "'" + std::string(MODELS_DIR) + "/plus_hub.cgb'";
  work.run_well("convert -q " + hub + " a.patch.json");
  Json json = json_of(work, "a.patch.json");
  CHECK(json["central_weight"] == "weight-deficiency");
  json["central_weight"] = "automatic";
  work.write("a.patch.json", json.dump());
  json.erase("central_weight");
  work.write("b.patch.json", json.dump());
  for (const std::string name : {"a.patch.json", "b.patch.json"}) {
    CHECK_THAT(work.run_well("info " + name),
               Contains("\nCentral weight: automatic (weight-deficiency); "));
    work.run_well("mesh -q --triangles 300 " + name + " -o a.ply --report a.json");
    const Json model = json_of(work, "a.json")["model"];
    CHECK(model["central_weight"] == "weight-deficiency");
    CHECK(model["central_weight_requested"] == "automatic");
    work.run_well("convert -q " + name + " c.cgb");
    work.run_well("convert -q " + name + " c.patch.json");
    CHECK(json_of(work, "c.patch.json")["central_weight"] == "automatic");
    CHECK(contents(work / "c.cgb").substr(0, 2) == "0\n");
  }
  CHECK_THAT(work.run_well("info " + hub), Contains("\nCentral weight: weight-deficiency; "));
  CHECK_THAT(work.run_well("mesh " + hub + " -o a.ply --triangles 300 --central-weight automatic"),
             StartsWith("a.ply: "));
}

TEST_CASE("A triangle has no clearance to tell") {
  const Scratch work("clearance");
  work.write("a.patch.json", triangle);
  CHECK_THAT(work.run_well("info a.patch.json"),
             Contains("clearance unlimited") && !Contains("clearance inf"));
  CHECK_THAT(work.run_well("mesh a.patch.json -o a.ply --triangles 50"),
             Contains("clearance unlimited"));
}

TEST_CASE("Text files may begin with a byte order mark") {
  const Scratch work("byte_order_mark");
  const std::string mark = "\xef\xbb\xbf";
  work.write("a.gbp", gbp(5, 3));
  work.write("marked.gbp", mark + gbp(5, 3));
  work.run_well("convert -q a.gbp a.patch.json");
  work.run_well("convert -q marked.gbp b.patch.json");
  CHECK((contents(work / "a.patch.json") == contents(work / "b.patch.json")));
  work.write("a.txt", "0 0\n1 0\n0 1\n");
  work.write("marked.txt", mark + "0 0\n1 0\n0 1\n");
  work.run_well("coordinates -q a.txt -o a.csv --samples 20");
  work.run_well("coordinates -q marked.txt -o b.csv --samples 20");
  CHECK((contents(work / "a.csv") == contents(work / "b.csv")));
}
