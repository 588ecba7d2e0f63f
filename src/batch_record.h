// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_BATCH_RECORD_H
#define MULTIPATCH_BATCH_RECORD_H

#include "batch_files.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace multipatch {

enum class Batch_status {
  not_done,   // its turn has not come
  started,    // and not finished, as far as is known
  meshed,     // in this run
  up_to_date, // meshed by an earlier run, with the same options
  failed
};

const char* to_string(Batch_status status);

// What became of a file of a batch.
struct Batch_record {
  Batch_status status = Batch_status::not_done;
  std::string error; // one line, if it failed

  // What it was made from and is, to know it again.
  std::uint64_t options = 0, input = 0; // hashes
  std::uintmax_t bytes = 0;

  std::size_t vertices = 0, triangles = 0;
  double smallest_angle = 0; // degrees
  std::string domain;        // the generator
  double seconds = 0;
};

// FNV-1a, 64 bits (Fowler, Noll, Vo): it tells changes, but is no protection against forgery.
std::uint64_t hash(const std::string& text);

// A line of the manifest, an entry of the report.
nlohmann::ordered_json record_json(const Batch_file& file, const Batch_record& record);

// Reads it back, but for the file. Throws nlohmann::json::exception, or std::invalid_argument, if
// it is something else.
Batch_record parse_record(const nlohmann::ordered_json& json);

} // namespace multipatch

#endif // MULTIPATCH_BATCH_RECORD_H
