// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mpi_batch.h"

#include "mpi_leader.h"
#include "mpi_worker.h"

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <memory>

namespace multipatch {

namespace mpi = boost::mpi;

namespace {

// Ends MPI when it goes out of scope, unless told not to: this waits for all ranks, and would do so
// forever if one is lost.
class Mpi_session {
public:
  Mpi_session()
      : environment_(std::make_unique<mpi::environment>(mpi::threading::funneled, false)) {}
  ~Mpi_session() {
    if (!ends_)
      static_cast<void>(environment_.release());
  }
  Mpi_session(const Mpi_session&) = delete;
  Mpi_session& operator=(const Mpi_session&) = delete;

  void set_has_all(bool has_all) { ends_ = has_all; }

private:
  std::unique_ptr<mpi::environment> environment_;
  bool ends_ = false;
};

void lead(const mpi::communicator& world, const Mesh_options& options, Mpi_session& session) {
  Mpi_leader leader(world);
  try {
    leader.run(options);
  } catch (...) {
    session.set_has_all(leader.has_all());
    throw;
  }
  session.set_has_all(leader.has_all());
}

} // namespace

void mpi_batch(const Mesh_options& options) {
  const Batch_settings settings(options); // or fails, on all ranks
  Mpi_session session;
  const mpi::communicator world;
  if (world.rank() == 0) {
    lead(world, options, session);
  } else {
    const Batch_interruption interruption;
    session.set_has_all(Mpi_worker(world, settings).run());
  }
}

} // namespace multipatch
