// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <type_traits>

// What derivatives of a patch cost in comparison with its points, on one core.

namespace {

namespace MP = bench::MP;
using bench::Kernel;

using Harmonic = MP::Harmonic_coordinates_2<Kernel>;
using Mean_value = MP::Mean_value_coordinates_2<Kernel>;
using Wachspress = MP::Wachspress_coordinates_2<Kernel>;

// Wachspress coordinates need a convex domain.
template <typename Coordinates>
constexpr const char* model_name =
    std::is_same_v<Coordinates, Wachspress> ? "pentagon_cap" : "u_vent";

template <int Order, typename Coordinates>
void patch_point(benchmark::State& state) {
  const std::string name = model_name<Coordinates>;
  const MP::Concave_bezier_patch_3<Kernel, Coordinates> patch(bench::read_model(name));
  const auto points = fixtures::random_points_inside(patch.domain(), 2000);
  const auto interior = MP::Domain_location<double>::interior();
  for (auto _ : state)
    for (const Kernel::Point_2& p : points)
      benchmark::DoNotOptimize(patch.template evaluate<Order>(p, interior));
  state.SetLabel(name);
  bench::report_seconds_per(state, "point", points.size());
}

} // namespace

// Points; with first derivatives; with second derivatives.
BENCHMARK_TEMPLATE(patch_point, 0, Harmonic)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(patch_point, 1, Harmonic)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(patch_point, 2, Harmonic)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(patch_point, 0, Mean_value)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(patch_point, 1, Mean_value)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(patch_point, 2, Mean_value)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(patch_point, 0, Wachspress)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(patch_point, 1, Wachspress)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(patch_point, 2, Wachspress)->Unit(benchmark::kMillisecond);
