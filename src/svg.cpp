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

void begin_svg(std::ostream& out, std::size_t panels) {
  const double width = static_cast<double>(panels) * Svg_panel::size;
  const double height = Svg_panel::size + Svg_panel::title_height;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
      << "\" viewBox=\"0 0 " << width << ' ' << height
      << "\" font-family=\"sans-serif\" font-size=\"13\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
}

void end_svg(std::ostream& out) {
  out << "</svg>\n";
}

Svg_panel::Svg_panel(std::ostream& out, const Domain& domain, std::size_t index)
    : out_(out), domain_(domain), left_(static_cast<double>(index) * size) {
  const CGAL::Bbox_2 box = domain.bbox();
  const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin();
  scale_ = (size - 2 * margin) / (std::max)(width, height);
  u_ = (box.xmin() + box.xmax()) / 2;
  v_ = (box.ymin() + box.ymax()) / 2;
}

Svg_panel::Pixel Svg_panel::pixel(double u, double v) const {
  const auto round = [](double x) { return std::round(100 * x) / 100; };
  return {round(left_ + size / 2 + scale_ * (u - u_)),
          round(title_height + size / 2 - scale_ * (v - v_))};
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
  this->text({left_ + size / 2, title_height / 2 + 4}, "black", text);
}

void Svg_panel::outline() {
  out_ << "<polygon fill=\"#f3f6fa\" stroke=\"black\" stroke-width=\"1.5\" points=\"";
  for (const auto& p : domain_.vertices()) {
    const Pixel at = pixel(p);
    out_ << at[0] << ',' << at[1] << ' ';
  }
  out_ << "\"/>\n";
}

void Svg_panel::side(std::size_t i, const std::string& color) {
  const Pixel a = pixel(domain_.vertex(i)), b = pixel(domain_.vertex(domain_.next(i)));
  out_ << "<line x1=\"" << a[0] << "\" y1=\"" << a[1] << "\" x2=\"" << b[0] << "\" y2=\"" << b[1]
       << "\" stroke=\"" << color << "\" stroke-width=\"4\"/>\n";
}

void Svg_panel::corners() {
  for (std::size_t i = 0; i < domain_.size(); ++i) {
    const auto& p = domain_.vertex(i);
    const std::string color = corner_color(domain_.corner_type(i));
    const Pixel at = pixel(p);
    out_ << "<circle cx=\"" << at[0] << "\" cy=\"" << at[1] << "\" r=\"5\" fill=\"" << color
         << "\"/>\n";
    // Along the sum of the unit vectors of both sides, to its right.
    const auto unit = [](const Kernel::Vector_2& d) { return d / std::hypot(d.x(), d.y()); };
    const auto direction =
        unit(p - domain_.vertex(domain_.prev(i))) + unit(domain_.vertex(domain_.next(i)) - p);
    text(beside(p, direction, 16), color, std::to_string(i));
  }
}

void Svg_panel::side_numbers() {
  for (std::size_t i = 0; i < domain_.size(); ++i) {
    const auto &a = domain_.vertex(i), &b = domain_.vertex(domain_.next(i));
    text(beside(CGAL::midpoint(a, b), b - a, -14), "#888888", std::to_string(i));
  }
}

void Svg_panel::isolines(const Domain_mesh& mesh, const std::vector<double>& values, double step,
                         const std::string& color) {
  out_ << "<path fill=\"none\" stroke=\"" << color << "\" stroke-width=\"1\" d=\"";
  for (const auto& t : mesh.triangles) {
    if (std::isnan(values[t[0]] + values[t[1]] + values[t[2]]))
      continue;
    const auto [low, high] = std::minmax({values[t[0]], values[t[1]], values[t[2]]});
    for (double k = std::ceil(low / step); k * step < high; ++k) {
      const double level = k * step;
      const char* pen = "M";
      for (std::size_t e = 0; e < 3; ++e) {
        const std::size_t a = t[e], b = t[(e + 1) % 3];
        if ((values[a] < level) == (values[b] < level))
          continue;
        const double x = (level - values[a]) / (values[b] - values[a]);
        const auto p = mesh.points[a] + x * (mesh.points[b] - mesh.points[a]);
        const Pixel at = pixel(p);
        out_ << pen << at[0] << ' ' << at[1];
        pen = "L";
      }
    }
  }
  out_ << "\"/>\n";
}

} // namespace multipatch
