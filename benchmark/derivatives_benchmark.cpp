// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multisided_patches.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

// What derivatives of a patch cost in comparison with its points, on one core.

namespace {

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// The points inside a mesh of the domain.
template <typename Patch>
std::vector<Kernel::Point_2> points_inside(const Patch& patch) {
  const auto mesh = MP::mesh_domain(patch, MP::Mesh_density::triangles(5000));
  return {mesh.points.begin() + static_cast<std::ptrdiff_t>(mesh.number_of_boundary_points),
          mesh.points.end()};
}

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
  const auto model = MP::IO::read_CGB<Kernel>(std::string(MODELS_DIR) + "/" + name + ".cgb");
  const MP::Concave_bezier_patch_3<Kernel, Coordinates> patch(model);
  const auto points = points_inside(patch);
  const auto interior = MP::Domain_location<double>::interior();
  for (auto _ : state)
    for (const Kernel::Point_2& p : points)
      benchmark::DoNotOptimize(patch.template evaluate<Order>(p, interior));
  state.SetLabel(name);
  state.counters["per_point"] = benchmark::Counter(static_cast<double>(points.size()),
                                                   benchmark::Counter::kIsIterationInvariantRate |
                                                       benchmark::Counter::kInvert);
}

} // namespace

// Points; with first derivatives; with second derivatives.
BENCHMARK_TEMPLATE(patch_point, 0, Harmonic);
BENCHMARK_TEMPLATE(patch_point, 1, Harmonic);
BENCHMARK_TEMPLATE(patch_point, 2, Harmonic);
BENCHMARK_TEMPLATE(patch_point, 0, Mean_value);
BENCHMARK_TEMPLATE(patch_point, 1, Mean_value);
BENCHMARK_TEMPLATE(patch_point, 2, Mean_value);
BENCHMARK_TEMPLATE(patch_point, 0, Wachspress);
BENCHMARK_TEMPLATE(patch_point, 1, Wachspress);
BENCHMARK_TEMPLATE(patch_point, 2, Wachspress);
