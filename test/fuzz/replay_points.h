// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_POINTS_H
#define MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_POINTS_H

#include "replay.h"

#include <CGAL/Multisided_patches/internal/to_text.h>

#include "../../src/point_file.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <vector>

namespace fuzz {

using multipatch::Located_point;

// A file for what the program reads from files only. One for all inputs is much faster than one for
// each.
class Scratch_file {
public:
  Scratch_file()
      : name_((std::filesystem::temp_directory_path() /
               ("multisided_patches_fuzz" + std::to_string(std::random_device{}())))
                  .string()) {}
  Scratch_file(const Scratch_file&) = delete;
  Scratch_file& operator=(const Scratch_file&) = delete;
  ~Scratch_file() {
    std::error_code ignored;
    std::filesystem::remove(name_, ignored);
  }

  const std::string& write(const std::string& bytes) const {
    std::ofstream out(name_, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    require(bool(out), "the scratch file can be written");
    return name_;
  }

private:
  std::string name_;
};

// A square with a square hole, on whose sides and vertices simple numbers lie.
inline const multipatch::Domain& domain_of_points() {
  using Point = Kernel::Point_2;
  static const multipatch::Domain domain({Point(0, 0), Point(3, 0), Point(3, 3), Point(0, 3)},
                                         {{Point(1, 1), Point(1, 2), Point(2, 2), Point(2, 1)}});
  return domain;
}

// Reads all points, and checks what the reader counts.
inline std::vector<Located_point> read_points(const std::string& bytes) {
  static const Scratch_file scratch;
  const multipatch::Domain& domain = domain_of_points();
  multipatch::Point_file file(scratch.write(bytes), domain);
  std::vector<Located_point> points;
  for (Located_point point; file.next(point);)
    points.push_back(point);
  Located_point after;
  require(!points.empty(), "a file without points is refused");
  require(!file.next(after), "nothing comes after the end");
  const auto outside = std::count_if(points.begin(), points.end(), [](const Located_point& p) {
    return p.location.kind == multipatch::Domain::Location::Kind::outside;
  });
  require(file.outside() == static_cast<std::size_t>(outside), "points outside are counted");
  require(file.first_outside().empty() == (outside == 0), "the first point outside is known");
  require_presentable(std::filesystem::path(file.first_outside()).filename().string());
  return points;
}

inline std::string written(const std::vector<Located_point>& points) {
  std::string text;
  for (const auto& p : points)
    text += MP::internal::to_text(p.point.x()) + ' ' + MP::internal::to_text(p.point.y()) + '\n';
  return text;
}

inline void require_valid_location(const multipatch::Domain::Location& location) {
  using Kind = multipatch::Domain::Location::Kind;
  if (location.is_on_boundary())
    require(location.index < domain_of_points().size(), "the vertex or side exists");
  if (location.kind == Kind::side)
    require(location.s >= 0 && location.s <= 1, "the parameter on a side is in [0,1]");
}

// A file of points is refused, or gives points that are finite and are written and read back bit
// for bit.
inline void replay_points(const std::string& bytes) {
  const auto points = read_or_refuse([&] { return read_points(bytes); });
  if (!points)
    return;
  for (const Located_point& p : *points) {
    require(CGAL::is_finite(p.point.x()) && CGAL::is_finite(p.point.y()), "points are finite");
    require_valid_location(p.location);
  }
  const auto again = read_points(written(*points));
  require(std::equal(points->begin(), points->end(), again.begin(), again.end(),
                     [](const Located_point& a, const Located_point& b) {
                       return is_same_point(a.point, b.point) &&
                              a.location.kind == b.location.kind &&
                              a.location.index == b.location.index &&
                              is_same(a.location.s, b.location.s);
                     }),
          "the points survive");
}

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_POINTS_H
