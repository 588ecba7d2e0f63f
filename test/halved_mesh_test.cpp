// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "linked_mesh_fixtures.h"
#include "polygon_fixtures.h"

#include <CGAL/Multisided_patches/meshing/internal/Domain_mesher.h>
#include <CGAL/Multisided_patches/meshing/internal/Mesh_region.h>
#include <CGAL/Multisided_patches/meshing/internal/even_parameters.h>
#include <CGAL/Multisided_patches/meshing/is_valid_domain_mesh.h>

#include <algorithm>
#include <optional>
#include <set>

using namespace fixtures;
using namespace MP::internal;

namespace {

using Domain_mesh = MP::Domain_mesh_2<Kernel>;

// ----------------------------------------------------------------------------- halving of edges

// A metric that stretches and turns from place to place.
struct Waves {
  Metric_2 operator()(const Uv& p, std::size_t&) const {
    const double a =
        density * (1 + amplitude * std::sin(frequency * p.x) * std::cos(frequency * p.y));
    const double b = density * (1 + amplitude * std::cos(frequency * (p.x + p.y)));
    return {a * a, shear * a * b, b * b};
  }
  double density, amplitude, frequency, shear;
};

// What the triangles of a mesh are in a metric.
struct Shapes {
  double area = 0; // of all together, in units of equilateral triangles with edges of length 1
  double sharp_part = 0; // of those that have an angle below 20.7 degrees, in the metric
};

Shapes shapes(const Domain_mesh& mesh, const Waves& field) {
  Shapes result;
  for (const auto& t : mesh.triangles) {
    Uv corners[3], center{0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = to_uv(mesh.points[t[i]]);
      center = center + 1. / 3 * corners[i];
    }
    std::size_t hint = 0;
    const Metric_triangle triangle({corners[0], corners[1], corners[2]}, field(center, hint));
    result.area += triangle.area() * 4 / std::sqrt(3.0);
    result.sharp_part += is_sharp(triangle);
  }
  result.sharp_part /= static_cast<double>(mesh.triangles.size());
  return result;
}

Side_parameters even_sides(const Domain& domain, double spacing) {
  Side_parameters sides;
  for (std::size_t i = 0; i < domain.size(); ++i)
    sides.push_back(even_parameters(
        static_cast<std::size_t>(std::ceil((std::max)(1.0, domain.side_length(i) / spacing)))));
  return sides;
}

// A mesh for the first field that turns out, while it is made, to be for the second one.
template <typename ConcurrencyTag>
Domain_mesh halved_mesh(const Domain& domain, const Side_parameters& sides, const Waves& first,
                        const Waves& second, int halvings, Keep keep) {
  Domain_mesher<Kernel, Waves, ConcurrencyTag> mesher(
      domain, sides, first, std::vector<std::size_t>(domain.size(), 0), halvings);
  const auto ignore = [](std::size_t) {};
  constexpr std::size_t max_points = 1000000;
  mesher.refine(max_points, ignore);
  mesher.halve_edges(
      max_points, ignore, [&](const auto&, const auto&) { return std::make_optional(second); },
      keep);
  return mesher.finish();
}

// -------------------------------------------------------------------------------------- regions

// How many triangles `rings` rings around some triangles have, by definition.
std::size_t count_with_rings(const Linked_triangles& mesh, std::vector<char> is_inside, int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    std::set<std::size_t> vertices;
    for (std::size_t t = 0; t < mesh.size(); ++t)
      if (is_inside[t])
        vertices.insert(mesh[t].vertices.begin(), mesh[t].vertices.end());
    for (std::size_t t = 0; t < mesh.size(); ++t)
      for (const std::size_t v : mesh[t].vertices)
        is_inside[t] = is_inside[t] || vertices.count(v) > 0;
  }
  return static_cast<std::size_t>(std::count(is_inside.begin(), is_inside.end(), true));
}

} // namespace

TEST_CASE("Meshes of a metric that is measured again on the way are valid and fit the last one") {
  const unsigned int seed = 20261123;
  CAPTURE(seed);
  Random random(seed);
  for (int k = 0; k < 12; ++k) {
    const Domain domain = k % 3 == 0
                              ? square_with_square_hole()
                              : Domain(star_shaped_polygon(random, random.integer(4, 15), 0.4));
    constexpr double triangles = 12000;
    const double density = std::sqrt(triangles * std::sqrt(3.0) / 4 / domain.area());
    const Waves first{density, random.in(0, 0.3), random.in(1, 6), 0};
    const Waves second{density * random.in(0.8, 1.2), random.in(0, 0.5), random.in(1, 6),
                       random.in(-0.5, 0.5)};
    const int halvings = 2 + k % 2;
    const Keep keep = k % 2 == 0 ? Keep::edge_length : Keep::number_of_triangles;
    const Side_parameters sides = even_sides(domain, 1 / density);
    CAPTURE(k, domain.size(), halvings);
    const Domain_mesh mesh =
        halved_mesh<CGAL::Sequential_tag>(domain, sides, first, second, halvings, keep);
    CHECK(MP::domain_mesh_defect(domain, mesh) == "");
    // What fits the second metric is not what fits the first one.
    const Shapes in_second = shapes(mesh, second);
    CHECK(in_second.sharp_part < 0.02);
    const double count = static_cast<double>(mesh.triangles.size());
    if (keep == Keep::edge_length)
      CHECK(count == Approx(in_second.area).epsilon(0.25));
    else
      CHECK(count == Approx(shapes(mesh, first).area).epsilon(0.25));
  }
}

TEST_CASE("Halving gives the same mesh, bit for bit, in parallel") {
  const Domain domain(u_shape());
  const double density = std::sqrt(12000 * std::sqrt(3.0) / 4 / domain.area());
  const Waves first{density, 0.1, 1, 0}, second{density, 0.4, 2, 0.4};
  const auto run = [&](auto tag) {
    return halved_mesh<decltype(tag)>(domain, even_sides(domain, 1 / density), first, second, 2,
                                      Keep::number_of_triangles);
  };
  const Domain_mesh a = run(CGAL::Sequential_tag()), b = run(CGAL::Parallel_if_available_tag());
  CHECK(a.points == b.points);
  CHECK(a.triangles == b.triangles);
}

TEST_CASE("A region has the triangles around those that are chosen, ring by ring") {
  constexpr std::size_t n = 9;
  const Linked_triangles mesh = grid(n);
  REQUIRE(is_linked_well(mesh));
  for (const std::size_t chosen : {std::size_t(0), std::size_t(2 * n - 1), n * n - 1, n * n})
    for (int rings = 0; rings <= 3; ++rings) {
      CAPTURE(chosen, rings);
      std::vector<char> is_chosen(mesh.size(), false);
      is_chosen[chosen] = true;
      const Mesh_region region(mesh, (n + 1) * (n + 1), is_chosen, rings);
      CHECK(region.triangles().size() == count_with_rings(mesh, is_chosen, rings));
      CHECK(is_linked_well(region.triangles()));
    }
}

TEST_CASE("Where the border of a region would pass through a point twice, the region is larger") {
  constexpr std::size_t n = 4;
  const Linked_triangles mesh = grid(n);
  // The lower triangle of square (0,0) and the upper one of square (1,1) meet at a point only.
  std::vector<char> is_chosen(mesh.size(), false);
  is_chosen[0] = is_chosen[2 * (n + 1) + 1] = true;
  const Mesh_region region(mesh, (n + 1) * (n + 1), is_chosen, 0);
  CHECK(region.triangles().size() == 6); // all those around that point
  std::multiset<std::size_t> starts;
  for (const Linked_triangle& t : region.triangles())
    for (std::size_t i = 0; i < 3; ++i)
      if (t.neighbors[i] == Linked_triangle::none)
        starts.insert(t.vertices[(i + 1) % 3]);
  CHECK(starts.size() == region.number_of_border_points());
  for (const std::size_t v : starts)
    CHECK(starts.count(v) == 1);
}

TEST_CASE("A region that is put back as it was leaves the mesh as it was") {
  constexpr std::size_t n = 6;
  Linked_triangles mesh = grid(n);
  const Linked_triangles before = mesh;
  std::vector<char> is_chosen(mesh.size(), false);
  is_chosen[n * n] = true;
  Mesh_region region(mesh, (n + 1) * (n + 1), is_chosen, 1);
  Linked_triangles triangles;
  for (Linked_triangle t : region.triangles()) // with their corners turned
    triangles.push_back({{t.vertices[1], t.vertices[2], t.vertices[0]},
                         {t.neighbors[1], t.neighbors[2], t.neighbors[0]}});
  region.replace(triangles, (n + 1) * (n + 1), mesh);
  REQUIRE(mesh.size() == before.size());
  CHECK(is_linked_well(mesh));
  for (std::size_t t = 0; t < mesh.size(); ++t)
    CHECK(std::is_permutation(mesh[t].vertices.begin(), mesh[t].vertices.end(),
                              before[t].vertices.begin()));
}

TEST_CASE("Components are refined within the limit for all, and alike in parallel") {
  // Some grids of n x n squares side by side; the borders of all of them come first.
  constexpr std::size_t n = 13, copies = 5, points = (n + 1) * (n + 1);
  const Bordered_grid one(n);
  const auto number = [&](std::size_t copy, std::size_t k) {
    return k < one.border ? copy * one.border + k
                          : copies * one.border + copy * (points - one.border) + k - one.border;
  };
  const Waves field{3, 0, 0, 0}; // wants edges a third as long
  Mesh_to_refine<Kernel, Waves> mesh{
      std::vector<Kernel::Point_2>(copies * points), Metric_at_points<Waves>(field), {}};
  for (std::size_t copy = 0; copy < copies; ++copy) {
    for (std::size_t k = 0; k < points; ++k)
      mesh.points[number(copy, k)] = {static_cast<double>(one.vertices[k][0] + copy * 2 * n),
                                      static_cast<double>(one.vertices[k][1])};
    for (Linked_triangle t : one.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        t.vertices[i] = static_cast<Linked_triangle::Index>(number(copy, t.vertices[i]));
        if (t.neighbors[i] != Linked_triangle::none)
          t.neighbors[i] += static_cast<Linked_triangle::Index>(copy * one.triangles.size());
      }
      mesh.triangles.push_back(t);
    }
  }
  for (const Kernel::Point_2& p : mesh.points)
    mesh.metric.add(to_uv(p), 0);
  REQUIRE(is_linked_well(mesh.triangles));
  const std::vector<Mesh_part> parts = split_mesh(mesh.triangles, mesh.points.size(), 300);
  REQUIRE(parts.size() == copies);
  for (const Mesh_part& part : parts)
    CHECK((part.points.size() == points && is_linked_well(part.triangles)));

  for (const std::size_t more : {std::size_t(0), std::size_t(100), std::size_t(100000)}) {
    CAPTURE(more);
    const std::size_t limit = mesh.points.size() + more;
    auto a = mesh, b = mesh;
    std::size_t reported = 0;
    refine_components<CGAL::Sequential_tag>(a, copies * one.border, limit,
                                            [&](std::size_t done) { reported = done; });
    refine_components<CGAL::Parallel_if_available_tag>(b, copies * one.border, limit,
                                                       [](std::size_t) {});
    CHECK(a.points.size() <= limit);
    CHECK(a.points.size() >= mesh.points.size() + (std::min)(more, std::size_t(2000)) * 9 / 10);
    CHECK(reported == a.points.size());
    CHECK(is_linked_well(a.triangles));
    CHECK(a.points == b.points);
    CHECK(a.metric.size() == a.points.size());
    for (std::size_t v = 0; v < copies * one.border; ++v)
      CHECK(a.points[v] == mesh.points[v]);
  }
}
