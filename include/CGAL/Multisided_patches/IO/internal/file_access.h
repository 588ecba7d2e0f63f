// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_INTERNAL_FILE_ACCESS_H
#define CGAL_MULTISIDED_PATCHES_IO_INTERNAL_FILE_ACCESS_H

#include <CGAL/Multisided_patches/errors.h>

#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <istream>
#include <locale>
#include <random>
#include <string>
#include <system_error>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// With its dot, and in lower case, as capitals make no difference.
inline std::string file_extension(const std::string& file_name) {
  std::string extension = std::filesystem::path(file_name).extension().string();
  for (char& c : extension)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

// ": No such file or directory", after a call of the system that has failed; nothing where streams
// do not set errno.
inline std::string reason_of_failure() {
  return errno == 0 ? "" : ": " + std::generic_category().message(errno);
}

inline std::ifstream open_for_reading(const std::string& file_name) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file_name, ignored))
    throw Input_error(file_name + ": expected a file, found a directory");
  errno = 0;
  std::ifstream in(file_name, std::ios::binary);
  if (!in)
    throw Input_error(file_name + ": cannot be opened for reading" + reason_of_failure());
  return in;
}

// Goes past the byte order mark with which some editors begin text in UTF-8, if there is one at the
// beginning of the stream; a part of one stays.
inline void skip_byte_order_mark(std::istream& in) {
  int count = 0;
  for (const int byte : {0xEF, 0xBB, 0xBF}) {
    if (in.peek() != byte) {
      for (; count > 0; --count)
        in.unget();
      return;
    }
    in.get();
    ++count;
  }
}

// A file that appears under its name whole or not at all: what is written goes to a file beside it,
// which takes the name when it is complete, and vanishes if it never is.
class Atomic_file {
public:
  explicit Atomic_file(const std::string& file_name) : name_(file_name) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file_name, ignored))
      throw Error(file_name + ": cannot be written: it is a directory");
    const auto status = std::filesystem::status(file_name, ignored);
    const bool exists = std::filesystem::exists(status);
    // Devices such as /dev/stdout are written to, not replaced; of a link, the target is replaced.
    replace_ = !exists || std::filesystem::is_regular_file(status);
    target_ = exists && replace_ ? std::filesystem::canonical(file_name, ignored).string() : name_;
    partial_ = replace_ ? target_ + ".part" + std::to_string(std::random_device{}()) : name_;
    errno = 0;
    // Opening a file for reading, too, leaves what is in it: it only tells whether that may change.
    const bool may_change = !exists || !replace_ || std::fstream(target_).is_open();
    // Files are written alike whatever the global locale is.
    out_.imbue(std::locale::classic());
    if (may_change)
      out_.open(partial_, std::ios::binary);
    if (!out_.is_open())
      throw Error(file_name + ": cannot be opened for writing" + reason_of_failure());
    if (exists && replace_)
      std::filesystem::permissions(partial_, status.permissions(), ignored);
  }
  Atomic_file(const Atomic_file&) = delete;
  Atomic_file& operator=(const Atomic_file&) = delete;
  ~Atomic_file() {
    if (replace_ && !committed_) {
      out_.close();
      std::error_code ignored;
      std::filesystem::remove(partial_, ignored);
    }
  }

  std::ofstream& stream() { return out_; }

  // Gives the file its name. Throws Error, and leaves nothing, if not all could be written.
  void commit() {
    out_.close();
    if (!out_)
      throw Error(name_ + ": cannot be written: is the disk full?");
    std::error_code error;
    if (replace_)
      std::filesystem::rename(partial_, target_, error);
    if (error)
      throw Error(name_ + ": cannot be written: " + error.message());
    committed_ = true;
  }

private:
  std::string name_, target_, partial_;
  std::ofstream out_;
  bool replace_ = true, committed_ = false;
};

// Throws Input_error if two names are of one file, which one of them would overwrite.
inline void check_different(const std::string& a, const std::string& b) {
  std::error_code error_a, error_b;
  const auto path_a = std::filesystem::weakly_canonical(std::filesystem::absolute(a), error_a);
  const auto path_b = std::filesystem::weakly_canonical(std::filesystem::absolute(b), error_b);
  if (!error_a && !error_b && path_a == path_b)
    throw Input_error(a + ": cannot be written: it is the same file as " + b);
}

// Throws Error if a file of this name cannot be made; leaves no trace.
inline void check_writable(const std::string& file_name) {
  Atomic_file probe(file_name);
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_INTERNAL_FILE_ACCESS_H
