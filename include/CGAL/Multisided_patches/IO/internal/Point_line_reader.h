// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_INTERNAL_POINT_LINE_READER_H
#define CGAL_MULTISIDED_PATCHES_IO_INTERNAL_POINT_LINE_READER_H

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/IO/internal/number_token.h>
#include <CGAL/Multisided_patches/errors.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <istream>
#include <string>
#include <utility>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Reads points of the plane, two numbers a line. `#` starts a comment that runs to the end of the
// line; lines end as on any system. Never holds more than one short token, so that a file of any
// size and content is refused at its first bad line.
class Point_line_reader {
public:
  enum class Line { point, blank, end };

  // A byte order mark at the beginning does not count.
  Point_line_reader(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {
    skip_byte_order_mark(in_);
  }

  // Goes to the next line that is more than a comment.
  Line next() {
    while (in_.peek() != eof) {
      ++line_;
      const std::size_t numbers = read_numbers();
      const bool comment = skip_rest_of_line();
      if (numbers == 1)
        fail("expected two numbers, found only one");
      if (numbers == 2)
        return Line::point;
      if (!comment)
        return Line::blank;
    }
    if (in_.bad())
      fail("the file cannot be read");
    return Line::end;
  }

  // Goes to the next point, past blank lines. False if there is none.
  bool next_point() {
    Line line = next();
    while (line == Line::blank)
      line = next();
    return line == Line::point;
  }

  // the point of the line, if it has one
  const std::array<double, 2>& point() const { return point_; }

  // the name of the file and the number of the line, for messages
  std::string position() const { return name_ + ":" + std::to_string(line_ > 0 ? line_ : 1); }

  [[noreturn]] void fail(const std::string& message) const {
    throw Input_error(position() + ": " + message);
  }

private:
  static constexpr int eof = std::char_traits<char>::eof();

  static bool is_line_end(int c) { return c == '\n' || c == '\r'; }

  std::size_t read_numbers() {
    std::size_t count = 0;
    for (std::string token = read_token(); !token.empty(); token = read_token()) {
      if (count == 2)
        fail("expected the end of the line after two numbers, found '" + token + "'");
      double& x = point_[count++];
      if (!parse_number(token, x) || !std::isfinite(x))
        fail_at(token);
    }
    return count;
  }

  // Empty at the end of the line, and where a comment starts.
  std::string read_token() {
    int c = in_.peek();
    for (; is_space(c) && !is_line_end(c); c = in_.peek())
      in_.get();
    std::string token;
    for (; c != eof && c != '#' && !is_space(c); c = in_.peek())
      if (!append_to_token(token, in_.get()))
        fail_at(start_of_token(token));
    return token;
  }

  [[noreturn]] void fail_at(const std::string& token) const {
    fail("expected two finite numbers, separated by white space, found '" + token + "'");
  }

  // Returns whether there was a comment.
  bool skip_rest_of_line() {
    const bool comment = in_.peek() == '#';
    int c = in_.get();
    while (c != eof && !is_line_end(c))
      c = in_.get();
    if (c == '\r' && in_.peek() == '\n')
      in_.get();
    return comment;
  }

  std::istream& in_;
  std::string name_;
  std::size_t line_ = 0;
  std::array<double, 2> point_{};
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_INTERNAL_POINT_LINE_READER_H
