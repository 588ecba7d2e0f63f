// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report_output.h"

#include "commands.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>

#include <cstdio>
#include <utility>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

Report_output::Report_output(std::string json_file, bool quiet,
                             const std::vector<std::string>& inputs)
    : json_file_(std::move(json_file)), quiet_(quiet) {
  if (!writes_file())
    return;
  check_different(json_file_, inputs);
  MP::internal::check_writable(json_file_);
}

void Report_output::write(const std::function<std::string()>& json,
                          const std::function<void()>& print_table) const {
  if (writes_file()) {
    MP::internal::Atomic_file file(json_file_);
    file.stream() << json();
    file.commit();
  }
  if (is_standard_output())
    std::fputs(json().c_str(), stdout);
  else if (!quiet_)
    print_table();
}

bool Report_output::is_standard_output() const {
  return json_file_ == "-";
}

bool Report_output::writes_file() const {
  return !json_file_.empty() && !is_standard_output();
}

} // namespace multipatch
