// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_SVG_H
#define MULTIPATCH_SVG_H

#include "commands.h"

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace multipatch {

// One drawing of a domain within a picture: maps the domain to pixels, v upwards.
class Svg_panel {
public:
  static constexpr double width = 460, margin = 40, title_height = 40;

  Svg_panel(std::ostream& out, const Domain& domain, std::size_t column, std::size_t row = 0);

  // No higher than the domain needs.
  static double height(const Domain& domain);

  void title(const std::string& text);
  void area();
  void outline();
  // Emphasizes one side.
  void side(std::size_t i, const std::string& color);
  // Emphasizes one vertex.
  void vertex(std::size_t i);
  // `vertices` has the indices in the domain of the corners that are to be called 0, 1, ...; by
  // default they are called by these indices.
  void corners(const std::vector<std::size_t>& vertices = {});
  void side_numbers();
  // Lines on which the piecewise linear function with these values at the vertices of the mesh has
  // one of the levels, which are in ascending order; none where a value is not a number.
  void isolines(const Domain_mesh& mesh, const std::vector<double>& values,
                const std::vector<double>& levels, const std::string& color);

private:
  using Pixel = std::array<double, 2>;
  // pixels for a unit of the domain
  static double scale(const Domain& domain);
  Pixel pixel(double u, double v) const;
  Pixel pixel(const Kernel::Point_2& p) const { return pixel(p.x(), p.y()); }
  // Its part in one triangle.
  void isoline(const Domain_mesh& mesh, const std::vector<double>& values,
               const std::array<std::size_t, 3>& triangle, double level);
  void loops(const std::string& style);
  void disc(std::size_t i, double radius, const std::string& color);
  void text(const Pixel& at, const std::string& color, const std::string& text);
  // A pixel a little to the right of the direction from a to b: outside the domain.
  Pixel beside(const Kernel::Point_2& at, const Kernel::Vector_2& direction, double pixels) const;

  std::ostream& out_;
  const Domain& domain_;
  double left_, top_, scale_, u_, v_;
};

// Levels of isolines: first * step, ..., last * step
std::vector<double> multiples(double step, int first, int last);

// Starts a picture of so many panels of one domain.
void begin_svg(std::ostream& out, const Domain& domain, std::size_t columns, std::size_t rows = 1);
void end_svg(std::ostream& out);

} // namespace multipatch

#endif // MULTIPATCH_SVG_H
