// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_UNIFORM_METRIC_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_UNIFORM_METRIC_H

#include <CGAL/Multisided_patches/meshing/internal/Metric_2.h>

#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The metric, the same everywhere, for edges of a length in the domain.
class Uniform_metric {
public:
  explicit Uniform_metric(double edge_length)
      : metric_{1 / (edge_length * edge_length), 0, 1 / (edge_length * edge_length)} {}

  Metric_2 operator()(const Uv&, std::size_t&) const { return metric_; }

private:
  Metric_2 metric_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_UNIFORM_METRIC_H
