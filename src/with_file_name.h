// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_WITH_FILE_NAME_H
#define MULTIPATCH_WITH_FILE_NAME_H

#include <CGAL/Multisided_patches/errors.h>

#include <string>

namespace multipatch {

// Runs a function, and names the file in errors of computations, which know of no files.
template <typename Function>
void with_file_name(const std::string& file_name, const Function& function) {
  try {
    function();
  } catch (const CGAL::Multisided_patches::Numerical_error& error) {
    throw CGAL::Multisided_patches::Numerical_error(file_name + ": " + error.what());
  }
}

} // namespace multipatch

#endif // MULTIPATCH_WITH_FILE_NAME_H
