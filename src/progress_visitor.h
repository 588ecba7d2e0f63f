// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_PROGRESS_VISITOR_H
#define MULTIPATCH_PROGRESS_VISITOR_H

#include "stage_clock.h"

#include <CGAL/Multisided_patches/meshing/Tessellation_visitor.h>

#include <cstddef>

namespace multipatch {

// Shows the progress of a tessellation on a clock.
struct Progress_visitor {
  Stage_clock* clock;

  bool go_further(CGAL::Multisided_patches::Tessellation_stage stage, std::size_t done,
                  std::size_t total) {
    clock->show_progress(name(stage), done, total);
    return true;
  }

private:
  static const char* name(CGAL::Multisided_patches::Tessellation_stage stage) {
    using Stage = CGAL::Multisided_patches::Tessellation_stage;
    switch (stage) {
    case Stage::meshing:
      return "meshing";
    case Stage::evaluation:
      return "evaluation";
    case Stage::assembly:
      return "assembly";
    }
    return "";
  }
};

} // namespace multipatch

#endif // MULTIPATCH_PROGRESS_VISITOR_H
