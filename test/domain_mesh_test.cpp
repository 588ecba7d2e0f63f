// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/meshing/triangulate_domain.h>

#include <map>

using namespace fixtures;
using Mesh = MP::Domain_mesh_2<Kernel>;

namespace {

std::vector<std::size_t> segments(const Domain& domain, double spacing) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < domain.size(); ++i)
    result.push_back(static_cast<std::size_t>(std::ceil(domain.side_length(i) / spacing)));
  return result;
}

// The triangles are positively oriented, cover the domain, and fit together to a surface whose
// boundary is exactly the sampled sides.
void check_mesh(const Domain& domain, const Mesh& mesh) {
  double area = 0;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (const auto& t : mesh.triangles) {
    REQUIRE(CGAL::orientation(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) ==
            CGAL::LEFT_TURN);
    area += CGAL::area(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
    for (int e = 0; e < 3; ++e)
      ++edges[{t[e], t[(e + 1) % 3]}];
  }
  CHECK(area == Approx(domain.area()).epsilon(1e-12));
  std::size_t boundary = 0;
  for (const auto& [edge, count] : edges) {
    REQUIRE(count == 1);
    if (edges.count({edge.second, edge.first}) == 0) {
      ++boundary;
      CHECK(edge.first < mesh.number_of_boundary_points);
      CHECK(edge.second < mesh.number_of_boundary_points);
    }
  }
  CHECK(boundary == mesh.number_of_boundary_points);
  // Euler's formula for a disk with holes.
  CHECK(mesh.triangles.size() ==
        2 * mesh.points.size() - mesh.number_of_boundary_points + 2 * domain.number_of_loops() - 4);
}

double smallest_angle(const Mesh& mesh) {
  double smallest = MP::internal::pi;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
      const auto b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
      smallest = (std::min)(smallest, std::atan2(a.x() * b.y() - a.y() * b.x(), a * b));
    }
  return smallest * 180 / MP::internal::pi;
}

} // namespace

TEST_CASE("Domain meshes are whole at every spacing") {
  const std::vector<Domain> domains{
      Domain(l_shape()), Domain(u_shape()), Domain({{0, 0}, {1, 0}, {0, 1}}),
      Domain({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}),
      Domain({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}})};
  for (const Domain& domain : domains)
    for (const double spacing : {10.0, 1.0, 0.3, 0.03}) {
      CAPTURE(domain.size(), spacing);
      check_mesh(domain, MP::triangulate_domain(domain, segments(domain, spacing), spacing));
    }
}

TEST_CASE("Domain meshes of plain shapes have no sharp triangles") {
  for (const Domain& domain : {Domain(l_shape()), Domain(u_shape())})
    for (const double spacing : {0.3, 0.1, 0.03})
      CHECK(smallest_angle(MP::triangulate_domain(domain, segments(domain, spacing), spacing)) >
            20.7);
}

TEST_CASE("Domain meshes of random and very narrow domains are whole") {
  const unsigned seed = 20260109;
  CAPTURE(seed);
  Random random(seed);
  for (int k = 0; k < 100; ++k) {
    CAPTURE(k);
    const Domain domain(star_shaped_polygon(random, random.integer(3, 25), 0.02));
    const double spacing = random.in(0.03, 0.5);
    check_mesh(domain, MP::triangulate_domain(domain, segments(domain, spacing), spacing));
  }
  // A slot much narrower than the spacing, and a spike of five thousandths of a degree.
  const Domain slot({{0, 0}, {2, 0}, {2, 1}, {1.0001, 1}, {1, 0.1}, {0.9999, 1}, {0, 1}});
  check_mesh(slot, MP::triangulate_domain(slot, segments(slot, 0.1), 0.1));
  const Domain spike({{0, 0}, {1, 0}, {1, 0.5}, {6, 0.5002}, {1, 0.5004}, {1, 1}, {0, 1}});
  check_mesh(spike, MP::triangulate_domain(spike, segments(spike, 0.1), 0.1));
}

TEST_CASE("Samples on the sides are the ones that were asked for") {
  const Domain domain(l_shape());
  const std::vector<std::size_t> counts{1, 7, 2, 3, 10, 4};
  const Mesh mesh = MP::triangulate_domain(domain, counts, 0.1);
  CHECK(mesh.number_of_boundary_points == 27);
  std::size_t index = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < counts[i]; ++k, ++index) {
      CHECK(mesh.locations[index].index == i);
      CHECK(mesh.locations[index].s ==
            Approx(static_cast<double>(k) / static_cast<double>(counts[i])));
    }
  for (; index < mesh.points.size(); ++index)
    CHECK(mesh.locations[index].kind == Domain::Location::Kind::interior);
}

TEST_CASE("Sample parameters from both ends of a side sum to exactly 1") {
  for (std::size_t m = 1; m < 300; ++m)
    for (std::size_t k = 0; k <= m; ++k) {
      const double s = MP::internal::sample_parameter(k, m);
      CHECK(s + MP::internal::sample_parameter(m - k, m) == 1);
      CHECK(1 - s == MP::internal::sample_parameter(m - k, m));
      CHECK(s == Approx(static_cast<double>(k) / static_cast<double>(m)).margin(1e-15));
    }
}
