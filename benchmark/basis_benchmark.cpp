// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Counting_number.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

// Side parameters and basis, times the control net: from coordinates to points of the surface, and
// the share of the machine's floating-point limit that this takes. Points one by one.

namespace {

using Coordinates = bench::MP::Mean_value_coordinates_2<bench::Kernel>;
using Patch = bench::MP::Concave_bezier_patch_3<bench::Kernel, Coordinates>;
template <typename FT, int Order>
using Jets = std::vector<bench::MP::Jet_2<FT, Order>>;

// The coordinates at points inside, one after the other.
template <int Order>
Jets<double, Order> coordinates_at(const Patch& patch, const bench::Points& points) {
  const std::size_t n = patch.domain().size();
  Jets<double, Order> lambda(n * points.size());
  for (std::size_t j = 0; j < points.size(); ++j)
    patch.coordinates().evaluate<Order>(points[j], Patch::Location::interior(), &lambda[n * j]);
  return lambda;
}

// The operations that one point takes.
template <int Order>
double count_operations(const Patch& patch, const Jets<double, Order>& lambda) {
  using Number = bench::Counting_number;
  Jets<Number, Order> counting(patch.domain().size());
  for (std::size_t i = 0; i < counting.size(); ++i)
    for (std::size_t k = 0; k < counting[i].size; ++k)
      counting[i][k] = Number(lambda[i][k]);
  const long begin = Number::operations();
  benchmark::DoNotOptimize(patch.combine(counting.data()));
  return static_cast<double>(Number::operations() - begin);
}

template <int Order>
void basis_combination(benchmark::State& state) {
  const auto size = [&](int k) { return static_cast<std::size_t>(state.range(k)); };
  const std::size_t n = size(0), count = 1000;
  const bench::Points plan = bench::plan(bench::random, n);
  const bench::Domain domain(plan);
  const Patch patch(bench::dome(plan, size(1), size(2)), Coordinates(domain));
  const auto lambda = coordinates_at<Order>(patch, fixtures::random_points_inside(domain, count));
  for (auto _ : state)
    for (std::size_t j = 0; j < count; ++j)
      benchmark::DoNotOptimize(patch.combine(&lambda[n * j]));
  const double operations = count_operations(patch, lambda);
  bench::report_seconds_per(state, "point", count);
  state.counters["flops/point"] = operations;
  bench::report_rate(state, "flops/s", operations * double(count));
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"n", "degree", "layers"})
      ->ArgsProduct({{3, 5, 8, 16, 32, 64}, {3}, {2}})
      ->ArgsProduct({{8}, {5, 7}, {2}})
      ->ArgsProduct({{8}, {5, 7}, {3}})
      ->Unit(benchmark::kMicrosecond);
}

} // namespace

// Points; with first derivatives.
BENCHMARK_TEMPLATE(basis_combination, 0)->Apply(sizes);
BENCHMARK_TEMPLATE(basis_combination, 1)->Apply(sizes);
