// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the program as a user does. POSIX only.

#include "catch.h"
#include "program_fixtures.h"

#include <string>

using namespace program_fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

std::string model(const std::string& name) {
  return std::string("'") + MODELS_DIR + '/' + name + ".cgb'";
}

// The number with a key in the object with another, in a JSON text.
double number(const std::string& json, const std::string& object, const std::string& key) {
  const std::size_t begin = json.find('"' + object + "\": {");
  REQUIRE(begin != std::string::npos);
  const std::string name = '"' + key + "\": ";
  return std::stod(json.substr(json.find(name, begin) + name.size()));
}

} // namespace

TEST_CASE("Exact measures rounding errors, with the yardstick that the domain allows") {
  const Scratch work("exact");
  const std::string triangle = work.run_well("exact --samples 1 " + model("triangle_corner"));
  CHECK_THAT(triangle, StartsWith("Wachspress coordinates, double precision against exact rational "
                                  "numbers at ") &&
                           Contains("\nsecond derivatives "));
  const std::string concave = work.run_well("exact --samples 5 " + model("u_vent"));
  CHECK_THAT(concave, StartsWith("mean value coordinates, double precision against numbers of 100 "
                                 "digits at 157 points\n"));
  CHECK(work.files().empty());
}

TEST_CASE("Exact measures patches of every type, with the stages that they have") {
  const Scratch work("exact_types");
  const std::string head = R"({"format": "multisided-patch", "version": 1, "type": )";
  work.write("net.gbp", "5 1\n0 0 0\n1 0 0\n0.3 1 0.1\n-0.8 0.6 0\n-0.8 -0.6 0.1\n0.3 -1 0\n");
  work.write("s.patch.json", head + R"("s-patch", "number_of_sides": 5, "depth": 1,
    "control_points": [[1, 0, 0], [0.3, 1, 0.1], [-0.8, 0.6, 0], [-0.8, -0.6, 0.1], [0.3, -1, 0]]})");
  work.write("tensor.patch.json", head + R"("tensor-product", "degree_u": 1, "degree_v": 1,
    "control_points": [[0, 0, 0], [1, 0, 1], [0, 1, 0], [1, 1, 0.3]]})");
  work.write("triangle.patch.json", head + R"("bezier-triangle", "degree": 1,
    "control_points": [[0, 0, 0], [1, 0, 0.1], [0, 1, 0.7]]})");
  const auto run = [&](const std::string& name) {
    const std::string json = work.run_well("exact --samples 3 --json - " + name);
    const double largest = number(json, "points", "max_relative");
    CHECK(largest < 1e-14);
    CHECK(number(json, "second_derivatives", "max_relative") < 1e-10);
    return work.run_well("exact --samples 3 " + name);
  };
  CHECK_THAT(run("net.gbp"),
             StartsWith("Wachspress coordinates, ") && Contains("side parameter h"));
  CHECK_THAT(run("s.patch.json"),
             StartsWith("Wachspress coordinates, ") && !Contains("side parameter"));
  for (const std::string name : {"tensor.patch.json", "triangle.patch.json"})
    CHECK_THAT(run(name), StartsWith("polynomials, double precision against exact rational ") &&
                              !Contains("weights"));
  CHECK_THAT(work.run_well("exact --samples 3 --json - s.patch.json"),
             Contains("\"coordinates\": \"Wachspress\""));
  CHECK_THAT(work.run_well("exact --samples 3 --json - tensor.patch.json"),
             Contains("\"coordinates\": null"));
}

TEST_CASE("Exact writes JSON to a file or to standard output") {
  const Scratch work("exact_json");
  const std::string arguments = "exact --samples 5 " + model("u_vent");
  const std::string json = work.run_well(arguments + " --json -");
  CHECK_THAT(json, StartsWith("{\n  \"input\": ") && Contains("\"samples\": 157,") &&
                       Contains("\"relative_to\": \"bounding box\"") && EndsWith("\n}\n"));
  const double largest = number(json, "points", "max_relative");
  CHECK(largest > 1e-18);
  CHECK(largest < 1e-14);
  CHECK(number(json, "points", "mean_relative") < largest);
  CHECK(number(json, "second_derivatives", "max_relative") < 1e-10);
  CHECK(work.run_well(arguments + " --json a.json -q").empty());
  CHECK(contents(work / "a.json") == json);
  CHECK(work.files() == std::set<std::string>{"a.json"});
}

TEST_CASE("What keeps exact from its work is said before it starts") {
  const Scratch work("exact_errors");
  CHECK_THAT(work.run_well("exact --help"), Contains("Usage: ") && Contains("--samples"));
  const std::string input = model("u_vent");
  struct Row {
    std::string arguments;
    int status;
    std::string message;
  };
  for (const Row& row :
       {Row{"missing.cgb", 1, "missing.cgb: cannot be opened for reading: No such"},
        Row{input + " --json no/a.json", 1, "no/a.json: cannot be opened"},
        Row{input + " --json " + input, 2, "it is the same file"},
        Row{input + " --samples 0", 2, "--samples"}}) {
    INFO(row.arguments);
    const Result result = work.run("exact " + row.arguments);
    CHECK(result.status == row.status);
    CHECK_THAT(result.err, StartsWith("multipatch: ") && Contains(row.message));
  }
  CHECK(work.files().empty());
}
