// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "svg.h"

#include <algorithm>
#include <cmath>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

const char* corner_color(MP::Corner_type type) {
  switch (type) {
  case MP::Corner_type::convex:
    return "#1f5fa8";
  case MP::Corner_type::straight:
    return "#777777";
  case MP::Corner_type::reflex:
    return "#c8322b";
  }
  return "";
}

} // namespace

std::vector<double> multiples(double step, int first, int last) {
  std::vector<double> levels;
  for (int k = first; k <= last; ++k)
    levels.push_back(k * step);
  return levels;
}

void begin_svg(std::ostream& out, const Domain& domain, std::size_t columns, std::size_t rows) {
  const double width = static_cast<double>(columns) * Svg_panel::width;
  const double height = static_cast<double>(rows) * Svg_panel::height(domain);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
      << "\" viewBox=\"0 0 " << width << ' ' << height
      << "\" font-family=\"sans-serif\" font-size=\"13\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
}

void end_svg(std::ostream& out) {
  out << "</svg>\n";
}

Svg_panel::Svg_panel(std::ostream& out, const Domain& domain, std::size_t column, std::size_t row)
    : out_(out), domain_(domain), scale_(scale(domain)) {
  const CGAL::Bbox_2 box = domain.bbox();
  left_ = static_cast<double>(column) * width;
  top_ = static_cast<double>(row) * height(domain);
  u_ = (box.xmin() + box.xmax()) / 2;
  v_ = box.ymax();
}

double Svg_panel::scale(const Domain& domain) {
  const CGAL::Bbox_2 box = domain.bbox();
  return (width - 2 * margin) / (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
}

double Svg_panel::height(const Domain& domain) {
  const CGAL::Bbox_2 box = domain.bbox();
  return std::ceil(title_height + 2 * margin + scale(domain) * (box.ymax() - box.ymin()));
}

Svg_panel::Pixel Svg_panel::pixel(double u, double v) const {
  const auto round = [](double x) { return std::round(100 * x) / 100; };
  return {round(left_ + width / 2 + scale_ * (u - u_)),
          round(top_ + title_height + margin + scale_ * (v_ - v))};
}

Svg_panel::Pixel Svg_panel::beside(const Kernel::Point_2& at, const Kernel::Vector_2& direction,
                                   double pixels) const {
  const double length = std::hypot(direction.x(), direction.y());
  const double shift = length > 0 ? pixels / scale_ / length : 0;
  return pixel(at.x() + shift * direction.y(), at.y() - shift * direction.x());
}

void Svg_panel::text(const Pixel& at, const std::string& color, const std::string& text) {
  out_ << "<text x=\"" << at[0] << "\" y=\"" << at[1] + 4 << "\" text-anchor=\"middle\" fill=\""
       << color << "\">" << text << "</text>\n";
}

void Svg_panel::title(const std::string& text) {
  this->text({left_ + width / 2, top_ + title_height / 2 + 4}, "black", text);
}

void Svg_panel::loops(const std::string& style) {
  out_ << "<path " << style << " d=\"";
  for (std::size_t loop = 0; loop < domain_.number_of_loops(); ++loop) {
    const char* pen = "M";
    for (std::size_t i = domain_.loop_begin(loop); i < domain_.loop_begin(loop + 1); ++i) {
      const Pixel at = pixel(domain_.vertex(i));
      out_ << pen << at[0] << ' ' << at[1];
      pen = "L";
    }
    out_ << 'Z';
  }
  out_ << "\"/>\n";
}

void Svg_panel::area() {
  loops("fill=\"#f3f6fa\" fill-rule=\"evenodd\"");
}

void Svg_panel::outline() {
  loops("fill=\"none\" stroke=\"black\" stroke-width=\"1.5\"");
}

void Svg_panel::side(std::size_t i, const std::string& color) {
  const Pixel a = pixel(domain_.vertex(i)), b = pixel(domain_.vertex(domain_.next(i)));
  out_ << "<line x1=\"" << a[0] << "\" y1=\"" << a[1] << "\" x2=\"" << b[0] << "\" y2=\"" << b[1]
       << "\" stroke=\"" << color << "\" stroke-width=\"4\"/>\n";
}

void Svg_panel::disc(std::size_t i, double radius, const std::string& color) {
  const Pixel at = pixel(domain_.vertex(i));
  out_ << "<circle cx=\"" << at[0] << "\" cy=\"" << at[1] << "\" r=\"" << radius << "\" fill=\""
       << color << "\"/>\n";
}

void Svg_panel::vertex(std::size_t i) {
  disc(i, 7, "black");
}

void Svg_panel::corners(const std::vector<std::size_t>& vertices) {
  for (std::size_t k = 0; k < domain_.size(); ++k) {
    const std::size_t i = vertices.empty() ? k : vertices[k];
    const auto& p = domain_.vertex(i);
    const std::string color = corner_color(domain_.corner_type(i));
    disc(i, 5, color);
    // Along the sum of the unit vectors of both sides, to its right.
    const auto unit = [](const Kernel::Vector_2& d) { return d / std::hypot(d.x(), d.y()); };
    const auto direction =
        unit(p - domain_.vertex(domain_.prev(i))) + unit(domain_.vertex(domain_.next(i)) - p);
    text(beside(p, direction, 16), color, std::to_string(k));
  }
}

void Svg_panel::side_numbers() {
  for (std::size_t i = 0; i < domain_.size(); ++i) {
    const auto &a = domain_.vertex(i), &b = domain_.vertex(domain_.next(i));
    text(beside(CGAL::midpoint(a, b), b - a, -14), "#888888", std::to_string(i));
  }
}

void Svg_panel::isolines(const Domain_mesh& mesh, const std::vector<double>& values,
                         const std::vector<double>& levels, const std::string& color) {
  out_ << "<path fill=\"none\" stroke=\"" << color << "\" stroke-width=\"1\" d=\"";
  for (const auto& t : mesh.triangles) {
    if (std::isnan(values[t[0]] + values[t[1]] + values[t[2]]))
      continue;
    const auto [low, high] = std::minmax({values[t[0]], values[t[1]], values[t[2]]});
    for (auto level = std::upper_bound(levels.begin(), levels.end(), low);
         level != levels.end() && *level <= high; ++level)
      isoline(mesh, values, t, *level);
  }
  out_ << "\"/>\n";
}

void Svg_panel::isoline(const Domain_mesh& mesh, const std::vector<double>& values,
                        const std::array<std::size_t, 3>& triangle, double level) {
  const char* pen = "M";
  for (std::size_t e = 0; e < 3; ++e) {
    const std::size_t a = triangle[e], b = triangle[(e + 1) % 3];
    if ((values[a] < level) == (values[b] < level))
      continue;
    const double x = (level - values[a]) / (values[b] - values[a]);
    const Pixel at = pixel(mesh.points[a] + x * (mesh.points[b] - mesh.points[a]));
    out_ << pen << at[0] << ' ' << at[1];
    pen = "L";
  }
}

} // namespace multipatch
