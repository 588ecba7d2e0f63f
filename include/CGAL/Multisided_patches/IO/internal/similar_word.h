// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_INTERNAL_SIMILAR_WORD_H
#define CGAL_MULTISIDED_PATCHES_IO_INTERNAL_SIMILAR_WORD_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The least number of characters to insert, remove or replace that makes one word of the other (V.
// I. Levenshtein, *Binary codes capable of correcting deletions, insertions, and reversals*, Soviet
// Physics Doklady 10, 1966). O(product of the lengths).
inline std::size_t edit_distance(const std::string& a, const std::string& b) {
  // to the first j characters of b, from as many of a as were gone through
  std::vector<std::size_t> distance(b.size() + 1);
  std::iota(distance.begin(), distance.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = distance[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = distance[j + 1];
      distance[j + 1] = (std::min)({replaced, diagonal + 1, distance[j] + 1});
    }
  }
  return distance[b.size()];
}

// The first of some words that is most likely meant by one which is misspelt: the closest one if
// at most a third of it differs, or else the closest one that contains it, or is contained in it.
// An empty word if there is none.
inline std::string similar_word(const std::string& misspelt,
                                const std::vector<std::string>& words) {
  // What is shorter is part of many words; what is longer is none, and would take time.
  constexpr std::size_t shortest = 3, longest = 100;
  std::string best;
  if (misspelt.size() < shortest || misspelt.size() > longest)
    return best;
  const auto is_part = [&](const std::string& word) {
    return word.size() >= shortest &&
           (word.find(misspelt) != std::string::npos || misspelt.find(word) != std::string::npos);
  };
  for (const bool parts : {false, true}) {
    std::size_t least = longest;
    for (const std::string& word : words) {
      const std::size_t distance = edit_distance(misspelt, word);
      const bool is_close = 3 * distance <= (std::max)(misspelt.size(), word.size());
      if (distance < least && (parts ? is_part(word) : is_close)) {
        least = distance;
        best = word;
      }
    }
    if (!best.empty())
      break;
  }
  return best;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_INTERNAL_SIMILAR_WORD_H
