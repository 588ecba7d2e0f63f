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
  for (const Row& row : {Row{"missing.cgb", 1, "missing.cgb: cannot be opened"},
                         Row{input + " --json no/a.json", 1, "no/a.json: cannot be opened"},
                         Row{input + " --json " + input, 1, "it is the same file"},
                         Row{input + " --samples 0", 2, "--samples"}}) {
    INFO(row.arguments);
    const Result result = work.run("exact " + row.arguments);
    CHECK(result.status == row.status);
    CHECK_THAT(result.err, StartsWith("multipatch: ") && Contains(row.message));
  }
  CHECK(work.files().empty());
}
