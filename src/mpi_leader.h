// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MPI_LEADER_H
#define MULTIPATCH_MPI_LEADER_H

#include "batch_run.h"
#include "mpi_messages.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace multipatch {

// Rank 0: shares a batch among the ranks.
class Mpi_leader {
public:
  explicit Mpi_leader(const boost::mpi::communicator& world);

  // Meshes the batch, and returns when all ranks have been told to stop, or throws then.
  void run(const Mesh_options& options);

  // Whether all ranks are there, as far as is known, and no signal has come, after which they may
  // be gone. Else MPI must not be ended in good order: it would wait for them.
  bool has_all() const;

private:
  using Clock = std::chrono::steady_clock;
  struct Worker {
    std::string host;
    std::optional<std::size_t> task;
    bool is_ready = false, is_lost = false;
    Mpi_silence silence;
  };

  void share(Batch_run& batch);
  bool is_working() const;
  void receive(Batch_run& batch);
  void hand_out(Batch_run& batch);
  void look_after(Batch_run& batch);
  void lose(std::size_t rank, Batch_run& batch);
  void tell_who_was_at_work(Batch_run& batch) const;
  void stop();
  Worker& worker(int rank) { return workers_[static_cast<std::size_t>(rank)]; }

  Mpi_mailbox mailbox_;
  std::vector<Worker> workers_; // the first one, rank 0 itself, is not used
  Mpi_heartbeat heartbeat_;
  double timeout_ = 0; // seconds
};

} // namespace multipatch

#endif // MULTIPATCH_MPI_LEADER_H
