// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "coordinates_csv.h"

#include <CGAL/Multisided_patches/internal/to_text.h>

#include <algorithm>
#include <string>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

void write_header(std::ostream& out, std::size_t vertices, int derivatives) {
  static const char* const parts[] = {"", "_u", "_v", "_uu", "_uv", "_vv"};
  out << "u,v";
  for (std::size_t i = 0; i < vertices; ++i)
    out << ",lambda_" << i;
  for (std::size_t i = 0; i < vertices; ++i)
    for (std::size_t k = 1; k < number_of_parts(derivatives); ++k)
      out << ",lambda_" << i << parts[k];
  out << '\n';
}

// A row for each point, of what evaluate() gives for all vertices.
void write_rows(std::ostream& out, const std::vector<Located_point>& points,
                const std::vector<double>& values, int derivatives) {
  const std::size_t parts = number_of_parts(derivatives);
  const std::size_t columns = values.size() / points.size();
  std::string row;
  const auto append = [&row](double x) { row += ',' + MP::internal::to_text(x); };
  for (std::size_t p = 0; p < points.size(); ++p) {
    row = MP::internal::to_text(points[p].point.x());
    append(points[p].point.y());
    const double* value = values.data() + p * columns;
    for (std::size_t c = 0; c < columns; c += parts)
      append(value[c]);
    for (std::size_t c = 0; c < columns; ++c)
      if (c % parts != 0)
        append(value[c]);
    out << row << '\n';
  }
}

} // namespace

std::size_t write_coordinates_csv(std::ostream& out, const Any_coordinates& coordinates,
                                  const std::vector<std::size_t>& vertices, int derivatives,
                                  const Point_source& next, Stage_clock& clock) {
  constexpr std::size_t block_numbers = std::size_t(1) << 20;
  const std::size_t columns = vertices.size() * number_of_parts(derivatives);
  const std::size_t block = (std::max)(std::size_t(1), block_numbers / columns);
  write_header(out, vertices.size(), derivatives);
  std::size_t count = 0;
  for (bool more = true; more;) {
    std::vector<Located_point> points;
    for (Located_point p; points.size() < block && (more = next(p));)
      points.push_back(p);
    if (points.empty())
      break;
    const std::vector<double> values = clock.run(
        "evaluation", [&] { return evaluate(coordinates, vertices, derivatives, points); });
    clock.run("writing", [&] { write_rows(out, points, values, derivatives); });
    count += points.size();
  }
  return count;
}

} // namespace multipatch
