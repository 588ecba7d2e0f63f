// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_REPORT_OUTPUT_H
#define MULTIPATCH_REPORT_OUTPUT_H

#include <functional>
#include <string>
#include <vector>

namespace multipatch {

// Where a command puts its report: as JSON into a file or, with "-", on standard output; otherwise
// as a table on standard output.
class Report_output {
public:
  // What cannot be written fails here, before the work.
  Report_output(std::string json_file, bool quiet, const std::vector<std::string>& inputs);

  void write(const std::function<std::string()>& json,
             const std::function<void()>& print_table) const;

private:
  bool writes_file() const;
  bool is_standard_output() const;

  std::string json_file_;
  bool quiet_;
};

} // namespace multipatch

#endif // MULTIPATCH_REPORT_OUTPUT_H
