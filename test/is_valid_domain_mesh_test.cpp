// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "polygon_fixtures.h"

#include <CGAL/Multisided_patches/meshing/is_valid_domain_mesh.h>
#include <CGAL/Multisided_patches/meshing/triangulate_domain.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <iostream>
#include <map>
#include <set>
#include <sstream>

using namespace fixtures;
using Domain_mesh = MP::Domain_mesh_2<Kernel>;

namespace {

Domain_mesh triangulate(const Domain& domain, double spacing) {
  std::vector<std::size_t> segments;
  for (std::size_t i = 0; i < domain.size(); ++i)
    segments.push_back(static_cast<std::size_t>(std::ceil(domain.side_length(i) / spacing)));
  return MP::triangulate_domain(domain, segments, spacing);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// What the checker promises but does not look at: Euler's formula, and that the triangles around a
// vertex are one fan, closed inside and open on the boundary.
void check_consequences(const Domain& domain, const Domain_mesh& mesh) {
  const std::size_t boundary = mesh.number_of_boundary_points;
  CHECK(mesh.triangles.size() ==
        2 * mesh.points.size() - boundary + 2 * domain.number_of_loops() - 4);
  std::vector<std::map<std::size_t, std::size_t>> opposite(mesh.points.size());
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      opposite[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    // from the next point on the boundary, or from any
    std::size_t start = opposite[v].begin()->first;
    std::set<std::size_t> ends;
    for (const auto& [a, b] : opposite[v])
      ends.insert(b);
    for (const auto& [a, b] : opposite[v])
      if (ends.count(a) == 0)
        start = a;
    std::size_t w = start, steps = 0;
    do {
      w = opposite[v].at(w);
      ++steps;
    } while (w != start && opposite[v].count(w) > 0);
    REQUIRE(steps == opposite[v].size());
    REQUIRE((w == start) == (v >= boundary));
  }
}

// A square of side 4 with a square hole, vertices inside, and samples 1 apart: the hole's samples
// are the vertices 16 to 23.
struct Sample {
  Domain domain{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}}};
  Domain_mesh mesh = MP::triangulate_domain(domain, {4, 4, 4, 4, 2, 2, 2, 2}, 0.4);

  std::string defect() const { return MP::domain_mesh_defect(domain, mesh); }
  std::size_t inside() const { return mesh.number_of_boundary_points; }
};

} // namespace

TEST_CASE("Meshes of all domains are valid at every spacing, and so are their consequences") {
  for (const Domain& domain : all_domains())
    for (const double spacing : {10.0, 0.3, 0.05}) {
      CAPTURE(domain.size(), spacing);
      const Domain_mesh mesh = triangulate(domain, spacing);
      CHECK(MP::domain_mesh_defect(domain, mesh) == "");
      CHECK(MP::is_valid_domain_mesh(domain, mesh));
      check_consequences(domain, mesh);
    }
}

TEST_CASE("Meshes of random domains with holes are valid") {
  const unsigned seed = 20261122;
  CAPTURE(seed);
  Random random(seed);
  for (int k = 0; k < 60; ++k) {
    CAPTURE(k);
    const Domain domain = random_domain(random, random.integer(4, 20), random.integer(0, 3));
    CHECK(MP::domain_mesh_defect(domain, triangulate(domain, random.in(0.02, 0.5))) == "");
  }
}

TEST_CASE("Meshes of domains with exact coordinates are checked") {
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using FT = Exact::FT;
  const MP::Polygonal_domain_2<Exact> domain(
      {{FT(0), FT(0)}, {FT(1), FT(0)}, {FT(1) / 3, FT(1) / 7}, {FT(0), FT(1)}});
  auto mesh = MP::triangulate_domain(domain, {5, 7, 3, 4}, 0.1);
  CHECK(MP::domain_mesh_defect(domain, mesh) == "");
  mesh.points[7] = mesh.points[7] + Exact::Vector_2(FT(1e-300), FT(0));
  CHECK(contains(MP::domain_mesh_defect(domain, mesh), "vertex 7 is not the point of side 1"));
}

TEST_CASE("A mesh of the domain without triangles, or of another domain, is not valid") {
  const Sample sample;
  CHECK_FALSE(MP::is_valid_domain_mesh(sample.domain, Domain_mesh()));
  CHECK_FALSE(MP::is_valid_domain_mesh(Domain(l_shape()), sample.mesh));
  for (const Domain& a : all_domains())
    for (const Domain& b : all_domains())
      CHECK(MP::is_valid_domain_mesh(a, triangulate(b, 0.3)) == (a.vertices() == b.vertices()));
}

TEST_CASE("The description of a defect goes to the error stream if that is wanted") {
  std::ostringstream text;
  std::streambuf* const old = std::cerr.rdbuf(text.rdbuf());
  const bool quiet = MP::is_valid_domain_mesh(Domain(square()), Domain_mesh());
  const bool silent = text.str().empty();
  const bool loud = MP::is_valid_domain_mesh(Domain(square()), Domain_mesh(), true);
  std::cerr.rdbuf(old);
  CHECK_FALSE(quiet);
  CHECK(silent);
  CHECK_FALSE(loud);
  CHECK(contains(text.str(), "vertex 0 is not vertex 0 of the domain"));
}

TEST_CASE("Sizes, indices and coordinates of a domain mesh that do not fit are found") {
  REQUIRE(Sample().defect() == "");
  REQUIRE(Sample().inside() == 24);
  REQUIRE(Sample().mesh.points.size() > 30);
  Sample s;
  SECTION("a location is missing") {
    s.mesh.locations.pop_back();
    CHECK(contains(s.defect(), "locations"));
  }
  SECTION("more boundary points than points") {
    s.mesh.number_of_boundary_points = s.mesh.points.size() + 1;
    CHECK(contains(s.defect(), "said to be on the boundary"));
  }
  SECTION("a boundary point too many") {
    ++s.mesh.number_of_boundary_points;
    CHECK(contains(s.defect(), "vertex 24 is not the next sample"));
  }
  SECTION("a boundary point too few") {
    --s.mesh.number_of_boundary_points;
    CHECK(contains(s.defect(), "vertex 23 comes after"));
  }
  SECTION("an index out of range") {
    s.mesh.triangles[3][1] = s.mesh.points.size();
    CHECK(contains(s.defect(), "triangle 3 refers to"));
  }
  SECTION("a coordinate that is not a number") {
    s.mesh.points[25] = Point_2(std::nan(""), 0);
    CHECK(contains(s.defect(), "vertex 25 is not finite"));
  }
  SECTION("an infinite coordinate") {
    s.mesh.points[2] = Point_2(0, -std::numeric_limits<double>::infinity());
    CHECK(contains(s.defect(), "vertex 2 is not finite"));
  }
}

TEST_CASE("Samples of a domain mesh that are not those of the sides are found") {
  Sample s;
  auto& points = s.mesh.points;
  auto& locations = s.mesh.locations;
  SECTION("a moved vertex of the domain") {
    points[4] = Point_2(4, std::nextafter(0.0, 1.0));
    CHECK(contains(s.defect(), "vertex 4 is not vertex 1 of the domain"));
  }
  SECTION("a moved sample") {
    points[5] = Point_2(4, std::nextafter(1.0, 2.0));
    CHECK(contains(s.defect(), "vertex 5 is not the point of side 1"));
  }
  SECTION("a sample of a hole that was moved") {
    points[17] = Point_2(std::nextafter(1.0, 2.0), 2);
    CHECK(contains(s.defect(), "vertex 17 is not the point of side 4"));
  }
  SECTION("a parameter that does not belong to the point") {
    locations[5].s = std::nextafter(locations[5].s, 1.0);
    CHECK(contains(s.defect(), "vertex 5 is not the point of side 1"));
  }
  SECTION("parameters that decrease") {
    std::swap(locations[5], locations[6]);
    std::swap(points[5], points[6]);
    CHECK(contains(s.defect(), "vertex 6 is not behind the sample before it on side 1"));
  }
  SECTION("a sample that is there twice") {
    locations[6] = locations[5];
    points[6] = points[5];
    CHECK(contains(s.defect(), "vertex 6 is not behind the sample before it on side 1"));
  }
  SECTION("parameters 0, 1 and not a number") {
    for (const double bad : {0.0, 1.0, -0.25, 1.25, std::nan("")}) {
      locations[5].s = bad;
      CHECK(contains(s.defect(), "vertex 5 is not behind"));
    }
  }
  SECTION("a sample that claims to be inside") {
    locations[5] = Domain::Location::interior();
    CHECK(contains(s.defect(), "vertex 5 is not vertex 2"));
  }
  SECTION("a sample that claims to be on another side") {
    locations[5].index = 2;
    CHECK(contains(s.defect(), "vertex 5 is not vertex 2"));
  }
  SECTION("a vertex that claims to be another") {
    locations[4].index = 2;
    CHECK(contains(s.defect(), "vertex 4 is not vertex 1"));
  }
  SECTION("a vertex that claims to be on a side") {
    locations[4] = Domain::Location::on_side(0, 1);
    CHECK_FALSE(s.defect().empty());
  }
  SECTION("a point inside that claims not to be") {
    for (const auto& location : {Domain::Location::on_vertex(0), Domain::Location::outside(),
                                 Domain::Location::on_side(7, 0.75)}) {
      locations[26] = location;
      CHECK(contains(s.defect(), "vertex 26 comes after"));
    }
  }
}

TEST_CASE("Triangles of a domain mesh that do not fit together are found, each of them") {
  const Sample valid;
  for (std::size_t t = 0; t < valid.mesh.triangles.size(); ++t) {
    CAPTURE(t);
    const std::string name = "triangle " + std::to_string(t) + " ";
    Sample s;
    auto& triangles = s.mesh.triangles;
    const auto triangle = triangles[t];
    std::swap(triangles[t][0], triangles[t][1]); // flipped
    CHECK(contains(s.defect(), name + "is not counterclockwise"));
    triangles[t] = {triangle[0], triangle[1], triangle[1]}; // degenerate
    CHECK(contains(s.defect(), name + "is not counterclockwise"));
    triangles[t] = triangle;
    triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(t)); // dropped
    CHECK(contains(s.defect(), "the edge from"));
    triangles.push_back(triangle);
    CHECK(s.defect() == ""); // the order of triangles does not matter, nor their first corners
    triangles.push_back({triangle[1], triangle[2], triangle[0]}); // twice
    CHECK(contains(s.defect(), "has two triangles on its left"));
  }
}

TEST_CASE("Points of a domain mesh that are swapped, moved, unused or merged are found") {
  Sample s;
  auto& points = s.mesh.points;
  auto& triangles = s.mesh.triangles;
  const std::size_t n = points.size(), inside = s.inside();
  SECTION("any two vertices are swapped") {
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < a; ++b) {
        std::swap(points[a], points[b]);
        CHECK_FALSE(s.defect().empty());
        std::swap(points[a], points[b]);
      }
  }
  SECTION("a point inside leaves its star") {
    for (std::size_t v = inside; v < n; ++v) {
      const Point_2 p = points[v];
      for (int k = 0; k < 8; ++k) {
        points[v] = p + Kernel::Vector_2(0.9 * std::cos(k), 0.9 * std::sin(k));
        CHECK(contains(s.defect(), "is not counterclockwise"));
      }
      points[v] = p;
    }
  }
  SECTION("a point inside moves a little, which is allowed") {
    points[inside] = points[inside] + Kernel::Vector_2(1e-3, 1e-3);
    CHECK(s.defect() == "");
  }
  SECTION("a vertex is not used") {
    points.emplace_back(0.5, 0.5);
    s.mesh.locations.push_back(Domain::Location::interior());
    CHECK(contains(s.defect(), "vertex " + std::to_string(n) + " is not used by any triangle"));
  }
  SECTION("any two vertices inside are merged") {
    for (std::size_t a = inside; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) {
        if (a == b)
          continue;
        Domain_mesh merged = s.mesh;
        for (auto& t : merged.triangles)
          std::replace(t.begin(), t.end(), a, b);
        CHECK_FALSE(MP::is_valid_domain_mesh(s.domain, merged));
      }
  }
  SECTION("a triangle is divided at a vertex that its neighbour does not know") {
    const auto t = triangles.back();
    const auto& p = points;
    const Point_2 centre = CGAL::centroid(p[t[0]], p[t[1]], p[t[2]]);
    points.push_back(centre);
    s.mesh.locations.push_back(Domain::Location::interior());
    triangles.pop_back();
    for (std::size_t k = 0; k < 3; ++k)
      triangles.push_back({t[k], t[(k + 1) % 3], n});
    CHECK(s.defect() == ""); // as all do
    triangles.pop_back();
    CHECK(contains(s.defect(), "has no triangle on its right"));
  }
}

TEST_CASE("Sheets, fans and holes that overlap a valid domain mesh are found") {
  Sample s;
  auto& triangles = s.mesh.triangles;
  const std::size_t n = s.mesh.points.size();
  SECTION("a second sheet with vertices of its own") {
    const std::size_t sheet = triangles.size();
    for (std::size_t k = 0; k < sheet; ++k)
      triangles.push_back({triangles[k][0] + n, triangles[k][1] + n, triangles[k][2] + n});
    for (std::size_t v = 0; v < n; ++v) {
      s.mesh.points.push_back(Point_2(s.mesh.points[v]));
      s.mesh.locations.push_back(Domain::Location::interior());
    }
    CHECK(contains(s.defect(), "has no triangle on its right"));
  }
  SECTION("a second fan at a vertex") {
    s.mesh.points.emplace_back(10, 10);
    s.mesh.points.emplace_back(10, 11);
    s.mesh.locations.resize(n + 2, Domain::Location::interior());
    triangles.push_back({s.inside(), n, n + 1});
    CHECK(contains(s.defect(), "has no triangle on its right"));
  }
  SECTION("the hole is filled") {
    const std::size_t first = 16;
    for (std::size_t k = first + 1; k + 1 < first + 8; ++k)
      if (CGAL::orientation(s.mesh.points[first], s.mesh.points[k + 1], s.mesh.points[k]) ==
          CGAL::LEFT_TURN)
        triangles.push_back({first, k + 1, k});
    CHECK_FALSE(s.defect().empty());
  }
  SECTION("a triangular hole is filled") {
    const Domain domain = square_with_triangular_hole();
    Domain_mesh mesh = triangulate(domain, 10);
    REQUIRE(mesh.number_of_boundary_points == 7);
    mesh.triangles.push_back({4, 6, 5});
    CHECK(contains(MP::domain_mesh_defect(domain, mesh), "but has a triangle on its right"));
  }
}

// The sides of a slot that rounding lets cross: triangles on its left and right overlap, although
// each is positive and they fit together.
TEST_CASE("A domain mesh that overlaps itself since rounded samples cross is found") {
  const unsigned seed = 20261123;
  CAPTURE(seed);
  Random random(seed);
  std::size_t crossings = 0, whole = 0;
  for (int k = 0; k < 2000; ++k) {
    const auto near_half = [&] { return 0.5 + std::ldexp(double(random.integer(0, 8)), -53); };
    const Point_2 tip(near_half(), 0.1), left(near_half(), 1), right(near_half(), 0.9);
    const std::vector<Point_2> polygon{{0, 0}, {1, 0}, {1, 1}, right, tip, left, {0, 1}};
    if (CGAL::orientation(right, tip, left) != CGAL::RIGHT_TURN ||
        !CGAL::is_simple_2(polygon.begin(), polygon.end()))
      continue;
    const Domain domain(polygon);
    Domain_mesh mesh;
    for (std::size_t i = 0; i < domain.size(); ++i)
      for (std::size_t j = 0; j < (i == 3 || i == 4 ? 8 : 1); ++j) {
        const double s = static_cast<double>(j) / 8;
        mesh.points.push_back(domain.point_on_side(i, s));
        mesh.locations.push_back(domain.location_on_side(i, s));
      }
    // right: 3, ..., tip: 11, ..., left: 19
    mesh.number_of_boundary_points = mesh.points.size();
    mesh.triangles = {{0, 1, 11}, {1, 2, 3}, {0, 19, 20}};
    for (std::size_t j = 3; j < 11; ++j)
      mesh.triangles.push_back({1, j, j + 1});
    for (std::size_t j = 11; j < 19; ++j)
      mesh.triangles.push_back({0, j, j + 1});
    const bool simple = CGAL::is_simple_2(mesh.points.begin(), mesh.points.end());
    const std::string defect = MP::domain_mesh_defect(domain, mesh);
    CHECK(simple == defect.empty());
    CHECK((simple || contains(defect, "are on the boundary, and cross or touch")));
    ++(simple ? whole : crossings);
  }
  CHECK(crossings > 10);
  CHECK(whole > 10);
}

// A hole so thin that the rounded sample on its upper side comes to lie below the lower side: what
// was the boundary of the hole runs the other way round, and the triangles there overlap.
TEST_CASE("A domain mesh with a hole that rounding turned over is found") {
  const unsigned seed = 20261125;
  CAPTURE(seed);
  Random random(seed);
  std::size_t turned = 0, whole = 0;
  for (int k = 0; k < 5000; ++k) {
    const auto near_two = [&] { return 2 + std::ldexp(double(random.integer(0, 16)), -51); };
    const Point_2 a(1, near_two()), b(3, near_two()), c(random.in(1, 3), near_two());
    if (CGAL::orientation(a, b, c) != CGAL::RIGHT_TURN)
      continue;
    const Domain domain({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{a, b, c}});
    const double s = random.in(0, 1);
    Domain_mesh mesh;
    mesh.number_of_boundary_points = 8;
    mesh.points = domain.vertices();
    mesh.points.insert(mesh.points.begin() + 5, domain.point_on_side(4, s));
    for (const std::size_t i : {0, 1, 2, 3, 4, 5, 6})
      mesh.locations.push_back(Domain::Location::on_vertex(i));
    mesh.locations.insert(mesh.locations.begin() + 5, Domain::Location::on_side(4, s));
    mesh.triangles = {{4, 5, 3}, {5, 6, 3}, {6, 2, 3}, {6, 7, 0},
                      {7, 4, 0}, {0, 1, 6}, {1, 2, 6}, {0, 4, 3}};
    const std::vector<Point_2> hole(mesh.points.begin() + 4, mesh.points.end());
    const std::string defect = MP::domain_mesh_defect(domain, mesh);
    if (!CGAL::is_simple_2(hole.begin(), hole.end())) {
      CHECK(contains(defect, "are on the boundary, and cross or touch"));
    } else if (CGAL::orientation_2(hole.begin(), hole.end()) == CGAL::CLOCKWISE) {
      CHECK(defect == "");
      ++whole;
    } else {
      CHECK(defect == "the samples of loop 1 run the wrong way round");
      ++turned;
    }
  }
  CHECK(turned > 10);
  CHECK(whole > 10);
}
