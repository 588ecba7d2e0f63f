// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_POINT_FILE_H
#define MULTIPATCH_POINT_FILE_H

#include "evaluate_coordinates.h"

#include <CGAL/Multisided_patches/IO/internal/Point_line_reader.h>

#include <cstddef>
#include <fstream>
#include <string>

namespace multipatch {

// The points of a file, two numbers a line, located in a domain one by one.
class Point_file {
public:
  Point_file(const std::string& name, const Domain& domain);

  // False at the end of the file. Throws Input_error at a line that has no point, and at the end of
  // a file without any.
  bool next(Located_point& point);

  // How many of the points so far are outside, and where the first of them is.
  std::size_t outside() const { return outside_; }
  const std::string& first_outside() const { return first_outside_; }

private:
  std::ifstream in_;
  CGAL::Multisided_patches::internal::Point_line_reader reader_;
  const Domain& domain_;
  std::size_t points_ = 0, outside_ = 0;
  std::string first_outside_;
};

} // namespace multipatch

#endif // MULTIPATCH_POINT_FILE_H
