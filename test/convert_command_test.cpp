// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the commands that make files of patches of others, and all commands on all types of patches,
// as a user does. POSIX only.

#include "catch.h"
#include "patch_file_fixtures.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>

using namespace patch_file_fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

TEST_CASE("A .cgb file that becomes a .patch.json file and comes back is the same") {
  const Scratch work("convert_cgb");
  for (const Example& example : examples()) {
    INFO(example.name);
    CHECK_THAT(work.run_well("convert " + example.argument + " a.cgb"),
               StartsWith("a.cgb: concave generalized Bezier patch, "));
    work.run_well("convert -q a.cgb b.patch.json");
    work.run_well("convert -q b.patch.json c.cgb");
    CHECK((contents(work / "c.cgb") == contents(work / "a.cgb")));
    CHECK(work.run_well("info b.patch.json").substr(12) == work.run_well("info a.cgb").substr(5));
  }
}

TEST_CASE("A .gbp file that becomes a .patch.json file and comes back is the same") {
  const Scratch work("convert_gbp");
  for (std::size_t degree = 1; degree < 6; ++degree) {
    CAPTURE(degree);
    work.write("x.gbp", gbp(3 + degree, degree));
    work.run_well("convert -q x.gbp a.gbp");
    work.run_well("convert -q a.gbp b.patch.json");
    work.run_well("convert -q b.patch.json c.gbp");
    CHECK(contents(work / "c.gbp") == contents(work / "a.gbp"));
    CHECK(json_of(work, "b.patch.json")["degree"] == degree);
    CHECK(json_of(work, "b.patch.json")["number_of_sides"] == 3 + degree);
  }
}

TEST_CASE("The format of a patch makes no difference to its mesh") {
  const Scratch work("convert_mesh");
  work.run_well("convert -q '" + std::string(MODELS_DIR) + "/l_bracket.cgb' a.cgb");
  work.write("b.gbp", gbp(5, 5));
  for (const std::string name : {"a.cgb", "b.gbp"}) {
    work.run_well("convert -q " + name + " x.Patch.JSON");
    work.run_well("mesh -q --triangles 300 " + name + " -o a.ply");
    work.run_well("mesh -q --triangles 300 x.Patch.JSON -o b.ply");
    CHECK(fs::file_size(work / "a.ply") > 5000);
    CHECK((contents(work / "a.ply") == contents(work / "b.ply")));
  }
  fs::rename(work / "b.gbp", work / "C.GBP");
  work.run_well("mesh -q --triangles 300 C.GBP -o c.ply");
  CHECK((contents(work / "c.ply") == contents(work / "b.ply")));
}

TEST_CASE("All commands take patches of every type") {
  const Scratch work("convert_types");
  for (const std::string& name : write_one_of_each(work)) {
    INFO(name);
    CHECK_THAT(work.run_well("info " + name),
               StartsWith(name + ": ") && Contains(" sides; corners: ") && Contains("\nType: ") &&
                   Contains("\nDomain: ") && !Contains(" of G"));
    CHECK_THAT(work.run_well("mesh " + name + " -o a.ply --triangles 500 --report a.json"),
               StartsWith("a.ply: "));
    const Json report = json_of(work, "a.json");
    CHECK(report["mesh"]["is_disk"] == true);
    CHECK(report["boundary"]["vertex_deviation_relative"].get<double>() < 1e-14);
    CHECK(report["model"]["sides"] == (name == "tensor.patch.json"     ? 4
                                       : name == "triangle.patch.json" ? 3
                                                                       : 5));
    CHECK_THAT(work.run_well("check " + name), Contains("Tolerances: ") && !Contains("exceeded"));
    CHECK_THAT(work.run_well("domain " + name + " -o a.svg --side 2"), StartsWith("a.svg: "));
    CHECK_THAT(work.run_well("coordinates " + name + " -o a.csv"),
               Contains("wachspress coordinates"));
  }
  work.run_well("mesh -q five.gbp s.patch.json -o b.ply --triangles 500 --report b.json");
  CHECK(json_of(work, "b.json")["patches"].size() == 2);
}

TEST_CASE("Domain and coordinates are those of the .patch.json file, unless one asks for others") {
  const Scratch work("convert_choices");
  work.write("x.cgb", cgb({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  work.run_well("convert -q x.cgb x.patch.json");
  Json json = json_of(work, "x.patch.json");
  json["domain"] = {{"vertices", {{0, 0}, {3, 0}, {2, 2}, {0, 1}}}};
  json["coordinates"] = "wachspress";
  work.write("x.patch.json", json.dump());
  const std::string mesh = "mesh -q x.patch.json -o a.ply --triangles 50 --report a.json";
  work.run_well(mesh);
  CHECK(json_of(work, "a.json")["domain"]["used"] == "given");
  CHECK(json_of(work, "a.json")["coordinates"]["name"] == "wachspress");
  work.run_well(mesh + " --domain projected --clearance 0 --coordinates mean-value");
  CHECK(json_of(work, "a.json")["domain"]["used"] == "projected");
  CHECK(json_of(work, "a.json")["coordinates"]["name"] == "mean-value");
  const Result refused = work.run(mesh + " --clearance 0.1");
  CHECK(refused.status == 1);
  CHECK_THAT(refused.err, Contains("x.patch.json: --clearance is for domains that are made"));
  // The domain has the vertices of the file.
  work.run_well("coordinates x.patch.json -o a.csv --samples 50");
  CHECK_THAT(contents(work / "a.csv"), Contains("\n3,0,0,1,0,0\n") && Contains("\n2,2,0,0,1,0\n"));
}

TEST_CASE("A .gbp file becomes a .cgb file with the same boundary, and that the rest differs is "
          "said") {
  const Scratch work("convert_net");
  work.write("a.gbp", gbp(6, 3));
  CHECK_THAT(work.run_well("convert a.gbp b.cgb"), Contains("the surface between them differs"));
  work.run_well("convert -q b.cgb b.patch.json");
  work.run_well("convert -q a.gbp a.patch.json");
  const Json ribbons = json_of(work, "b.patch.json"), net = json_of(work, "a.patch.json");
  CHECK(ribbons["central_weight"] == "weight-deficiency");
  CHECK(ribbons["central_point"] == net["control_points"].back());
  REQUIRE(ribbons["sides"].size() == 6);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(ribbons["sides"][i]["control_points"][j] == net["control_points"][3 * i + j]);
  work.run_well("mesh -q --triangles 200 b.cgb -o b.ply");
}

TEST_CASE("What the format cannot hold is refused by its name, or left out if one wants so") {
  const Scratch work("convert_lossy");
  work.write("x.cgb", cgb({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  work.run_well("convert -q x.cgb plain.patch.json");
  struct Row {
    std::string key;
    Json value;
    std::string lost;
  };
  const Row rows[] = {
      {"reflex_weight", 2, "the reflex weight"},
      {"coordinates", "wachspress", "wachspress coordinates"},
      {"domain", {{"generator", "regular"}}, "the domain generator regular"},
      {"domain", {{"vertices", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}}, "the vertices of the domain"}};
  for (const Row& row : rows) {
    Json json = json_of(work, "plain.patch.json");
    json[row.key] = row.value;
    work.write("y.patch.json", json.dump());
    const Result refused = work.run("convert y.patch.json a.cgb");
    CHECK(refused.status == 1);
    CHECK_THAT(refused.err,
               StartsWith("multipatch: a.cgb: ") && Contains(row.lost) && Contains("--lossy"));
    CHECK(!fs::exists(work / "a.cgb"));
    CHECK_THAT(work.run_well("convert y.patch.json a.cgb --lossy"), Contains(row.lost));
    CHECK(fs::exists(work / "a.cgb"));
    fs::remove(work / "a.cgb");
    // Nothing is lost where the format holds everything.
    work.run_well("convert y.patch.json z.patch.json");
    CHECK(json_of(work, "z.patch.json")[row.key].dump().find(row.value.dump().substr(1, 5)) !=
          std::string::npos);
  }
}

TEST_CASE("Elevation raises what is lower, and nothing else") {
  const Scratch work("elevate");
  const std::string duct = "'" + std::string(MODELS_DIR) + "/mixed_duct.cgb'";
  work.run_well("convert -q " + duct + " a.cgb");
  work.run_well("elevate -q a.cgb -o b.cgb --degree 1 --layers 1");
  CHECK((contents(work / "b.cgb") == contents(work / "a.cgb")));
  work.run_well("convert -q a.cgb a.patch.json");
  const Result result = work.run("elevate a.cgb -o b.patch.json --degree 5 --layers 3");
  CHECK(result.status == 0);
  CHECK_THAT(result.out, StartsWith("b.patch.json: concave generalized Bezier patch"));
  CHECK_THAT(result.err, Contains("by its 4 layers")); // as one side has
  const Json before = json_of(work, "a.patch.json"), after = json_of(work, "b.patch.json");
  bool raised = false, stayed = false;
  for (std::size_t i = 0; i < before["sides"].size(); ++i) {
    const Json &old_side = before["sides"][i], &side = after["sides"][i];
    const std::size_t degree = old_side["degree"], layers = old_side["layers"];
    CHECK(side["degree"] == (std::max)(degree, std::size_t(5)));
    CHECK(side["layers"] == (std::max)(layers, std::size_t(3)));
    CHECK(side["control_points"][0] == old_side["control_points"][0]);
    raised = raised || side["degree"] != old_side["degree"];
    stayed = stayed || side["degree"] == old_side["degree"];
  }
  CHECK((raised && stayed));

  work.write("a.gbp", gbp(5, 3));
  CHECK_THAT(work.run_well("elevate a.gbp -o b.gbp --degree 5"),
             StartsWith("b.gbp: generalized Bezier patch of degree 5, 5 sides") &&
                 !Contains("nothing was raised"));
  CHECK_THAT(contents(work / "b.gbp"), StartsWith("5 5\n"));
  write_one_of_each(work);
  for (const auto& [name, key] :
       {std::pair("s", "depth"), std::pair("triangle", "degree"), std::pair("tensor", "degree_u"),
        std::pair("tensor", "degree_v")}) {
    work.run_well("elevate -q " + std::string(name) + ".patch.json -o e.patch.json --degree 4");
    CHECK(json_of(work, "e.patch.json")[key] == 4);
    work.run_well("mesh -q e.patch.json -o e.ply --triangles 50");
  }
}

TEST_CASE("Merging two loops gives the loop around both and says where its sides come from") {
  const Scratch work("merge");
  // The second lies on the left half of the upper side of the first.
  work.write("a.cgb", cgb({{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
  work.write("b.cgb", cgb({{0, 1}, {1, 1}, {1, 2}, {0, 2}}));
  const std::string out = work.run_well("merge a.cgb b.cgb -o l.cgb");
  CHECK_THAT(out, StartsWith("l.cgb: 6 sides; corners: 5 convex, 1 reflex, 0 straight\n") &&
                      Contains("a.cgb side 2 from s = 0 to 0.5\n") &&
                      Contains("b.cgb side 3 and a.cgb side 3\n"));
  CHECK_THAT(work.run_well("info l.cgb"), Contains("l.cgb: 6 sides") && Contains("reflex"));
  work.run_well("merge -q a.cgb b.cgb -o l.patch.json");
  CHECK(json_of(work, "l.patch.json")["sides"].size() == 6);
  work.write("far.cgb", cgb({{5, 5}, {6, 5}, {6, 6}, {5, 6}}));
  const Result refused = work.run("merge a.cgb far.cgb -o x.cgb");
  CHECK(refused.status == 1);
  CHECK_THAT(refused.err, Contains("the loops cannot be merged"));
  CHECK(!fs::exists(work / "x.cgb"));
}

TEST_CASE("What goes wrong with files of patches is said in two lines, and leaves no trace") {
  constexpr int data = 1, usage = 2;
  struct Row {
    std::string arguments;
    int status;
    std::string message;
  };
  const Row rows[] = {
      {"convert x.cgb a.foo", usage,
       "a.foo: expected a name that ends in .cgb, .gbp or .patch.json"},
      {"convert x.cgb a.json", usage, "a.json: expected a name that ends in .cgb"},
      {"convert x.cgb a.gbp", data, "a.gbp: a .gbp file cannot hold this concave generalized"},
      {"convert x.cgb a.gbp --lossy", data, "a.gbp: a .gbp file cannot hold"},
      {"convert s.patch.json a.cgb --lossy", data, "a .cgb file cannot hold this S-patch of depth"},
      {"convert tensor.patch.json a.gbp", data,
       "cannot hold this tensor product patch of degree 2"},
      {"convert triangle.patch.json a.gbp", data, "cannot hold this Bezier triangle of degree 2"},
      {"convert x.cgb x.cgb", usage, "x.cgb: cannot be written: it is the same file"},
      {"convert x.cgb no/a.cgb", data, "no/a.cgb: cannot be opened for writing"},
      {"convert missing.gbp a.cgb", data, "missing.gbp: cannot be opened"},
      {"convert cut.gbp a.patch.json", data, "cut.gbp:3: expected"},
      {"convert cut.patch.json a.cgb", data, "cut.patch.json:1: expected JSON"},
      {"convert deep.patch.json a.cgb", data, "deep.patch.json: expected at most 8 levels"},
      {"convert typo.patch.json a.cgb", data, "typo.patch.json: the key 'dephth' is not known"},
      {"convert x.cgb", usage, "OUTPUT"},
      {"elevate x.cgb -o a.cgb", usage, "--degree or --layers is required"},
      {"elevate five.gbp -o a.gbp --layers 3", data, "five.gbp: --layers is for concave"},
      {"elevate five.gbp -o a.cgb --degree 5", data, "a.cgb: the type of the patch would change"},
      {"elevate s.patch.json -o a.patch.json --degree 100", data,
       "s.patch.json: an S-patch with 5"},
      {"elevate x.cgb -o a.cgb --degree 101", usage, "101"},
      {"elevate x.cgb -o x.cgb --degree 5", usage, "x.cgb: cannot be written"},
      {"merge x.cgb x.cgb -o a.cgb", data, "cannot be merged"},
      {"merge x.cgb five.gbp -o a.gbp", usage, "a.gbp: expected a name that ends in .cgb or"},
      {"merge x.cgb missing.cgb -o a.cgb", data,
       "missing.cgb: cannot be opened for reading: No such"},
      {"mesh five.gbp -o a.ply --central-weight none", data,
       "five.gbp: --central-weight is for concave generalized Bezier patches only"},
      {"mesh five.gbp -o a.ply --elevate", data, "five.gbp: --elevate is for concave"},
      {"check s.patch.json --central-weight none", data, "s.patch.json: --central-weight is for"},
      {"mesh tensor.patch.json -o a.ply --coordinates harmonic", data,
       "tensor.patch.json: --coordinates does not apply to a tensor product patch"},
      {"mesh triangle.patch.json -o a.ply --domain regular", data,
       "triangle.patch.json: --domain does not apply to a Bezier triangle"},
      {"domain triangle.patch.json -o a.svg --side 3", data, "--side must be less than 3"},
      {"info x.foo", usage, "x.foo: expected a name that ends in .cgb, .gbp or .patch.json"},
      {"mesh x -o a.ply", usage, "x: expected a name that ends in .cgb, .gbp or .patch.json"},
      {"mesh x.cgb x.cgb -o a.ply", usage, "x.cgb: the file is given twice"},
      {"check ./x.cgb x.cgb", usage, "x.cgb: the file is given twice, first as ./x.cgb"},
      {"info cut.gbp", data, "cut.gbp:3: expected"},
      {"info point.gbp", data, "point.gbp: the control points are too far apart or too close"},
      {"convert side.gbp a.cgb", data, "side.gbp: the boundary curve of side 0 is a single point"},
      {"coordinates cut.patch.json -o a.csv", data, "cut.patch.json:1: expected JSON"},
      {"coordinates five.gbp -o a.csv --target-error 1e-3", data, "for harmonic coordinates only"},
      {"coordinates five.gbp -o a.csv --target-error 1e-3 --coordinates mean-value", usage,
       "--target-error is for harmonic coordinates only"},
  };
  const Scratch work("convert_errors");
  work.write("x.cgb", cgb({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  write_one_of_each(work);
  work.write("cut.gbp", "5 5\n0 0 0\n1 2");
  work.write("point.gbp", "3 1\n1 1 1\n1 1 1\n1 1 1\n1 1 1\n");
  work.write("side.gbp", "3 1\n1 1 1\n0 0 0\n0 0 0\n1 1 1\n");
  work.write("cut.patch.json", s_patch.substr(0, 60));
  work.write("deep.patch.json", std::string(100000, '['));
  work.write("typo.patch.json", head + R"("s-patch", "number_of_sides": 3, "dephth": 1})");
  const std::set<std::string> files = work.files();
  const std::string before = contents(work / "x.cgb");
  for (const Row& row : rows) {
    const Result result = work.run(row.arguments);
    INFO("multipatch " << row.arguments);
    CHECK(result.status == row.status);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Contains(row.message) && EndsWith("\n"));
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') <= 2);
    CHECK(work.files() == files);
    CHECK(contents(work / "x.cgb") == before);
  }
}
