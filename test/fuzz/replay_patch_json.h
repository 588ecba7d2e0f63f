// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_PATCH_JSON_H
#define MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_PATCH_JSON_H

#include "replay.h"

#include <CGAL/Multisided_patches/IO/patch_json.h>

#include <sstream>
#include <string>

namespace fuzz {

// Reads a `.patch.json` file and, if it is one, writes and reads it again.
inline void replay_patch_json(const std::string& bytes) {
  const auto read = [](const std::string& text) {
    std::istringstream in(text);
    return MP::IO::read_patch_json<Kernel>(in, "input");
  };
  const auto written = [](const MP::IO::Any_patch_model<Kernel>& model) {
    std::ostringstream out;
    MP::IO::write_patch_json<Kernel>(out, model);
    return out.str();
  };
  const auto model = read_or_refuse([&] { return read(bytes); });
  if (!model)
    return;
  const std::string text = written(*model);
  const auto again = read(text);
  require(model->index() == again.index(), "the type survives");
  require(written(again) == text, "the same model is the same text");
}

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_PATCH_JSON_H
