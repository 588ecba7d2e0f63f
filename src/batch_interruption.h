// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_BATCH_INTERRUPTION_H
#define MULTIPATCH_BATCH_INTERRUPTION_H

#include <atomic>
#include <csignal>
#include <utility>

namespace multipatch {

// While there is one, SIGINT and SIGTERM do not end the program but ask to end the work in good
// order; a second one ends the program. What is ignored stays ignored, as in background jobs.
class Batch_interruption {
public:
  Batch_interruption() {
    struct sigaction action = {};
    action.sa_handler = [](int number) { received_ = number; };
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    for (const auto& [signal, before] :
         {std::pair(SIGINT, &on_interrupt_), std::pair(SIGTERM, &on_terminate_)}) {
      sigaction(signal, &action, before);
      if (before->sa_handler == SIG_IGN)
        sigaction(signal, before, nullptr);
    }
  }
  ~Batch_interruption() {
    sigaction(SIGINT, &on_interrupt_, nullptr);
    sigaction(SIGTERM, &on_terminate_, nullptr);
  }
  Batch_interruption(const Batch_interruption&) = delete;
  Batch_interruption& operator=(const Batch_interruption&) = delete;

  // The signal that has come, 0 if none has.
  static int received() { return received_; }

private:
  static_assert(std::atomic<int>::is_always_lock_free, "signal handlers must not wait for locks");
  static inline std::atomic<int> received_{0};
  struct sigaction on_interrupt_ = {}, on_terminate_ = {};
};

} // namespace multipatch

#endif // MULTIPATCH_BATCH_INTERRUPTION_H
