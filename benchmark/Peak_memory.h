// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_BENCHMARK_PEAK_MEMORY_H
#define MULTISIDED_PATCHES_BENCHMARK_PEAK_MEMORY_H

#include <fstream>
#include <limits>
#include <string>

#include <malloc.h>

namespace bench {

/*!
 * How much memory this process holds at most, from the construction of this object on, beyond what
 * it had then. On Linux only; elsewhere it is unknown.
 */
class Peak_memory {
public:
  Peak_memory() {
    malloc_trim(0); // or what was freed before would be used again, and not be seen
    std::ofstream("/proc/self/clear_refs") << "5"; // the peak is now what there is
    begin_ = kibibytes("VmRSS:");
  }

  //! not a number if it is unknown
  double bytes() const { return 1024 * (kibibytes("VmHWM:") - begin_); }

private:
  static double kibibytes(const std::string& wanted) {
    std::ifstream file("/proc/self/status");
    for (std::string key, rest; file >> key; std::getline(file, rest))
      if (double value = 0; key == wanted && file >> value)
        return value;
    return std::numeric_limits<double>::quiet_NaN();
  }

  double begin_;
};

} // namespace bench

#endif // MULTISIDED_PATCHES_BENCHMARK_PEAK_MEMORY_H
