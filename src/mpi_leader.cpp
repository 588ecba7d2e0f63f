// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mpi_leader.h"

#include <CGAL/Multisided_patches/errors.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

Mpi_leader::Mpi_leader(const boost::mpi::communicator& world)
    : mailbox_(world), workers_(static_cast<std::size_t>(world.size())) {}

void Mpi_leader::run(const Mesh_options& options) {
  timeout_ = options.batch.rank_timeout;
  std::optional<Batch_run> batch;
  try {
    batch.emplace(options);
    share(*batch);
  } catch (...) {
    stop();
    throw;
  }
  stop();
  batch->conclude();
}

bool Mpi_leader::has_all() const {
  return Batch_interruption::received() == 0 &&
         std::none_of(workers_.begin(), workers_.end(), [](const Worker& w) { return w.is_lost; });
}

// Meshes in another thread, so that this one always has time for the other ranks.
void Mpi_leader::share(Batch_run& batch) {
  std::atomic<bool> is_done{false};
  std::thread own_work([&] {
    work_on(batch);
    is_done = true;
  });
  try {
    // After a signal mpirun leaves little time, and others may be gone already.
    constexpr std::chrono::milliseconds grace(300);
    std::optional<Clock::time_point> end;
    while (!is_done || (is_working() && !(end && Clock::now() > *end))) {
      hand_out(batch);
      receive(batch);
      look_after(batch);
      mailbox_.is_delivered();
      if (Batch_interruption::received() != 0 && !end) {
        tell_who_was_at_work(batch);
        end = Clock::now() + grace;
      }
      wait_a_little();
    }
  } catch (...) {
    batch.give_up(std::current_exception());
  }
  own_work.join();
}

bool Mpi_leader::is_working() const {
  return std::any_of(workers_.begin(), workers_.end(),
                     [](const Worker& w) { return w.task.has_value(); });
}

void Mpi_leader::receive(Batch_run& batch) {
  while (const auto letter = mailbox_.receive()) {
    Worker& sender = worker(letter->rank);
    if (sender.is_lost) { // and now is back: too late, but it is to wait for the end
      mailbox_.send({letter->rank, alive, ""});
      continue;
    }
    sender.silence.end();
    if (letter->kind == ready) {
      const std::size_t space = letter->text.find(' ');
      sender.host = letter->text.substr(space + 1);
      sender.is_ready = true;
      if (letter->text.substr(0, space) != std::to_string(batch.settings().hash))
        throw MP::Error("rank " + std::to_string(letter->rank) + " on " + sender.host +
                        " runs another version of the program, or with other options");
    } else if (letter->kind == outcome && sender.task) {
      batch.finish(*std::exchange(sender.task, std::nullopt),
                   parse_record(nlohmann::ordered_json::parse(letter->text)));
      sender.is_ready = true;
    }
  }
}

// One file at most, as to look whether it is up to date takes time.
void Mpi_leader::hand_out(Batch_run& batch) {
  const auto idle = std::find_if(workers_.begin(), workers_.end(),
                                 [](const Worker& w) { return w.is_ready && !w.is_lost; });
  if (idle == workers_.end())
    return;
  idle->task = batch.try_next();
  if (!idle->task)
    return;
  idle->is_ready = false;
  mailbox_.send({static_cast<int>(idle - workers_.begin()), task, batch.file(*idle->task).input});
}

void Mpi_leader::look_after(Batch_run& batch) {
  if (!heartbeat_.is_due())
    return;
  for (std::size_t r = 1; r < workers_.size(); ++r) {
    if (workers_[r].is_lost)
      continue;
    mailbox_.send({static_cast<int>(r), alive, ""});
    if (workers_[r].silence.seconds() > timeout_)
      lose(r, batch);
  }
}

// Its file may be what has ended it, and is not given to another rank.
void Mpi_leader::lose(std::size_t rank, Batch_run& batch) {
  Worker& lost = workers_[rank];
  lost.is_lost = true;
  const std::string name = "rank " + std::to_string(rank) + " on " + lost.host;
  batch.warn(name + " is lost");
  if (!lost.task)
    return;
  Batch_record record;
  record.options = batch.settings().hash;
  record.status = Batch_status::failed;
  record.error = name + ", which was to mesh it, is lost";
  batch.finish(*std::exchange(lost.task, std::nullopt), std::move(record));
}

// Where mpirun ends all ranks because one is lost, it names that rank.
void Mpi_leader::tell_who_was_at_work(Batch_run& batch) const {
  for (std::size_t r = 1; r < workers_.size(); ++r)
    if (workers_[r].task)
      batch.warn("rank " + std::to_string(r) + " on " + workers_[r].host + " was at work on " +
                 batch.file(*workers_[r].task).input);
}

void Mpi_leader::stop() {
  for (std::size_t r = 1; r < workers_.size(); ++r) // those that count as lost may live
    mailbox_.send({static_cast<int>(r), Mpi_message::stop, has_all() ? everybody : ""});
  constexpr std::chrono::seconds grace(2); // for those that do not listen any more
  const Clock::time_point end = Clock::now() + grace;
  while (!mailbox_.is_delivered() && Clock::now() < end)
    wait_a_little();
}

} // namespace multipatch
