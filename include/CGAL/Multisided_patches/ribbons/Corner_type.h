// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CORNER_TYPE_H
#define CGAL_MULTISIDED_PATCHES_CORNER_TYPE_H

namespace CGAL {
namespace Multisided_patches {

//! How the boundary turns at a corner when it is run with the surface (or the domain) on its left.
enum class Corner_type {
  convex,   //!< to the left: the interior angle is less than π
  straight, //!< not at all
  reflex    //!< to the right: the interior angle is greater than π
};

//! the name of a corner type in lower case, for messages and files
inline const char* to_string(Corner_type type) {
  switch (type) {
  case Corner_type::convex:
    return "convex";
  case Corner_type::straight:
    return "straight";
  case Corner_type::reflex:
    return "reflex";
  }
  return "";
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CORNER_TYPE_H
