// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fixtures.h"

#include <CGAL/version.h>

#include <Eigen/Core>

#include <boost/config.hpp>

// What the machine can do, measured in the same run and compiled with the same options as
// everything else: the limits that kernels are compared with. One thread.

namespace {

using Array = Eigen::ArrayXd;
constexpr Eigen::Index large = Eigen::Index(1) << 25; // 256 MiB, beyond any cache

void limit_read_bandwidth(benchmark::State& state) {
  const Array a = Array::Ones(large);
  // Independent sums, so that the additions are no limit.
  using Pack = Eigen::Array<double, 16, 1>;
  for (auto _ : state) {
    Pack sum = Pack::Zero();
    for (Eigen::Index i = 0; i < large; i += Pack::SizeAtCompileTime)
      sum += a.segment<Pack::SizeAtCompileTime>(i);
    benchmark::DoNotOptimize(sum);
  }
  bench::report_rate(state, "bytes/s", 8. * large);
}

// a = b + x c, as STREAM has it and counts its bytes.
void limit_triad_bandwidth(benchmark::State& state) {
  constexpr Eigen::Index size = large / 4;
  Array a = Array::Zero(size), b = Array::Ones(size), c = Array::Ones(size);
  for (auto _ : state) {
    a = b + 3 * c;
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  bench::report_rate(state, "bytes/s", 24. * size);
}

// Multiplications and additions in registers.
void limit_multiply_add(benchmark::State& state) {
  constexpr int lanes = 24, rounds = 10000;
  using Pack = Eigen::Array<double, lanes, 1>;
  double factor = 0.5, summand = 1;
  benchmark::DoNotOptimize(factor);
  benchmark::DoNotOptimize(summand);
  for (auto _ : state) {
    Pack x = Pack::LinSpaced(0, 1);
    for (int i = 0; i < rounds; ++i)
      x = x * factor + summand;
    benchmark::DoNotOptimize(x);
  }
  bench::report_rate(state, "flops/s", 2. * lanes * rounds);
}

// What a well-made kernel reaches.
void limit_matrix_product(benchmark::State& state) {
  constexpr Eigen::Index n = 512;
  const Eigen::MatrixXd a = Eigen::MatrixXd::Constant(n, n, 0.5), b = a;
  Eigen::MatrixXd c(n, n);
  for (auto _ : state) {
    c.noalias() = a * b;
    benchmark::DoNotOptimize(c.data());
    benchmark::ClobberMemory();
  }
  bench::report_rate(state, "flops/s", 2. * n * n * n);
}

// What the tables say about the build.
const bool context = [] {
  const auto number = [](int n) { return std::to_string(n); };
  benchmark::AddCustomContext("compiler", BOOST_COMPILER);
  benchmark::AddCustomContext("CGAL", CGAL_VERSION_STR);
  benchmark::AddCustomContext("Eigen", number(EIGEN_WORLD_VERSION) + '.' +
                                           number(EIGEN_MAJOR_VERSION) + '.' +
                                           number(EIGEN_MINOR_VERSION));
  return true;
}();

} // namespace

BENCHMARK(limit_read_bandwidth)->Unit(benchmark::kMillisecond);
BENCHMARK(limit_triad_bandwidth)->Unit(benchmark::kMillisecond);
BENCHMARK(limit_multiply_add)->Unit(benchmark::kMillisecond);
BENCHMARK(limit_matrix_product)->Unit(benchmark::kMillisecond);
