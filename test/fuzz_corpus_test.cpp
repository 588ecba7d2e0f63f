// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fuzz/replay_cgb.h"
#include "fuzz/replay_gbp.h"
#include "fuzz/replay_patch_json.h"
#include "fuzz/replay_points.h"
#include "fuzz/replay_polygon.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
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

// Whether the file was replayed; what is wrong with it is a failure that names it.
template <typename Replay>
void replay(const fs::path& file, const Replay& replay_bytes) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
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
