// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_POLYGON_FILE_H
#define CGAL_MULTISIDED_PATCHES_IO_POLYGON_FILE_H

#include <CGAL/Multisided_patches/IO/internal/Point_line_reader.h>
#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>

#include <algorithm>
#include <cstddef>
#include <istream>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * \file
 * Polygon files: the vertices of a polygon, possibly with holes, as text. A line has the two
 * numbers of a vertex, separated by white space and written with a decimal point. Blank lines
 * separate the loops; the first loop is the outer one, the others are holes. A loop may run either
 * way around, and its last point may repeat the first one. `#` starts a comment, and a line that
 * has nothing but a comment separates nothing. A square with a hole:
 * \verbatim
 * 0 0
 * 3 0
 * 3 3
 * 0 3
 *
 * 1 1    # a triangular hole
 * 2 1
 * 1 2
 * \endverbatim
 */
namespace IO {

//! Limits of polygon files. They are above what coordinates need and keep hostile files harmless.
struct Polygon_file_limits {
  static constexpr std::size_t max_vertices = 10000;
};

/*!
 * What is in a polygon file.
 *
 * \tparam Traits a CGAL kernel with exact predicates
 */
template <typename Traits>
struct Polygon_file {
  Polygonal_domain_2<Traits> domain;
  //! for each vertex in the order of the file, its index in `domain`. Loops that run the other way
  //! in the file start with the same vertex in the domain, and have the others in reverse order.
  //! Points that repeat the first one of their loop do not count.
  std::vector<std::size_t> vertices;
};

namespace internal {

// The points of all loops in the order of a file; loop k starts at begins[k].
template <typename Traits>
struct Polygon_points {
  std::vector<typename Traits::Point_2> points;
  std::vector<std::size_t> begins{0};

  // Called where a loop ends, for the reader to name the line if something is wrong with it.
  void end_loop(const Multisided_patches::internal::Point_line_reader& reader) {
    const std::size_t first = begins.back();
    if (points.size() == first)
      return;
    if (points.size() - first > 1 && points.back() == points[first])
      points.pop_back();
    if (points.size() - first < 3)
      reader.fail("expected at least 3 different vertices in the loop that ends here, found " +
                  std::to_string(points.size() - first));
    begins.push_back(points.size());
  }
};

template <typename Traits>
Polygon_points<Traits>
read_polygon_points(Multisided_patches::internal::Point_line_reader& reader) {
  using Line = Multisided_patches::internal::Point_line_reader::Line;
  using FT = typename Traits::FT;
  constexpr std::size_t max_vertices = Polygon_file_limits::max_vertices;
  Polygon_points<Traits> loops;
  for (Line line = reader.next(); line != Line::end; line = reader.next()) {
    if (line == Line::blank) {
      loops.end_loop(reader);
      continue;
    }
    if (loops.points.size() == max_vertices)
      reader.fail("expected no more than " + std::to_string(max_vertices) + " vertices");
    loops.points.emplace_back(FT(reader.point()[0]), FT(reader.point()[1]));
  }
  loops.end_loop(reader);
  if (loops.points.empty())
    reader.fail(
        "expected the vertices of a polygon, two numbers a line, found the end of the file");
  return loops;
}

// Checks the loops in the order of the file, so that messages tell the numbers that the user knows,
// and orients them.
template <typename Traits>
Polygon_file<Traits> oriented_polygon(const Polygon_points<Traits>& file) {
  const Multisided_patches::internal::Loops<Traits> loops{file.points, file.begins};
  check_unoriented_loops(loops);
  std::vector<std::vector<typename Traits::Point_2>> holes;
  std::vector<typename Traits::Point_2> outer;
  std::vector<std::size_t> vertices(file.points.size());
  std::iota(vertices.begin(), vertices.end(), std::size_t(0));
  for (std::size_t k = 0; k + 1 < file.begins.size(); ++k) {
    std::vector<typename Traits::Point_2> loop(loops.begin(k), loops.end(k));
    if (!is_well_oriented(loops, k)) {
      // The same permutation turns the order of the file into that of the domain and back.
      std::reverse(loop.begin() + 1, loop.end());
      std::reverse(vertices.begin() + file.begins[k] + 1, vertices.begin() + file.begins[k + 1]);
    }
    if (k == 0)
      outer = loop;
    else
      holes.push_back(loop);
  }
  return {Polygonal_domain_2<Traits>(outer, holes), vertices};
}

} // namespace internal

/*!
 * reads a polygon file.
 *
 * \tparam Traits a CGAL kernel with exact predicates
 * \param in the stream
 * \param name what error messages call the stream
 *
 * \throws Input_error naming the line and what was expected there, or the sides or loops for which
 * the polygon is not valid, numbered in the order of the file from 0 on
 *
 * Complexity: that of the constructor of `Polygonal_domain_2`
 */
template <typename Traits>
Polygon_file<Traits> read_polygon_file(std::istream& in, const std::string& name) {
  Multisided_patches::internal::Point_line_reader reader(in, name);
  const auto points = internal::read_polygon_points<Traits>(reader);
  try {
    return internal::oriented_polygon(points);
  } catch (const Input_error& error) {
    throw Input_error(name + ": " + error.what());
  }
}

//! reads a polygon from a file. \throws Input_error as above, or if the file cannot be read
template <typename Traits>
Polygon_file<Traits> read_polygon_file(const std::string& file_name) {
  auto in = Multisided_patches::internal::open_for_reading(file_name);
  return read_polygon_file<Traits>(in, file_name);
}

} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_POLYGON_FILE_H
