// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_PROGRAM_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_PROGRAM_FIXTURES_H

#include "catch.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <sys/wait.h>

// What tests of the program share: they run it as a user does. POSIX only.
namespace program_fixtures {

namespace fs = std::filesystem;

inline std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Result {
  int status; // what the program returned, -1 if it did not end by itself
  std::string out, err;
};

// An empty directory for one test, in which the program runs.
class Scratch {
public:
  explicit Scratch(const std::string& name) : path_(fs::path(PROGRAM_TEST_DIR) / name) {
    fs::remove_all(path_);
    fs::create_directories(path_ / "work");
  }

  fs::path operator/(const std::string& name) const { return path_ / "work" / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(*this / name, std::ios::binary) << text;
  }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(path_ / "work"))
      names.insert(entry.path().filename().string());
    return names;
  }

  // The limit, in seconds, turns an endless loop into a failure. Where `output` sends standard
  // output somewhere else, it is not in the result; `first` is for the shell to do before.
  Result run(const std::string& arguments, const std::string& output = ">../out",
             const std::string& first = "") const {
    std::ofstream(path_ / "out");
    const std::string command = "cd '" + (path_ / "work").string() + "' && ulimit -t 100 && " +
                                first + " '" + PROGRAM + "' " + arguments +
                                " 2>../err </dev/null " + output;
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(path_ / "out"),
            contents(path_ / "err")};
  }

  // The same for mistakes that the command line alone shows.
  Result run_wrongly(const std::string& arguments) const {
    const Result result = run(arguments);
    INFO(arguments);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    CHECK(result.err.find("\nRun with --help for more information.\n") != std::string::npos);
    return result;
  }

  // Runs it and expects success without complaints.
  std::string run_well(const std::string& arguments) const {
    const Result result = run(arguments);
    INFO(arguments);
    CHECK(result.status == 0);
    CHECK(result.err.empty());
    return result.out;
  }

private:
  fs::path path_;
};

struct Example {
  std::string name, argument; // the second as the shell wants it
};

inline std::vector<Example> examples() {
  std::vector<Example> result;
  for (const auto& entry : fs::directory_iterator(MODELS_DIR))
    if (entry.path().extension() == ".cgb")
      result.push_back({entry.path().stem().string(), "'" + entry.path().string() + "'"});
  std::sort(result.begin(), result.end(),
            [](const Example& a, const Example& b) { return a.name < b.name; });
  REQUIRE(result.size() >= 10);
  return result;
}

} // namespace program_fixtures

#endif // MULTISIDED_PATCHES_TEST_PROGRAM_FIXTURES_H
