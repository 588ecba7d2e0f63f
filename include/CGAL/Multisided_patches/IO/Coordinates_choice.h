// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_COORDINATES_CHOICE_H
#define CGAL_MULTISIDED_PATCHES_IO_COORDINATES_CHOICE_H

namespace CGAL {
namespace Multisided_patches {
namespace IO {

//! The barycentric coordinates that files can ask for.
enum class Coordinates_choice {
  harmonic,   //!< `Harmonic_coordinates_2`
  mean_value, //!< `Mean_value_coordinates_2`
  wachspress  //!< `Wachspress_coordinates_2`, for convex domains
};

//! the name of coordinates as files and the command line spell it
inline const char* to_string(Coordinates_choice choice) {
  switch (choice) {
  case Coordinates_choice::harmonic:
    return "harmonic";
  case Coordinates_choice::mean_value:
    return "mean-value";
  case Coordinates_choice::wachspress:
    return "wachspress";
  }
  return "";
}

} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_COORDINATES_CHOICE_H
