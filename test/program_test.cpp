// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the program as a user does. POSIX only.

#include "catch.h"
#include "program_fixtures.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace program_fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

// A flat triangle with sides of degree 1. Line 5 is n, line 6 the central point, line 7 starts side
// 0.
std::string triangle(const std::string& n = "3", const std::string& x = "0.3",
                     const std::string& degree = "1", const std::string& corner = "1 0 0") {
  return "1\n1\n0.05\n0\n" + n + "\n" + x + " 0.3 0.1\n" + degree + " 1\n0 0 0\n" + corner +
         "\n1 1\n" + corner + "\n0 1 0\n1 1\n0 1 0\n0 0 0\n0\n";
}

} // namespace

TEST_CASE("The same input gives the same bytes") {
  const Scratch work("repeated");
  for (const std::string extension : {"ply", "obj", "off", "stl"})
    for (const Example& example : {examples().front(), examples().back()}) {
      const std::string mesh = "mesh -q --triangles 3000 " + example.argument;
      CHECK(work.run_well(mesh + " -o a." + extension).empty());
      CHECK(work.run_well(mesh + " -o b." + extension).empty());
      CHECK(fs::file_size(work / ("a." + extension)) > 50000);
      CHECK((contents(work / ("a." + extension)) == contents(work / ("b." + extension))));
    }
}

TEST_CASE("Domains, coordinates and central weights are those that one asks for") {
  const Scratch work("choices");
  work.write("x.cgb", triangle());
  const std::vector<std::pair<std::string, std::vector<std::string>>> choices{
      {"domain",
       {"automatic", "projected", "similarity", "similarity-outer", "circular", "regular"}},
      {"coordinates", {"harmonic", "mean-value", "wachspress"}},
      {"central-weight",
       {"weight-deficiency", "none", "adjacent-products", "full-product", "automatic"}}};
  for (const auto& [option, names] : choices)
    for (const std::string& name : names) {
      work.run_well("mesh x.cgb -o a.ply --triangles 100 --report a.json --" + option + " " + name);
      CHECK_THAT(contents(work / "a.json"), Contains("\": \"" + name + "\""));
      CHECK_THAT(contents(work / "a.json"), Contains("\"is_disk\": true"));
    }
}

TEST_CASE("Info prints corner types, and Wachspress coordinates refuse reflex corners") {
  const Scratch work("corners");
  int concave = 0;
  for (const Example& example : examples()) {
    INFO(example.name);
    const std::string info = work.run_well("info " + example.argument);
    CHECK_THAT(info, Contains(" sides; corners: ") && Contains(" convex, ") && Contains("angle") &&
                         Contains("\nDomain: "));
    if (info.find(", 0 reflex") != std::string::npos)
      continue;
    ++concave;
    CHECK_THAT(info, Contains("   reflex "));
    const Result result =
        work.run("mesh " + example.argument + " -o a.ply --coordinates wachspress");
    CHECK(result.status == 1);
    CHECK_THAT(result.err, Contains("; corner ") && EndsWith(" is reflex\n"));
    work.run_well("mesh -q " + example.argument + " -o b.ply --coordinates mean-value");
  }
  CHECK(concave >= 3);
  CHECK(work.files() == std::set<std::string>{"b.ply"});
}

TEST_CASE("Layers that promise more than the patch has are named, and elevation helps") {
  const Scratch work("contact");
  const std::string duct = std::string("'") + MODELS_DIR + "/mixed_duct.cgb'";
  const std::string info = work.run_well("info " + duct);
  CHECK_THAT(info,
             Contains("G0 of G3\n") &&
                 Contains("\n  side 4 promises continuity of order 3 by its 4 layers but gets "
                          "position continuity only; it takes degree 7 on sides 3 and 5 and "
                          "4 layers on sides 0, 1, 2 and 6\n"));
  const std::string mesh = "mesh " + duct + " -o a.ply --triangles 100 --report a.json";
  const Result poor = work.run(mesh);
  CHECK(poor.status == 0);
  CHECK_THAT(poor.out, !Contains("promises"));
  CHECK_THAT(poor.err, Contains("\nmultipatch: warning: side 4 promises ") &&
                           Contains("\nmultipatch: warning: the option --elevate of "));
  CHECK(work.run(mesh + " -q").err.empty());
  CHECK_THAT(contents(work / "a.json"), Contains("\"order\": 0"));
  // What other sides have too few layers for stays out of reach.
  CHECK_THAT(work.run(mesh + " --elevate").err,
             Contains("\nmultipatch: warning: side 4 promises continuity of order 3 by its 4 "
                      "layers but gets tangent plane continuity only") &&
                 !Contains("--elevate"));
  CHECK_THAT(contents(work / "a.json"), Contains("\"is_disk\": true") && !Contains("\"order\": 0"));
  const std::string good = std::string("'") + MODELS_DIR + "/g2_blend.cgb'";
  CHECK_THAT(work.run_well("info " + good), !Contains("promises"));
  work.run_well("mesh -q " + good + " -o b.ply --triangles 100");
  work.run_well("mesh -q " + good + " -o c.ply --triangles 100 --elevate");
  CHECK((contents(work / "b.ply") == contents(work / "c.ply")));
}

TEST_CASE("Domain draws every example") {
  const Scratch work("domain");
  for (const Example& example : examples()) {
    INFO(example.name);
    const Result result =
        work.run("domain " + example.argument + " -o a.svg --side 2 --coordinate 1");
    CHECK(result.status == 0);
    CHECK_THAT(result.out, StartsWith("a.svg: domain ") && Contains("clearance") && EndsWith("\n"));
    CHECK(std::count(result.out.begin(), result.out.end(), '\n') == 1);
    CHECK_THAT(contents(work / "a.svg"), StartsWith("<svg ") && EndsWith("</svg>\n") &&
                                             Contains("<path ") && !Contains("nan") &&
                                             !Contains("inf"));
  }
}

TEST_CASE("Help and version go to standard output") {
  const Scratch work("help");
  CHECK_THAT(work.run_well("--version"), StartsWith("multipatch "));
  CHECK_THAT(work.run_well("--help"), Contains("Usage: ") && Contains("mesh") && Contains("info") &&
                                          Contains("domain") && Contains("coordinates"));
  CHECK_THAT(work.run_well("mesh --help"), Contains("Usage: ") && Contains("--triangles") &&
                                               Contains("--edge-length") && Contains("--report") &&
                                               Contains("--chordal-deviation") &&
                                               Contains("--normal-deviation"));
  CHECK_THAT(work.run_well("info --help"), Contains("Usage: "));
  CHECK_THAT(work.run_well("domain --help"), Contains("Usage: ") && Contains("--coordinate"));
  CHECK_THAT(work.run_well("coordinates --help"), Contains("Usage: ") && Contains("--samples"));
}

TEST_CASE("What goes wrong is said in two lines, and leaves no trace") {
  constexpr int data = 1, usage = 2;
  struct Row {
    std::string arguments;
    int status;
    std::string message;
  };
  const Row rows[] = {
      {"mesh empty.cgb -o a.ply", data, "empty.cgb:1: "},
      {"mesh cut.cgb -o a.ply", data, "cut.cgb:12: "},
      {"mesh cut.cgb -o old.ply", data, "cut.cgb:12: "},
      {"mesh n0.cgb -o a.ply", data, "n0.cgb:5: "},
      {"mesh n9.cgb -o a.ply", data, "n9.cgb:5: "},
      {"mesh nan.cgb -o a.ply", data, "nan.cgb:6: "},
      {"mesh degree.cgb -o a.ply", data, "degree.cgb:7: "},
      {"mesh huge.cgb -o a.ply", data, "huge.cgb: "},
      {"mesh old.ply -o a.ply", usage,
       "old.ply: expected a name that ends in .cgb, .gbp or .patch.json"},
      {"mesh . -o a.ply", data,
       ".: expected a file, found a directory; with --output-directory, all"},
      {"mesh missing.cgb -o a.ply", data, "missing.cgb: cannot be opened for reading: No such"},
      {"info missing.cgb", data, "missing.cgb: cannot be opened for reading: No such"},
      {"info n9.cgb", data, "n9.cgb:5: "},
      {"info huge.cgb", data, "huge.cgb: "},
      {"domain nan.cgb -o a.svg", data, "nan.cgb:6: "},
      {"mesh x.cgb -o no/a.ply", data, "no/a.ply: cannot be opened"},
      {"mesh x.cgb -o directory.ply", data, "directory.ply: cannot be written"},
      {"mesh x.cgb -o full.ply", data, "full.ply: cannot be written"},
      {"mesh x.cgb -o a.foo", usage, "a.foo: expected a name that ends in .ply"},
      {"mesh x.cgb -o a", usage, "a: expected a name that ends in .ply"},
      {"mesh x.cgb -o a.ply --report no/a.json", data, "no/a.json: cannot be opened"},
      {"mesh x.cgb -o a.ply --report directory.ply", data, "directory.ply: cannot be written"},
      {"mesh missing.cgb -o a.ply --report ./a.ply", usage, "a.ply: cannot be written: it is the"},
      {"mesh x.cgb -o a.ply --report x.cgb", usage, "x.cgb: cannot be written: it is the same"},
      {"domain x.cgb -o x.cgb", usage, "x.cgb: expected a name that ends in .svg"},
      {"domain x.svg -o x.svg", usage, "x.svg: expected a name that ends in .cgb"},
      {"domain x.cgb -o no/a.svg", data, "no/a.svg: cannot be opened"},
      {"domain x.cgb -o a.svg --side 3", data, "--side"},
      {"domain x.cgb -o a.svg --side -1", usage, "expected a whole number from 0 to 999, not -1\n"},
      {"mesh x.cgb -o a.ply --edge-length 0", usage, "expected a positive number, not 0\n"},
      {"mesh x.cgb -o a.ply --edge-length -1", usage, "-1"},
      {"mesh x.cgb -o a.ply --edge-length 1e-300", data, "the limit is 100000000\n"},
      {"mesh x.cgb -o a.ply --edge-length nan", usage, "nan"},
      {"mesh x.cgb -o a.ply --edge-length inf", usage, "inf"},
      {"mesh x.cgb -o a.ply --edge-length long", usage, "long"},
      {"mesh x.cgb -o a.ply --triangles 0", usage,
       "expected a whole number from 1 to 100000000, not 0\n"},
      {"mesh x.cgb -o a.ply --triangles -5", usage, "-5"},
      {"mesh x.cgb -o a.ply --triangles 1000000000000000000", usage, "1000000000000000000"},
      {"mesh x.cgb -o a.ply --triangles 1e3", usage,
       "--triangles: expected a whole number from 1 to 100000000, not 1e3\n"},
      {"mesh x.cgb -o a.ply --triangles 2.5", usage, "expected a whole number from 1 to 1"},
      {"mesh x.cgb -o a.ply --triangles many", usage, "expected a whole number from 1 to 1"},
      {"mesh x.cgb -o a.ply --triangle 10", usage,
       "multipatch: the command mesh has no option --triangle; did you mean --triangles?\n"},
      {"mesh x.cgb -o a.ply --traingles=10", usage, "--traingles; did you mean --triangles?\n"},
      {"info x.cgb old.cgb", usage, "the command info has no place for the argument old.cgb\n"},
      {"mesh x.cgb -o a.ply --triangles 9 --edge-length 1", usage, "excludes"},
      {"mesh x.cgb -o a.ply --chordal-deviation 0", usage, "not 0\n"},
      {"mesh x.cgb -o a.ply --chordal-deviation -1", usage, "-1"},
      {"mesh x.cgb -o a.ply --chordal-deviation nan", usage, "nan"},
      {"mesh x.cgb -o a.ply --chordal-deviation fine", usage, "fine"},
      {"mesh x.cgb -o a.ply --normal-deviation 0", usage, "not 0\n"},
      {"mesh x.cgb -o a.ply --normal-deviation 91", usage, "at most 90, not 91\n"},
      {"mesh x.cgb -o a.ply --normal-deviation nan", usage, "nan"},
      {"mesh x.cgb -o a.ply --chordal-deviation 1 --triangles 9", usage, "excludes"},
      {"mesh x.cgb -o a.ply --normal-deviation 1 --triangles 9", usage, "excludes"},
      {"mesh x.cgb missing.cgb -o a.ply", data,
       "missing.cgb: cannot be opened for reading: No such"},
      {"mesh x.cgb n9.cgb -o a.ply", data, "n9.cgb:5: "},
      {"mesh x.cgb old.cgb -o a.ply --edge-length 1e-300", data, "x.cgb: "},
      {"mesh old.cgb x.cgb -o x.cgb", usage, "x.cgb: expected a name that"},
      {"mesh old.cgb x.cgb -o a.ply --report x.cgb", usage, "x.cgb: cannot be written"},
      {"mesh x.cgb -o a.ply --clearance nan", usage, "expected a number from 0 to 1, not nan\n"},
      {"mesh x.cgb -o a.ply --clearance 2", usage, "2"},
      {"mesh x.cgb -o a.ply --domain round", usage, "round"},
      {"mesh x.cgb -o a.ply --domain 2", usage, "2"},
      {"mesh x.cgb -o a.ply --coordinates polar", usage, "polar"},
      {"mesh x.cgb -o a.ply --central-weight heavy", usage, "heavy"},
      {"mesh x.cgb -o a.ply --colour red", usage, "no option --colour\n"},
      {"mesh x.cgb", usage, "--output"},
      {"mesh -o a.ply", usage, "INPUT"},
      {"melt x.cgb", usage, "multipatch: there is no command melt\n"},
      {"mehs x.cgb -o a.ply", usage, "multipatch: there is no command mehs; did you mean mesh?\n"},
      {"--versoin", usage, "multipatch: there is no option --versoin; did you mean --version?\n"},
      {"", usage, "multipatch: a command is required\n"},
  };

  const Scratch work("errors");
  fs::create_directory(work / "directory.ply");
  if (fs::exists("/dev/full"))
    fs::create_symlink("/dev/full", work / "full.ply");
  else
    fs::create_directory(work / "full.ply");
  work.write("x.cgb", triangle());
  work.write("old.ply", "old");
  work.write("old.cgb", triangle());
  work.write("empty.cgb", "");
  work.write("cut.cgb", triangle().substr(0, triangle().rfind("0 1 0\n1 1")));
  work.write("n0.cgb", triangle("0"));
  work.write("n9.cgb", triangle("1000000000"));
  work.write("nan.cgb", triangle("3", "nan"));
  work.write("degree.cgb", triangle("3", "0.3", "1000000"));
  work.write("huge.cgb", triangle("3", "0.3", "1", "1e200 0 0"));
  CHECK_THAT(work.run_well("mesh x.cgb -o b.ply"), StartsWith("b.ply: "));
  const std::set<std::string> files = work.files();
  for (const Row& row : rows) {
    const Result result = work.run(row.arguments);
    INFO("multipatch " << row.arguments);
    CHECK(result.status == row.status);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Contains(row.message) && EndsWith("\n"));
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') <= 2);
    CHECK_THAT(result.err, !Contains("->") && !Contains("what()"));
    CHECK(work.files() == files);
    CHECK(contents(work / "old.ply") == "old");
    CHECK((contents(work / "x.cgb") == triangle()));
    fs::remove(work / "a.ply");
    fs::remove(work / "a.svg");
    work.write("x.cgb", triangle());
  }
}

TEST_CASE("What does not reach standard output is an error, unless who reads it has left") {
  const Scratch work("output");
  work.write("x.cgb", triangle());
  for (const std::string command : {"info x.cgb", "check x.cgb", "check x.cgb --json -",
                                    "exact x.cgb --samples 1", "mesh x.cgb -o a.ply", "--help"}) {
    INFO("multipatch " << command);
    if (fs::exists("/dev/full")) {
      const Result full = work.run(command, ">/dev/full");
      CHECK(full.status == 1);
      CHECK_THAT(full.err, StartsWith("multipatch: standard output: cannot be written"));
    }
    const Result closed = work.run(command, ">&-");
    CHECK(closed.status == 1);
    CHECK_THAT(closed.err, StartsWith("multipatch: standard output: cannot be written"));
    CHECK(work.run(command, "| true").err.empty());
    // As some programs start others.
    CHECK(work.run(command, "| true", "trap '' PIPE;").err.empty());
  }
  CHECK_THAT(work.run("info x.cgb", "| head -n 1 >../out").out, StartsWith("x.cgb: 3 sides"));
}
