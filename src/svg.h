// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_SVG_H
#define MULTIPATCH_SVG_H

#include "commands.h"

#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace multipatch {

// One drawing of a domain within a picture: maps the domain to a square of pixels, v upwards.
class Svg_panel {
public:
  using Domain = CGAL::Multisided_patches::Polygonal_domain_2<Kernel>;
  using Domain_mesh = CGAL::Multisided_patches::Domain_mesh_2<Kernel>;

  static constexpr double size = 460, margin = 40, title_height = 40;

  // The `index`-th panel from the left.
  Svg_panel(std::ostream& out, const Domain& domain, std::size_t index);

  void title(const std::string& text);
  void outline();
  // Emphasizes one side.
  void side(std::size_t i, const std::string& color);
  void corners();
  void side_numbers();
  // Lines on which the piecewise linear function with these values at the vertices of the mesh is a
  // multiple of `step`; none where a value is not a number.
  void isolines(const Domain_mesh& mesh, const std::vector<double>& values, double step,
                const std::string& color);

private:
  using Pixel = std::array<double, 2>;
  Pixel pixel(double u, double v) const;
  Pixel pixel(const Kernel::Point_2& p) const { return pixel(p.x(), p.y()); }
  void text(const Pixel& at, const std::string& color, const std::string& text);
  // A pixel a little to the right of the direction from a to b: outside the domain.
  Pixel beside(const Kernel::Point_2& at, const Kernel::Vector_2& direction, double pixels) const;

  std::ostream& out_;
  const Domain& domain_;
  double left_, scale_, u_, v_;
};

void begin_svg(std::ostream& out, std::size_t panels);
void end_svg(std::ostream& out);

} // namespace multipatch

#endif // MULTIPATCH_SVG_H
