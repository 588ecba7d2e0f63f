// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_BENCHMARK_FIXTURES_H
#define MULTISIDED_PATCHES_BENCHMARK_FIXTURES_H

#include "polygon_fixtures.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_model_3.h>

#include <benchmark/benchmark.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

// What several benchmarks measure with: models, loops of any size, and how to report about them.
namespace bench {

namespace MP = CGAL::Multisided_patches;
using fixtures::Domain;
using fixtures::Kernel;
using fixtures::Loop;
using fixtures::Point_2;
using fixtures::Point_3;
using fixtures::Points;
using fixtures::Ribbon;
using Model = MP::Concave_bezier_model_3<Kernel>;

// ------------------------------------------------------------------------------------------ input

inline std::string model_file(const std::string& name) {
  return std::string(MODELS_DIR) + "/" + name + ".cgb";
}

inline Model read_model(const std::string& name) {
  return MP::IO::read_CGB<Kernel>(model_file(name));
}

// Of growing complexity.
constexpr const char* model_names[] = {"triangle_corner", "l_bracket", "u_vent", "plus_hub",
                                       "spiral_volute"};

// The arguments of benchmarks of loops: plans are regular polygons, or random ones that are
// star-shaped, with about as many reflex as convex corners.
enum Plan : std::int64_t { regular, random };

inline Points plan(std::int64_t kind, std::size_t n) {
  if (kind == regular)
    return fixtures::regular_polygon(n);
  fixtures::Random generator(static_cast<unsigned>(n)); // the same plan in every benchmark
  return fixtures::star_shaped_polygon(generator, n, 0.4);
}

// The ribbons of a shallow dome over a polygon, with any degree and number of layers: as in
// `fixtures::lifted_loop()`, the rows of a side follow those next to it at its ends.
inline Loop dome(const Points& polygon, std::size_t degree, std::size_t layers) {
  const std::size_t n = polygon.size();
  const auto lift = [](const Point_2& p) {
    return Point_3(p.x(), p.y(), -0.2 * (p.x() * p.x() + p.y() * p.y()));
  };
  const auto inwards = [](const Point_2& p, const Point_2& q, const Point_2& r, bool at_start) {
    const Kernel::Vector_2 along = at_start ? p - q : r - q;
    return CGAL::orientation(p, q, r) == CGAL::RIGHT_TURN ? -along : along;
  };
  std::vector<Ribbon> ribbons;
  for (std::size_t i = 0; i < n; ++i) {
    const Point_2 &before = polygon[(i + n - 1) % n], &a = polygon[i], &b = polygon[(i + 1) % n],
                  &after = polygon[(i + 2) % n];
    const Kernel::Vector_2 first = inwards(before, a, b, true), last = inwards(a, b, after, false);
    std::vector<Point_3> points;
    for (std::size_t k = 0; k < layers; ++k)
      for (std::size_t j = 0; j <= degree; ++j) {
        const double s = double(j) / double(degree), depth = double(k) / double(2 * layers - 1);
        const Point_2 on_side = j == degree ? b : a + s * (b - a);
        points.push_back(lift(on_side + depth * ((1 - s) * first + s * last)));
      }
    ribbons.emplace_back(degree, layers, points);
  }
  return Loop(std::move(ribbons));
}

// ----------------------------------------------------------------------------------------- output

// Seconds for each of the items of which an iteration has as many as told.
inline void report_seconds_per(benchmark::State& state, const std::string& item,
                               std::size_t items) {
  state.counters["s/" + item] = benchmark::Counter(
      double(items), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// A rate, of which an iteration does as much as told: "flops/s", "bytes/s".
inline void report_rate(benchmark::State& state, const std::string& name, double per_iteration) {
  state.counters[name] =
      benchmark::Counter(per_iteration, benchmark::Counter::kIsIterationInvariantRate);
}

// CPU time of all threads, for what Google Benchmark does not measure.
inline double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// --------------------------------------------------------------------------------------- threads

// Lets the library use so many threads, as long as this lives.
class Thread_limit {
public:
#ifdef CGAL_LINKED_WITH_TBB
  explicit Thread_limit(std::int64_t threads)
      : control_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}

private:
  tbb::global_control control_;
#else
  explicit Thread_limit(std::int64_t) {}
#endif
};

// For arguments: the numbers of threads to measure with.
inline std::vector<std::int64_t> thread_counts() {
#ifdef CGAL_LINKED_WITH_TBB
  return {1, 2}; // the same on all machines that have them
#else
  return {1};
#endif
}

} // namespace bench

#endif // MULTISIDED_PATCHES_BENCHMARK_FIXTURES_H
