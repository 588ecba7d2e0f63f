// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_POLYGON_H
#define MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_POLYGON_H

#include "replay.h"

#include <CGAL/Multisided_patches/IO/polygon_file.h>
#include <CGAL/Multisided_patches/internal/to_text.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace fuzz {

using Domain = MP::Polygonal_domain_2<Kernel>;
using Polygon_file = MP::IO::Polygon_file<Kernel>;

inline Polygon_file read_polygon(const std::string& bytes) {
  std::istringstream in(bytes);
  return MP::IO::read_polygon_file<Kernel>(in, "input");
}

// A polygon file with the vertices of a domain in their order.
inline std::string written(const Domain& domain) {
  std::string text;
  for (std::size_t loop = 0; loop < domain.number_of_loops(); ++loop) {
    text += loop == 0 ? "" : "\n";
    for (std::size_t i = domain.loop_begin(loop); i < domain.loop_begin(loop + 1); ++i)
      text += MP::internal::to_text(domain.vertex(i).x()) + ' ' +
              MP::internal::to_text(domain.vertex(i).y()) + '\n';
  }
  return text;
}

// A file has every vertex once.
inline void require_permutation(std::vector<std::size_t> vertices, std::size_t n) {
  std::sort(vertices.begin(), vertices.end());
  std::vector<std::size_t> all(n);
  std::iota(all.begin(), all.end(), std::size_t(0));
  require(vertices == all, "the vertices of the file are those of the domain");
}

// Every vertex is found on the boundary. This takes quadratic time, and so only the first ones are.
inline void require_located(const Domain& domain) {
  for (std::size_t i = 0; i < (std::min)(domain.size(), std::size_t(20)); ++i) {
    const auto location = domain.locate(domain.vertex(i));
    require(location.kind == Domain::Location::Kind::vertex && location.index == i,
            "a vertex is where it is");
  }
}

// A polygon file is refused, or gives a domain whose own file gives the same domain bit for bit.
inline void replay_polygon(const std::string& bytes) {
  const auto polygon = read_or_refuse([&] { return read_polygon(bytes); });
  if (!polygon)
    return;
  const Domain& domain = polygon->domain;
  require(domain.size() >= 3, "a domain has at least 3 vertices");
  require_permutation(polygon->vertices, domain.size());
  require_located(domain);
  const Polygon_file again = read_polygon(written(domain));
  require(std::is_sorted(again.vertices.begin(), again.vertices.end()),
          "loops that run the right way keep their order");
  require(again.domain.number_of_loops() == domain.number_of_loops() &&
              written(again.domain) == written(domain),
          "the domain survives");
}

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_POLYGON_H
