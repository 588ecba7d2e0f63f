// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mpi_batch.h"

#include <CGAL/Multisided_patches/errors.h>

namespace multipatch {

// Stands in for mpi_batch.cpp.
void mpi_batch(const Mesh_options&) {
  throw CGAL::Multisided_patches::Input_error(
      "--mpi: this program was built without MPI; configure it with "
      "-DMULTISIDED_PATCHES_WITH_MPI=ON, which needs Boost.MPI (Debian: libboost-mpi-dev)");
}

} // namespace multipatch
