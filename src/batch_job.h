// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_BATCH_JOB_H
#define MULTIPATCH_BATCH_JOB_H

#include "batch_record.h"

#include <CGAL/Multisided_patches/meshing/Mesh_density.h>

#include <cstdint>

namespace multipatch {

// What all files of a batch have in common.
struct Batch_settings {
  explicit Batch_settings(const Mesh_options& options);

  const Mesh_options& options;
  CGAL::Multisided_patches::Mesh_density density;
  std::uint64_t hash; // of the version and of all options that change meshes
};

// Whether the file is meshed already, as the record of an earlier run says.
bool is_up_to_date(const Batch_file& file, const Batch_record& record,
                   const Batch_settings& settings);

// Meshes a file in the calling thread alone; the mesh is the same as that of any other way. What
// goes wrong is in the record, and nothing is written then. After a signal, the record may be that
// of a file which is not done.
Batch_record mesh_file(const Batch_file& file, const Batch_settings& settings);

} // namespace multipatch

#endif // MULTIPATCH_BATCH_JOB_H
