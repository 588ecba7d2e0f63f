// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_INTERNAL_POINT_TEXT_H
#define CGAL_MULTISIDED_PATCHES_IO_INTERNAL_POINT_TEXT_H

#include <CGAL/Multisided_patches/IO/internal/Token_reader.h>
#include <CGAL/Multisided_patches/internal/to_text.h>

#include <CGAL/number_utils.h>

#include <string>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// What the text formats of control points share. `what` names the point in error messages.
template <typename Traits>
typename Traits::Point_3 read_point(Token_reader& in, const std::string& what) {
  using FT = typename Traits::FT;
  const double x = in.number("x of " + what);
  const double y = in.number("y of " + what);
  const double z = in.number("z of " + what);
  return typename Traits::Point_3(FT(x), FT(y), FT(z));
}

// A line with as many digits as it takes to read the same doubles back.
template <typename Point_3>
std::string point_line(const Point_3& p) {
  return to_text(CGAL::to_double(p.x())) + ' ' + to_text(CGAL::to_double(p.y())) + ' ' +
         to_text(CGAL::to_double(p.z())) + '\n';
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_INTERNAL_POINT_TEXT_H
