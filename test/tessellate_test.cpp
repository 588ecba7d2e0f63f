// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/analysis/boundary_deviation.h>
#include <CGAL/Multisided_patches/analysis/mesh_topology.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/Surface_mesh.h>

using namespace fixtures;
using Patch = MP::Concave_bezier_patch_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;

namespace {

double bowl(double x, double y) {
  return 0.3 * x * x - 0.2 * y * y + 0.1 * x * y;
}

// A model of MultisidedPatch_3 that has nothing to do with the package's own: a paraboloid.
class Paraboloid {
public:
  using Geom_traits = Kernel;
  using Point_2 = Kernel::Point_2;
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;

  const Domain& domain() const { return domain_; }
  Point_3 point(const Point_2& p, const Domain::Location&) const {
    return Point_3(p.x(), p.y(), p.x() * p.x() + p.y() * p.y());
  }
  std::pair<Point_3, Vector_3> point_and_normal(const Point_2& p,
                                                const Domain::Location& location) const {
    const Vector_3 n(-2 * p.x(), -2 * p.y(), 1);
    return {point(p, location), n / std::sqrt(n.squared_length())};
  }

private:
  Domain domain_{Domain(l_shape())};
};

} // namespace

TEST_CASE("A tessellated patch is one disk with its boundary on the boundary curves") {
  for (const auto& polygon : {l_shape(), u_shape(), std::vector<Point_2>{{0, 0}, {1, 0}, {0, 1}}}) {
    const Loop loop = lifted_loop(polygon, bowl);
    const Patch patch(loop);
    for (const std::size_t target : {20, 1000, 20000}) {
      const auto domain_mesh = MP::mesh_domain(patch, MP::Mesh_density::triangles(target));
      Mesh mesh;
      MP::tessellate(patch, domain_mesh, mesh);
      CHECK(MP::mesh_topology(mesh).is_disk());
      CHECK(mesh.is_valid(false));
      CHECK(MP::boundary_deviation(loop, domain_mesh, mesh).vertices <= 1e-15 * loop.diagonal());
      if (target >= 1000)
        CHECK(mesh.number_of_faces() == Approx(target).epsilon(0.02));
    }
  }
}

TEST_CASE("Edges have about the target length on the average, and none is much longer") {
  const Patch patch(lifted_loop(u_shape(), bowl));
  for (const double target : {0.3, 0.1, 0.03}) {
    Mesh mesh;
    MP::tessellate(patch, mesh, target);
    double sum = 0, longest = 0;
    for (const auto e : mesh.edges()) {
      const double length = std::sqrt(
          CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
      sum += length;
      longest = (std::max)(longest, length);
    }
    CHECK(sum / static_cast<double>(mesh.number_of_edges()) == Approx(target).epsilon(0.15));
    CHECK(longest < 2.5 * target);
  }
}

TEST_CASE("Vertices carry unit normals that fit the triangles, and their place in the domain") {
  const Patch patch(lifted_loop(l_shape(), bowl));
  Mesh mesh;
  MP::tessellate(patch, mesh, MP::Mesh_density::triangles(5000));
  const auto normal = mesh.add_property_map<Vertex, Vector_3>("v:normal").first;
  const auto u = mesh.add_property_map<Vertex, double>("v:u").first;
  const auto v = mesh.add_property_map<Vertex, double>("v:v").first;
  for (const auto f : mesh.faces()) {
    Vertex corners[3];
    auto h = mesh.halfedge(f);
    for (Vertex& c : corners) {
      c = mesh.target(h);
      h = mesh.next(h);
    }
    const Vector_3 n =
        CGAL::normal(mesh.point(corners[0]), mesh.point(corners[1]), mesh.point(corners[2]));
    for (const Vertex c : corners)
      CHECK(n * normal[c] > 0.9 * std::sqrt(n.squared_length()));
  }
  for (const Vertex w : mesh.vertices()) {
    CHECK(normal[w].squared_length() == Approx(1));
    if (!mesh.is_border(w))
      CHECK(CGAL::squared_distance(patch({u[w], v[w]}), mesh.point(w)) < 1e-24);
  }
}

TEST_CASE("Tessellation gives the same mesh in parallel and in sequence") {
  const Patch patch(lifted_loop(u_shape(), bowl));
  Mesh parallel, sequential;
  MP::tessellate<CGAL::Parallel_if_available_tag>(patch, parallel, 0.05);
  MP::tessellate<CGAL::Sequential_tag>(patch, sequential, 0.05);
  REQUIRE(parallel.number_of_vertices() == sequential.number_of_vertices());
  for (const Vertex v : parallel.vertices())
    CHECK(parallel.point(v) == sequential.point(v));
}

TEST_CASE("Two patches on the two sides of a curve get bitwise the same points on it") {
  // Neighbours across the side (1,0)-(1,1), which one runs upwards and the other downwards.
  const Loop left_loop = lifted_loop({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, bowl);
  auto ribbons = lifted_loop({{1, 0}, {2, 0}, {2, 2}, {1, 1}}, bowl).ribbons();
  std::vector<Point_3> points = left_loop[1].reversed().control_points();
  std::copy(ribbons[3].control_points().begin() + 4, ribbons[3].control_points().end(),
            points.begin() + 4);
  ribbons[3] = Ribbon(3, 2, points);
  const Patch left(left_loop), right{Loop(ribbons)};
  Mesh a, b;
  MP::tessellate(left, a, 0.013);
  MP::tessellate(right, b, 0.013);
  const auto shared_points = [](const Mesh& mesh) {
    std::vector<Point_3> shared;
    for (const Vertex v : mesh.vertices())
      if (mesh.is_border(v) && std::abs(mesh.point(v).x() - 1) < 1e-12)
        shared.push_back(mesh.point(v));
    std::sort(shared.begin(), shared.end());
    return shared;
  };
  CHECK(shared_points(a).size() > 70);
  CHECK(shared_points(a) == shared_points(b));
}

TEST_CASE("Any class with the members of a patch can be tessellated") {
  Mesh mesh;
  MP::tessellate(Paraboloid(), mesh, MP::Mesh_density::triangles(2000));
  CHECK(MP::mesh_topology(mesh).is_disk());
  for (const Vertex v : mesh.vertices()) {
    const Point_3& p = mesh.point(v);
    CHECK(p.z() == Approx(p.x() * p.x() + p.y() * p.y()));
  }
}

TEST_CASE("Tessellation adds to a mesh that already has faces") {
  const Patch patch(lifted_loop(l_shape(), bowl));
  Mesh mesh;
  MP::tessellate(patch, mesh, 0.2);
  const auto once = mesh.number_of_faces();
  MP::tessellate(patch, mesh, 0.2);
  CHECK(mesh.number_of_faces() == 2 * once);
  CHECK(MP::mesh_topology(mesh).components == 2);
  CHECK_FALSE(MP::mesh_topology(mesh).is_disk());
}

TEST_CASE("Densities that make no sense are refused, and the mesh stays as it was") {
  const Patch patch(lifted_loop(l_shape(), bowl));
  Mesh mesh;
  for (const double length : {0.0, -1.0, std::nan(""), HUGE_VAL, 1e-9, 1e-300})
    CHECK_THROWS_AS(MP::tessellate(patch, mesh, length), MP::Input_error);
  CHECK_THROWS_AS(MP::Mesh_density::triangles(0), MP::Input_error);
  CHECK_THROWS_AS(MP::Mesh_density::triangles(1000000000000), MP::Input_error);
  CHECK(mesh.number_of_vertices() == 0);
  // As coarse as it gets: no point inside, and no sample on the sides.
  MP::tessellate(patch, mesh, 1e9);
  CHECK(mesh.number_of_faces() == 4);
}
