// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "meshing_fixtures.h"

#include <CGAL/Multisided_patches/analysis/check_mesh.h>
#include <CGAL/Multisided_patches/meshing/is_valid_domain_mesh.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

using namespace fixtures;
using Density = MP::Mesh_density;
using Domain_mesh = MP::Domain_mesh_2<Kernel>;

namespace {

// Deviations of a surface from the mesh over a mesh of its domain, measured at 10 points or more
// inside of each triangle, most of which the mesher does not look at.
template <typename Any_patch>
class Deviations {
public:
  double chordal = 0, normal = 0; // model units, degrees

  Deviations(const Any_patch& patch, const Domain_mesh& mesh)
      : patch_(patch), mesh_(mesh), stars_(mesh.points.size()) {
    for (std::size_t k = 0; k < mesh.points.size(); ++k)
      points_.push_back(patch.point(mesh.points[k], mesh.locations[k]));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const std::size_t v : mesh.triangles[t])
        stars_[v].push_back(t);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      measure(t);
    chordal = std::sqrt(squared_);
  }

private:
  void measure(std::size_t t) {
    const int intervals =
        (std::max)(6, static_cast<int>(std::sqrt(20000 / double(mesh_.triangles.size()))));
    const auto& v = mesh_.triangles[t];
    for (int i = 1; i < intervals; ++i)
      for (int j = 1; i + j < intervals; ++j) {
        const double a = double(i) / intervals, b = double(j) / intervals;
        const Point_2 uv = CGAL::barycenter(mesh_.points[v[0]], a, mesh_.points[v[1]], b,
                                            mesh_.points[v[2]], 1 - a - b);
        const auto [point, n] = patch_.point_and_normal(uv, Location::interior());
        squared_ = (std::max)(squared_, squared_distance(point, t));
        if (n != CGAL::NULL_VECTOR)
          normal = (std::max)(normal, CGAL::approximate_angle(
                                          n, triangle(t).supporting_plane().orthogonal_vector()));
      }
  }

  Kernel::Triangle_3 triangle(std::size_t t) const {
    const auto& v = mesh_.triangles[t];
    return Kernel::Triangle_3(points_[v[0]], points_[v[1]], points_[v[2]]);
  }

  // From the triangle or, if that is farther than all so far, from those around it, too.
  double squared_distance(const Point_3& p, std::size_t t) const {
    double squared = CGAL::squared_distance(p, triangle(t));
    if (squared > squared_)
      for (const std::size_t v : mesh_.triangles[t])
        for (const std::size_t other : stars_[v])
          squared = (std::min)(squared, CGAL::squared_distance(p, triangle(other)));
    return squared;
  }

  const Any_patch& patch_;
  const Domain_mesh& mesh_;
  std::vector<Point_3> points_;
  std::vector<std::vector<std::size_t>> stars_; // the triangles around each vertex
  double squared_ = 0;
};

void check_chordal_deviation(const std::string& name, double relative) {
  CAPTURE(name, relative);
  const Patch patch(read_model(name));
  const double bound = relative * patch.loop().diagonal();
  const Domain_mesh mesh = MP::mesh_domain(patch, Density::chordal_deviation(bound));
  CHECK(MP::domain_mesh_defect(patch.domain(), mesh) == "");
  const double deviation = Deviations(patch, mesh).chordal;
  CHECK(deviation <= bound);
  // but no finer than needed, by far, unless other limits make it finer
  if (relative < 1e-3)
    CHECK(deviation > bound / 2);
}

Domain centred_square() {
  return Domain({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
}

// Two planes that meet along u = 0.1.
auto folded_patch() {
  return Formula_patch(centred_square(), [](auto u, auto v) {
    const auto w = u - 0.1;
    return std::array{u, v, w.value() < 0 ? -w : w};
  });
}

// A cone with its tip inside.
auto cone() {
  return Formula_patch(centred_square(), [](auto u, auto v) {
    const auto x = u - 0.1234567, y = v - 0.0456789;
    return std::array{u, v, sqrt(x * x + y * y)};
  });
}

} // namespace

TEST_CASE("Meshes of all example models keep to chordal deviations") {
  for (const std::string& name : model_names())
    for (const double relative : {0.1, 1e-2, 1e-3})
      check_chordal_deviation(name, relative);
}

TEST_CASE("Meshes of all example models keep to small chordal deviations") {
  for (const std::string& name : model_names())
    check_chordal_deviation(name, 1e-4);
}

TEST_CASE("Meshes keep to very small chordal deviations") {
  check_chordal_deviation("g2_blend", 1e-5);
  check_chordal_deviation("triangle_corner", 3e-5);
}

TEST_CASE("Meshes of all example models keep to normal deviations") {
  for (const std::string& name : model_names()) {
    CAPTURE(name);
    const Patch patch(read_model(name));
    for (const double angle : {60., 20., 5.}) {
      CAPTURE(angle);
      const Domain_mesh mesh = MP::mesh_domain(patch, Density::normal_deviation(angle));
      CHECK(MP::domain_mesh_defect(patch.domain(), mesh) == "");
      CHECK(Deviations(patch, mesh).normal <= angle);
    }
  }
}

TEST_CASE("The looser a bound, the fewer triangles, down to a few for each corner") {
  for (const std::string& name : model_names()) {
    CAPTURE(name);
    const Patch patch(read_model(name));
    const auto check = [&](const auto& density, std::initializer_list<double> bounds) {
      std::size_t last = (std::numeric_limits<std::size_t>::max)();
      for (const double bound : bounds) {
        CAPTURE(bound);
        const std::size_t count = MP::mesh_domain(patch, density(bound)).triangles.size();
        CHECK(count <= last);
        last = count;
      }
      CHECK(last <= 3 * patch.domain().size());
    };
    check([&](double b) { return Density::chordal_deviation(b * patch.loop().diagonal()); },
          {1e-4, 1e-3, 1e-2, 0.1, 1});
    check([&](double b) { return Density::normal_deviation(b); }, {3, 10, 30, 90});
  }
}

TEST_CASE(
    "A tenth of a deviation needs about ten times the triangles, next to reflex corners, too") {
  for (const char* name : {"l_bracket", "plus_hub", "t_junction"}) {
    CAPTURE(name);
    const Patch patch(read_model(name));
    const auto count = [&](double relative) {
      const auto density = Density::chordal_deviation(relative * patch.loop().diagonal());
      return static_cast<double>(MP::mesh_domain(patch, density).triangles.size());
    };
    CHECK(count(1e-5) == Approx(10 * count(1e-4)).epsilon(0.25));
  }
}

TEST_CASE("Halved deviations need 2 and 4 times the triangles") {
  // A part of a sphere of radius 2: chordal deviations go with the square of edge lengths, normal
  // ones with edge lengths.
  const Formula_patch patch(centred_square(), [](auto u, auto v) {
    return std::array{u, v, sqrt(4 - u * u - v * v)};
  });
  const auto count = [&](const Density& density) {
    return static_cast<double>(MP::mesh_domain(patch, density).triangles.size());
  };
  CHECK(count(Density::chordal_deviation(1e-5)) ==
        Approx(10 * count(Density::chordal_deviation(1e-4))).epsilon(0.15));
  CHECK(count(Density::normal_deviation(0.4)) ==
        Approx(9 * count(Density::normal_deviation(1.2))).epsilon(0.15));
}

TEST_CASE("Normal deviations are kept along straight sides around which a surface twists") {
  const auto check = [](const auto& patch) {
    for (const double angle : {10., 5., 2.}) {
      CAPTURE(angle);
      CHECK(Deviations(patch, MP::mesh_domain(patch, Density::normal_deviation(angle))).normal <=
            angle);
    }
  };
  check(Formula_patch(centred_square(), [](auto u, auto v) {
    return std::array{u, v, 0.5 * u * v};
  }));
  check(Patch(lifted_loop(u_shape(), bowl)));
}

TEST_CASE("Normal deviations are kept along straight sides around which a surface waves") {
  // Products of Chebyshev polynomials, which turn the faster the closer they are to the sides.
  const Formula_patch patch(centred_square(), [](auto u, auto v) {
    const auto t12 = [](const auto& x) {
      const auto t3 = 4 * x * x * x - 3 * x, t6 = 2 * t3 * t3 - 1.;
      return 2 * t6 * t6 - 1.;
    };
    return std::array{u, v, 0.02 * t12(0.97 * u) * t12(0.97 * v)};
  });
  for (const double angle : {40., 20.}) {
    CAPTURE(angle);
    const Domain_mesh mesh = MP::mesh_domain(patch, Density::normal_deviation(angle));
    CHECK(MP::domain_mesh_defect(patch.domain(), mesh) == "");
    CHECK(Deviations(patch, mesh).normal <= angle);
  }
}

TEST_CASE("Small normal deviations are kept on surfaces that twist next to reflex corners") {
  const Patch patch(read_model("twisted_handle_root"));
  for (const double angle : {3., 0.7}) {
    CAPTURE(angle);
    const Domain_mesh mesh = MP::mesh_domain(patch, Density::normal_deviation(angle));
    CHECK(MP::domain_mesh_defect(patch.domain(), mesh) == "");
    CHECK(Deviations(patch, mesh).normal <= angle);
  }
}

TEST_CASE("A surface that is not finite in a spot does not pass for a flat one") {
  const Formula_patch patch(centred_square(), [](auto u, auto v) {
    const auto x = u - 0.1234567, y = v - 0.0456789;
    const auto square = x * x + y * y;
    const double spot =
        square.value() < 0.012 * 0.012 ? std::numeric_limits<double>::quiet_NaN() : 0;
    return std::array{u, v, 0.5 * u * v + spot};
  });
  // What is not seen, because no sample is in the spot, cannot be refused.
  for (const double bound : {1e-3, 1e-4, 1e-5})
    CHECK_THROWS_AS(MP::mesh_domain(patch, Density::chordal_deviation(bound)), MP::Numerical_error);
}

// On u_vent, which is bent evenly, little is to be gained: twice the triangles deviate by 0.9
// to 1.1 of the bound.
TEST_CASE("Uniform meshes with more triangles than adaptive ones deviate more") {
  const std::vector<std::pair<const char*, double>> models{
      {"u_vent", 1.5}, {"g2_blend", 2}, {"spiral_volute", 2}, {"plus_hub", 2}};
  for (const auto& [name, factor] : models) {
    CAPTURE(name);
    const Patch patch(read_model(name));
    const double bound = 1e-4 * patch.loop().diagonal();
    const std::size_t adaptive =
        MP::mesh_domain(patch, Density::chordal_deviation(bound)).triangles.size();
    const auto count = static_cast<std::size_t>(factor * static_cast<double>(adaptive));
    const Domain_mesh uniform = MP::mesh_domain(patch, Density::triangles(count));
    CHECK(Deviations(patch, uniform).chordal > bound);
  }
}

TEST_CASE("Several bounds together are all kept") {
  const Patch patch(read_model("star_knob"));
  const double diagonal = patch.loop().diagonal(), length = 0.02 * diagonal,
               chordal = 2e-4 * diagonal;
  const auto density = Density::chordal_deviation(chordal) & Density::normal_deviation(8) & length;
  const Domain_mesh domain_mesh = MP::mesh_domain(patch, density);
  const Deviations deviations(patch, domain_mesh);
  CHECK(deviations.chordal <= chordal);
  CHECK(deviations.normal <= 8);
  Mesh mesh;
  MP::tessellate(patch, domain_mesh, mesh);
  CHECK(mean_edge_length(mesh) < 1.1 * length);
  CHECK(MP::check_mesh(mesh).longest_edge < 2.5 * length);
  // at least as fine as each of them alone, up to the scatter of counts
  for (const Density& one : {Density::chordal_deviation(chordal), Density::normal_deviation(8),
                             Density::edge_length(length)})
    CHECK(double(domain_mesh.triangles.size()) >
          0.9 * double(MP::mesh_domain(patch, one).triangles.size()));
}

TEST_CASE("An edge length that is short enough leaves nothing to do for deviations") {
  const Patch patch(read_model("u_vent"));
  const double diagonal = patch.loop().diagonal(), length = 0.02 * diagonal;
  const auto count = [&](const Density& density) {
    return static_cast<double>(MP::mesh_domain(patch, density).triangles.size());
  };
  CHECK(count(Density(length) & Density::chordal_deviation(0.1 * diagonal)) ==
        Approx(count(length)).epsilon(0.1));
}

TEST_CASE("Adaptive meshes have no sharp triangles where nothing forces them") {
  for (const char* name : {"u_vent", "g2_blend", "pentagon_cap", "triangle_corner"}) {
    CAPTURE(name);
    const Patch patch(read_model(name));
    Mesh mesh;
    MP::tessellate(patch, mesh, Density::chordal_deviation(1e-4 * patch.loop().diagonal()));
    CHECK(MP::check_mesh(mesh).smallest_angle > 20);
    CHECK(mean_smallest_angle(mesh) > 45);
  }
}

TEST_CASE("Next to reflex corners, where parameters run unevenly, sharp triangles are mended") {
  for (const char* name : {"l_bracket", "mixed_duct", "plus_hub", "star_knob", "t_junction"})
    for (const double relative : {1e-3, 1e-4}) {
      CAPTURE(name, relative);
      const Patch patch(read_model(name));
      Mesh mesh;
      MP::tessellate(patch, mesh, Density::chordal_deviation(relative * patch.loop().diagonal()));
      CHECK(MP::check_mesh(mesh).smallest_angle > 22);
    }
}

TEST_CASE(
    "Next to sides around which a surface twists, normal deviations are kept without slivers") {
  const Patch patch(read_model("twisted_handle_root"));
  for (const double degrees : {2.0, 1.0}) {
    CAPTURE(degrees);
    const Density density = Density::normal_deviation(degrees);
    CHECK(Deviations(patch, MP::mesh_domain(patch, density)).normal <= degrees);
    Mesh mesh;
    MP::tessellate(patch, mesh, density);
    const std::vector<double> angles = smallest_angles(mesh);
    const auto sharp =
        std::count_if(angles.begin(), angles.end(), [](double angle) { return angle < 20.7; });
    CHECK(1000 * static_cast<double>(sharp) < static_cast<double>(angles.size()));
  }
}

TEST_CASE("A crease or a tip keeps to chordal deviations, up to what is seen of it") {
  const auto check = [](const auto& patch) {
    const Domain_mesh mesh = MP::mesh_domain(patch, Density::chordal_deviation(3e-3));
    CHECK(Deviations(patch, mesh).chordal <= 1.2 * 3e-3);
  };
  check(folded_patch());
  check(cone());
}

TEST_CASE("A crease or a tip cannot keep to normal deviations, and the mesh stays as it was") {
  const auto check = [](const auto& patch) {
    Mesh mesh;
    MP::tessellate(patch, mesh, 1.0);
    const Triangles before = triangles(mesh);
    CHECK_THROWS_AS(MP::tessellate(patch, mesh, Density::normal_deviation(5)), MP::Accuracy_error);
    CHECK((triangles(mesh) == before));
  };
  check(cone());
  check(folded_patch());
}
