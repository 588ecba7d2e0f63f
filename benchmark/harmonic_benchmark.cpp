// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>

#include <CGAL/tags.h>

#include <cmath>
#include <map>

// Harmonic coordinates: how setting them up grows with the number of sides, and what a point costs.
// All on one core, unless the name says Parallel_tag.

namespace {

namespace MP = bench::MP;
using bench::cpu_seconds;
using bench::Domain;
using bench::Points;
using CGAL::Sequential_tag;
using Coordinates = MP::Harmonic_coordinates_2<bench::Kernel>;

constexpr double target_error = 1e-8; // the default, spelled out as the sequential tag comes after

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
      error_bound = Coordinates(domain, target_error, 0, Sequential_tag()).error_bound();
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
  bench::report_seconds_per(state, "point", input.points.size());
}

template <int Order, typename ConcurrencyTag>
void harmonic_batch(benchmark::State& state) {
  const bench::Thread_limit limit(bench::thread_counts().back());
  const Batch_case& input = batch_case(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        input.coordinates.evaluate_batch<Order, ConcurrencyTag>(input.points, input.locations));
  bench::report_seconds_per(state, "point", input.points.size());
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgName("n");
  for (const int n : {8, 16, 20, 32, 64, 128, 256})
    b->Arg(n);
  b->Unit(benchmark::kMillisecond);
}

void batches(benchmark::internal::Benchmark* b) {
  // The CPU time is that of all threads, to tell what the machine had to give from what was lost.
  b->ArgName("n")
      ->Arg(8)
      ->Arg(20)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
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
