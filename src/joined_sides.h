// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_JOINED_SIDES_H
#define MULTIPATCH_JOINED_SIDES_H

#include <CGAL/Multisided_patches/meshing/Patch_complex.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace multipatch {

// How the patches of a complex hang together.
struct Joined_sides {
  std::vector<CGAL::Multisided_patches::Shared_side> shared;
  std::vector<std::pair<std::size_t, std::size_t>> free; // patch and side
  std::vector<std::string> remarks;

  bool are_joined(std::size_t patch_a, std::size_t side_a, std::size_t patch_b,
                  std::size_t side_b) const {
    return std::any_of(shared.begin(), shared.end(), [&](const auto& s) {
      return s.patch_a == patch_a && s.side_a == side_a && s.patch_b == patch_b &&
             s.side_b == side_b;
    });
  }
  // Whether the patch shares a side with itself, and so is no disk.
  bool is_joined_to_itself(std::size_t patch) const {
    return std::any_of(shared.begin(), shared.end(),
                       [&](const auto& s) { return s.patch_a == patch && s.patch_b == patch; });
  }
};

template <typename Patch>
Joined_sides joined_sides(const CGAL::Multisided_patches::Patch_complex<Patch>& complex) {
  Joined_sides result{complex.shared_sides(), {}, complex.remarks()};
  std::vector<std::pair<std::size_t, std::size_t>> shared;
  for (const auto& s : result.shared) {
    shared.emplace_back(s.patch_a, s.side_a);
    shared.emplace_back(s.patch_b, s.side_b);
  }
  std::sort(shared.begin(), shared.end());
  for (std::size_t k = 0; k < complex.patches().size(); ++k)
    for (std::size_t i = 0; i < complex.patches()[k].domain().size(); ++i)
      if (!std::binary_search(shared.begin(), shared.end(), std::make_pair(k, i)))
        result.free.emplace_back(k, i);
  return result;
}

} // namespace multipatch

#endif // MULTIPATCH_JOINED_SIDES_H
