// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>

#include <type_traits>

// Coordinates with gradients at single points, over the number of sides and the number of points.

namespace {

using Harmonic = bench::MP::Harmonic_coordinates_2<bench::Kernel>;
using Mean_value = bench::MP::Mean_value_coordinates_2<bench::Kernel>;
using Wachspress = bench::MP::Wachspress_coordinates_2<bench::Kernel>;

template <typename Coordinates>
void coordinates_of_points(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0)),
             count = static_cast<std::size_t>(state.range(1));
  // Wachspress coordinates need a convex domain.
  const bench::Plan kind = std::is_same_v<Coordinates, Wachspress> ? bench::regular : bench::random;
  const bench::Domain domain(bench::plan(kind, n));
  const Coordinates coordinates(domain);
  const bench::Points points = fixtures::random_points_inside(domain, count);
  const auto interior = bench::Domain::Location::interior();
  std::vector<bench::MP::Jet_2<double, 1>> lambda(n);
  state.SetLabel(kind == bench::regular ? "regular" : "random");
  for (auto _ : state)
    for (const bench::Point_2& p : points) {
      coordinates.template evaluate<1>(p, interior, lambda.data());
      benchmark::DoNotOptimize(lambda.data());
      benchmark::ClobberMemory();
    }
  bench::report_seconds_per(state, "point", count);
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"n", "points"})
      ->ArgsProduct({{3, 5, 8, 16, 32, 64}, {1000}})
      ->ArgsProduct({{8}, {100000, 1000000}})
      ->Unit(benchmark::kMillisecond);
}

} // namespace

BENCHMARK_TEMPLATE(coordinates_of_points, Harmonic)->Apply(sizes);
BENCHMARK_TEMPLATE(coordinates_of_points, Mean_value)->Apply(sizes);
BENCHMARK_TEMPLATE(coordinates_of_points, Wachspress)->Apply(sizes);
