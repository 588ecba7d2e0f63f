// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_GBP_H
#define MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_GBP_H

#include "replay.h"

#include <CGAL/Multisided_patches/IO/GBP.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace fuzz {

// Reads a `.gbp` file and, if it is one, writes and reads it again.
inline void replay_gbp(const std::string& bytes) {
  const auto read = [](const std::string& text) {
    std::istringstream in(text);
    return MP::IO::read_GBP<Kernel>(in, "input");
  };
  const auto net = read_or_refuse([&] { return read(bytes); });
  if (!net)
    return;
  std::ostringstream out;
  MP::IO::write_GBP(out, *net);
  const auto again = read(out.str());
  const auto &p = net->control_points(), &q = again.control_points();
  require(net->size() == again.size() && net->degree() == again.degree(), "the sizes survive");
  require(std::equal(p.begin(), p.end(), q.begin(), q.end(), is_same_point<Kernel::Point_3>),
          "the control points survive");
}

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_GBP_H
