// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "polygon_fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>

#include <CGAL/Barycentric_coordinates_2/Delaunay_domain_2.h>
#include <CGAL/Barycentric_coordinates_2/Harmonic_coordinates_2.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <benchmark/benchmark.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cmath>
#include <cstddef>
#include <ctime>
#include <map>
#include <vector>

// Harmonic coordinates: how setting them up grows with the number of sides, what a point costs, and
// how they compare with the ones of CGAL. All on one core, unless the name says Parallel_tag.

namespace {

namespace MP = CGAL::Multisided_patches;
using CGAL::Sequential_tag;
using fixtures::Domain;
using fixtures::Kernel;
using fixtures::Point_2;
using fixtures::Points;
using Coordinates = MP::Harmonic_coordinates_2<Kernel>;

constexpr double target_error = 1e-8; // the default, spelled out as the sequential tag comes after

Coordinates sequential_coordinates(const Domain& domain) {
  return Coordinates(domain, target_error, 0, Sequential_tag());
}

// CPU time rather than real time, which other work on the machine would spoil.
double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// ------------------------------------------------------------------------------------------ setup

// Families of polygons, by the number of sides, which is a multiple of 4 here.

Points regular_polygon(std::size_t n) {
  return fixtures::regular_polygon(n);
}

Points star(std::size_t n) {
  return fixtures::star(n / 2);
}

Points comb(std::size_t n) {
  return fixtures::comb(n / 4);
}

Points spiral(std::size_t n) {
  return fixtures::spiral(n / 2);
}

Points random_polygon(std::size_t n) {
  fixtures::Random random(1);
  return fixtures::random_polygon(random, n);
}

// the exponent p of times that grow like n^p: the slope of the line that fits their logarithms best
double exponent(const std::map<std::size_t, double>& times) {
  double x_sum = 0, y_sum = 0, xx_sum = 0, xy_sum = 0;
  for (const auto& [n, time] : times) {
    const double x = std::log(static_cast<double>(n)), y = std::log(time);
    x_sum += x;
    y_sum += y;
    xx_sum += x * x;
    xy_sum += x * y;
  }
  const double count = static_cast<double>(times.size());
  return (count * xy_sum - x_sum * y_sum) / (count * xx_sum - x_sum * x_sum);
}

// `exponent` is that of all sizes up to this one, so that the last row of a family has the one of
// the family. (Complexity() of Google Benchmark knows whole powers only.)
template <Points (*make_polygon)(std::size_t)>
void harmonic_scaling(benchmark::State& state) {
  static std::map<std::size_t, double> times; // of this family, by the number of sides
  const std::size_t n = static_cast<std::size_t>(state.range(0));
  const Domain domain(make_polygon(n));
  double error_bound = 0;
  const double begin = cpu_seconds();
  try {
    for (auto _ : state)
      error_bound = sequential_coordinates(domain).error_bound();
  } catch (const MP::Accuracy_error& e) {
    state.SkipWithError(e.what());
    return;
  }
  times[n] = (cpu_seconds() - begin) / static_cast<double>(state.iterations());
  state.counters["error_bound"] = error_bound;
  if (times.size() > 1)
    state.counters["exponent"] = exponent(times);
}

// ------------------------------------------------------------------------------------- evaluation

struct Batch_case {
  explicit Batch_case(const Points& polygon)
      : coordinates(Domain(polygon)),
        points(fixtures::random_points_inside(Domain(polygon), 100000)),
        locations(points.size(), Domain::Location()) {
    for (std::size_t j = 0; j < points.size(); ++j)
      locations[j] = coordinates.domain().locate(points[j]);
  }
  Coordinates coordinates;
  Points points;
  std::vector<Domain::Location> locations;
};

const Batch_case& batch_case(benchmark::State& state) {
  static const Batch_case u_shape(fixtures::unit_u_shape()), star_with_10_tips(fixtures::star(10));
  const bool small = state.range(0) == 8;
  state.SetLabel(small ? "u_shape" : "star");
  return small ? u_shape : star_with_10_tips;
}

void report_points(benchmark::State& state, const Batch_case& input) {
  const std::size_t points = input.points.size();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
  state.counters["per_point"] = benchmark::Counter(static_cast<double>(points),
                                                   benchmark::Counter::kIsIterationInvariantRate |
                                                       benchmark::Counter::kInvert);
}

template <int Order>
void harmonic_single(benchmark::State& state) {
  const Batch_case& input = batch_case(state);
  std::vector<MP::Jet_2<double, Order>> lambda(input.coordinates.domain().size());
  for (auto _ : state)
    for (std::size_t j = 0; j < input.points.size(); ++j) {
      input.coordinates.evaluate<Order>(input.points[j], input.locations[j], lambda.data());
      benchmark::DoNotOptimize(lambda.data());
      benchmark::ClobberMemory();
    }
  report_points(state, input);
}

template <int Order, typename ConcurrencyTag>
void harmonic_batch(benchmark::State& state) {
#ifdef CGAL_LINKED_WITH_TBB
  // The same number of threads on all machines that have them.
  const tbb::global_control two_threads(tbb::global_control::max_allowed_parallelism, 2);
#endif
  const Batch_case& input = batch_case(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        input.coordinates.evaluate_batch<Order, ConcurrencyTag>(input.points, input.locations));
  report_points(state, input);
}

// ------------------------------------------------------------------------------------- comparison

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
  return sequential_coordinates(domain).evaluate_batch<0, Sequential_tag>(points)[0];
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

Points star_with_5_tips() {
  return fixtures::star();
}

template <Points (*make_polygon)()>
void harmonic_from_polygon_cgal(benchmark::State& state) {
  Comparison& c = comparison<make_polygon>();
  const double begin = cpu_seconds();
  for (auto _ : state)
    benchmark::DoNotOptimize(compute_with_cgal(c.polygon, c.inside, c.max_edge_length));
  c.cgal_seconds = (cpu_seconds() - begin) / static_cast<double>(state.iterations());
  state.counters["points"] = static_cast<double>(c.points.size());
  state.counters["error"] = c.cgal_error;
}

template <Points (*make_polygon)()>
void harmonic_from_polygon_ours(benchmark::State& state) {
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

void sizes(benchmark::internal::Benchmark* b) {
  for (const int n : {8, 16, 20, 32, 64, 128, 256})
    b->Arg(n);
  b->Unit(benchmark::kMillisecond);
}

void batches(benchmark::internal::Benchmark* b) {
  // The CPU time is that of all threads, to tell what the machine had to give from what was lost.
  b->Arg(8)->Arg(20)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}

} // namespace

BENCHMARK_TEMPLATE(harmonic_scaling, regular_polygon)->Apply(sizes);
BENCHMARK_TEMPLATE(harmonic_scaling, star)->Apply(sizes);
BENCHMARK_TEMPLATE(harmonic_scaling, comb)->Apply(sizes);
BENCHMARK_TEMPLATE(harmonic_scaling, spiral)->Apply(sizes);
BENCHMARK_TEMPLATE(harmonic_scaling, random_polygon)->Apply(sizes);

BENCHMARK_TEMPLATE(harmonic_single, 0)->Apply(batches);
BENCHMARK_TEMPLATE(harmonic_single, 1)->Apply(batches);
BENCHMARK_TEMPLATE(harmonic_single, 2)->Apply(batches);
BENCHMARK_TEMPLATE(harmonic_batch, 0, Sequential_tag)->Apply(batches);
BENCHMARK_TEMPLATE(harmonic_batch, 1, Sequential_tag)->Apply(batches);
BENCHMARK_TEMPLATE(harmonic_batch, 2, Sequential_tag)->Apply(batches);
#ifdef CGAL_LINKED_WITH_TBB
using CGAL::Parallel_tag;
BENCHMARK_TEMPLATE(harmonic_batch, 0, Parallel_tag)->Apply(batches);
BENCHMARK_TEMPLATE(harmonic_batch, 1, Parallel_tag)->Apply(batches);
BENCHMARK_TEMPLATE(harmonic_batch, 2, Parallel_tag)->Apply(batches);
#endif

BENCHMARK_TEMPLATE(harmonic_from_polygon_cgal, l_shape)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(harmonic_from_polygon_ours, l_shape)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(harmonic_from_polygon_cgal, star_with_5_tips)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(harmonic_from_polygon_ours, star_with_5_tips)->Unit(benchmark::kMillisecond);
