// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_OPEN_EDGES_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_OPEN_EDGES_H

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// While triangles are put together: the halfedges that have no triangle yet, by the numbers of the
// vertices where they start and end. If triangles come in an order in which neighbours are close to
// each other, there are few at any time.
template <typename Halfedge>
class Open_edges {
public:
  void add(std::size_t start, std::size_t end, const Halfedge& halfedge) {
    if (start >= first_.size())
      first_.resize(start + 1, none);
    if (free_ == none) {
      free_ = entries_.size();
      entries_.push_back({0, Halfedge(), none});
    }
    Entry& entry = entries_[free_];
    const std::size_t next_free = entry.next;
    entry = {end, halfedge, first_[start]};
    first_[start] = free_;
    free_ = next_free;
  }

  // Removes the halfedge from `start` to `end`, and returns it, if it is there.
  std::optional<Halfedge> take(std::size_t start, std::size_t end) {
    if (start >= first_.size())
      return std::nullopt;
    for (std::size_t* link = &first_[start]; *link != none; link = &entries_[*link].next)
      if (entries_[*link].end == end) {
        const std::size_t found = *link;
        *link = entries_[found].next;
        entries_[found].next = free_;
        free_ = found;
        return entries_[found].halfedge;
      }
    return std::nullopt;
  }

  // Calls f(start, end, halfedge).
  template <typename Function>
  void for_each(const Function& f) const {
    for (std::size_t start = 0; start < first_.size(); ++start)
      for (std::size_t k = first_[start]; k != none; k = entries_[k].next)
        f(start, entries_[k].end, entries_[k].halfedge);
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  struct Entry {
    std::size_t end;
    Halfedge halfedge;
    std::size_t next; // that starts at the same vertex, or is free
  };

  std::vector<std::size_t> first_; // by vertex
  std::vector<Entry> entries_;
  std::size_t free_ = none;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_OPEN_EDGES_H
