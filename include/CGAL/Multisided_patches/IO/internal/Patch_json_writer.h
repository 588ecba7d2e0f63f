// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PATCH_JSON_WRITER_H
#define CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PATCH_JSON_WRITER_H

#include <CGAL/Multisided_patches/IO/internal/patch_json_format.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace IO {
namespace internal {

// The members of a JSON object, in order, which a person can read: one a line, and one point a
// line.
class Json_members {
public:
  explicit Json_members(std::size_t indentation) : margin_(indentation + 2, ' ') {}

  Json_members& add(const std::string& key, const std::string& value) {
    text_ += (text_.empty() ? "" : ",\n") + margin_ + '"' + key + "\": " + value;
    return *this;
  }
  std::string object() const { return "{\n" + text_ + '\n' + margin_.substr(2) + '}'; }

  // Elements one a line, for a member.
  std::string array(const std::vector<std::string>& elements) const {
    std::string text;
    for (const std::string& element : elements)
      text += (text.empty() ? "\n" : ",\n") + margin_ + "  " + element;
    return '[' + text + (text.empty() ? "]" : '\n' + margin_ + ']');
  }

private:
  std::string margin_, text_;
};

// Makes the JSON text of a model. Throws Input_error if the reader would refuse it.
class Patch_json_writer {
public:
  template <typename Traits>
  std::string text(const Concave_bezier_description_3<Traits>& model) {
    check_sides(model.loop.size());
    require(model.reflex_weight > 0, "the reflex weight must be positive");
    require(model.corner_control_points.size() <= model.loop.size(),
            "there are more corner control points than sides");
    Json_members members = head(Patch_type::concave_bezier);
    add_plane(members, model);
    members.add("central_weight", quoted(model.central_weight));
    if (model.central_point)
      members.add("central_point", point(*model.central_point));
    members.add("parameter_dilation", number(model.parameter_dilation))
        .add("reflex_weight", number(model.reflex_weight))
        .add("sides", members.array(sides(model.loop)));
    if (!model.corner_control_points.empty())
      members.add("corner_control_points", members.array(corners(model)));
    return members.object();
  }

  template <typename Traits>
  std::string text(const Generalized_bezier_description_3<Traits>& model) {
    Json_members members = head(Patch_type::generalized_bezier);
    add_plane(members, model);
    members.add("number_of_sides", sides(model.net.size()))
        .add("degree", degree(model.net.degree()))
        .add("control_points", members.array(points(model.net.control_points())));
    return members.object();
  }

  template <typename Traits>
  std::string text(const S_patch_description_3<Traits>& model) {
    Json_members members = head(Patch_type::s_patch);
    add_plane(members, model);
    members.add("number_of_sides", sides(model.net.size()))
        .add("depth", degree(model.net.depth()))
        .add("control_points", members.array(points(model.net.control_points())));
    return members.object();
  }

  template <typename Traits>
  std::string text(const Tensor_product_patch_3<Traits>& patch) {
    Json_members members = head(Patch_type::tensor_product);
    members.add("degree_u", degree(patch.degree_u()))
        .add("degree_v", degree(patch.degree_v()))
        .add("control_points", members.array(points(patch.control_points())));
    return members.object();
  }

  template <typename Traits>
  std::string text(const Bezier_triangle_3<Traits>& patch) {
    Json_members members = head(Patch_type::bezier_triangle);
    members.add("domain", polygon(patch.domain().vertices()))
        .add("degree", degree(patch.degree()))
        .add("control_points", members.array(points(patch.control_points())));
    return members.object();
  }

private:
  static Json_members head(Patch_type type) {
    Json_members members(0);
    members.add("format", '"' + std::string(patch_json_name) + '"')
        .add("version", std::to_string(patch_json_version))
        .add("type", quoted(type));
    return members;
  }

  template <typename Description>
  static void add_plane(Json_members& members, const Description& model) {
    members.add("coordinates", quoted(model.coordinates));
    require(model.domain.clearance >= 0, "the clearance must not be negative");
    members.add("domain", !model.domain_vertices.empty()
                              ? polygon(model.domain_vertices)
                              : "{\"generator\": " + quoted(model.domain.generator) +
                                    ", \"clearance\": " + number(model.domain.clearance) + '}');
  }

  template <typename Points>
  static std::string polygon(const Points& vertices) {
    std::string text;
    for (const auto& p : vertices)
      text += (text.empty() ? "[" : ", [") + number(CGAL::to_double(p.x())) + ", " +
              number(CGAL::to_double(p.y())) + ']';
    return "{\"vertices\": [" + text + "]}";
  }

  template <typename Loop>
  std::vector<std::string> sides(const Loop& loop) {
    std::vector<std::string> result;
    for (const auto& ribbon : loop.ribbons()) {
      require(ribbon.layers() <= Patch_json_limits::max_layers, "there are too many layers");
      Json_members side(4);
      side.add("degree", degree(ribbon.degree()))
          .add("layers", std::to_string(ribbon.layers()))
          .add("control_points", side.array(points(ribbon.control_points())));
      result.push_back(side.object());
    }
    return result;
  }

  template <typename Model>
  static std::vector<std::string> corners(const Model& model) {
    std::vector<std::string> result;
    for (const auto& corner : model.corner_control_points) {
      require(corner.index < model.loop.size(), "a corner control point is at no corner");
      result.push_back("{\"side\": " + std::to_string(corner.index) +
                       ", \"point\": " + point(corner.point) + '}');
    }
    return result;
  }

  template <typename Point_3>
  std::vector<std::string> points(const std::vector<Point_3>& control_points) {
    number_of_points_ += control_points.size();
    require(number_of_points_ <= Patch_json_limits::max_control_points,
            "there are too many control points");
    std::vector<std::string> result;
    for (const Point_3& p : control_points)
      result.push_back(point(p));
    return result;
  }
  template <typename Point_3>
  static std::string point(const Point_3& p) {
    return '[' + number(CGAL::to_double(p.x())) + ", " + number(CGAL::to_double(p.y())) + ", " +
           number(CGAL::to_double(p.z())) + ']';
  }

  static std::string number(double x) {
    require(std::isfinite(x), "a number is not finite");
    // As an integer, zero would lose its sign.
    return x == 0 && std::signbit(x) ? "-0.0" : Multisided_patches::internal::to_text(x);
  }
  static std::string degree(std::size_t degree) {
    require(degree <= Patch_json_limits::max_degree, "a degree is too high");
    return std::to_string(degree);
  }
  static void check_sides(std::size_t n) {
    require(n <= Patch_json_limits::max_sides, "there are too many sides");
  }
  static std::string sides(std::size_t n) {
    check_sides(n);
    return std::to_string(n);
  }
  template <typename Value>
  static std::string quoted(Value value) {
    return '"' + std::string(to_string(value)) + '"';
  }

  static void require(bool condition, const char* reason) {
    if (!condition)
      throw Input_error("the patch does not fit the .patch.json format: " + std::string(reason));
  }

  std::size_t number_of_points_ = 0;
};

} // namespace internal
} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PATCH_JSON_WRITER_H
