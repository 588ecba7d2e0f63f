// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_STAGE_CLOCK_H
#define MULTIPATCH_STAGE_CLOCK_H

#include <chrono>
#include <cmath>
#include <cstddef>
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

  // Runs f, and adds its time to that of `name`; returns what f returns.
  template <typename Function>
  auto run(const std::string& name, const Function& f) {
    if (show_)
      std::fprintf(stderr, "\r\033[K%s ...", name.c_str());
    const Timer timer{*this, name, Clock::now()};
    return f();
  }

  // Shows how much of what is running is done, now and then.
  void show_progress(const char* what, std::size_t done, std::size_t total) {
    const Clock::time_point now = Clock::now();
    if (!show_ || now - shown_ < std::chrono::milliseconds(100))
      return;
    shown_ = now;
    const double part = total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 0;
    std::fprintf(stderr, "\r\033[K%s: %.0f %% ...", what, std::floor(100 * part));
  }

  // Seconds by stage, in the order in which the stages were first run.
  const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }
  // Those of one stage, 0 if it was never run.
  double seconds(const std::string& name) const {
    for (const auto& [stage, time] : seconds_)
      if (stage == name)
        return time;
    return 0;
  }
  double total_seconds() const {
    double sum = 0;
    for (const auto& stage : seconds_)
      sum += stage.second;
    return sum;
  }

private:
  using Clock = std::chrono::steady_clock;
  struct Timer {
    Stage_clock& owner;
    std::string name;
    Clock::time_point start;
    ~Timer() { owner.add(name, std::chrono::duration<double>(Clock::now() - start).count()); }
  };

  void add(const std::string& name, double time) {
    for (auto& [stage, sum] : seconds_)
      if (stage == name) {
        sum += time;
        return;
      }
    seconds_.emplace_back(name, time);
  }

  bool show_;
  Clock::time_point shown_ = Clock::now();
  std::vector<std::pair<std::string, double>> seconds_;
};

} // namespace multipatch

#endif // MULTIPATCH_STAGE_CLOCK_H
