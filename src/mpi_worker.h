// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MPI_WORKER_H
#define MULTIPATCH_MPI_WORKER_H

#include "batch_job.h"
#include "mpi_messages.h"

#include <future>

namespace multipatch {

// A rank other than 0: meshes the files that rank 0 hands out.
class Mpi_worker {
public:
  Mpi_worker(const boost::mpi::communicator& world, const Batch_settings& settings)
      : mailbox_(world), rank_(world.rank()), settings_(settings) {}

  // Works until rank 0 says stop; returns whether all ranks are there. Throws Error if rank 0 is
  // lost.
  bool run();

private:
  void begin(const std::string& input);
  void tell_outcome();

  Mpi_mailbox mailbox_;
  int rank_;
  const Batch_settings& settings_;
  Mpi_heartbeat heartbeat_;
  Mpi_silence silence_;
  Batch_file file_;
  std::future<Batch_record> record_; // of the file, while it is meshed
};

} // namespace multipatch

#endif // MULTIPATCH_MPI_WORKER_H
