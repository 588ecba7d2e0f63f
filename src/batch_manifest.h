// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_BATCH_MANIFEST_H
#define MULTIPATCH_BATCH_MANIFEST_H

#include "batch_record.h"

#include <string>
#include <unordered_map>

namespace multipatch {

// What is known about the meshes in a directory: a file there with a line of JSON for each event,
// to which lines are only added. The last line on an output counts; lines that make no sense, as
// one may that a crash has cut off, do not. While it is open, no other process can open it,
// unless there is a `lock_error()`.
class Batch_manifest {
public:
  static constexpr const char* file_name = "multipatch-manifest.jsonl";

  // Throws Error if another process has the manifest of this directory, or if it cannot be written.
  explicit Batch_manifest(const std::string& directory);
  ~Batch_manifest();
  Batch_manifest(const Batch_manifest&) = delete;
  Batch_manifest& operator=(const Batch_manifest&) = delete;

  // Why other processes are not kept out, as on file systems without locks; empty if they are.
  const std::string& lock_error() const { return lock_error_; }

  // What earlier runs have said about the output, or nullptr. Not changed by `add()`.
  const Batch_record* find(const std::string& output) const;

  // Adds a line. Throws Error if it cannot be written.
  void add(const Batch_file& file, const Batch_record& record);

private:
  std::string read() const;
  void parse(const std::string& text);

  std::string path_;
  int descriptor_;
  std::string lock_error_;
  std::unordered_map<std::string, Batch_record> earlier_; // by the name of the output alone
};

} // namespace multipatch

#endif // MULTIPATCH_BATCH_MANIFEST_H
