// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "point_file.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/internal/to_text.h>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

Point_file::Point_file(const std::string& name, const Domain& domain)
    : in_(MP::internal::open_for_reading(name)), reader_(in_, name), domain_(domain) {}

bool Point_file::next(Located_point& point) {
  if (!reader_.next_point()) {
    if (points_ == 0)
      reader_.fail("expected points, two numbers a line, found the end of the file");
    return false;
  }
  const auto [u, v] = reader_.point();
  point.point = {u, v};
  point.location = domain_.locate(point.point);
  ++points_;
  if (point.location.kind == Domain::Location::Kind::outside && outside_++ == 0)
    first_outside_ = reader_.position() + ": (" + MP::internal::to_text(u) + ", " +
                     MP::internal::to_text(v) + ")";
  return true;
}

} // namespace multipatch
