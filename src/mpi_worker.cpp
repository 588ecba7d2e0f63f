// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mpi_worker.h"

#include <CGAL/Multisided_patches/errors.h>

#include <boost/mpi/environment.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <string>

namespace multipatch {

bool Mpi_worker::run() {
  // Rank 0 may be silent while it looks whether a large file is up to date.
  const double patience = 10 * settings_.options.batch.rank_timeout;
  mailbox_.send(
      {0, ready, std::to_string(settings_.hash) + ' ' + boost::mpi::environment::processor_name()});
  for (;; wait_a_little()) {
    while (const auto letter = mailbox_.receive()) {
      silence_.end();
      if (letter->kind == stop)
        return letter->text == everybody;
      if (letter->kind == task)
        begin(letter->text);
    }
    if (record_.valid() && record_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
      tell_outcome();
    if (heartbeat_.is_due())
      mailbox_.send({0, alive, ""});
    mailbox_.is_delivered();
    if (silence_.seconds() > patience)
      throw CGAL::Multisided_patches::Error("rank " + std::to_string(rank_) + ": rank 0 is lost");
  }
}

// In another thread, so that this one can give signs of life.
void Mpi_worker::begin(const std::string& input) {
  file_ = {input, batch_output(input, settings_.options.batch)};
  record_ = std::async(std::launch::async, [this] { return mesh_file(file_, settings_); });
}

void Mpi_worker::tell_outcome() {
  mailbox_.send({0, outcome,
                 record_json(file_, record_.get())
                     .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)});
}

} // namespace multipatch
