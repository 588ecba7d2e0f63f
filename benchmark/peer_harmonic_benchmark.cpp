// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>

#include <CGAL/Barycentric_coordinates_2/Delaunay_domain_2.h>
#include <CGAL/Barycentric_coordinates_2/Harmonic_coordinates_2.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cmath>

// CGAL's own harmonic coordinates next to ours, on one core: from a polygon to the values at the
// same points, with the largest error of each.

namespace {

using bench::cpu_seconds;
using bench::Domain;
using bench::Kernel;
using bench::Point_2;
using bench::Points;
using CGAL::Sequential_tag;
using Coordinates = bench::MP::Harmonic_coordinates_2<Kernel>;

constexpr double target_error = 1e-8; // the default, spelled out as the sequential tag comes after

// CGAL has harmonic coordinates, too, by linear finite elements on a triangle mesh. They are exact
// nowhere, and best at the vertices of the mesh; we compare all values at these.

using Values = Eigen::MatrixXd; // a row for each vertex of the polygon, a column for each point

struct Mesh_values {
  Points points; // the vertices inside; on the boundary, both are exact
  Values values;
};

using Mesh = CGAL::Barycentric_coordinates::Delaunay_domain_2<Points, Kernel>;
using Mesh_coordinates =
    CGAL::Barycentric_coordinates::Harmonic_coordinates_2<Points, Mesh, Kernel>;

Mesh_values compute_with_cgal(const Points& polygon, const Point_2& inside,
                              double max_edge_length) {
  Mesh mesh(polygon);
  mesh.create(max_edge_length, Points{inside});
  Mesh_coordinates coordinates(polygon, mesh);
  coordinates.compute();
  std::vector<std::size_t> vertices;
  for (std::size_t j = 0; j < mesh.number_of_vertices(); ++j)
    if (!mesh.is_on_boundary(j))
      vertices.push_back(j);
  Mesh_values result;
  result.values.resize(static_cast<Eigen::Index>(polygon.size()),
                       static_cast<Eigen::Index>(vertices.size()));
  double* column = result.values.data();
  for (const std::size_t j : vertices) {
    result.points.push_back(mesh.vertex(j));
    column = coordinates(j, column);
  }
  return result;
}

Values compute_with_ours(const Points& polygon, const Points& points) {
  const Domain domain(polygon);
  return Coordinates(domain, target_error, 0, Sequential_tag())
      .evaluate_batch<0, Sequential_tag>(points)[0];
}

// the length with which a mesh has about this many vertices: their number is inverse to its square
double edge_length_for(std::size_t vertices, const Points& polygon, const Point_2& inside) {
  double length = 0.05;
  for (int i = 0; i < 3; ++i) {
    Mesh mesh(polygon);
    mesh.create(length, Points{inside});
    length *=
        std::sqrt(static_cast<double>(mesh.number_of_vertices()) / static_cast<double>(vertices));
  }
  return length;
}

// What both rows of a shape need, whichever of them is run.
struct Comparison {
  explicit Comparison(const Points& p)
      : polygon(p), inside(fixtures::random_points_inside(Domain(p), 1)[0]),
        max_edge_length(edge_length_for(100000, polygon, inside)) {
    const double begin = cpu_seconds();
    const Mesh_values cgal = compute_with_cgal(polygon, inside, max_edge_length);
    cgal_seconds = cpu_seconds() - begin;
    points = cgal.points;
    const Coordinates reference(Domain(polygon), 1e-12, 1e-11);
    reference_values = reference.evaluate_batch<0, Sequential_tag>(points)[0];
    cgal_error = error(cgal.values);
  }

  double error(const Values& values) const {
    return (values - reference_values).cwiseAbs().maxCoeff();
  }

  Points polygon;
  Point_2 inside;
  double max_edge_length;
  Points points;
  Values reference_values;
  double cgal_seconds, cgal_error;
};

template <Points (*make_polygon)()>
Comparison& comparison() {
  static Comparison result(make_polygon());
  return result;
}

Points l_shape() {
  return fixtures::l_shape();
}

Points star() {
  return fixtures::star();
}

template <Points (*make_polygon)()>
void peer_harmonic_cgal(benchmark::State& state) {
  Comparison& c = comparison<make_polygon>();
  const double begin = cpu_seconds();
  for (auto _ : state)
    benchmark::DoNotOptimize(compute_with_cgal(c.polygon, c.inside, c.max_edge_length));
  c.cgal_seconds = (cpu_seconds() - begin) / static_cast<double>(state.iterations());
  state.counters["points"] = static_cast<double>(c.points.size());
  state.counters["error"] = c.cgal_error;
}

template <Points (*make_polygon)()>
void peer_harmonic_ours(benchmark::State& state) {
  const Comparison& c = comparison<make_polygon>();
  Values values;
  const double begin = cpu_seconds();
  for (auto _ : state)
    values = compute_with_ours(c.polygon, c.points);
  const double seconds = (cpu_seconds() - begin) / static_cast<double>(state.iterations());
  state.counters["points"] = static_cast<double>(c.points.size());
  state.counters["error"] = c.error(values);
  state.counters["times_faster"] = c.cgal_seconds / seconds;
  state.counters["error_ratio"] = c.cgal_error / c.error(values);
}

} // namespace

BENCHMARK_TEMPLATE(peer_harmonic_cgal, l_shape)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(peer_harmonic_ours, l_shape)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(peer_harmonic_cgal, star)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(peer_harmonic_ours, star)->Unit(benchmark::kMillisecond);
