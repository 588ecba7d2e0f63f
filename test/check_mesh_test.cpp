// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/analysis/check_mesh.h>
#include <CGAL/Multisided_patches/analysis/self_intersections.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <map>

using namespace fixtures;
using MP::internal::pi;

namespace {

using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Triangles = std::vector<std::array<std::size_t, 3>>;

template <typename Mesh>
Mesh make_mesh(const std::vector<Point_3>& points, const Triangles& triangles) {
  Mesh mesh;
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> handles;
  for (const Point_3& p : points) {
    handles.push_back(add_vertex(mesh));
    get(CGAL::vertex_point, mesh)[handles.back()] = p;
  }
  for (const auto& t : triangles)
    REQUIRE(CGAL::Euler::add_face(std::array{handles[t[0]], handles[t[1]], handles[t[2]]}, mesh) !=
            boost::graph_traits<Mesh>::null_face());
  return mesh;
}

// A grid of m × n squares in two triangles each: a torus if it closes in both directions.
struct Grid {
  std::vector<Point_3> points;
  Triangles triangles;

  Grid(std::size_t m, std::size_t n, bool close_m, bool close_n, double scale = 1) {
    const std::size_t rows = m + !close_m, columns = n + !close_n;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j) {
        const double a = 2 * pi * double(i) / double(m), b = 2 * pi * double(j) / double(n);
        // a band or a torus around the z axis, or a plane
        const double r = 3 + (close_m ? std::cos(a) : 0), z = close_m ? std::sin(a) : a;
        const double x = close_n ? r * std::cos(b) : b, y = close_n ? r * std::sin(b) : 0;
        points.emplace_back(scale * x, scale * y, scale * z);
      }
    const auto vertex = [&](std::size_t i, std::size_t j) {
      return (i % rows) * columns + j % columns;
    };
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
        triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)});
      }
  }
  Surface_mesh mesh() const { return make_mesh<Surface_mesh>(points, triangles); }
};

const Triangles tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
std::vector<Point_3> regular_tetrahedron(double scale) {
  return {{scale, scale, scale},
          {-scale, scale, -scale},
          {scale, -scale, -scale},
          {-scale, -scale, scale}};
}

void check_topology(const MP::Mesh_topology& topology, std::size_t components, std::size_t loops,
                    long euler_characteristic) {
  CHECK(topology.components == components);
  CHECK(topology.boundary_loops == loops);
  CHECK(topology.euler_characteristic == euler_characteristic);
  CHECK(topology.is_closed() == (loops == 0));
}

} // namespace

TEST_CASE("A regular tetrahedron of any size is measured") {
  for (const double scale : {1.0, 1e-150, 1e-100, 1e100, 1e150}) {
    CAPTURE(scale);
    const auto mesh = make_mesh<Surface_mesh>(regular_tetrahedron(scale), tetrahedron);
    const MP::Mesh_check check = MP::check_mesh(mesh);
    check_topology(check, 1, 0, 2);
    CHECK(check.vertices == 4);
    CHECK(check.edges == 6);
    CHECK(check.triangles == 4);
    CHECK(check.degenerate_triangles == 0);
    CHECK(check.folded_edges == 0);
    CHECK_FALSE(check.inverted_triangles);
    CHECK(check.patches.empty());
    CHECK(check.has_one_component_per_patch());
    CHECK(check.smallest_angle == Approx(60).epsilon(1e-14));
    CHECK(check.largest_angle == Approx(60).epsilon(1e-14));
    CHECK(check.shortest_edge == Approx(std::sqrt(8) * scale).epsilon(1e-15));
    CHECK(check.longest_edge == Approx(std::sqrt(8) * scale).epsilon(1e-15));
    // Its normals make angles of 109.47 degrees.
    CHECK(MP::check_mesh(mesh, CGAL::parameters::default_values(), 109.4).folded_edges == 6);
    CHECK(MP::check_mesh(mesh, CGAL::parameters::default_values(), 109.5).folded_edges == 0);
    CHECK(MP::number_of_self_intersections(mesh) == 0);
  }
}

TEST_CASE("Disks, annuli, tori and several components are told apart") {
  check_topology(MP::check_mesh(Grid(3, 4, false, false).mesh()), 1, 1, 1);
  check_topology(MP::check_mesh(Grid(3, 12, false, true).mesh()), 1, 2, 0);
  check_topology(MP::check_mesh(Grid(8, 12, true, true).mesh()), 1, 0, 0);
  CHECK(MP::mesh_topology(Grid(3, 4, false, false).mesh()).is_disk());
  CHECK_FALSE(MP::mesh_topology(Grid(8, 12, true, true).mesh()).is_disk());

  Surface_mesh mesh = Grid(8, 12, true, true).mesh();
  mesh += Grid(3, 4, false, false).mesh();
  mesh += Grid(3, 12, false, true).mesh();
  check_topology(MP::check_mesh(mesh), 3, 3, 1);
  mesh.add_vertex(Point_3(9, 9, 9));
  check_topology(MP::check_mesh(mesh), 4, 3, 2);
  // removed elements do not count
  CGAL::Euler::remove_face(mesh.halfedge(*mesh.faces_begin()), mesh);
  check_topology(MP::check_mesh(mesh), 4, 4, 1);
  CHECK(mesh.has_garbage());
  CHECK(MP::check_mesh(mesh).triangles == mesh.number_of_faces());

  check_topology(MP::check_mesh(Surface_mesh()), 0, 0, 0);
  CHECK(MP::check_mesh(Surface_mesh()).smallest_angle == 0);
}

TEST_CASE("Triangles that share only a vertex are not a disk") {
  const auto mesh = make_mesh<Surface_mesh>(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  check_topology(MP::mesh_topology(mesh), 2, 2, 2);
  CHECK_FALSE(MP::mesh_topology(mesh).is_disk());
}

TEST_CASE("Polyhedron_3 and Surface_mesh are measured alike") {
  const Grid torus(8, 12, true, true), band(3, 12, false, true), plane(2, 3, false, false);
  for (const Grid& grid : {torus, band, plane}) {
    const MP::Mesh_check a = MP::check_mesh(grid.mesh());
    const auto polyhedron = make_mesh<Polyhedron>(grid.points, grid.triangles);
    const MP::Mesh_check b = MP::check_mesh(polyhedron);
    check_topology(b, a.components, a.boundary_loops, a.euler_characteristic);
    CHECK(a.vertices == b.vertices);
    CHECK(a.edges == b.edges);
    CHECK(a.triangles == b.triangles);
    CHECK(a.smallest_angle == Approx(b.smallest_angle).epsilon(1e-13));
    CHECK(a.largest_angle == Approx(b.largest_angle).epsilon(1e-13));
    CHECK(a.shortest_edge == Approx(b.shortest_edge).epsilon(1e-15));
    CHECK(a.longest_edge == Approx(b.longest_edge).epsilon(1e-15));
    CHECK(MP::number_of_self_intersections(polyhedron) == 0);
  }
}

TEST_CASE("Degenerate triangles are found at any size, and only they") {
  for (const double scale : {1.0, 1e-150, 1e150}) {
    CAPTURE(scale);
    const auto check = [&](const Point_3& p) {
      return MP::check_mesh(make_mesh<Surface_mesh>(
          {{0, 0, 0}, {scale, scale, 0}, {0, 3 * scale, scale}, p}, {{0, 1, 2}, {1, 0, 3}}));
    };
    const MP::Mesh_check collinear = check({scale / 2, scale / 2, 0});
    CHECK(collinear.degenerate_triangles == 1);
    CHECK(collinear.folded_edges == 0);
    CHECK(collinear.smallest_angle == 0);
    CHECK(collinear.largest_angle == 180);

    const MP::Mesh_check coincident = check({0, 0, 0});
    CHECK(coincident.degenerate_triangles == 1);
    CHECK(coincident.shortest_edge == 0);

    // as thin as can be: its angles are 2^-53 / sqrt(2) at the base, nearly
    const MP::Mesh_check thin = check({scale / 2, std::nextafter(scale / 2, 0.0), 0});
    CHECK(thin.degenerate_triangles == 0);
    CHECK(thin.smallest_angle > 0);
    CHECK(thin.smallest_angle < 1e-13);
    CHECK(thin.largest_angle > 179.99);
  }
}

TEST_CASE("Angles of thin triangles are accurate, not merely small") {
  // tan of the angle at the far end is h exactly
  for (const double h : {1e-3, 1e-9, 1e-15, 1e-100, 1e-140}) {
    CAPTURE(h);
    const auto mesh = make_mesh<Surface_mesh>({{0, 0, 0}, {1, 0, 0}, {0, h, 0}}, {{0, 1, 2}});
    const MP::Mesh_check check = MP::check_mesh(mesh);
    CHECK(check.degenerate_triangles == 0);
    CHECK(check.smallest_angle == Approx(std::atan(h) * 180 / pi).epsilon(1e-14));
    CHECK(check.largest_angle == Approx(90).epsilon(1e-14));
  }
}

TEST_CASE("Triangles that are folded over are found") {
  for (const double scale : {1.0, 1e-150, 1e150}) {
    CAPTURE(scale);
    Grid grid(4, 4, false, false, scale);
    CHECK(MP::check_mesh(grid.mesh()).folded_edges == 0);
    CHECK(MP::number_of_self_intersections(grid.mesh()) == 0);
    // The vertex in the middle moves over a far edge of its star: two of its six triangles turn
    // over, and all edges between them and others are folded.
    Point_3& p = grid.points[12];
    p = p + Vector_3(-2 * scale, 0, 1 * scale);
    const Surface_mesh mesh = grid.mesh();
    const MP::Mesh_check check = MP::check_mesh(mesh);
    CHECK(check.folded_edges > 0);
    CHECK(check.degenerate_triangles == 0);
    CHECK(MP::number_of_self_intersections(mesh) > 0);

    // All vertex normals are those of the plane, to the left of which the others lie.
    std::size_t turned = 0;
    for (const auto& t : grid.triangles)
      turned += CGAL::cross_product((grid.points[t[1]] - grid.points[t[0]]) / scale,
                                    (grid.points[t[2]] - grid.points[t[0]]) / scale)
                    .y() > 0;
    CHECK(turned > 0);
    CHECK(turned < 6);
    Surface_mesh with_normals = mesh;
    auto normals = with_normals
                       .add_property_map<Surface_mesh::Vertex_index, Vector_3>(
                           "v:normal", Vector_3(0, -1e-200, 0))
                       .first;
    const auto parameters = CGAL::parameters::vertex_normal_map(normals);
    CHECK(MP::check_mesh(with_normals, parameters).inverted_triangles == turned);
    // One vertex normal on its side is enough for a triangle not to be inverted.
    for (const auto v : with_normals.vertices())
      normals[v] = Vector_3(0, v.idx() == 12 ? 1 : -1, 0);
    CHECK(MP::check_mesh(with_normals, parameters).inverted_triangles == 0u);
  }
}

TEST_CASE("The angle of a fold is that between normals") {
  for (const double angle : {1., 30., 89., 91., 149., 151., 179., 179.99}) {
    CAPTURE(angle);
    const double t = angle * pi / 180;
    const auto mesh = make_mesh<Surface_mesh>(
        {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -std::cos(t), std::sin(t)}},
        {{0, 1, 2}, {1, 0, 3}});
    CHECK(MP::check_mesh(mesh).folded_edges == (angle > 150 ? 1 : 0));
    const auto none = CGAL::parameters::default_values();
    CHECK(MP::check_mesh(mesh, none, angle - 1e-3).folded_edges == 1);
    CHECK(MP::check_mesh(mesh, none, (std::min)(angle + 1e-3, 179.999)).folded_edges == 0);
  }
}

TEST_CASE("Intersections of distant parts of a mesh are found") {
  const std::vector<Point_3> points{{0, 0, 0},  {4, 0, 0}, {0, 4, 0},
                                    {1, 1, -1}, {1, 1, 1}, {2, 1, 1}};
  const Triangles apart{{0, 1, 2}, {3, 4, 5}};
  CHECK(MP::number_of_self_intersections(make_mesh<Surface_mesh>(points, apart)) == 1);
  for (const double scale : {1e-150, 1e150}) {
    std::vector<Point_3> scaled;
    for (const Point_3& p : points)
      scaled.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
    CHECK(MP::number_of_self_intersections(make_mesh<Surface_mesh>(scaled, apart)) == 1);
  }
  // a torus whose tube is wider than its hole
  Grid fat(16, 24, true, true);
  for (Point_3& p : fat.points) {
    const double r = std::hypot(p.x(), p.y()), f = (r - 2.5) / r;
    p = Point_3(f * p.x(), f * p.y(), p.z());
  }
  CHECK(MP::number_of_self_intersections(Grid(16, 24, true, true).mesh()) == 0);
  CHECK(MP::number_of_self_intersections(fat.mesh()) > 100);
  // A degenerate triangle is not one.
  CHECK(MP::number_of_self_intersections(
            make_mesh<Surface_mesh>({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}})) == 0);
}

TEST_CASE("Every patch of a mesh is counted as a surface of its own") {
  // A torus in three strips around the tube: two annuli and one that lacks a square.
  Surface_mesh mesh = Grid(9, 12, true, true).mesh();
  auto patch = mesh.add_property_map<Surface_mesh::Face_index, int>("f:patch", 0).first;
  for (const auto f : mesh.faces())
    patch[f] = 10 * (static_cast<int>(f.idx()) / (3 * 2 * 12));
  const auto parameters = CGAL::parameters::face_patch_map(patch);
  MP::Mesh_check check = MP::check_mesh(mesh, parameters);
  REQUIRE(check.patches.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    check_topology(check.patches[k], 1, 2, 0);
    CHECK(check.patches[k].patch == 10 * k);
    CHECK(check.patches[k].faces == 72);
  }
  CHECK(check.has_one_component_per_patch());

  // a square in the middle of one patch that belongs to another
  patch[Surface_mesh::Face_index(24)] = patch[Surface_mesh::Face_index(25)] = 20;
  check = MP::check_mesh(mesh, parameters);
  check_topology(check.patches[0], 1, 3, -1);
  check_topology(check.patches[1], 1, 2, 0);
  check_topology(check.patches[2], 2, 3, 1);
  CHECK(check.patches[2].faces == 74);
  CHECK_FALSE(check.has_one_component_per_patch());

  // Two triangles that share only a vertex are two pieces. What they leave of the first annulus is
  // an annulus again, since one of them has a vertex on its boundary.
  patch[Surface_mesh::Face_index(24)] = patch[Surface_mesh::Face_index(50)] = 7;
  patch[Surface_mesh::Face_index(25)] = 0;
  check = MP::check_mesh(mesh, parameters);
  REQUIRE(check.patches.size() == 4);
  CHECK(check.patches[1].patch == 7);
  check_topology(check.patches[0], 1, 2, 0);
  check_topology(check.patches[1], 2, 2, 2);
  check_topology(check.patches[3], 1, 2, 0);
  check_topology(check, 1, 0, 0);
}

TEST_CASE("Patches of a Polyhedron_3 are those of a Surface_mesh") {
  const unsigned seed = 20261124;
  CAPTURE(seed);
  Random random(seed);
  const Grid grid(6, 8, true, true);
  Surface_mesh a = grid.mesh();
  auto b = make_mesh<Polyhedron>(grid.points, grid.triangles);
  const auto patch_a = a.add_property_map<Surface_mesh::Face_index, std::size_t>("f:patch").first;
  std::map<Polyhedron::Face_handle, std::size_t> patch_of;
  for (int k = 0; k < 50; ++k) {
    std::map<std::array<Point_3, 3>, std::size_t> patches;
    const auto key = [](const auto& mesh, auto f) {
      std::array<Point_3, 3> corners;
      std::size_t i = 0;
      for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
        corners[i++] = get(CGAL::vertex_point, mesh, v);
      std::sort(corners.begin(), corners.end());
      return corners;
    };
    for (const auto f : a.faces())
      patches[key(a, f)] = patch_a[f] = random.integer(1, 4);
    for (const auto f : faces(b))
      patch_of[f] = patches.at(key(b, f));
    const auto pa = MP::patch_topologies(a, patch_a);
    const auto pb = MP::patch_topologies(b, boost::make_assoc_property_map(patch_of));
    REQUIRE(pa.size() == pb.size());
    std::size_t total = 0;
    for (std::size_t i = 0; i < pa.size(); ++i) {
      CHECK(pa[i].patch == pb[i].patch);
      CHECK(pa[i].faces == pb[i].faces);
      check_topology(pb[i], pa[i].components, pa[i].boundary_loops, pa[i].euler_characteristic);
      // a surface with handles: chi = 2 components - 2 handles - loops
      CHECK(pa[i].euler_characteristic <=
            2 * static_cast<long>(pa[i].components) - static_cast<long>(pa[i].boundary_loops));
      CHECK((pa[i].euler_characteristic - static_cast<long>(pa[i].boundary_loops)) % 2 == 0);
      total += pa[i].faces;
    }
    CHECK(total == a.number_of_faces());
  }
}

TEST_CASE("Meshes that cannot be measured are refused with a reason") {
  Surface_mesh quad;
  const auto a = quad.add_vertex({0, 0, 0}), b = quad.add_vertex({1, 0, 0}),
             c = quad.add_vertex({1, 1, 0}), d = quad.add_vertex({0, 1, 0});
  quad.add_face(a, b, c, d);
  CHECK_THROWS_WITH(MP::check_mesh(quad),
                    "face 0 of the mesh has 4 corners; triangles were expected");
  check_topology(MP::mesh_topology(quad), 1, 1, 1);

  auto points = regular_tetrahedron(1);
  const auto mesh = make_mesh<Surface_mesh>(points, tetrahedron);
  points[2] = Point_3(0, std::nan(""), 0);
  CHECK_THROWS_WITH(MP::check_mesh(make_mesh<Surface_mesh>(points, tetrahedron)),
                    "vertex 2 of the mesh is not finite");
  for (const double angle : {0.0, 180.0, -1.0, std::nan("")})
    CHECK_THROWS_AS(MP::check_mesh(mesh, CGAL::parameters::default_values(), angle),
                    MP::Input_error);
}
