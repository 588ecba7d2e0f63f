// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch_manifest.h"

#include <CGAL/Multisided_patches/errors.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <sstream>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw MP::Error(path + ": cannot be " + what + ": " + std::strerror(errno));
}

// The directory may be moved, or named in another way.
std::string key(const std::string& output) {
  return fs::path(output).filename().string();
}

} // namespace

Batch_manifest::Batch_manifest(const std::string& directory)
    : path_((fs::path(directory) / file_name).string()),
      descriptor_(open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0)
    fail(path_, "opened for writing");
  try {
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK)
        throw MP::Error(directory + ": another run is writing to this directory");
      lock_error_ = std::strerror(errno);
    }
    const std::string text = read();
    // What follows the last line break, a crash has cut off.
    const std::size_t whole = text.rfind('\n') + 1; // 0 if there is none
    if (whole < text.size() && ftruncate(descriptor_, static_cast<off_t>(whole)) != 0)
      fail(path_, "written");
    parse(text.substr(0, whole));
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

Batch_manifest::~Batch_manifest() {
  close(descriptor_);
}

const Batch_record* Batch_manifest::find(const std::string& output) const {
  const auto found = earlier_.find(key(output));
  return found == earlier_.end() ? nullptr : &found->second;
}

void Batch_manifest::add(const Batch_file& file, const Batch_record& record) {
  const std::string line =
      record_json(file, record).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
      '\n';
  std::size_t done = 0;
  while (done < line.size()) {
    const ssize_t n = write(descriptor_, line.data() + done, line.size() - done);
    if (n < 0 && errno != EINTR)
      fail(path_, "written");
    done += n > 0 ? static_cast<std::size_t>(n) : 0;
  }
}

std::string Batch_manifest::read() const {
  std::string text;
  char block[1 << 16];
  for (;;) {
    const ssize_t n = ::read(descriptor_, block, sizeof block);
    if (n == 0)
      return text;
    if (n < 0 && errno != EINTR)
      fail(path_, "read");
    if (n > 0)
      text.append(block, static_cast<std::size_t>(n));
  }
}

void Batch_manifest::parse(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    try {
      const auto json = nlohmann::ordered_json::parse(line);
      earlier_[key(json.at("output").get<std::string>())] = parse_record(json);
    } catch (const std::exception&) {
      // What is not understood is made anew.
    }
}

} // namespace multipatch
