// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "meshing_fixtures.h"

#include <CGAL/Multisided_patches/meshing/sample_side.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/meshing/tessellate_complex.h>
#include <memory>

#include <CGAL/Polyhedron_3.h>

#include <limits>
#include <memory>
#include <stdexcept>

using namespace fixtures;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Face = Mesh::Face_index;
using Stage = MP::Tessellation_stage;

namespace {

// Throws at the tenth vertex.
struct Throwing_map {
  using key_type = Vertex;
  using value_type = Point_2;
  using reference = Point_2;
  using category = boost::writable_property_map_tag;
  friend void put(const Throwing_map& map, key_type, const Point_2&) {
    if (++*map.calls == 10)
      throw std::runtime_error("no more");
  }
  std::shared_ptr<int> calls = std::make_shared<int>(0);
};

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

// A sphere of radius 75 around the origin, as a graph, with normals that point outwards.
auto cap() {
  return Formula_patch(Domain({{-20, -30}, {30, -20}, {25, 30}, {-25, 20}}), [](auto u, auto v) {
    return std::array{u, v, sqrt(75 * 75 - u * u - v * v)};
  });
}

// Over the L and with two holes; sides are in planes.
auto plane_with_holes() {
  return Formula_patch(
      Domain({{0, 0}, {3, 0}, {3, 3}, {0, 3}},
             {{{0.5, 1}, {0.5, 2}, {1, 2}, {1, 1}}, {{2, 1}, {1.5, 2.5}, {2.5, 2.5}}}),
      [](auto u, auto v) {
        return std::array{u, v, 0.1 * u * v};
      });
}

// Every border edge has the number of its side, and no other halfedge has one; a side has an edge
// more than samples inside.
template <typename Any_patch>
void check_sides(const Any_patch& patch, double edge_length) {
  CAPTURE(edge_length);
  Mesh mesh;
  const auto sides = mesh.add_property_map<Halfedge, std::size_t>("h:side", none).first;
  MP::tessellate(patch, mesh, edge_length, MP::Mesh_maps().halfedge_side_map(sides));
  std::vector<std::size_t> counts(patch.domain().size(), 0);
  bool is_on_border = true;
  for (const Halfedge h : mesh.halfedges()) {
    is_on_border = is_on_border && (sides[h] != none) == mesh.is_border(mesh.opposite(h));
    if (sides[h] != none)
      ++counts.at(sides[h]);
  }
  CHECK(is_on_border);
  MP::Side_sampling rule;
  rule.max_edge_length = edge_length;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    CHECK(counts[i] == MP::sample_side(patch, i, rule).size() + 1);
    // from one corner of the domain to the next
    const auto corner = [&](std::size_t k) {
      return patch.point(patch.domain().vertex(k), Location::on_vertex(k));
    };
    std::size_t starts = 0, ends = 0;
    for (const Halfedge h : mesh.halfedges())
      if (sides[h] == i) {
        starts += mesh.point(mesh.source(h)) == corner(i);
        ends += mesh.point(mesh.target(h)) == corner(patch.domain().next(i));
      }
    CHECK(starts == 1);
    CHECK(ends == 1);
  }
}

} // namespace

TEST_CASE("Normals and parameters of vertices are those of the patch") {
  const auto patch = cap();
  Mesh mesh;
  const auto normals = mesh.add_property_map<Vertex, Vector_3>("v:n").first;
  const auto uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
  MP::tessellate(patch, mesh, 3.0, MP::Mesh_maps().vertex_normal_map(normals).vertex_uv_map(uv));
  for (const Vertex v : mesh.vertices()) {
    const Point_3& p = mesh.point(v);
    CHECK((normals[v] - (p - CGAL::ORIGIN) / 75).squared_length() < 1e-28);
    CHECK(std::abs(uv[v].x() - p.x()) + std::abs(uv[v].y() - p.y()) < 1e-13);
  }
  // nothing that was not asked for
  CHECK_FALSE((mesh.property_map<Vertex, Vector_3>("v:normal").second));
  CHECK_FALSE((mesh.property_map<Vertex, double>("v:u").second));
}

TEST_CASE("Curvatures of vertices are those of the patch") {
  Mesh mesh;
  const auto mean = mesh.add_property_map<Vertex, double>("v:mean").first;
  const auto gaussian = mesh.add_property_map<Vertex, double>("v:gaussian").first;
  const auto maps =
      MP::Mesh_maps().vertex_mean_curvature_map(mean).vertex_Gaussian_curvature_map(gaussian);
  MP::tessellate(cap(), mesh, 3.0, maps);
  for (const Vertex v : mesh.vertices()) {
    CHECK(mean[v] == Approx(-1. / 75).epsilon(1e-12));
    CHECK(gaussian[v] == Approx(1. / 75 / 75).epsilon(1e-12));
  }

  // A patch of the package's own that approximates a sphere of radius 75.
  Mesh other;
  const auto mean_of_patch = other.add_property_map<Vertex, double>("v:mean", 0).first;
  MP::tessellate(Patch(read_model("pentagon_cap")), other, MP::Mesh_density::triangles(2000),
                 MP::Mesh_maps().vertex_mean_curvature_map(mean_of_patch));
  std::vector<double> inside;
  for (const Vertex v : other.vertices())
    if (!other.is_border(v))
      inside.push_back(std::abs(mean_of_patch[v]) * 75);
  std::sort(inside.begin(), inside.end());
  CHECK(inside[inside.size() / 2] == Approx(1).epsilon(0.1));
  CHECK(inside.front() > 0.3);
  CHECK(inside.back() < 3);
}

TEST_CASE("There is no curvature where a surface has none") {
  // The parameters stand still at u = 0, which is a side.
  const Formula_patch patch(Domain({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), [](auto u, auto v) {
    return std::array{u * u, v, 0.1 * v * v};
  });
  Mesh mesh;
  const auto mean = mesh.add_property_map<Vertex, double>("v:mean").first;
  const MP::Mesh_density density(0.1);
  MP::tessellate(patch, mesh, density, MP::Mesh_maps().vertex_mean_curvature_map(mean));
  for (const Vertex v : mesh.vertices())
    CHECK(std::isnan(mean[v]) == (mesh.point(v).x() == 0));
}

TEST_CASE("Halfedges on the border know their sides") {
  for (const double length : {1000.0, 10.0, 2.0})
    check_sides(cap(), length);
  for (const double length : {10.0, 0.3, 0.05})
    check_sides(plane_with_holes(), length);
  const Patch patch(lifted_loop(u_shape(), bowl));
  for (const double length : {10.0, 0.3, 0.05})
    check_sides(patch, length);
}

TEST_CASE("A Polyhedron_3 gets the same from any property maps") {
  const auto patch = plane_with_holes();
  std::map<Polyhedron::Vertex_handle, Vector_3> normals;
  std::map<Polyhedron::Vertex_handle, Point_2> uv;
  std::map<Polyhedron::Halfedge_handle, std::size_t> sides;
  std::map<Polyhedron::Facet_handle, std::size_t> patches;
  Polyhedron polyhedron;
  MP::tessellate(patch, polyhedron, 0.3,
                 MP::Mesh_maps()
                     .vertex_normal_map(boost::make_assoc_property_map(normals))
                     .vertex_uv_map(boost::make_assoc_property_map(uv))
                     .halfedge_side_map(boost::make_assoc_property_map(sides))
                     .face_patch_map(boost::make_assoc_property_map(patches)));
  Mesh mesh;
  MP::tessellate(patch, mesh, 0.3);
  const auto n = mesh.property_map<Vertex, Vector_3>("v:normal").first;
  const auto u = mesh.property_map<Vertex, double>("v:u").first;
  REQUIRE(polyhedron.size_of_vertices() == mesh.number_of_vertices());
  auto w = polyhedron.vertices_begin();
  for (const Vertex v : mesh.vertices()) {
    CHECK(normals.at(w) == n[v]);
    CHECK(uv.at(w).x() == u[v]);
    ++w;
  }
  std::size_t border = 0;
  for (const Halfedge h : mesh.halfedges())
    border += mesh.is_border(h);
  CHECK(sides.size() == border);
  CHECK(patches.size() == mesh.number_of_faces());
  for (const auto& [face, index] : patches)
    CHECK(index == 0);
}

TEST_CASE("Faces of a complex know their patch, and its halfedges the sides of their patches") {
  const MP::Patch_complex<Patch> complex(make_patches(computer_mouse()));
  Mesh mesh;
  const auto patch = mesh.add_property_map<Face, std::size_t>("f:p", none).first;
  const auto side = mesh.add_property_map<Halfedge, std::size_t>("h:s", none).first;
  const auto normal = mesh.add_property_map<Vertex, Vector_3>("v:n").first;
  const auto maps =
      MP::Mesh_maps().face_patch_map(patch).halfedge_side_map(side).vertex_normal_map(normal);
  MP::tessellate(complex, mesh, MP::Mesh_density::triangles(3000), maps);

  // The sides that patches share, as the mesh has it: pairs of (patch, side), each way round.
  using Side = std::pair<std::size_t, std::size_t>;
  std::map<Side, std::vector<Side>> neighbours;
  for (const Halfedge h : mesh.halfedges()) {
    const Halfedge o = mesh.opposite(h);
    const std::size_t a = patch[mesh.face(h)], b = patch[mesh.face(o)];
    REQUIRE(a < complex.patches().size());
    REQUIRE((side[h] != none) == (a != b));
    REQUIRE((side[h] != none) == (side[o] != none));
    if (side[h] != none)
      neighbours[{a, side[h]}].push_back({b, side[o]});
  }
  CHECK(neighbours.size() == 2 * complex.shared_sides().size());
  for (const MP::Shared_side& s : complex.shared_sides())
    for (const auto& other : neighbours[{s.patch_a, s.side_a}])
      CHECK((other == Side(s.patch_b, s.side_b)));

  for (const Vertex v : mesh.vertices())
    CHECK(normal[v].squared_length() == Approx(1));

  // by default, too
  Mesh plain;
  MP::tessellate(complex, plain, MP::Mesh_density::triangles(3000));
  const auto [patch_of_face, has_patches] = plain.property_map<Face, int>("f:patch");
  REQUIRE(has_patches);
  for (const Face f : plain.faces())
    REQUIRE(static_cast<std::size_t>(patch_of_face[f]) == patch[f]);
}

// ------------------------------------------------------------------------------------- visitors

namespace {

// Notes what it hears, and wants to stop at a call.
struct Recorder {
  struct Call {
    Stage stage;
    std::size_t done, total;
  };
  std::size_t stop_at = none;
  std::vector<Call> calls = {};

  bool go_further(Stage stage, std::size_t done, std::size_t total) {
    calls.push_back({stage, done, total});
    return calls.size() <= stop_at;
  }
};

std::vector<std::string> property_names(const Mesh& mesh) {
  std::vector<std::string> names = mesh.properties<Vertex>();
  for (const std::string& name : mesh.properties<Face>())
    names.push_back(name);
  return names;
}

// What is heard of a whole run. Meshing and evaluation take turns while a mesh is refined.
template <typename Any>
std::size_t check_progress(const Any& patch_or_complex, const MP::Mesh_density& density) {
  Recorder recorder;
  Mesh mesh;
  MP::tessellate(patch_or_complex, mesh, density, MP::Default_maps(), recorder);
  const auto& calls = recorder.calls;
  REQUIRE(calls.size() >= 3);
  CHECK(calls.front().stage == Stage::meshing);
  CHECK(calls[calls.size() - 2].stage == Stage::evaluation);
  CHECK(calls.back().stage == Stage::assembly);
  CHECK(std::count_if(calls.begin(), calls.end(),
                      [](const auto& call) { return call.stage == Stage::assembly; }) == 1);
  for (const auto& call : calls) {
    CAPTURE(static_cast<int>(call.stage), call.done, call.total);
    CHECK(call.done <= call.total);
  }
  CHECK(calls.back().total >= mesh.number_of_vertices());
  return calls.size();
}

// A mesh with faces stays as it was, whenever the visitor cancels.
template <typename Any>
void check_cancelling(const Any& patch_or_complex, const MP::Mesh_density& density) {
  const std::size_t calls = check_progress(patch_or_complex, density);
  Mesh mesh;
  MP::tessellate(cap(), mesh, 20, MP::Mesh_maps());
  mesh.remove_vertex(mesh.add_vertex());
  const Triangles before = triangles(mesh);
  const std::size_t vertices = mesh.number_of_vertices(), edges = mesh.number_of_edges();
  const auto names = property_names(mesh);
  for (const std::size_t k :
       {std::size_t(0), std::size_t(1), calls / 3, calls / 2, calls - 2, calls - 1}) {
    CAPTURE(calls, k);
    Recorder recorder{k};
    CHECK_THROWS_AS(MP::tessellate(patch_or_complex, mesh, density, MP::Default_maps(), recorder),
                    MP::Cancelled);
    CHECK(recorder.calls.size() == k + 1); // not asked again
    CHECK((triangles(mesh) == before));
    CHECK(mesh.number_of_vertices() == vertices);
    CHECK(mesh.number_of_removed_vertices() == 1);
    CHECK(mesh.number_of_edges() == edges);
    CHECK(mesh.is_valid(false));
    CHECK(property_names(mesh) == names);
  }
  // One that never wants to stop changes nothing.
  Recorder patient{calls};
  CHECK_NOTHROW(MP::tessellate(patch_or_complex, mesh, density, MP::Default_maps(), patient));
  CHECK(mesh.number_of_faces() > before.size());
}

} // namespace

TEST_CASE("A visitor hears of all stages in order and can cancel any of them") {
  const Patch patch(lifted_loop(u_shape(), bowl));
  for (const auto& density :
       {MP::Mesh_density(0.03), MP::Mesh_density::triangles(5000),
        MP::Mesh_density::chordal_deviation(1e-3), MP::Mesh_density::chordal_deviation(1e-2) & 0.1})
    check_cancelling(patch, density);
}

TEST_CASE("What a visitor hears of coarse and of narrow meshes is no more than there is") {
  const Patch patch(lifted_loop(u_shape(), bowl));
  for (const double length : {100.0, 1.0, 0.3})
    check_progress(patch, length);
  const Formula_patch strip(Domain({{0, 0}, {100, 0}, {100, 0.1}, {0, 0.1}}), [](auto u, auto v) {
    return std::array{u, v, u * v};
  });
  check_progress(strip, 0.1);
}

TEST_CASE("A visitor hears of a complex and can cancel it") {
  const auto models = computer_mouse();
  const MP::Patch_complex<Patch> complex(make_patches({models.begin(), models.begin() + 4}));
  for (const auto& density : {MP::Mesh_density(4), MP::Mesh_density::triangles(2000),
                              MP::Mesh_density::chordal_deviation(0.1)})
    check_cancelling(complex, density);
}

TEST_CASE("A map that throws leaves a mesh that is whole") {
  const Patch patch(lifted_loop(u_shape(), bowl));
  Mesh mesh, expected;
  CHECK_THROWS_AS(MP::tessellate(patch, mesh, 0.3, MP::Mesh_maps().vertex_uv_map(Throwing_map())),
                  std::runtime_error);
  MP::tessellate(patch, expected, 0.3, MP::Mesh_maps());
  CHECK(mesh.is_valid(false));
  CHECK((triangles(mesh) == triangles(expected)));
}
