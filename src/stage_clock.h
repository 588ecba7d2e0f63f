// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_STAGE_CLOCK_H
#define MULTIPATCH_STAGE_CLOCK_H

#include <chrono>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace multipatch {

// Times the stages of a job. On a terminal it also shows which one is running.
class Stage_clock {
public:
  explicit Stage_clock(bool quiet) : show_(!quiet && isatty(STDERR_FILENO)) {}
  ~Stage_clock() {
    if (show_)
      std::fprintf(stderr, "\r\033[K");
  }
  Stage_clock(const Stage_clock&) = delete;
  Stage_clock& operator=(const Stage_clock&) = delete;

  // Runs f, and keeps its time under `name`; returns what f returns.
  template <typename Function>
  auto run(const std::string& name, const Function& f) {
    if (show_)
      std::fprintf(stderr, "\r\033[K%s ...", name.c_str());
    const Timer timer{*this, name, Clock::now()};
    return f();
  }

  // Seconds by stage, in the order in which the stages were run.
  const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }

private:
  using Clock = std::chrono::steady_clock;
  struct Timer {
    Stage_clock& owner;
    std::string name;
    Clock::time_point start;
    ~Timer() {
      owner.seconds_.emplace_back(name,
                                  std::chrono::duration<double>(Clock::now() - start).count());
    }
  };

  bool show_;
  std::vector<std::pair<std::string, double>> seconds_;
};

} // namespace multipatch

#endif // MULTIPATCH_STAGE_CLOCK_H
