// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the program as a user does. POSIX only.

#include "catch.h"
#include "program_fixtures.h"

#include <CGAL/Multisided_patches/internal/cgal_compat.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace program_fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

// What follows `"key": ` in a JSON text, as a number.
double number(const std::string& json, const std::string& key) {
  const std::size_t at = json.find('"' + key + "\": ");
  REQUIRE(at != std::string::npos);
  return std::stod(json.substr(at + key.size() + 4));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t result = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++result;
  return result;
}

// The 12 patches of a closed body.
std::vector<std::string> body() {
  std::vector<std::string> arguments;
  for (const auto& entry : fs::directory_iterator(MODELS_DIR "/computer_mouse"))
    arguments.push_back(" '" + entry.path().string() + "'");
  std::sort(arguments.begin(), arguments.end());
  REQUIRE(arguments.size() == 12);
  return arguments;
}

std::string joined(const std::vector<std::string>& arguments) {
  std::string result;
  for (const std::string& argument : arguments)
    result += argument;
  return result;
}

Mesh read(const fs::path& file) {
  Mesh mesh;
  std::ifstream in(file, std::ios::binary);
  REQUIRE(CGAL::IO::read_PLY(in, mesh));
  REQUIRE(CGAL::is_valid_polygon_mesh(mesh));
  return mesh;
}

// The largest angle between the normals of neighbouring triangles (degrees).
double largest_turn(const Mesh& mesh) {
  const auto normal = [&](Mesh::Halfedge_index h) {
    return CGAL::unit_normal(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                             mesh.point(mesh.target(mesh.next(h))));
  };
  double smallest = 1;
  for (const auto e : mesh.edges())
    if (!mesh.is_border(e))
      smallest = (std::min)(smallest, normal(mesh.halfedge(e, 0)) * normal(mesh.halfedge(e, 1)));
  return std::acos(smallest) * 180 / CGAL_PI;
}

} // namespace

TEST_CASE("Every example becomes a disk with the wanted number of triangles") {
  const Scratch work("examples");
  for (const Example& example : examples()) {
    INFO(example.name);
    const Result result =
        work.run("mesh " + example.argument + " -o a.ply --triangles 1000 --report a.json");
    CHECK(result.status == 0);
    CHECK_THAT(result.out, StartsWith("a.ply: ") && Contains(" triangles, "));
    CHECK((result.err.find("warning: ") != std::string::npos) == (example.name == "mixed_duct"));
    CHECK_THAT(contents(work / "a.ply"), StartsWith("ply\n"));
    const std::string json = contents(work / "a.json");
    CHECK_THAT(json, Contains("\"is_disk\": true"));
    CHECK(number(json, "vertex_deviation_relative") < 1e-14);
    CHECK(number(json, "triangles") == Approx(1000).epsilon(0.05).margin(20));
    CHECK(work.files() == std::set<std::string>{"a.ply", "a.json"});
  }
}

TEST_CASE("Half the edge length gives four times the triangles") {
  const Scratch work("edge_length");
  const std::string mesh = "mesh -q " + examples()[0].argument + " -o a.ply --report a.json";
  work.run_well(mesh);
  const double length = number(contents(work / "a.json"), "diagonal") / 20;
  work.run_well(mesh + " --edge-length " + std::to_string(length));
  const std::string coarse = contents(work / "a.json");
  work.run_well(mesh + " --edge-length " + std::to_string(length / 2));
  const std::string fine = contents(work / "a.json");
  CHECK(number(coarse, "mean_edge") == Approx(length).epsilon(0.2));
  CHECK(number(fine, "triangles") == Approx(4 * number(coarse, "triangles")).epsilon(0.15));
}

TEST_CASE("The patches of a closed body become one closed mesh, whose faces know their patch") {
  const Scratch work("closed_body");
  const std::string out =
      work.run_well("mesh" + joined(body()) + " -o a.ply --triangles 6000 --report a.json");
  CHECK_THAT(out, StartsWith("a.ply: 12 patches, 30 shared sides, 0 free sides; ") &&
                      Contains(", closed; ") && EndsWith(" s\n"));
  const Mesh mesh = read(work / "a.ply");
  CHECK(CGAL::is_closed(mesh));
  CHECK(static_cast<double>(mesh.number_of_faces()) == Approx(6000).epsilon(0.05));
  const auto patches =
      CGAL::Multisided_patches::internal::find_property_map<Mesh::Face_index, int>(mesh, "f:patch");
  REQUIRE(patches);
  const std::set<int> used(patches->begin(), patches->end());
  CHECK((used.size() == 12 && *used.begin() == 0 && *used.rbegin() == 11));

  const std::string json = contents(work / "a.json");
  CHECK(count(json, "\"input_a\": ") == 30);
  CHECK(count(json, "\"is_disk\": true") == 12);
  CHECK(count(json, "\"error_bound\": ") == 12);
  CHECK_THAT(json, Contains("\"free_sides\": []") && Contains("\"remarks\": []") &&
                       Contains("\"closed\": true") && Contains("\"target_triangles\": 6000") &&
                       Contains("\"degenerate_triangles\": 0") && Contains("\"folded_edges\": 0") &&
                       Contains("\"inverted_triangles\": 0"));
  CHECK(number(json, "euler_characteristic") == 2);
  CHECK(number(json, "vertices") == static_cast<double>(mesh.number_of_vertices()));
  CHECK(work.files() == std::set<std::string>{"a.ply", "a.json"});
}

TEST_CASE("A body without one of its patches has the sides of that for its boundary") {
  const Scratch work("open_body");
  std::vector<std::string> patches = body();
  patches.erase(patches.begin() + 3);
  const std::string out =
      work.run_well("mesh" + joined(patches) + " -o a.ply --edge-length 3 --report a.json");
  CHECK_THAT(out, StartsWith("a.ply: 11 patches, 26 shared sides, 4 free sides; ") &&
                      Contains(", not closed; "));
  const std::string json = contents(work / "a.json");
  CHECK(number(json, "boundary_loops") == 1);
  CHECK(number(json, "euler_characteristic") == 1);
  CHECK(number(json, "mean_edge") == Approx(3).epsilon(0.2));
  CHECK(!CGAL::is_closed(read(work / "a.ply")));
}

TEST_CASE("Several patches give the same bytes each time, in all formats") {
  const Scratch work("repeated_body");
  for (const std::string extension : {"ply", "obj", "off", "stl"}) {
    const std::string mesh = "mesh -q --triangles 2000" + joined(body());
    CHECK(work.run_well(mesh + " -o a." + extension).empty());
    CHECK(work.run_well(mesh + " -o b." + extension).empty());
    CHECK((contents(work / ("a." + extension)) == contents(work / ("b." + extension))));
  }
}

TEST_CASE("What keeps patches from being joined is said") {
  const Scratch work("remarks");
  work.run_well("convert -q " + examples()[0].argument + " copy.cgb"); // another file of the same
  const std::string twice = examples()[0].argument + " copy.cgb";
  const std::string mesh = "mesh " + twice + " -o a.ply --triangles 400 --report a.json";
  const Result result = work.run(mesh);
  CHECK(result.status == 0);
  CHECK_THAT(result.out, StartsWith("a.ply: 2 patches, 0 shared sides, ") && !Contains("\n  "));
  CHECK_THAT(result.err, StartsWith("multipatch: warning: ") &&
                             Contains(", but are not joined: ") &&
                             Contains("in the same direction"));
  CHECK(work.run(mesh + " -q").err.empty());
  CHECK_THAT(contents(work / "a.json"),
             Contains("in the same direction") && Contains("\"components\": 2"));
}

TEST_CASE("Deviations make a mesh finer, and can be combined with each other and edge lengths") {
  const Scratch work("deviations");
  const std::string input = "mesh -q '" MODELS_DIR "/saddle_seat.cgb' -o a.ply --report a.json ";
  work.run_well(input);
  const double diagonal = number(contents(work / "a.json"), "diagonal");
  const auto triangles = [&](const std::string& options) {
    work.run_well(input + options);
    return number(contents(work / "a.json"), "triangles");
  };
  const std::string chord = " --chordal-deviation " + std::to_string(diagonal / 2000);
  const std::string half = " --chordal-deviation " + std::to_string(diagonal / 4000);
  const std::string angle = " --normal-deviation 4";
  const std::string length = " --edge-length " + std::to_string(diagonal / 40);

  const double by_chord = triangles(chord), by_length = triangles(length);
  CHECK(triangles(half) > 1.5 * by_chord); // in theory, twice as many
  const double by_angle = triangles(angle);
  CHECK(largest_turn(read(work / "a.ply")) < 2 * 4 * 1.2); // samples are not on the edges
  CHECK(triangles(chord + angle + length) > 0.95 * (std::max)({by_chord, by_angle, by_length}));
  const std::string json = contents(work / "a.json");
  CHECK(number(json, "max_chordal_deviation") == Approx(diagonal / 2000).epsilon(1e-2));
  CHECK(number(json, "max_normal_deviation_degrees") == 4);
  CHECK(number(json, "target_edge_length") == Approx(diagonal / 40).epsilon(1e-2));
  CHECK_THAT(json, !Contains("target_triangles") && Contains("\"is_disk\": true"));
}

TEST_CASE("What goes wrong with one of several patches begins with its name, and leaves no trace") {
  const Scratch work("body_errors");
  fs::copy(MODELS_DIR "/u_vent.cgb", work / "vent.cgb");
  fs::copy(MODELS_DIR "/triangle_corner.cgb", work / "corner.cgb");
  for (const auto& [options, message] : std::vector<std::pair<std::string, std::string>>{
           {"--coordinates wachspress", "multipatch: vent.cgb: Wachspress coordinates need"},
           {"--edge-length 1e-9", "multipatch: corner.cgb: "}}) {
    const Result result = work.run("mesh corner.cgb vent.cgb -o a.ply --report a.json " + options);
    CHECK(result.status == 1);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, StartsWith(message));
    CHECK(work.files() == std::set<std::string>{"corner.cgb", "vent.cgb"});
  }
}
