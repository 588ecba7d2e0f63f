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
