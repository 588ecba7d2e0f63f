// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_INTERIOR_LATTICE_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_INTERIOR_LATTICE_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The points of a triangular lattice that lie inside a domain and keep a distance from its
// boundary. They are found row by row: a row crosses the domain in intervals, from which every side
// cuts out the interval that is closer to it than the distance. This takes O(n) for a row, whatever
// the number of points in it.
template <typename Traits>
class Interior_lattice {
public:
  using Domain = Polygonal_domain_2<Traits>;

  // The distance kept from the boundary, in units of the spacing: between none, which makes flat
  // triangles, and the height of an equilateral triangle, which leaves gaps.
  static constexpr double margin = 0.6;

  Interior_lattice(const Domain& domain, double spacing)
      : spacing_(spacing), distance_(margin * spacing) {
    for (std::size_t i = 0; i < domain.size(); ++i) {
      const auto &a = domain.vertex(i), &b = domain.vertex(domain.next(i));
      sides_.push_back({CGAL::to_double(a.x()), CGAL::to_double(a.y()), CGAL::to_double(b.x()),
                        CGAL::to_double(b.y())});
    }
    const Bbox_2 box = domain.bbox();
    center_ = {(box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2};
    row_height_ = spacing * std::sqrt(3.0) / 2;
    half_rows_ = static_cast<long>((box.ymax() - box.ymin()) / 2 / row_height_);
  }

  std::size_t count() const {
    std::size_t n = 0;
    for_each_run([&](double, double, long first, long last) { n += last - first + 1; });
    return n;
  }

  template <typename Visitor>
  void for_each_point(const Visitor& visit) const {
    for_each_run([&](double x, double y, long first, long last) {
      for (long k = first; k <= last; ++k)
        visit(x + spacing_ * static_cast<double>(k), y);
    });
  }

private:
  using Interval = std::pair<double, double>;
  struct Side {
    double ax, ay, bx, by;
  };

  // Calls visit(x, y, first, last) for runs of lattice points (x + k spacing, y), first ≤ k ≤ last.
  template <typename Visitor>
  void for_each_run(const Visitor& visit) const {
    for (long row = -half_rows_; row <= half_rows_; ++row) {
      const double y = center_[1] + row_height_ * static_cast<double>(row);
      const double x = center_[0] + (row % 2 == 0 ? 0 : spacing_ / 2);
      for (const Interval& free : free_intervals(y)) {
        const double first = std::ceil((free.first - x) / spacing_);
        const double last = std::floor((free.second - x) / spacing_);
        if (first <= last)
          visit(x, y, static_cast<long>(first), static_cast<long>(last));
      }
    }
  }

  // The parts of the row at `y` that are inside and far enough from all sides, in order.
  std::vector<Interval> free_intervals(double y) const {
    std::vector<double> crossings;
    std::vector<Interval> taken;
    for (const Side& s : sides_) {
      if ((s.ay <= y) != (s.by <= y))
        crossings.push_back(s.ax + (y - s.ay) / (s.by - s.ay) * (s.bx - s.ax));
      const Interval close = close_to_side(s, y);
      if (close.first <= close.second)
        taken.push_back(close);
    }
    std::sort(crossings.begin(), crossings.end());
    std::sort(taken.begin(), taken.end());

    std::vector<Interval> free;
    auto next = taken.begin();
    // Up to where the row is taken; this may reach beyond a slot into the next part inside.
    double reach = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      double left = (std::max)(crossings[i], reach);
      for (; next != taken.end() && next->first <= crossings[i + 1]; ++next) {
        if (next->first > left)
          free.emplace_back(left, next->first);
        reach = (std::max)(reach, next->second);
        left = (std::max)(left, reach);
      }
      if (left < crossings[i + 1])
        free.emplace_back(left, crossings[i + 1]);
    }
    return free;
  }

  // The interval of the row at `y` within the distance of a side: the row's part in the two discs
  // around the ends and the rectangle between them, a convex set. Empty: first > second.
  Interval close_to_side(const Side& s, double y) const {
    Interval close{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
    const auto add = [&](double x) {
      close.first = (std::min)(close.first, x);
      close.second = (std::max)(close.second, x);
    };
    const auto add_disc = [&](double cx, double cy) {
      const double square = distance_ * distance_ - (y - cy) * (y - cy);
      if (square >= 0) {
        add(cx - std::sqrt(square));
        add(cx + std::sqrt(square));
      }
    };
    add_disc(s.ax, s.ay);
    add_disc(s.bx, s.by);
    const double dx = s.bx - s.ax, dy = s.by - s.ay, length = std::hypot(dx, dy);
    const double nx = -dy / length * distance_, ny = dx / length * distance_;
    for (const double side : {-1.0, 1.0}) {
      const double t = dy != 0 ? (y - s.ay - side * ny) / dy : -1;
      if (t >= 0 && t <= 1)
        add(s.ax + side * nx + t * dx);
    }
    return close;
  }

  double spacing_, distance_, row_height_;
  std::array<double, 2> center_;
  long half_rows_;
  std::vector<Side> sides_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_INTERIOR_LATTICE_H
