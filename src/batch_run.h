// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_BATCH_RUN_H
#define MULTIPATCH_BATCH_RUN_H

#include "batch_interruption.h"
#include "batch_job.h"
#include "batch_manifest.h"

#include <chrono>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace multipatch {

// Hands out the files of a batch one by one, and takes in what became of them: on the terminal, in
// the manifest, and in the report. Its functions may be called from many threads.
class Batch_run {
public:
  // Throws if something cannot succeed, whichever files there are.
  explicit Batch_run(const Mesh_options& options);

  const Batch_settings& settings() const { return settings_; }
  std::size_t size() const { return files_.size(); }
  const Batch_file& file(std::size_t k) const { return files_[k]; }

  // The number of a file to mesh, and nothing if there is none left, or after what ends the run.
  std::optional<std::size_t> next();
  // The same, but looks at one file at most, and says nothing, too, if that one is up to date.
  std::optional<std::size_t> try_next();
  void finish(std::size_t k, Batch_record record);
  // Lets no file begin, and `conclude()` throw the exception.
  void give_up(std::exception_ptr error);

  // Says on standard error what is worth knowing, and goes on.
  void warn(const std::string& text);

  // When all are finished: writes the report, prints the summary, and throws if there is cause. If
  // there is another one, too, that the report cannot be written is only a warning.
  void conclude();

private:
  using Clock = std::chrono::steady_clock;

  bool is_over() const;
  std::optional<std::size_t> take();
  bool begin(std::size_t k);
  void tell_failure(std::size_t k) const;
  void show_progress();
  void clear_line() const;
  std::size_t count(Batch_status status) const;
  std::string message(std::size_t k) const;
  std::string what_is_left() const;
  void remove_leftovers() const;
  void end() const;
  std::string try_to_write_report() const;
  void write_report() const;
  void print_summary() const;

  Batch_settings settings_;
  std::vector<Batch_file> files_;
  std::vector<Batch_record> records_; // one for each file
  std::optional<Batch_manifest> manifest_;
  Batch_interruption interruption_;

  mutable std::mutex mutex_; // guards all that follows, the records and the manifest
  std::size_t next_ = 0, done_ = 0, failures_ = 0;
  std::exception_ptr error_;
  bool show_;
  Clock::time_point start_ = Clock::now(), shown_ = start_;
};

// Meshes files of the batch until there are none left, in the calling thread.
void work_on(Batch_run& run);

} // namespace multipatch

#endif // MULTIPATCH_BATCH_RUN_H
