// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MODEL_OUTPUT_H
#define MULTIPATCH_MODEL_OUTPUT_H

#include "model_file.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>

#include <cstddef>
#include <string>
#include <vector>

namespace multipatch {

// Throws, before the work, if a file of this name cannot be written, or must not be.
inline void check_model_output(const std::string& output, const std::vector<std::string>& inputs) {
  check_different(output, inputs);
  CGAL::Multisided_patches::internal::check_writable(output);
}

// "a, b and c"
inline std::string joined(const std::vector<std::string>& phrases) {
  std::string text;
  for (std::size_t k = 0; k < phrases.size(); ++k)
    text += (k == 0 ? "" : k + 1 == phrases.size() ? " and " : ", ") + phrases[k];
  return text;
}

} // namespace multipatch

#endif // MULTIPATCH_MODEL_OUTPUT_H
