// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "polygon_fixtures.h"

#include <CGAL/Multisided_patches/meshing/is_valid_domain_mesh.h>
#include <CGAL/Multisided_patches/meshing/triangulate_domain.h>

#include <array>
#include <limits>

using namespace fixtures;
using Domain_mesh = MP::Domain_mesh_2<Kernel>;

namespace {

// The angle below which triangles are refined, where the boundary is not in the way (degrees).
constexpr double sharp = 20.7;

std::vector<std::size_t> segments(const Domain& domain, double spacing) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < domain.size(); ++i)
    result.push_back(static_cast<std::size_t>(std::ceil(domain.side_length(i) / spacing)));
  return result;
}

Domain_mesh triangulate(const Domain& domain, double spacing, int sweeps = 0) {
  return MP::triangulate_domain(domain, segments(domain, spacing), spacing, sweeps);
}

// degrees
double smallest_angle(const Domain_mesh& mesh, const std::array<std::size_t, 3>& t) {
  double smallest = pi;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
    const auto b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
    smallest = (std::min)(smallest, std::atan2(a.x() * b.y() - a.y() * b.x(), a * b));
  }
  return smallest * 180 / pi;
}

double smallest_angle(const Domain_mesh& mesh) {
  double smallest = 180;
  for (const auto& t : mesh.triangles)
    smallest = (std::min)(smallest, smallest_angle(mesh, t));
  return smallest;
}

// Whether no sharp triangle is farther from the boundary than the length of its longest edge.
bool are_sharp_triangles_near_boundary(const Domain& domain, const Domain_mesh& mesh) {
  for (const auto& t : mesh.triangles)
    if (smallest_angle(mesh, t) <= sharp) {
      double longest = 0, distance = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < 3; ++k) {
        const Point_2 &p = mesh.points[t[k]], &q = mesh.points[t[(k + 1) % 3]];
        longest = (std::max)(longest, std::sqrt(CGAL::squared_distance(p, q)));
        distance = (std::min)(distance, distance_to_boundary(domain, p));
      }
      if (distance > longest)
        return false;
    }
  return true;
}

std::vector<Domain> plain_domains() {
  return {Domain(l_shape()), Domain(u_shape()), Domain(star()), Domain(comb()),
          square_with_square_hole()};
}

Domain transformed(const Domain& domain, double scale, double x, double y) {
  std::vector<Points> loops(domain.number_of_loops());
  for (std::size_t loop = 0; loop < domain.number_of_loops(); ++loop)
    for (std::size_t i = domain.loop_begin(loop); i < domain.loop_begin(loop + 1); ++i)
      loops[loop].emplace_back(scale * domain.vertex(i).x() + x, scale * domain.vertex(i).y() + y);
  return Domain(loops[0], std::vector<Points>(loops.begin() + 1, loops.end()));
}

} // namespace

TEST_CASE("Domain meshes are valid at every spacing, smoothed or not") {
  const std::vector<Domain> domains{
      Domain(l_shape()),
      Domain(u_shape()),
      Domain({{0, 0}, {1, 0}, {0, 1}}),
      Domain({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}),
      Domain({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}),
      Domain(star()),
      Domain(comb())};
  for (const Domain& domain : domains)
    for (const double spacing : {10.0, 1.0, 0.3, 0.03})
      for (const int sweeps : {0, 1, 3}) {
        CAPTURE(domain.size(), spacing, sweeps);
        const Domain_mesh mesh = triangulate(domain, spacing, sweeps);
        CHECK(MP::domain_mesh_defect(domain, mesh) == "");
        CHECK(are_sharp_triangles_near_boundary(domain, mesh));
      }
}

TEST_CASE("Domain meshes of plain shapes have no sharp triangles") {
  for (const Domain& domain : plain_domains())
    for (const double spacing : {0.3, 0.2, 0.1, 0.05, 0.03, 0.01}) {
      CAPTURE(domain.size(), spacing);
      // A tip of 38 degrees leaves no room for 30 next to it; 27 are measured.
      const bool has_tips = domain.size() == 10;
      CHECK(smallest_angle(triangulate(domain, spacing)) > (has_tips ? 25 : 30));
    }
}

TEST_CASE("Domain meshes have about as many triangles as equilateral ones fill the domain") {
  for (const Domain& domain : plain_domains())
    for (const double spacing : {0.05, 0.02, 0.01}) {
      CAPTURE(domain.size(), spacing);
      const double expected = domain.area() / (std::sqrt(3.0) / 4 * spacing * spacing);
      const auto count = static_cast<double>(triangulate(domain, spacing).triangles.size());
      CHECK(count == Approx(expected).epsilon(0.1));
    }
}

TEST_CASE("Smoothing raises the smallest angle and never lowers it") {
  for (const Domain& domain : plain_domains())
    for (const double spacing : {0.3, 0.1, 0.03}) {
      CAPTURE(domain.size(), spacing);
      double last = 0;
      for (const int sweeps : {0, 1, 2, 5}) {
        const Domain_mesh mesh = triangulate(domain, spacing, sweeps);
        const double angle = smallest_angle(mesh);
        CAPTURE(sweeps, last);
        CHECK(angle >= last);
        CHECK(MP::domain_mesh_defect(domain, mesh) == "");
        last = angle;
      }
    }
}

TEST_CASE(
    "Domain meshes of random domains are valid, and sharp triangles lie next to the boundary") {
  const unsigned seed = 20260109;
  CAPTURE(seed);
  Random random(seed);
  for (int k = 0; k < 100; ++k) {
    CAPTURE(k);
    const Domain domain(star_shaped_polygon(random, random.integer(3, 25), 0.02));
    const Domain_mesh mesh = triangulate(domain, random.in(0.03, 0.5), k % 3);
    CHECK(MP::domain_mesh_defect(domain, mesh) == "");
    CHECK(are_sharp_triangles_near_boundary(domain, mesh));
  }
}

TEST_CASE(
    "Slots, spikes and uneven samples are meshed, with sharp triangles next to the boundary") {
  // A slot much narrower than the spacing, and a spike of five thousandths of a degree.
  const std::vector<Domain> domains{
      Domain({{0, 0}, {2, 0}, {2, 1}, {1.0001, 1}, {1, 0.1}, {0.9999, 1}, {0, 1}}),
      Domain({{0, 0}, {1, 0}, {1, 0.5}, {6, 0.5002}, {1, 0.5004}, {1, 1}, {0, 1}}),
      Domain(slotted()), Domain(dumbbell(1e-3)), Domain(spiked())};
  for (const Domain& domain : domains)
    for (const double spacing : {0.1, 0.03}) {
      CAPTURE(domain.size(), spacing);
      const Domain_mesh mesh = triangulate(domain, spacing);
      CHECK(MP::domain_mesh_defect(domain, mesh) == "");
      CHECK(are_sharp_triangles_near_boundary(domain, mesh));
    }
  // Short segments next to long ones: sizes grade between them.
  for (const std::vector<std::size_t>& counts :
       {std::vector<std::size_t>{1, 50, 1, 3}, {1, 1, 1, 1000}, {100, 1, 100, 1}, {1, 1, 1, 1}}) {
    const Domain domain(square());
    const Domain_mesh mesh = MP::triangulate_domain(domain, counts, 0.1);
    CAPTURE(counts);
    CHECK(MP::domain_mesh_defect(domain, mesh) == "");
    CHECK(are_sharp_triangles_near_boundary(domain, mesh));
  }
}

TEST_CASE("Large meshes, which are made of coarse ones, are valid, too") {
  const unsigned seed = 20261122;
  CAPTURE(seed);
  Random random(seed);
  std::vector<Domain> domains{Domain(slotted()), Domain(dumbbell(1e-3)), Domain(dumbbell(1e-9)),
                              Domain(spiked()), square_with_triangular_hole()};
  for (int k = 0; k < 20; ++k)
    domains.emplace_back(star_shaped_polygon(random, random.integer(3, 25), 0.02));
  for (std::size_t k = 0; k < domains.size(); ++k)
    // 0, 1, 2 and 3 times are edges halved.
    for (const double triangles : {5000., 20000., 30000., 100000.}) {
      if (triangles > 50000 && k % 5 != 0)
        continue;
      const Domain& domain = domains[k];
      CAPTURE(k, triangles);
      const double spacing = std::sqrt(domain.area() / triangles * 4 / std::sqrt(3.0));
      // Some sides are sampled more densely than others.
      std::vector<std::size_t> counts = segments(domain, spacing);
      counts[0] = 1 + counts[0] / 3;
      counts[1] *= 2;
      const Domain_mesh mesh = MP::triangulate_domain(domain, counts, spacing);
      CHECK(MP::domain_mesh_defect(domain, mesh) == "");
      CHECK(are_sharp_triangles_near_boundary(domain, mesh));
    }
}

TEST_CASE("Large meshes far from the origin, where rounding is felt, are valid") {
  for (const Domain& domain : {Domain(star()), square_with_triangular_hole()})
    for (const double offset : {1e9, 1e11, 1e12}) {
      const Domain moved = transformed(domain, 1, offset, offset / 3);
      const double spacing = std::sqrt(domain.area() / 20000 * 4 / std::sqrt(3.0));
      CAPTURE(domain.size(), offset);
      const Domain_mesh mesh = triangulate(moved, spacing);
      CHECK(MP::domain_mesh_defect(moved, mesh) == "");
    }
}

TEST_CASE("Samples on the sides are the ones that were asked for") {
  const Domain domain(l_shape());
  const std::vector<std::size_t> counts{1, 7, 2, 3, 10, 4};
  for (const int sweeps : {0, 3}) {
    const Domain_mesh mesh = MP::triangulate_domain(domain, counts, 0.1, sweeps);
    REQUIRE(mesh.number_of_boundary_points == 27);
    std::size_t index = 0;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t k = 0; k < counts[i]; ++k, ++index) {
        const Domain::Location& location = mesh.locations[index];
        CHECK(location.kind ==
              (k == 0 ? Domain::Location::Kind::vertex : Domain::Location::Kind::side));
        CHECK(location.index == i);
        const double s = static_cast<double>(k) / static_cast<double>(counts[i]);
        CHECK(location.s == Approx(s).epsilon(0).margin(1e-15));
        CHECK(mesh.points[index] == domain.point_on_side(i, location.s));
      }
    for (; index < mesh.points.size(); ++index)
      CHECK(mesh.locations[index].kind == Domain::Location::Kind::interior);
  }
}

TEST_CASE("A domain twice as large gives twice as large triangles, bit for bit") {
  for (const Domain& domain : {Domain(star()), Domain(comb()), square_with_triangular_hole()}) {
    const double spacing = 0.07;
    const std::vector<std::size_t> counts = segments(domain, spacing);
    const Domain_mesh mesh = MP::triangulate_domain(domain, counts, spacing, 2);
    for (const double scale : {0x1p-200, 0x1p-20, 0.5, 2.0, 0x1p40, 0x1p200}) {
      CAPTURE(domain.size(), scale);
      const Domain_mesh scaled =
          MP::triangulate_domain(transformed(domain, scale, 0, 0), counts, scale * spacing, 2);
      CHECK((scaled.triangles == mesh.triangles));
      REQUIRE(scaled.points.size() == mesh.points.size());
      for (std::size_t k = 0; k < mesh.points.size(); ++k)
        REQUIRE(scaled.points[k] ==
                Point_2(scale * mesh.points[k].x(), scale * mesh.points[k].y()));
    }
  }
}

TEST_CASE("A domain far from the origin is meshed as well as near it") {
  for (const Domain& domain : plain_domains()) {
    const double spacing = 0.1;
    const std::vector<std::size_t> counts = segments(domain, spacing);
    const Domain_mesh near = MP::triangulate_domain(domain, counts, spacing);
    for (const double offset : {1e3, -1e6, 1e9}) {
      CAPTURE(domain.size(), offset);
      const Domain moved = transformed(domain, 1, offset, offset / 3);
      const Domain_mesh mesh = MP::triangulate_domain(moved, counts, spacing);
      CHECK(MP::domain_mesh_defect(moved, mesh) == "");
      CHECK(smallest_angle(mesh) > 25);
      CHECK(static_cast<double>(mesh.triangles.size()) ==
            Approx(static_cast<double>(near.triangles.size())).epsilon(0.03));
    }
  }
}

TEST_CASE("Spacings that need too many triangles are refused at once") {
  const Domain domain(l_shape());
  for (const double spacing : {1e-5, 1e-100, 1e-300})
    CHECK_THROWS_AS(triangulate_domain(domain, std::vector<std::size_t>(6, 1), spacing),
                    MP::Input_error);
}
