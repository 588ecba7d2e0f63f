// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"
#include "io_fixtures.h"

#include <CGAL/Multisided_patches/IO/surface_mesh.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;

namespace {

Mesh l_shaped_mesh() {
  const auto height = [](double x, double y) { return std::sin(x) * y / 3; };
  Mesh mesh;
  MP::tessellate(MP::Concave_bezier_patch_3<Kernel>(lifted_loop(l_shape(), height)), mesh,
                 MP::Mesh_density::triangles(2500));
  return mesh;
}

template <typename T>
auto vertex_map(const Mesh& mesh, const std::string& name) {
  return MP::internal::find_property_map<Vertex, T>(mesh, name);
}

} // namespace

TEST_CASE("A .ply mesh is read back as it was, with its normals and domain points") {
  const Scratch_directory directory;
  const Mesh mesh = l_shaped_mesh();
  const Global_locale locale(GENERATE(std::locale(), decimal_comma));
  MP::IO::write_mesh(directory / "mesh.PLY", mesh);
  for (const std::string property : {"x", "y", "z", "nx", "ny", "nz", "u", "v"})
    CHECK_THAT(contents(directory / "mesh.PLY"), Contains("\nproperty double " + property + "\n"));

  Mesh again;
  std::ifstream in(directory / "mesh.PLY", std::ios::binary);
  in.imbue(std::locale::classic());
  REQUIRE(CGAL::IO::read_PLY(in, again));
  REQUIRE(again.number_of_vertices() == mesh.number_of_vertices());
  CHECK(again.number_of_faces() == mesh.number_of_faces());
  CHECK(std::equal(mesh.points().begin(), mesh.points().end(), again.points().begin()));
  const auto same = [&](const auto& a, const auto& b) {
    REQUIRE((a && b));
    return std::equal(a->begin(), a->end(), b->begin());
  };
  CHECK(same(vertex_map<Vector_3>(mesh, "v:normal"), vertex_map<Vector_3>(again, "v:normal")));
  for (const std::string name : {"v:u", "v:v"})
    CHECK(same(vertex_map<double>(mesh, name), vertex_map<double>(again, name)));
}

TEST_CASE("Text formats of meshes give the same doubles back, with normals") {
  const Scratch_directory directory;
  const Mesh mesh = l_shaped_mesh();
  const auto normals = vertex_map<Vector_3>(mesh, "v:normal");
  const std::size_t n = mesh.number_of_vertices();
  {
    const Global_locale locale(GENERATE(std::locale(), decimal_comma));
    MP::IO::write_mesh(directory / "mesh.off", mesh);
    MP::IO::write_mesh(directory / "mesh.obj", mesh);
  }
  const auto reads = [](std::istream& in, const auto& p) {
    double x = 0, y = 0, z = 0;
    return in >> x >> y >> z && x == p.x() && y == p.y() && z == p.z();
  };
  std::ifstream off(directory / "mesh.off"), obj(directory / "mesh.obj");
  std::string header;
  std::size_t vertices = 0, faces = 0, edges = 0, equal_vertices = 0;
  off >> header >> vertices >> faces >> edges;
  CHECK(header == "NOFF");
  CHECK(vertices == n);
  CHECK(faces == mesh.number_of_faces());
  for (const Vertex v : mesh.vertices())
    equal_vertices += reads(off, mesh.point(v)) && reads(off, (*normals)[v]);
  CHECK(equal_vertices == n);

  // Programs use the normals only if the faces name them: f 1//1 2//2 3//3.
  std::size_t points = 0, directions = 0, equal = 0, faces_with_normals = 0;
  for (std::string line; std::getline(obj, line);) {
    std::istringstream words(line);
    std::string key, corner;
    words >> key;
    if (key == "v")
      equal += reads(words, mesh.point(Vertex(static_cast<unsigned>(points++))));
    else if (key == "vn")
      equal += reads(words, (*normals)[Vertex(static_cast<unsigned>(directions++))]);
    else if (key == "f" && words >> corner)
      faces_with_normals += corner.find("//" + corner.substr(0, corner.find('/'))) + 1 > 1;
  }
  CHECK(points == n);
  CHECK(directions == n);
  CHECK(equal == 2 * n);
  CHECK(faces_with_normals == mesh.number_of_faces());
}

TEST_CASE("A mesh without normals is written without them") {
  const Scratch_directory directory;
  Mesh mesh;
  mesh.add_face(mesh.add_vertex(Point_3(0, 0, 0)), mesh.add_vertex(Point_3(1, 0, 0)),
                mesh.add_vertex(Point_3(0, 1 / 3.0, 0)));
  for (const std::string extension : {"ply", "obj", "off", "stl"}) {
    MP::IO::write_mesh(directory / ("mesh." + extension), mesh);
    for (const std::string normals : {"NOFF", "nx", "vn", "//"})
      CHECK_THAT(contents(directory / ("mesh." + extension)), !Contains(normals));
  }
  CHECK(fs::file_size(directory / "mesh.stl") == 84 + 50);
}

TEST_CASE("A mesh is not written under a name that says no format") {
  const Scratch_directory directory;
  for (const std::string name : {"mesh", "mesh.", "mesh.foo", "ply", ".ply", "mesh.ply.gz"}) {
    CHECK_THROWS_AS(MP::IO::write_mesh(directory / name, Mesh()), MP::Input_error);
    CHECK_THROWS_WITH(MP::IO::mesh_format(name), StartsWith(name + ": expected a name that ends"));
  }
  CHECK_THROWS_AS(MP::IO::write_mesh(directory / "no/mesh.ply", Mesh()), MP::Error);
  CHECK(directory.files().empty());
}
