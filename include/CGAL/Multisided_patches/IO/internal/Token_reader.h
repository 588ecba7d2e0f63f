// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_INTERNAL_TOKEN_READER_H
#define CGAL_MULTISIDED_PATCHES_IO_INTERNAL_TOKEN_READER_H

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/IO/internal/number_token.h>
#include <CGAL/Multisided_patches/errors.h>

#include <cmath>
#include <cstddef>
#include <istream>
#include <string>
#include <utility>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Reads numbers that are separated by white space, knows the line it is in, and never holds more
// than one short token, so that a file of any size and content is refused at its first bad token.
class Token_reader {
public:
  // A byte order mark at the beginning does not count.
  Token_reader(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {
    skip_byte_order_mark(in_);
  }

  // An integer in [min, max]; `what` completes "expected ..." in the message.
  std::size_t integer(const std::string& what, std::size_t min, std::size_t max) {
    const std::string token = next(what);
    std::size_t value = 0;
    if (!parse_number(token, value) || value < min || value > max)
      fail("expected " + what + ", an integer from " + std::to_string(min) + " to " +
           std::to_string(max) + ", found '" + token + "'");
    return value;
  }

  double number(const std::string& what) {
    const std::string token = next(what);
    double value = 0;
    if (!parse_number(token, value) || !std::isfinite(value))
      fail("expected " + what + ", a finite number, found '" + token + "'");
    return value;
  }

  void expect_end() {
    const std::string token = read_token();
    if (!token.empty())
      fail("expected the end of the file, found '" + token + "'");
  }

  // Throws an error that names the file and, if it is known, the line.
  [[noreturn]] void fail(const std::string& message) const {
    throw Input_error(name_ + ":" + std::to_string(token_line_) + ": " + message);
  }

private:
  std::string next(const std::string& what) {
    std::string token = read_token();
    if (token.empty())
      fail("expected " + what + ", found the end of the file");
    return token;
  }

  std::string read_token() {
    std::string token;
    int c = in_.get();
    for (; is_space(c); c = in_.get())
      line_ += c == '\n';
    token_line_ = line_;
    for (; c != std::char_traits<char>::eof() && !is_space(c); c = in_.get())
      if (!append_to_token(token, c))
        fail("expected a number, found '" + start_of_token(token) + "'");
    line_ += c == '\n';
    if (in_.bad())
      fail("the file cannot be read");
    return token;
  }

  std::istream& in_;
  std::string name_;
  std::size_t line_ = 1, token_line_ = 1;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_INTERNAL_TOKEN_READER_H
