// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fuzz/random_loops.h"
#include "fuzz/replay_cgb.h"
#include "fuzz/replay_gbp.h"
#include "fuzz/replay_harmonic.h"
#include "fuzz/replay_patch_json.h"
#include "fuzz/replay_points.h"
#include "fuzz/replay_polygon.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

// Replays what the fuzzers of test/fuzz have found, without any fuzzer. FUZZ_DIR is that directory.

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.is_regular_file())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Whether the file was replayed; what is wrong with it is a failure that names it.
template <typename Replay>
void replay(const fs::path& file, const Replay& replay_bytes) {
  const std::string bytes = bytes_of(file);
  INFO(file);
  CHECK_NOTHROW(replay_bytes(bytes));
}

template <typename Replay>
void replay_all(const std::string& kind, const Replay& replay_bytes) {
  const auto corpus = files_in(fs::path(FUZZ_DIR) / "corpus" / kind);
  CHECK(!corpus.empty());
  for (const fs::path& file : corpus)
    replay(file, replay_bytes);
  const fs::path findings = fs::path(FUZZ_DIR) / "findings" / kind;
  if (fs::exists(findings)) // version control keeps no empty directories
    for (const fs::path& file : files_in(findings))
      replay(file, replay_bytes);
}

} // namespace

TEST_CASE("Every .cgb file of the fuzzer's corpus is read or refused with an error") {
  replay_all("cgb", fuzz::replay_cgb);
}

TEST_CASE("Every polygon file of the fuzzer's corpus is read or refused with an error") {
  replay_all("polygon", fuzz::replay_polygon);
}

TEST_CASE("Every point file of the fuzzer's corpus is read or refused with an error") {
  replay_all("points", fuzz::replay_points);
}

TEST_CASE("Every .gbp file of the fuzzer's corpus is read or refused with an error") {
  replay_all("gbp", fuzz::replay_gbp);
}

TEST_CASE("Every .patch.json file of the fuzzer's corpus is read or refused with an error") {
  replay_all("patch_json", fuzz::replay_patch_json);
}

// More rounds took up to 20 seconds, and gained nothing. The targets are just out of reach.
TEST_CASE("Harmonic coordinates give up soon where the rounding of vertices limits the accuracy") {
  struct Finding {
    const char* file;
    double target, acceptable, reached;
  };
  for (const Finding& f : {Finding{"spike_of_3e-7_radians", 1e-6, 1e-3, 1e-5},
                           Finding{"vertices_6e-12_apart", 1e-5, 1e-3, 1e-4},
                           Finding{"vertices_7e-15_apart", 1e-4, 1e-4, 1e-1}}) {
    INFO(f.file);
    const auto solution = fuzz::solve_for_harmonic(
        bytes_of(fs::path(FUZZ_DIR) / "findings" / "polygon" / f.file), f.target, f.acceptable);
    CHECK(solution.rounds <= 3);
    CHECK(solution.error < f.reached);
  }
}

// In case 46864 the corners of the side that became a point are 6e-14 apart, so that the loop is
// closed by moving one of them, and the side is no point any more.
TEST_CASE("What the fuzzer calls a broken loop is refused") {
  const std::uint64_t seed = 20261122;
  std::vector<std::uint64_t> indices(3000);
  std::iota(indices.begin(), indices.end(), std::uint64_t(0));
  indices.push_back(46864);
  std::size_t broken = 0;
  for (const std::uint64_t index : indices) {
    INFO("seed " << seed << ", index " << index);
    fuzz::Random random = fuzz::random_of_case(seed, index);
    if (fuzz::chance(random, 0.12)) // it is a domain
      continue;
    const fuzz::Raw_loop raw = fuzz::random_raw_loop(random);
    broken += raw.is_broken;
    if (raw.is_broken)
      CHECK_THROWS_AS(raw.loop(), fixtures::MP::Input_error);
  }
  CHECK(broken > 30);
}
