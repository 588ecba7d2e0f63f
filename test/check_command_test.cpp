// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the program as a user does. POSIX only.

#include "catch.h"
#include "program_fixtures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

using namespace program_fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

const double five_degrees = std::atan(1.) / 9;

// A square patch of degree 3 with 2 layers over [left, left + 1] x [0, 1], with height z(x, y),
// which is linear.
std::string square(double left, const std::function<double(double, double)>& z) {
  const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  out << "1\n1\n0.05\n0\n4\n0 0 0\n";
  for (std::size_t i = 0; i < 4; ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % 4], &inwards = corners[(i + 2) % 4];
    out << "3 2\n";
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 4; ++j) {
        const auto coordinate = [&](std::size_t c) {
          return a[c] + j / 3. * (b[c] - a[c]) + k / 3. * (inwards[c] - b[c]);
        };
        const double x = left + coordinate(0), y = coordinate(1);
        out << x << ' ' << y << ' ' << z(x, y) << '\n';
      }
  }
  out << "0\n";
  return out.str();
}

// A number of the last object in a JSON text with this key.
double last_max(const std::string& json, const std::string& key) {
  const std::size_t object = json.rfind('"' + key + "\": {");
  REQUIRE(object != std::string::npos);
  const std::string max = "\"max\": ";
  return std::stod(json.substr(json.find(max, object) + max.size()));
}

} // namespace

TEST_CASE("Check finds that the examples meet their ribbons, but for one of too low a degree") {
  const Scratch work("check_examples");
  for (const Example& example : examples()) {
    INFO(example.name);
    const Result result = work.run("check " + example.argument);
    CHECK_THAT(result.out, Contains("tangent plane (degrees)") && Contains("\nTolerances: "));
    if (example.name == "mixed_duct") {
      CHECK(result.status == 1);
      CHECK_THAT(result.out, Contains("  exceeded: tangent plane, curvature\n"));
      CHECK_THAT(result.err, EndsWith(" 3 of 7 sides\n"));
    } else {
      CHECK(result.status == 0);
      CHECK_THAT(result.out, !Contains("exceeded"));
    }
  }
  const std::string duct = std::string("check '") + MODELS_DIR + "/mixed_duct.cgb'";
  CHECK_THAT(work.run_well(duct + " --plane-tolerance 10 --curvature-tolerance 2"),
             Contains("  side 6 promises ") && !Contains("exceeded"));
  CHECK_THAT(work.run(duct + " --elevate").out, !Contains("exceeded: tangent plane"));
}

TEST_CASE("Check writes JSON to a file or to standard output") {
  const Scratch work("check_json");
  work.write("x.cgb", square(0, [](double, double) { return 0; }));
  const std::string json = work.run_well("check x.cgb --json -");
  CHECK_THAT(json, StartsWith("{\n  \"passed\": true,") && Contains("\"side\": 3,") &&
                       Contains("\"normal_curvature_relative\": null") && EndsWith("\n}\n"));
  CHECK_THAT(json, Contains("\"fairness\": {") && Contains("\"bending_energy\": ") &&
                       Contains("\"curvature_99\": "));
  CHECK_THAT(work.run_well("check x.cgb --json a.json"), StartsWith("x.cgb: 4 sides, diagonal "));
  CHECK((contents(work / "a.json") == json));
  CHECK(work.run_well("check x.cgb --json a.json -q --samples 1").empty());
  CHECK_THAT(contents(work / "a.json"), Contains("\"even_samples_per_side\": 1,"));
  CHECK(work.files() == std::set<std::string>{"a.json", "x.cgb"});
}

TEST_CASE("Check finds the sides that patches have in common, and how they meet there") {
  const Scratch work("check_seams");
  const auto flat = [](double, double) { return 0; };
  const auto tilted = [](double x, double) { return std::tan(five_degrees) * (x - 1); };
  work.write("a.cgb", square(0, flat));
  work.write("b.cgb", square(1, flat));
  work.write("tilted.cgb", square(1, tilted));
  work.write("gap.cgb", square(1.0001, flat));
  work.write("far.cgb", square(3, flat));

  const std::string pair = work.run_well("check a.cgb b.cgb far.cgb");
  CHECK_THAT(pair, Contains("\na.cgb side 1 and b.cgb side 3   "));
  CHECK(pair.find(" and ") == pair.rfind(" and "));
  CHECK_THAT(work.run_well("check a.cgb b.cgb --json -"),
             Contains("\"input_b\": \"b.cgb\"") && Contains("\"reversed\": true"));

  CHECK_THAT(pair, Contains("Sides: 1 pair shared exactly, 10 sides free\n") &&
                       Contains("\nMesh: ") && !Contains("gap"));

  const Result turned = work.run("check a.cgb tilted.cgb --json -");
  CHECK(turned.status == 1);
  CHECK_THAT(turned.err, Contains("1 of 9 sides"));
  CHECK_THAT(turned.out, StartsWith("{\n  \"passed\": false,"));
  CHECK(last_max(turned.out, "tangent_plane_degrees") == Approx(5).epsilon(1e-12));
  work.run_well("check a.cgb tilted.cgb --plane-tolerance 5.001");

  const Result apart = work.run("check a.cgb gap.cgb --json -");
  CHECK(apart.status == 1);
  CHECK(last_max(apart.out, "position") == Approx(1e-4).epsilon(1e-9));
  CHECK_THAT(work.run_well("check a.cgb gap.cgb --position-tolerance 1e-4"),
             Contains("  not the same curve: a mesh has a gap here\n") &&
                 Contains("Sides: 0 pairs shared exactly, 8 "));
}

TEST_CASE(
    "Check prints a line for each pair of common sides, and for those that run alike the why") {
  const Scratch work("check_table");
  const auto flat = [](double, double) { return 0; };
  for (int k = 0; k < 4; ++k)
    work.write(std::to_string(k) + ".cgb", square(k, flat));
  const std::string row = work.run_well("check 0.cgb 1.cgb 2.cgb 3.cgb");
  const std::size_t table = row.find("\ncommon sides ");
  REQUIRE(table != std::string::npos);
  const std::string lines = row.substr(table, row.find("\nSides: ") - table);
  CHECK(std::count(lines.begin(), lines.end(), '\n') == 4);
  for (int k = 0; k < 3; ++k)
    CHECK_THAT(lines, Contains('\n' + std::to_string(k) + ".cgb side 1 and " +
                               std::to_string(k + 1) + ".cgb side 3  "));

  work.write("copy.cgb", square(0, flat));
  const Result twice = work.run("check 0.cgb copy.cgb");
  CHECK_THAT(twice.out, Contains("\n0.cgb side 0 and copy.cgb side 0  ") && !Contains("gap") &&
                            Contains("0.cgb side 0 and copy.cgb side 0 have the same curve") &&
                            Contains("in the same direction"));
}

namespace {

// A tetrahedron, of which the faces and its last point may be changed.
std::string off(const std::string& faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
                const std::string& last = "0 0 1") {
  return "OFF\n4 " + std::to_string(std::count(faces.begin(), faces.end(), '\n')) +
         " 0\n0 0 0\n1 0 0\n0 1 0\n" + last + '\n' + faces;
}

} // namespace

TEST_CASE("Check takes the meshes that the command mesh writes, in all formats") {
  const Scratch work("check_meshes");
  const std::string vent = MODELS_DIR "/u_vent.cgb";
  std::string all;
  for (const std::string extension : {"ply", "obj", "off", "STL"}) {
    const std::string name = "a." + extension;
    work.run_well("mesh -q '" + vent + "' -o " + name + " --triangles 500");
    const std::string line = work.run_well("check " + name);
    CHECK_THAT(line, StartsWith(name + ": ") &&
                         Contains(", 1 component, 1 boundary loop, Euler characteristic 1; ") &&
                         Contains("; 0 self-intersections, 0 degenerate triangles, 0 folded"));
    // The others have no normals, or they are not read.
    const bool has_normals = extension == "ply" || extension == "off";
    CHECK((line.find(", 0 inverted triangles\n") != std::string::npos) == has_normals);
    all += ' ' + name;
  }
  work.write("closed.off", off());
  CHECK_THAT(work.run_well("check closed.off"),
             StartsWith("closed.off: 4 triangles, 1 component, closed, Euler characteristic 2; "));
  CHECK_THAT(work.run_well("check closed.off --json -"),
             StartsWith("{\n  \"passed\": true,\n  \"failures\": [],\n  \"meshes\": [") &&
                 Contains("\"input\": \"closed.off\"") && Contains("\"closed\": true") &&
                 Contains("\"self_intersections\": 0") && EndsWith("\n}\n"));
  CHECK(work.run_well("check -q --json a.json" + all).empty());
  const std::string json = contents(work / "a.json");
  CHECK_THAT(json, Contains("\"input\": \"a.STL\"") && Contains("\"euler_characteristic\": 1"));
}

TEST_CASE("Check finds what is wrong with a mesh") {
  const Scratch work("check_bad_meshes");
  work.write("flat.off", off("3 0 2 1\n3 0 1 3\n", "2 0 0"));
  work.write("fold.off", off("3 0 1 2\n3 1 0 3\n", "0.1 0.9 0"));
  work.write("book.off", off("3 0 1 2\n3 1 0 3\n3 0 1 3\n"));
  work.write("turned.off", off("3 0 1 2\n3 0 1 3\n"));
  work.write("twice.off", off("3 0 1 1\n"));
  work.write("square.off", off("4 0 1 2 3\n"));
  work.write("none.off", off(""));
  work.write("index.off", off("3 0 1 4\n"));
  work.write("cut.off", off().substr(0, 40));
  work.write("nan.off", off("3 0 1 3\n", "0 nan 0"));
  work.write("junk.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n");
  work.write("junk.stl", "nothing of the kind");
  work.write("inverted.off", "NOFF\n3 1 0\n0 0 0 0 0 -1\n1 0 0 0 0 -1\n0 1 0 0 0 -1\n3 0 1 2\n");
  work.write("crossing.off",
             "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n.2 .2 -1\n.2 .2 1\n.3 .2 1\n3 0 1 2\n3 3 4 5\n");
  const std::pair<std::string, std::string> rows[] = {
      {"flat.off", "the mesh has 1 degenerate triangle\n"},
      {"fold.off", "the mesh has 1 folded edge\n"},
      {"book.off", "the triangles make no mesh: more than two triangles meet at 1 edge\n"},
      {"turned.off", "the triangles on the two sides of 1 edge turn opposite ways\n"},
      {"twice.off", "a triangle has vertex 1 twice\n"},
      {"square.off", "face 0 has 4 corners; triangles were expected\n"},
      {"none.off", "expected triangles, found none\n"},
      {"index.off", "index.off: "},
      {"cut.off", "cut.off: cannot be read"},
      {"nan.off", "nan.off: "},
      {"junk.ply", "tells of more elements 'vertex' than the file has bytes\n"},
      {"junk.stl", "junk.stl: "},
      {"inverted.off", "the mesh has 1 inverted triangle\n"},
      {"crossing.off", "the mesh has 1 self-intersection\n"}};
  for (const auto& [name, message] : rows) {
    INFO(name);
    const Result result = work.run("check " + name);
    CHECK(result.status == 1);
    CHECK_THAT(result.err, StartsWith("multipatch: " + name + ": ") && Contains(message));
  }
  work.write("good.off", off());
  const Result several = work.run("check good.off book.off fold.off --json -");
  CHECK(several.status == 1);
  CHECK_THAT(several.err, Contains("book.off: the triangles") && Contains("; fold.off: the mesh"));
  CHECK_THAT(several.out, StartsWith("{\n  \"passed\": false,") && Contains("\"mesh\": null"));
}

TEST_CASE("Check finds that a closed body is closed") {
  const Scratch work("check_body");
  std::string inputs;
  for (const auto& entry : fs::directory_iterator(MODELS_DIR "/computer_mouse"))
    inputs += " '" + entry.path().string() + "'";
  const std::string table = work.run_well("check --json a.json" + inputs);
  CHECK_THAT(table, Contains("Sides: 30 pairs shared exactly, 0 sides free\n") &&
                        Contains(" triangles, 1 component, closed, Euler characteristic 2; ") &&
                        Contains("; 0 self-intersections, ") && !Contains("gap"));
  const std::string json = contents(work / "a.json");
  std::size_t seams = 0;
  for (std::size_t at = json.find("\"exact\": true"); at != std::string::npos;
       at = json.find("\"exact\": true", at + 1))
    ++seams;
  CHECK(seams == 30);
  CHECK_THAT(json, StartsWith("{\n  \"passed\": true,\n  \"failures\": [],") &&
                       Contains("\"free_sides\": []") && Contains("\"closed\": true") &&
                       Contains("\"is_as_joined\": true") && Contains("\"self_intersections\": 0"));
}

TEST_CASE("Patches that touch at a corner do not intersect") {
  const Scratch work("check_corner");
  const std::string body = MODELS_DIR "/computer_mouse/";
  work.run_well("check -q '" + body + "bottom_left.cgb' '" + body + "rear_right.cgb'");
}

TEST_CASE("Check fails if the mesh intersects itself") {
  const Scratch work("check_intersections");
  const double slope = 1;
  work.write("a.cgb", square(0, [](double, double) { return 0; }));
  work.write("b.cgb", square(0, [=](double x, double) { return slope * (x - 0.5); }));
  const Result result = work.run("check a.cgb b.cgb --mesh-triangles 200 --json a.json");
  CHECK(result.status == 1);
  CHECK_THAT(result.err,
             StartsWith("multipatch: the mesh has ") && EndsWith(" self-intersections\n"));
  CHECK_THAT(result.out, Contains("\nMesh: ") && Contains("\n  the mesh has "));
  CHECK_THAT(contents(work / "a.json"), StartsWith("{\n  \"passed\": false,"));
}

TEST_CASE("What keeps check from its work is said before it starts") {
  const Scratch work("check_errors");
  work.write("x.cgb", square(0, [](double, double) { return 0; }));
  CHECK_THAT(work.run_well("--help"), Contains("check"));
  CHECK_THAT(work.run_well("check --help"), Contains("Usage: ") && Contains("--json"));
  work.write("bad.cgb", "1\n1\n0.05\n0\nthree\n");
  fs::create_directory(work / "directory.json");
  const std::set<std::string> files = work.files();
  struct Row {
    std::string arguments;
    int status;
    std::string message;
  };
  for (const Row& row :
       {Row{"x.cgb missing.cgb", 1, "missing.cgb: cannot be opened for reading: No such"},
        Row{"x.cgb bad.cgb --json a.json", 1, "bad.cgb:5: "},
        Row{std::string("x.cgb --coordinates wachspress '") + MODELS_DIR + "/u_vent.cgb'", 1,
            "u_vent.cgb: Wachspress coordinates need"},
        Row{"x.cgb --json directory.json", 1, "directory.json: cannot be written"},
        Row{"x.cgb --json no/a.json", 1, "no/a.json: cannot be opened"},
        Row{"x.cgb --json ./x.cgb", 2, "x.cgb: cannot be written"},
        Row{"x.cgb --plane-tolerance nan", 2, "not nan"},
        Row{"x.cgb --position-tolerance -1", 2, "a number of at least 0, not -1\n"},
        Row{"x.cgb --curvature-tolerance much", 2, "much"},
        Row{"x.foo", 2, "x.foo: expected a name that ends in .cgb, .gbp or .patch.json, or"},
        Row{"x.cgb missing.ply", 2, "not both at a time"},
        Row{"missing.ply --samples 3", 2, "--samples: is for patches, not for meshes"},
        Row{"missing.ply", 1, "missing.ply: cannot be opened"}, Row{"x.cgb --samples 0", 2, "0"},
        Row{"x.cgb --mesh-triangles 0", 2, "0"}, Row{"", 2, "INPUT"}}) {
    INFO("multipatch check " << row.arguments);
    const Result result = work.run("check " + row.arguments);
    CHECK(result.status == row.status);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Contains(row.message));
    CHECK(work.files() == files);
  }
}
