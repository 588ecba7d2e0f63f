// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch_run.h"

#include "report_json.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <unordered_set>
#include <utility>
#include <vector>

#include <unistd.h>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;
namespace fs = std::filesystem;

namespace {

// The report may be in the directory. If it cannot be written, nothing is left.
void make_directory(const Mesh_options& options) {
  std::error_code error, ignored;
  std::vector<fs::path> made;
  for (fs::path path = options.batch.directory;
       path.has_relative_path() && !fs::exists(path, error); path = path.parent_path())
    made.push_back(path);
  fs::create_directories(options.batch.directory, error);
  if (error)
    throw MP::Error(options.batch.directory + ": cannot be made: " + error.message());
  try {
    if (!options.report.empty())
      MP::internal::check_writable(options.report);
  } catch (...) {
    for (const fs::path& path : made)
      fs::remove(path, ignored);
    throw;
  }
}

// Whether the file may belong to a run that is at work: meshes are written in much less time.
bool is_recent(const fs::path& path) {
  std::error_code error;
  const auto time = fs::last_write_time(path, error);
  return error || fs::file_time_type::clock::now() - time < std::chrono::minutes(1);
}

} // namespace

Batch_run::Batch_run(const Mesh_options& options)
    : settings_(options), files_(batch_files(options)), records_(files_.size()),
      show_(!options.quiet && isatty(STDERR_FILENO)) {
  make_directory(options);
  manifest_.emplace(options.batch.directory);
  if (!manifest_->lock_error().empty())
    warn(options.batch.directory + ": cannot be locked against other runs, of which none should " +
         "write to it now: " + manifest_->lock_error());
  remove_leftovers();
}

std::optional<std::size_t> Batch_run::next() {
  while (const auto k = take())
    if (begin(*k))
      return k;
  return std::nullopt;
}

std::optional<std::size_t> Batch_run::try_next() {
  const auto k = take();
  return k && begin(*k) ? k : std::nullopt;
}

void Batch_run::finish(std::size_t k, Batch_record record) {
  const std::lock_guard<std::mutex> lock(mutex_);
  records_[k] = std::move(record);
  if (records_[k].status == Batch_status::not_done) // interrupted
    return;
  ++done_;
  manifest_->add(files_[k], records_[k]);
  if (records_[k].status == Batch_status::failed) {
    ++failures_;
    if (settings_.options.batch.keep_going)
      tell_failure(k);
  }
  show_progress();
}

void Batch_run::give_up(std::exception_ptr error) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!error_)
    error_ = std::move(error);
}

void Batch_run::warn(const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  multipatch::warn(text);
}

void Batch_run::conclude() {
  clear_line();
  const std::string report_error = try_to_write_report();
  try {
    end();
  } catch (...) {
    if (!report_error.empty())
      warn(report_error);
    throw;
  }
  if (!report_error.empty())
    throw MP::Error(report_error);
}

void Batch_run::end() const {
  if (error_)
    std::rethrow_exception(error_);
  const int signal = Batch_interruption::received();
  if (signal != 0 && done_ < files_.size()) {
    std::fprintf(stderr,
                 "multipatch: interrupted; %zu of %zu files are done, and the same command with "
                 "--resume does the others\n",
                 done_ - failures_, files_.size());
    throw Interrupted{signal};
  }
  if (failures_ > 0 && !settings_.options.batch.keep_going)
    for (std::size_t k = 0; k < files_.size(); ++k)
      if (records_[k].status == Batch_status::failed)
        throw MP::Error(message(k) + what_is_left());
  if (!settings_.options.quiet)
    print_summary();
  if (failures_ > 0)
    throw MP::Error(std::to_string(failures_) + " of " + std::to_string(files_.size()) +
                    " files failed");
}

// After the first file that has failed.
std::string Batch_run::what_is_left() const {
  const std::size_t left = files_.size() - done_;
  return left == 0 ? ""
                   : "; not done: " + std::to_string(left) + " of " +
                         std::to_string(files_.size()) + " files, with which --keep-going goes on";
}

bool Batch_run::is_over() const {
  return error_ || (failures_ > 0 && !settings_.options.batch.keep_going) ||
         Batch_interruption::received() != 0 || next_ == files_.size();
}

std::optional<std::size_t> Batch_run::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_over())
    return std::nullopt;
  return next_++;
}

// Whether the file is to be meshed, and is not up to date.
bool Batch_run::begin(std::size_t k) {
  const Batch_record* earlier = manifest_->find(files_[k].output);
  // Reads files, and is therefore done without the lock.
  const bool passes = earlier != nullptr && settings_.options.batch.resume &&
                      is_up_to_date(files_[k], *earlier, settings_);
  const std::lock_guard<std::mutex> lock(mutex_);
  Batch_record& record = records_[k];
  if (passes) {
    record = *earlier;
    record.status = Batch_status::up_to_date;
    ++done_;
    show_progress();
    return false;
  }
  record.options = settings_.hash;
  record.status = Batch_status::started;
  // If the run is killed after the mesh is replaced, what the manifest says would be wrong.
  if (earlier != nullptr && earlier->status == Batch_status::meshed)
    manifest_->add(files_[k], record);
  return true;
}

void Batch_run::tell_failure(std::size_t k) const {
  clear_line();
  std::fprintf(stderr, "error: %s\n", message(k).c_str());
}

// Now and then.
void Batch_run::show_progress() {
  const Clock::time_point now = Clock::now();
  if (!show_ || now - shown_ < std::chrono::milliseconds(100))
    return;
  shown_ = now;
  std::fprintf(stderr, "\r\033[K%zu of %zu files, %zu failed; %.0f s ...", done_, files_.size(),
               failures_, std::chrono::duration<double>(now - start_).count());
}

void Batch_run::clear_line() const {
  if (show_)
    std::fprintf(stderr, "\r\033[K");
}

std::size_t Batch_run::count(Batch_status status) const {
  return static_cast<std::size_t>(
      std::count_if(records_.begin(), records_.end(),
                    [&](const Batch_record& record) { return record.status == status; }));
}

// Many messages begin with the name of the file by themselves.
std::string Batch_run::message(std::size_t k) const {
  const std::string& error = records_[k].error;
  const std::string prefix = files_[k].input + ':';
  return error.compare(0, prefix.size(), prefix) == 0 ? error : prefix + ' ' + error;
}

// What a run that was killed some time ago has left beside its meshes (see Atomic_file).
void Batch_run::remove_leftovers() const {
  std::unordered_set<std::string> outputs;
  for (const Batch_file& file : files_)
    outputs.insert(fs::path(file.output).filename().string());
  std::vector<fs::path> leftovers;
  std::error_code error;
  for (fs::directory_iterator entry(settings_.options.batch.directory, error);
       !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const std::string part = ".part";
    const std::size_t at = name.rfind(part);
    if (at != std::string::npos && at + part.size() < name.size() &&
        name.find_first_not_of("0123456789", at + part.size()) == std::string::npos &&
        outputs.count(name.substr(0, at)) > 0 && !is_recent(entry->path()))
      leftovers.push_back(entry->path());
  }
  for (const fs::path& path : leftovers)
    fs::remove(path, error);
}

// Returns what went wrong, if anything did.
std::string Batch_run::try_to_write_report() const {
  try {
    if (!settings_.options.report.empty())
      write_report();
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

void Batch_run::write_report() const {
  Json files = Json::array();
  for (std::size_t k = 0; k < files_.size(); ++k)
    files.push_back(record_json(files_[k], records_[k]));
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  write_json(settings_.options.report,
             {{"output_directory", settings_.options.batch.directory},
              {"density", density_json(settings_.density)},
              {"meshed", count(Batch_status::meshed)},
              {"up_to_date", count(Batch_status::up_to_date)},
              {"failed", count(Batch_status::failed)},
              {"not_done", count(Batch_status::not_done) + count(Batch_status::started)},
              {"files", files},
              {"seconds", seconds}});
}

void Batch_run::print_summary() const {
  std::size_t triangles = 0;
  for (const Batch_record& record : records_)
    if (record.status == Batch_status::meshed)
      triangles += record.triangles;
  std::printf("%s: %zu meshed, %zu up to date, %zu failed; %zu triangles; %.2f s\n",
              settings_.options.batch.directory.c_str(), count(Batch_status::meshed),
              count(Batch_status::up_to_date), failures_, triangles,
              std::chrono::duration<double>(Clock::now() - start_).count());
}

void work_on(Batch_run& run) {
  try {
    while (const auto k = run.next())
      run.finish(*k, mesh_file(run.file(*k), run.settings()));
  } catch (...) {
    run.give_up(std::current_exception());
  }
}

} // namespace multipatch
