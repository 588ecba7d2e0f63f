// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_BENCHMARK_MESHING_FIXTURES_H
#define MULTISIDED_PATCHES_BENCHMARK_MESHING_FIXTURES_H

#include "fixtures.h"

#include <CGAL/Multisided_patches/meshing/triangulate_domain.h>

#include <algorithm>
#include <cmath>

// Domains to mesh evenly, and how good the triangles are.
namespace bench {

using Domain_mesh = MP::Domain_mesh_2<Kernel>;

constexpr const char* mesh_domain_names[] = {"L", "U", "star"};

inline Domain mesh_domain(std::int64_t index) {
  return Domain(index == 0   ? fixtures::l_shape()
                : index == 1 ? fixtures::unit_u_shape()
                             : fixtures::star());
}

// What `triangulate_domain()` wants to know for so many triangles.
struct Even_spacing {
  Even_spacing(const Domain& domain, std::int64_t triangles)
      : length(std::sqrt(domain.area() / double(triangles) * 4 / std::sqrt(3.0))) {
    for (std::size_t i = 0; i < domain.size(); ++i)
      segments.push_back(static_cast<std::size_t>(std::ceil(domain.side_length(i) / length)));
  }

  double length;
  std::vector<std::size_t> segments; // of each side
};

inline double smallest_angle(const Point_2& a, const Point_2& b, const Point_2& c) {
  const auto angle = [](const Kernel::Vector_2& u, const Kernel::Vector_2& v) {
    return std::atan2(std::abs(u.x() * v.y() - u.y() * v.x()), u * v) * 180 / fixtures::pi;
  };
  return (std::min)({angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)});
}

// In degrees; not among those triangles whose angle is one of the domain itself.
inline double smallest_angle(const Domain_mesh& mesh) {
  double smallest = 180;
  for (const auto& t : mesh.triangles)
    smallest = (std::min)(smallest,
                          smallest_angle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]));
  return smallest;
}

inline void report_mesh(benchmark::State& state, std::size_t triangles, double angle) {
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["smallest_angle"] = angle;
  report_seconds_per(state, "triangle", triangles);
}

} // namespace bench

#endif // MULTISIDED_PATCHES_BENCHMARK_MESHING_FIXTURES_H
