// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "coordinates_svg.h"

#include "svg.h"

#include <algorithm>

namespace multipatch {

namespace {

constexpr std::size_t max_columns = 4;

// Lines of small values lie far from the vertex, where those at steps of 0.1 say nothing.
void draw_isolines(Svg_panel& panel, const Domain_mesh& mesh, const std::vector<double>& values) {
  panel.isolines(mesh, values, {0.0001}, "#ddd0ea");
  panel.isolines(mesh, values, {0.001}, "#cdbbe0");
  panel.isolines(mesh, values, {0.01}, "#b598d0");
  panel.isolines(mesh, values, multiples(0.1, 1, 20), "#7a3fa0");
  panel.isolines(mesh, values, {-0.01, -0.001}, "#efa8a4");
  panel.isolines(mesh, values, multiples(0.1, -20, -1), "#c8322b");
}

// Numbers that would cover each other are left out.
void draw_vertices(Svg_panel& panel, const Domain_input& input, std::size_t vertex) {
  constexpr std::size_t many = 40;
  if (input.vertices.size() <= many)
    panel.corners(input.vertices);
  panel.vertex(input.vertices[vertex]);
}

} // namespace

void write_coordinates_svg(std::ostream& out, const Domain_input& input, const Domain_mesh& mesh,
                           const std::vector<std::size_t>& drawn, const std::vector<double>& values,
                           const std::string& name) {
  const std::size_t count = drawn.size(), columns = (std::min)(count, max_columns);
  begin_svg(out, input.domain, columns, (count + columns - 1) / columns);
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> lambda;
    for (std::size_t p = k; p < values.size(); p += count)
      lambda.push_back(values[p]);
    Svg_panel panel(out, input.domain, k % columns, k / columns);
    panel.title(name + " coordinate of vertex " + std::to_string(drawn[k]) +
                "; light: 0.01, 0.001, 0.0001");
    panel.area();
    draw_isolines(panel, mesh, lambda);
    panel.outline();
    draw_vertices(panel, input, drawn[k]);
  }
  end_svg(out);
}

} // namespace multipatch
