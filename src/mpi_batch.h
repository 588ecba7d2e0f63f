// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MPI_BATCH_H
#define MULTIPATCH_MPI_BATCH_H

#include "commands.h"

namespace multipatch {

// The same as `batch_command()`, on all ranks of an MPI job: rank 0 hands out files one by one, and
// meshes some itself. Each rank has one file at a time. Throws Input_error if the program was built
// without MPI.
void mpi_batch(const Mesh_options& options);

} // namespace multipatch

#endif // MULTIPATCH_MPI_BATCH_H
