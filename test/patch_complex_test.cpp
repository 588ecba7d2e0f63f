// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "meshing_fixtures.h"

#include <CGAL/Multisided_patches/analysis/check_mesh.h>
#include <CGAL/Multisided_patches/analysis/self_intersections.h>
#include <CGAL/Multisided_patches/meshing/Patch_complex.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/meshing/tessellate_complex.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>

#include <limits>

using namespace fixtures;
using Complex = MP::Patch_complex<Patch>;
using Density = MP::Mesh_density;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Catch::Contains;

namespace {

// The same patch with its sides numbered from another one.
Model rotated(Model model, std::size_t by) {
  std::vector<Ribbon> ribbons = model.loop.ribbons();
  std::rotate(ribbons.begin(), ribbons.begin() + static_cast<std::ptrdiff_t>(by), ribbons.end());
  model.loop = Loop(std::move(ribbons));
  return model;
}

// The same boundary run the other way, so that normals point to the other side.
Model turned_over(Model model) {
  std::vector<Ribbon> ribbons;
  for (std::size_t i = model.loop.size(); i-- > 0;)
    ribbons.push_back(model.loop[i].reversed());
  model.loop = Loop(std::move(ribbons));
  return model;
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : triangles(mesh))
    sum += CGAL::volume(Point_3(0, 0, 0), t[0], t[1], t[2]);
  return sum;
}

Mesh tessellated(const Complex& complex, const Density& density) {
  Mesh mesh;
  MP::tessellate(complex, mesh, density);
  return mesh;
}

void check_closed_body(const Mesh& mesh) {
  CHECK(mesh.is_valid(false));
  CHECK(CGAL::is_closed(mesh));
  const auto patches = mesh.property_map<Mesh::Face_index, int>("f:patch").first;
  const MP::Mesh_check check = MP::check_mesh(mesh, CGAL::parameters::face_patch_map(patches));
  CHECK(check.components == 1);
  CHECK(check.euler_characteristic == 2);
  CHECK(check.patches.size() == 12);
  for (const MP::Patch_topology& patch : check.patches)
    CHECK(patch.is_disk());
  CHECK(check.degenerate_triangles == 0);
  CHECK(check.folded_edges == 0);
  CHECK(MP::number_of_self_intersections(mesh) == 0);
}

// Two quadrilaterals or so on either side of a common boundary.
Complex pillow(std::size_t n) {
  std::vector<Point_2> polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * MP::internal::pi * double(i) / double(n);
    polygon.emplace_back(std::cos(t), std::sin(t));
  }
  const auto dome = [](double x, double y) { return 1 - x * x - y * y; };
  const Model upper = lifted_loop(polygon, dome);
  const Model below = turned_over(upper);
  std::vector<Ribbon> lower;
  for (const Ribbon& r : below.loop.ribbons()) {
    std::vector<Point_3> points = r.control_points();
    for (std::size_t k = r.degree() + 1; k < points.size(); ++k) {
      const Point_3 &p = points[k], &on_boundary = points[k - r.degree() - 1];
      points[k] = Point_3(p.x(), p.y(), 2 * on_boundary.z() - p.z());
    }
    lower.emplace_back(r.degree(), r.layers(), points);
  }
  return Complex({Patch(upper), Patch(Loop(lower))});
}

std::vector<std::array<std::size_t, 4>> ids(const std::vector<MP::Shared_side>& sides) {
  std::vector<std::array<std::size_t, 4>> result;
  for (const MP::Shared_side& s : sides)
    result.push_back({s.patch_a, s.side_a, s.patch_b, s.side_b});
  return result;
}

} // namespace

TEST_CASE("The computer mouse is meshed to a closed body at every density") {
  const Complex complex(make_patches(computer_mouse()), model_names("computer_mouse"));
  CHECK(complex.shared_sides().size() == 30);
  CHECK(complex.number_of_free_sides() == 0);
  CHECK(complex.remarks().empty());
  for (const auto& density : {Density(1e9), Density(10), Density(4), Density::triangles(3000),
                              Density::chordal_deviation(0.2)}) {
    const Mesh mesh = tessellated(complex, density);
    CAPTURE(mesh.number_of_faces());
    // 36 triangles are all too few for the shape.
    if (mesh.number_of_faces() > 100)
      check_closed_body(mesh);
    CHECK(CGAL::is_closed(mesh));
    Polyhedron polyhedron;
    MP::tessellate(complex, polyhedron, density);
    CHECK(polyhedron.is_valid());
    CHECK(polyhedron.is_closed());
    CHECK((triangles(polyhedron) == triangles(mesh)));
  }
}

TEST_CASE("Complexes have the wanted number of triangles, to 5 percent") {
  const Complex complex(make_patches(computer_mouse()));
  for (const std::size_t target : {2000, 20000})
    CHECK(tessellated(complex, Density::triangles(target)).number_of_faces() ==
          Approx(target).epsilon(0.05));
}

TEST_CASE("The triangles of a complex do not depend on the order of its patches") {
  const unsigned seed = 20261130;
  CAPTURE(seed);
  Random random(seed);
  std::vector<Patch> patches = make_patches(computer_mouse());
  for (const auto& density : {Density(8), Density::chordal_deviation(0.5)}) {
    const Triangles expected = sorted_triangles(tessellated(Complex(patches), density));
    for (int k = 0; k < 3; ++k) {
      CAPTURE(k);
      for (std::size_t i = patches.size(); i-- > 1;)
        std::swap(patches[i], patches[random.integer(0, i)]);
      CHECK((sorted_triangles(tessellated(Complex(patches), density)) == expected));
    }
  }
}

TEST_CASE("A body stays closed however its patches and their sides are numbered") {
  const unsigned seed = 20261201;
  CAPTURE(seed);
  Random random(seed);
  const std::vector<Model> models = computer_mouse();
  const double expected_volume =
      volume(tessellated(Complex(make_patches(models)), Density::triangles(4000)));
  for (int k = 0; k < 6; ++k) {
    CAPTURE(k);
    const bool inside_out = k % 2 == 1;
    std::vector<Model> changed;
    for (const Model& model : models) {
      const Model same = inside_out ? turned_over(model) : model;
      changed.push_back(rotated(same, random.integer(0, same.loop.size() - 1)));
    }
    for (std::size_t i = changed.size(); i-- > 1;)
      std::swap(changed[i], changed[random.integer(0, i)]);
    const Complex complex(make_patches(changed));
    CHECK(complex.shared_sides().size() == 30);
    CHECK(complex.number_of_free_sides() == 0);
    CHECK(complex.remarks().empty());
    const Mesh mesh = tessellated(complex, Density::triangles(4000));
    check_closed_body(mesh);
    CHECK(volume(mesh) == Approx(inside_out ? -expected_volume : expected_volume).epsilon(0.01));
  }
}

TEST_CASE("A patch that is inside out is not joined to the others, and remarks say so") {
  std::vector<Model> models = computer_mouse();
  const std::size_t sides = models[3].loop.size();
  models[3] = turned_over(models[3]);
  const Complex complex(make_patches(models), model_names("computer_mouse"));
  CHECK(complex.shared_sides().size() == 30 - sides);
  CHECK(complex.number_of_free_sides() == 2 * sides);
  REQUIRE(complex.remarks().size() == sides);
  for (const std::string& remark : complex.remarks()) {
    CHECK_THAT(remark, Contains(complex.names()[3]));
    CHECK_THAT(remark, Contains("inside out"));
  }
  const MP::Mesh_topology topology = MP::mesh_topology(tessellated(complex, 10));
  CHECK(topology.components == 2);
  CHECK(topology.boundary_loops == 2);
}

TEST_CASE("Every two patches share alone the sides that they share among others") {
  const std::vector<Patch> patches = make_patches(computer_mouse());
  const Complex complex(patches);
  for (std::size_t a = 0; a < patches.size(); ++a)
    for (std::size_t b = a + 1; b < patches.size(); ++b) {
      std::vector<std::array<std::size_t, 4>> expected, swapped;
      for (const auto& s : ids(complex.shared_sides()))
        if (s[0] == a && s[2] == b) {
          expected.push_back({0, s[1], 1, s[3]});
          swapped.push_back({0, s[3], 1, s[1]});
        }
      std::sort(swapped.begin(), swapped.end());
      CHECK(ids(Complex({patches[a], patches[b]}).shared_sides()) == expected);
      CHECK(ids(Complex({patches[b], patches[a]}).shared_sides()) == swapped);
    }
}

TEST_CASE("Patches that share nothing are meshed side by side") {
  const Patch patch(lifted_loop(l_shape(), bowl));
  const Patch other(lifted_loop({{5, 0}, {6, 0}, {6, 1}}, bowl));
  const Complex complex({patch, other});
  CHECK(complex.shared_sides().empty());
  CHECK(complex.number_of_free_sides() == 9);
  CHECK(complex.remarks().empty());
  CHECK(complex.names() == std::vector<std::string>{"patch 0", "patch 1"});
  const Mesh mesh = tessellated(complex, 0.2);
  CHECK(MP::mesh_topology(mesh).components == 2);
  Mesh one_by_one;
  MP::tessellate(patch, one_by_one, 0.2);
  MP::tessellate(other, one_by_one, 0.2);
  CHECK((triangles(mesh) == triangles(one_by_one)));
}

TEST_CASE("A complex may have one patch or none") {
  const Patch patch(lifted_loop(l_shape(), bowl));
  Mesh alone;
  MP::tessellate(patch, alone, 0.2);
  CHECK((triangles(tessellated(Complex({patch}), 0.2)) == triangles(alone)));

  const Complex empty({});
  CHECK(empty.number_of_free_sides() == 0);
  for (const auto& density :
       {Density(0.1), Density::triangles(100), Density::chordal_deviation(0.1)})
    CHECK(tessellated(empty, density).number_of_faces() == 0);
}

TEST_CASE("The same patch twice is not joined to itself") {
  const Patch patch(lifted_loop(l_shape(), bowl));
  const Complex complex({patch, patch}, {"left", "right"});
  CHECK(complex.shared_sides().empty());
  REQUIRE(complex.remarks().size() == 6);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK_THAT(complex.remarks()[i],
               Contains("left side " + std::to_string(i) + " and right side " + std::to_string(i)));
}

TEST_CASE("A third patch on a curve is not joined, and a remark says so") {
  const auto patch = [](const std::vector<Point_2>& polygon) {
    return Patch(lifted_loop(polygon, [](double, double) { return 0.; }));
  };
  const Complex complex({patch({{0, 0}, {1, 0}, {1, 1}}), patch({{1, 0}, {2, 0.5}, {1, 1}}),
                         patch({{1, 0}, {3, 0.5}, {1, 1}})});
  CHECK(ids(complex.shared_sides()) == std::vector<std::array<std::size_t, 4>>{{0, 1, 1, 2}});
  REQUIRE(complex.remarks().size() == 1);
  CHECK_THAT(complex.remarks()[0], Contains("a third side"));
}

TEST_CASE("Patches that share their whole boundary are meshed to a closed body") {
  for (const std::size_t n : {3, 4, 5}) {
    const Complex complex = pillow(n);
    CHECK(complex.shared_sides().size() == n);
    for (const double length : {1.0, 0.3, 0.1, 0.03}) {
      CAPTURE(n, length);
      Mesh mesh;
      CHECK_NOTHROW(MP::tessellate(complex, mesh, length));
      CHECK(CGAL::is_closed(mesh));
      CHECK(MP::mesh_topology(mesh).euler_characteristic == 2);
    }
  }
}

TEST_CASE("A side that a patch shares with itself is joined") {
  // A tube whose cross section is a loop: the sides at u = -1 and u = 1 are the same line.
  const Formula_patch tube(Domain({{-1, 0}, {1, 0}, {1, 1}, {-1, 1}}),
                           [](const auto& u, const auto& v) {
                             const auto x = 1 - u * u, y = u * (1 - u * u);
                             return std::array{x, y, v};
                           });
  const MP::Patch_complex<std::decay_t<decltype(tube)>> complex({tube});
  REQUIRE(complex.shared_sides().size() == 1);
  for (const double length : {0.5, 0.1, 0.02}) {
    CAPTURE(length);
    Mesh mesh;
    MP::tessellate(complex, mesh, Density(length));
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    // A cylinder has the Euler characteristic 0, and two circles for a border.
    CHECK(mesh.number_of_vertices() + mesh.number_of_faces() == mesh.number_of_edges());
    std::vector<Mesh::Halfedge_index> circles;
    CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(circles));
    CHECK(circles.size() == 2);
  }
}

TEST_CASE("Errors carry the name of the patch, and the mesh stays as it was") {
  // Smooth, with a crease, or with a hole in its values, next to a smooth one.
  const auto patch = [](double x, int kind) {
    return Formula_patch(
        Domain({{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}), [x, kind](auto u, auto v) {
          const auto w = u - x - 0.4;
          using T = std::decay_t<decltype(u)>;
          const bool is_inside = w.value() * w.value() < 0.01 && std::abs(v.value() - 0.5) < 0.1;
          const T nothing(std::numeric_limits<double>::quiet_NaN());
          return std::array<T, 3>{u, v,
                                  kind == 1                ? (w.value() < 0 ? -w : w)
                                  : kind == 2 && is_inside ? nothing
                                                           : 0.1 * u * v};
        });
  };
  using Any = decltype(patch(0, 0));
  const auto message = [&](int kind, const Density& density) -> std::string {
    Mesh mesh;
    MP::tessellate(patch(7, 0), mesh, 0.5, MP::Mesh_maps());
    const Triangles before = triangles(mesh);
    const MP::Patch_complex<Any> complex({patch(0, 0), patch(1, kind), patch(2, kind)},
                                         {"smooth", "second", "third"});
    std::string text = "none";
    try {
      MP::tessellate(complex, mesh, density);
    } catch (const MP::Error& error) {
      text = error.what();
    }
    CHECK((triangles(mesh) == before));
    return text;
  };
  using Catch::StartsWith;
  CHECK_THAT(message(1, Density::normal_deviation(5)), StartsWith("second: "));
  CHECK_THAT(message(2, Density(0.1)), StartsWith("second: ") && Contains("not finite"));
  CHECK_THAT(message(0, Density(1e-9)), StartsWith("smooth: ") && Contains("limit"));
  std::vector<Patch> patches = make_patches(computer_mouse());
  CHECK_THROWS_WITH(tessellated(Complex(patches), 1e-9), StartsWith("patch 0: "));
}
