// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_GBP_H
#define CGAL_MULTISIDED_PATCHES_IO_GBP_H

#include <CGAL/Multisided_patches/IO/internal/Token_reader.h>
#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/IO/internal/point_text.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/ribbons/Generalized_bezier_net_3.h>

#include <cstddef>
#include <istream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * \file
 * The `.gbp` format of control nets of generalized Bézier patches: numbers separated by white
 * space,
 * \verbatim
 * n d                               number of sides, and degree
 * x y z                             central control point
 * x y z ...                         for each row k from the boundary inwards, and in it for each
 *                                   side i in order, the points of columns j = k, ..., d - k - 1
 * \endverbatim
 * The points are those of `Generalized_bezier_net_3::control_points()` in their order, but for the
 * central one, which comes first.
 */
namespace IO {

//! Limits of `.gbp` files. They are far above what patches need and keep hostile files harmless.
struct GBP_limits {
  static constexpr std::size_t max_sides = 1000;
  static constexpr std::size_t max_degree = 100;
};

/*!
 * reads a control net in `.gbp` format.
 *
 * \tparam Traits a CGAL kernel
 * \param in the stream
 * \param name what error messages call the stream
 *
 * \throws Input_error naming the line and what was expected there
 */
template <typename Traits>
Generalized_bezier_net_3<Traits> read_GBP(std::istream& in, const std::string& name) {
  using Multisided_patches::internal::read_point;
  Multisided_patches::internal::Token_reader reader(in, name);
  const std::size_t n = reader.integer("the number of sides", 3, GBP_limits::max_sides);
  const std::size_t d = reader.integer("the degree", 1, GBP_limits::max_degree);
  const auto central_point = read_point<Traits>(reader, "the central control point");
  // Grows with what is read: a file that claims much and holds little takes little memory.
  std::vector<typename Traits::Point_3> points;
  for (std::size_t k = 0; k < (d + 1) / 2; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = k; j < d - k; ++j)
        points.push_back(read_point<Traits>(reader, "point " + std::to_string(j) + " in row " +
                                                        std::to_string(k) + " of side " +
                                                        std::to_string(i)));
  reader.expect_end();
  points.push_back(central_point);
  return Generalized_bezier_net_3<Traits>(n, d, std::move(points));
}

//! reads a net from a `.gbp` file. \throws Input_error as above, or if the file cannot be read
template <typename Traits>
Generalized_bezier_net_3<Traits> read_GBP(const std::string& file_name) {
  auto in = Multisided_patches::internal::open_for_reading(file_name);
  return read_GBP<Traits>(in, file_name);
}

/*!
 * writes a control net in `.gbp` format. Numbers have as many digits as it takes to read the same
 * doubles back.
 *
 * \throws Input_error if the net exceeds `GBP_limits`
 */
template <typename Traits>
void write_GBP(std::ostream& out, const Generalized_bezier_net_3<Traits>& net) {
  using Multisided_patches::internal::point_line;
  if (net.size() > GBP_limits::max_sides || net.degree() > GBP_limits::max_degree)
    throw Input_error("the net does not fit the .gbp format: it has " + std::to_string(net.size()) +
                      " sides and degree " + std::to_string(net.degree()) + ", the limits are " +
                      std::to_string(GBP_limits::max_sides) + " and " +
                      std::to_string(GBP_limits::max_degree));
  // Only text goes to the stream, so that its format flags and its locale have no effect.
  out << std::to_string(net.size()) + ' ' + std::to_string(net.degree()) + '\n'
      << point_line(net.central_point());
  for (std::size_t k = 0; k + 1 < net.control_points().size(); ++k)
    out << point_line(net.control_points()[k]);
}

//! writes a net to a `.gbp` file, whole or not at all. \throws Error if it cannot be written
template <typename Traits>
void write_GBP(const std::string& file_name, const Generalized_bezier_net_3<Traits>& net) {
  Multisided_patches::internal::Atomic_file file(file_name);
  write_GBP(file.stream(), net);
  file.commit();
}

} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_GBP_H
