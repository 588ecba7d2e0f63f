// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"

#include <CGAL/Multisided_patches/internal/Number_pack.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/Patch_evaluator.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

// Points and normals of many points: one by one, at once, and where only control points move.
// Everything is in double; harmonic coordinates are part of the work, but not of Patch_evaluator's.

namespace {

using bench::MP::Patch_evaluator;
using bench::MP::internal::Number_pack;
using Patch = bench::MP::Concave_bezier_patch_3<bench::Kernel>;
using Result = std::pair<bench::Point_3, bench::Kernel::Vector_3>;

// Points inside a domain, row by row of a grid.
struct Samples {
  std::vector<bench::Point_2> points;
  std::vector<Patch::Location> locations;

  Samples(const bench::Domain& domain, std::size_t count) {
    const CGAL::Bbox_2 box = domain.bbox();
    const double area = (box.xmax() - box.xmin()) * (box.ymax() - box.ymin());
    double step = std::sqrt(area / double(count)) / 1.1;
    do { // until there are enough points
      points.clear();
      for (double v = box.ymin() + step / 2; v < box.ymax(); v += step)
        for (double u = box.xmin() + step / 3; u < box.xmax(); u += step)
          if (domain.locate({u, v}).kind == Patch::Location::Kind::interior)
            points.emplace_back(u, v);
      step /= 1.1;
    } while (points.size() < count);
    points.resize(count);
    locations.assign(count, Patch::Location::interior());
  }
};

// A patch with n sides, most of whose loop is concave, and degree 2 l - 1 for l layers.
Patch patch_with_sides(std::int64_t n, std::int64_t layers) {
  const auto l = static_cast<std::size_t>(layers);
  return Patch(bench::Model(
      bench::dome(bench::plan(bench::random, static_cast<std::size_t>(n)), 2 * l - 1, l)));
}

void points_one_by_one(benchmark::State& state) {
  const Patch patch = patch_with_sides(state.range(0), state.range(1));
  const Samples samples(patch.domain(), static_cast<std::size_t>(state.range(2)));
  std::vector<Result> results(samples.points.size());
  for (auto _ : state) {
    for (std::size_t k = 0; k < results.size(); ++k)
      results[k] = patch.point_and_normal(samples.points[k], samples.locations[k]);
    benchmark::DoNotOptimize(results.data());
  }
  bench::report_seconds_per(state, "point", results.size());
}

void measure_batches(benchmark::State& state, const Patch& patch, std::int64_t count,
                     std::int64_t threads) {
  const bench::Thread_limit limit(threads);
  const Samples samples(patch.domain(), static_cast<std::size_t>(count));
  std::vector<Result> results(samples.points.size());
  for (auto _ : state) {
    patch.points_and_normals(samples.points, samples.locations, results.begin());
    benchmark::DoNotOptimize(results.data());
  }
  bench::report_seconds_per(state, "point", results.size());
}

void points_at_once(benchmark::State& state) {
  measure_batches(state, patch_with_sides(state.range(0), state.range(1)), state.range(2),
                  state.range(3));
}

void points_of_model_at_once(benchmark::State& state) {
  const std::string name = bench::model_names[state.range(0)];
  state.SetLabel(name);
  measure_batches(state, Patch(bench::read_model(name)), state.range(1), state.range(2));
}

// Numbers to be read that fill at least so many bytes, and much more than the caches.
class Memory {
public:
  static constexpr std::size_t cached_bytes = 10'000'000; // what caches may hold

  explicit Memory(std::size_t bytes = 0)
      : numbers_(block * (std::max)(least_blocks, blocks_for(bytes)), 1.0),
        sums_(numbers_.size() / block) {}

  std::size_t bytes() const { return numbers_.size() * sizeof(double); }

  // Reads at least so many bytes on all threads, those that have not been read for longest. Returns
  // how many they were. pre: there are as many
  std::size_t read(std::size_t bytes) {
    const std::size_t count = blocks_for(bytes);
    bench::MP::internal::for_each_index<CGAL::Parallel_if_available_tag>(
        count,
        [&](std::size_t k) {
          const std::size_t b = (next_ + k) % sums_.size();
          sums_[b] = sum(&numbers_[b * block]);
        },
        1);
    benchmark::DoNotOptimize(sums_.data());
    next_ += count;
    return count * block * sizeof(double);
  }

private:
  static constexpr std::size_t block = 1 << 14, least_blocks = 1 << 11;

  static std::size_t blocks_for(std::size_t bytes) {
    return (bytes + block * sizeof(double) - 1) / (block * sizeof(double));
  }

  static double sum(const double* numbers) {
    std::array<Number_pack, 8> sum;
    sum.fill(Number_pack(0));
    constexpr std::size_t lanes = Number_pack::lanes;
    for (std::size_t k = 0; k < block; k += sum.size() * lanes)
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += Number_pack::load(&numbers[k + i * lanes]);
    for (std::size_t i = 1; i < sum.size(); ++i)
      sum[0] += sum[i];
    return sum[0][0] + sum[0][1];
  }

  std::vector<double> numbers_, sums_;
  std::size_t next_ = 0;
};

// What memory delivers at best.
void memory_bandwidth(benchmark::State& state) {
  const bench::Thread_limit limit(state.range(0));
  Memory memory;
  for (auto _ : state)
    memory.read(memory.bytes());
  bench::report_rate(state, "bytes/s", double(memory.bytes()));
}

// Of u_vent, with as many samples as told.
template <int Order, typename Storage>
class Evaluator {
public:
  explicit Evaluator(benchmark::State& state)
      : limit_(state.range(1)), patch_(bench::read_model("u_vent")),
        samples_(patch_.domain(), static_cast<std::size_t>(state.range(0))),
        evaluator_(patch_, samples_.points, samples_.locations) {
    state.counters["megabytes"] = double(evaluator_.number_of_bytes()) / 1e6;
  }

  Patch_evaluator<Patch, Order, Storage>& operator*() { return evaluator_; }

private:
  bench::Thread_limit limit_;
  Patch patch_;
  Samples samples_;
  Patch_evaluator<Patch, Order, Storage> evaluator_;
};

template <typename Function>
double seconds(const Function& f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// All weights are read, and all results written. What memory delivers changes from second to second
// where machines are shared, so it is measured in between, unless all fits into caches.
template <int Order, typename Storage>
void all_control_points_move(benchmark::State& state) {
  Evaluator<Order, Storage> evaluator(state);
  std::vector<bench::Point_3> points;
  for (std::size_t c = 0; c < (*evaluator).number_of_control_points(); ++c)
    points.push_back((*evaluator).control_point(c));
  const std::size_t bytes = (*evaluator).number_of_bytes();
  const bool is_cached = bytes <= Memory::cached_bytes;
  Memory memory(is_cached ? 0 : bytes);
  double bytes_read = 0, seconds_of_reading = 0;
  for (auto _ : state) {
    if (!is_cached)
      seconds_of_reading += seconds([&] { bytes_read += double(memory.read(bytes)); });
    state.SetIterationTime(seconds([&] { (*evaluator).set_control_points(points); }));
  }
  if (is_cached)
    return;
  bench::report_rate(state, "bytes/s", double(bytes));
  state.counters["bandwidth"] = bytes_read / seconds_of_reading;
}

template <int Order, typename Storage>
void one_control_point_moves(benchmark::State& state) {
  Evaluator<Order, Storage> evaluator(state);
  const std::size_t c = (*evaluator).basis().index(1, 1, 1);
  const bench::Point_3 start = (*evaluator).control_point(c);
  double step = 0;
  for (auto _ : state) {
    step = step < 0.1 ? step + 0.01 : 0;
    (*evaluator).set_control_point(c, start + bench::Kernel::Vector_3(0, 0, step));
  }
}

template <int Order, typename Storage>
void one_ribbon_moves(benchmark::State& state) {
  Evaluator<Order, Storage> evaluator(state);
  std::vector<std::pair<std::size_t, bench::Point_3>> moves;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t j = 0; j <= 3; ++j) {
      const std::size_t c = (*evaluator).basis().index(1, j, k);
      moves.emplace_back(c, (*evaluator).control_point(c));
    }
  double step = 0.01;
  for (auto _ : state) {
    for (auto& move : moves)
      move.second = move.second + bench::Kernel::Vector_3(0, 0, step);
    step = -step;
    (*evaluator).move_control_points(moves);
  }
}

} // namespace

BENCHMARK(points_one_by_one)
    ->ArgNames({"n", "layers", "points"})
    ->ArgsProduct({{3, 6, 8, 12, 24}, {2, 3}, {1000, 100000}});
BENCHMARK(points_at_once)
    ->ArgNames({"n", "layers", "points", "threads"})
    ->ArgsProduct({{3, 6, 8, 12, 24}, {2, 3}, {1000, 10000, 100000, 1000000}, {1}})
    ->ArgsProduct({{8}, {2}, {1000000}, bench::thread_counts()})
    ->UseRealTime();
BENCHMARK(points_of_model_at_once)
    ->ArgNames({"model", "points", "threads"})
    ->ArgsProduct({{0, 1, 2, 3, 4}, {50000}, {1}})
    ->UseRealTime();

BENCHMARK(memory_bandwidth)
    ->ArgName("threads")
    ->ArgsProduct({bench::thread_counts()})
    ->UseRealTime();
#define MULTISIDED_PATCHES_MEASURE(function, order, storage)                                       \
  BENCHMARK_TEMPLATE(function, order, storage)                                                     \
      ->ArgNames({"points", "threads"})                                                            \
      ->ArgsProduct({{1000, 100000, 1000000}, bench::thread_counts()})
MULTISIDED_PATCHES_MEASURE(all_control_points_move, 0, double)->UseManualTime();
MULTISIDED_PATCHES_MEASURE(all_control_points_move, 0, float)->UseManualTime();
MULTISIDED_PATCHES_MEASURE(all_control_points_move, 1, double)->UseManualTime();
MULTISIDED_PATCHES_MEASURE(all_control_points_move, 1, float)->UseManualTime();
MULTISIDED_PATCHES_MEASURE(one_control_point_moves, 0, double)->UseRealTime();
MULTISIDED_PATCHES_MEASURE(one_control_point_moves, 1, double)->UseRealTime();
MULTISIDED_PATCHES_MEASURE(one_control_point_moves, 1, float)->UseRealTime();
MULTISIDED_PATCHES_MEASURE(one_ribbon_moves, 1, double)->UseRealTime();
