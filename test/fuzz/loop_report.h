// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_LOOP_REPORT_H
#define MULTISIDED_PATCHES_TEST_FUZZ_LOOP_REPORT_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>

// What is to be run, and what came of it.
namespace fuzz {

struct Options {
  std::uint64_t count = 1000, seed = 1, first = 0, threads = 1;
  double limit = 5; // seconds of processor time
  bool verbose = false;
};

// The first words of a message, without numbers, by which messages are counted.
inline std::string kind_of(const std::string& message) {
  std::istringstream in(message);
  std::string word, kind;
  for (int words = 0; words < 9 && in >> word; ++words) {
    const bool is_number = word.find_first_of("0123456789") != std::string::npos;
    kind += (kind.empty() ? "" : " ") + (is_number ? "#" : word);
  }
  return kind;
}

class Report {
public:
  explicit Report(const Options& options) : options_(options) {}

  void start(const std::string& group) { ++groups_[group].cases; }

  void end(std::uint64_t index, const std::string& group, const std::string& text,
           const std::string& verdict, const std::string& message, double seconds,
           std::size_t triangles, double share_of_target) {
    if (options_.verbose)
      std::cout << index << ": " << verdict << ' ' << message << ", " << seconds << " s, "
                << triangles << " triangles: " << text << '\n';
    Group& g = groups_[group];
    g.seconds += seconds;
    slowest_.insert({seconds, index, text});
    if (slowest_.size() > 5)
      slowest_.erase(slowest_.begin());
    if (verdict == "finding") {
      found(index, text, message);
    } else if (verdict == "mesh") {
      ++g.meshes;
      g.triangles += triangles;
      targets_ += share_of_target > 0;
      hits_ += share_of_target > 0.9 && share_of_target < 1.1;
    } else {
      Refusal& refusal = refusals_[kind_of(message)];
      ++refusal.count;
      refusal.harmless += group.find("harmless") == 0;
      refusal.example = index;
    }
  }

  void found(std::uint64_t index, const std::string& text, const std::string& what) {
    ++findings_[kind_of(what)];
    std::cout << "FINDING: " << what << "\n  in the case " << text << "\n  repeat with --seed "
              << options_.seed << " --first " << index << " --count 1" << std::endl;
  }

  // Returns whether there was no finding.
  bool print() const {
    std::cout << "seed " << options_.seed << ", cases " << options_.first << " to "
              << options_.first + options_.count - 1 << '\n';
    for (const auto& [name, g] : groups_)
      std::printf("%-32s %7zu cases %6.2f %% meshed, %6.1f ms, %7.0f triangles\n", name.c_str(),
                  g.cases, 100 * double(g.meshes) / double(g.cases),
                  1000 * g.seconds / double(g.cases),
                  double(g.triangles) / double((std::max)(g.meshes, std::size_t(1))));
    std::fflush(stdout);
    std::cout << "1000 triangles or more that were asked for: met within 10 % by " << hits_
              << " of " << targets_
              << " meshes\nrefused, by message (of these, harmless loops; the last one):\n";
    for (const auto& [kind, r] : refusals_)
      std::cout << "  " << r.count << " (" << r.harmless << ", " << r.example << "): " << kind
                << '\n';
    std::cout << "slowest:\n";
    for (auto s = slowest_.rbegin(); s != slowest_.rend(); ++s)
      std::cout << "  " << s->seconds << " s: " << s->index << ", " << s->text << '\n';
    std::cout << "findings, by kind:" << (findings_.empty() ? " none" : "") << '\n';
    for (const auto& [kind, count] : findings_)
      std::cout << "  " << count << ": " << kind << '\n';
    std::cout.flush();
    return findings_.empty();
  }

private:
  struct Group {
    std::size_t cases = 0, meshes = 0, triangles = 0;
    double seconds = 0;
  };
  struct Refusal {
    std::size_t count = 0, harmless = 0;
    std::uint64_t example = 0;
  };
  struct Slow {
    double seconds;
    std::uint64_t index;
    std::string text;
    bool operator<(const Slow& other) const {
      return std::make_pair(seconds, index) < std::make_pair(other.seconds, other.index);
    }
  };

  const Options& options_;
  std::map<std::string, Group> groups_;
  std::map<std::string, Refusal> refusals_;
  std::map<std::string, std::size_t> findings_;
  std::set<Slow> slowest_;
  std::size_t targets_ = 0, hits_ = 0;
};

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_LOOP_REPORT_H
