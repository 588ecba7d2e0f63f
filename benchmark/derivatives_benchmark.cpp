// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Multisided_patches.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
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

template <int Order, typename Coordinates>
void patch_point(benchmark::State& state, const std::string& name) {
  const auto model = MP::IO::read_CGB<Kernel>(std::string(MODELS_DIR) + "/" + name + ".cgb");
  const MP::Concave_bezier_patch_3<Kernel, Coordinates> patch(model);
  const auto points = points_inside(patch);
  const auto interior = MP::Domain_location<double>::interior();
  for (auto _ : state)
    for (const Kernel::Point_2& p : points)
      benchmark::DoNotOptimize(patch.template evaluate<Order>(p, interior));
  state.counters["per_point"] = benchmark::Counter(static_cast<double>(points.size()),
                                                   benchmark::Counter::kIsIterationInvariantRate |
                                                       benchmark::Counter::kInvert);
}

using Harmonic = MP::Harmonic_coordinates_2<Kernel>;
using Mean_value = MP::Mean_value_coordinates_2<Kernel>;
using Wachspress = MP::Wachspress_coordinates_2<Kernel>;

} // namespace

// Value; with gradient; with Hessian.
BENCHMARK_CAPTURE((patch_point<0, Harmonic>), harmonic, "u_vent");
BENCHMARK_CAPTURE((patch_point<1, Harmonic>), harmonic, "u_vent");
BENCHMARK_CAPTURE((patch_point<2, Harmonic>), harmonic, "u_vent");
BENCHMARK_CAPTURE((patch_point<0, Mean_value>), mean_value, "g2_blend");
BENCHMARK_CAPTURE((patch_point<1, Mean_value>), mean_value, "g2_blend");
BENCHMARK_CAPTURE((patch_point<2, Mean_value>), mean_value, "g2_blend");
BENCHMARK_CAPTURE((patch_point<0, Wachspress>), wachspress, "pentagon_cap");
BENCHMARK_CAPTURE((patch_point<1, Wachspress>), wachspress, "pentagon_cap");
BENCHMARK_CAPTURE((patch_point<2, Wachspress>), wachspress, "pentagon_cap");
