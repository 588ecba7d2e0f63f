// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_CGB_H
#define CGAL_MULTISIDED_PATCHES_IO_CGB_H

#include <CGAL/Multisided_patches/IO/internal/Token_reader.h>
#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/IO/internal/point_text.h>
#include <CGAL/Multisided_patches/bases/Central_weight.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_model_3.h>

#include <algorithm>
#include <array>
#include <cmath>
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
 * The `.cgb` format of concave generalized Bézier patches: numbers separated by white space,
 * \verbatim
 * central_weight                    0 weight deficiency, 1 none, 2 adjacent, 3 full product of h
 * domain_type                       0 projected, 1 similarity, 2 similarity-outer, 3 curved
 * domain_tolerance                  wanted clearance, as a fraction of the domain's size
 * parameter_dilation
 * n                                 number of sides
 * x y z                             central control point
 * d l                               for each side: degree and layers, then
 * x y z ...                         l rows of d + 1 points, row 0 (the boundary) first
 * k                                 number of extra corner control points, then for each
 * i x y z                           the side that ends at the corner, and the point
 * \endverbatim
 * The last point of row 0 of a side is the first one of the next side.
 */
namespace IO {

//! Limits of `.cgb` files. They are far above what patches need and keep hostile files harmless.
struct CGB_limits {
  static constexpr std::size_t max_sides = 1000;
  static constexpr std::size_t max_degree = 100;
  static constexpr std::size_t max_layers = 50;
};

namespace internal {

using Multisided_patches::internal::read_point;
using Multisided_patches::internal::Token_reader;

// The integers of the format, in order.
inline constexpr std::array central_weights{Central_weight::weight_deficiency, Central_weight::none,
                                            Central_weight::adjacent_products,
                                            Central_weight::full_product};
inline constexpr std::array domain_types{Domain_generator::projected, Domain_generator::similarity,
                                         Domain_generator::similarity_outer,
                                         Domain_generator::curved};

template <typename Traits>
Bezier_ribbon_3<Traits> read_ribbon(Token_reader& in, std::size_t side) {
  const std::string of_side = " of side " + std::to_string(side);
  const std::size_t degree = in.integer("the degree" + of_side, 1, CGB_limits::max_degree);
  const std::size_t layers =
      in.integer("the number of layers" + of_side, 1, CGB_limits::max_layers);
  std::vector<typename Traits::Point_3> points;
  for (std::size_t k = 0; k < layers; ++k)
    for (std::size_t j = 0; j <= degree; ++j)
      points.push_back(read_point<Traits>(in, "point " + std::to_string(j) + " in row " +
                                                  std::to_string(k) + of_side));
  return Bezier_ribbon_3<Traits>(degree, layers, std::move(points));
}

} // namespace internal

/*!
 * reads a patch in `.cgb` format.
 *
 * \tparam Traits a CGAL kernel
 * \param in the stream
 * \param name what error messages call the stream
 *
 * \throws Input_error naming the line and what was expected there, or the side at which the loop is
 * not valid
 */
template <typename Traits>
Concave_bezier_model_3<Traits> read_CGB(std::istream& in, const std::string& name) {
  internal::Token_reader reader(in, name);
  const auto central_weight = internal::central_weights[reader.integer("the central weight", 0, 3)];
  Domain_options domain;
  domain.generator = internal::domain_types[reader.integer("the domain type", 0, 3)];
  domain.clearance = reader.number("the domain tolerance");
  if (domain.clearance < 0)
    reader.fail("expected a domain tolerance that is not negative");
  const double dilation = reader.number("the parameter dilation");
  const std::size_t n = reader.integer("the number of sides", 3, CGB_limits::max_sides);
  const auto central_point = internal::read_point<Traits>(reader, "the central control point");
  std::vector<Bezier_ribbon_3<Traits>> ribbons;
  for (std::size_t i = 0; i < n; ++i)
    ribbons.push_back(internal::read_ribbon<Traits>(reader, i));

  using Model = Concave_bezier_model_3<Traits>;
  std::vector<typename Model::Corner_control_point> corner_points;
  const std::size_t k = reader.integer("the number of extra corner control points", 0, n);
  for (std::size_t i = 0; i < k; ++i) {
    const std::string what = "extra corner control point " + std::to_string(i);
    const std::size_t index = reader.integer("the index of " + what, 0, n - 1);
    corner_points.push_back({index, internal::read_point<Traits>(reader, what)});
  }
  reader.expect_end();

  try {
    Model model(Ribbon_loop_3<Traits>(std::move(ribbons)));
    model.central_point = central_point;
    model.central_weight = central_weight;
    model.domain = domain;
    model.parameter_dilation = dilation;
    model.corner_control_points = std::move(corner_points);
    return model;
  } catch (const Input_error& error) {
    throw Input_error(name + ": " + error.what());
  }
}

//! reads a patch from a `.cgb` file. \throws Input_error as above, or if the file cannot be read
template <typename Traits>
Concave_bezier_model_3<Traits> read_CGB(const std::string& file_name) {
  auto in = Multisided_patches::internal::open_for_reading(file_name);
  return read_CGB<Traits>(in, file_name);
}

namespace internal {

// Refuses what read_CGB would refuse.
template <typename Traits>
void check_limits(const Concave_bezier_model_3<Traits>& model) {
  bool good = model.loop.size() <= CGB_limits::max_sides && model.domain.clearance >= 0 &&
              std::isfinite(model.domain.clearance) && std::isfinite(model.parameter_dilation) &&
              model.corner_control_points.size() <= model.loop.size();
  for (const auto& ribbon : model.loop.ribbons())
    good = good && ribbon.degree() <= CGB_limits::max_degree &&
           ribbon.layers() <= CGB_limits::max_layers;
  for (const auto& corner : model.corner_control_points)
    good = good && corner.index < model.loop.size();
  if (!good)
    throw Input_error(
        "the model does not fit the .cgb format: too many sides or layers, too high a "
        "degree, or options that are out of range");
  if (model.central_weight == Central_weight::automatic)
    throw Input_error("the .cgb format has no automatic central weight; name one, or write what "
                      "with_resolved_central_weight() returns");
}

} // namespace internal

/*!
 * writes a patch in `.cgb` format. Numbers have as many digits as it takes to read the same doubles
 * back. The format knows only four ways to make a domain; others are written as similarity.
 *
 * It has no automatic central weight, which a new model has: name a weight, or pass
 * `with_resolved_central_weight(model)`, which computes what the automatic one stands for.
 *
 * \throws Input_error if the central weight is `automatic`, the model exceeds `CGB_limits`, or an
 * option is not finite or negative
 */
template <typename Traits>
void write_CGB(std::ostream& out, const Concave_bezier_model_3<Traits>& model) {
  using Multisided_patches::internal::point_line;
  using Multisided_patches::internal::to_text;
  internal::check_limits(model);
  const auto index_of = [](const auto& values, auto value, std::size_t otherwise) {
    const auto found = std::find(values.begin(), values.end(), value);
    return std::to_string(found == values.end() ? otherwise : found - values.begin());
  };
  // Only text goes to the stream, so that its format flags and its locale have no effect.
  out << index_of(internal::central_weights, model.central_weight, 1) << '\n'
      << index_of(internal::domain_types, model.domain.generator, 1) << '\n'
      << to_text(model.domain.clearance) << '\n'
      << to_text(model.parameter_dilation) << '\n'
      << std::to_string(model.loop.size()) << '\n'
      << point_line(model.central_point.value_or(model.default_central_point()));
  for (const auto& ribbon : model.loop.ribbons()) {
    out << std::to_string(ribbon.degree()) << ' ' << std::to_string(ribbon.layers()) << '\n';
    for (const auto& p : ribbon.control_points())
      out << point_line(p);
  }
  out << std::to_string(model.corner_control_points.size()) << '\n';
  for (const auto& corner : model.corner_control_points)
    out << std::to_string(corner.index) << ' ' << point_line(corner.point);
}

/*!
 * writes the patch that fills a loop without a central control point (`Central_weight::none`), and
 * with the default options otherwise. A patch made from the loop chooses the weight itself, and
 * takes another one for compact stars; `with_resolved_central_weight<Traits>(loop)` is the model
 * that it has.
 */
template <typename Traits>
void write_CGB(std::ostream& out, const Ribbon_loop_3<Traits>& loop) {
  Concave_bezier_model_3<Traits> model(loop);
  model.central_weight = Central_weight::none;
  write_CGB(out, model);
}

//! writes a patch to a `.cgb` file, whole or not at all. \throws Error if it cannot be written
template <typename Traits>
void write_CGB(const std::string& file_name, const Concave_bezier_model_3<Traits>& model) {
  Multisided_patches::internal::Atomic_file file(file_name);
  write_CGB(file.stream(), model);
  file.commit();
}

//! the same for the patch that fills a loop without a central control point
template <typename Traits>
void write_CGB(const std::string& file_name, const Ribbon_loop_3<Traits>& loop) {
  Multisided_patches::internal::Atomic_file file(file_name);
  write_CGB(file.stream(), loop);
  file.commit();
}

} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_CGB_H
