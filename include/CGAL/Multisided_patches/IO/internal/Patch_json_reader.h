// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PATCH_JSON_READER_H
#define CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PATCH_JSON_READER_H

#include <CGAL/Multisided_patches/IO/internal/Json_reader.h>
#include <CGAL/Multisided_patches/IO/internal/patch_json_format.h>
#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/errors.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace IO {
namespace internal {

using Multisided_patches::internal::Json_reader;

// Makes a patch model of the root of a JSON file.
template <typename Traits>
class Patch_json_reader {
public:
  using Model = Any_patch_model<Traits>;

  explicit Patch_json_reader(const Json_reader& root) : root_(root) {}

  Model read() const {
    if (root_["format"].text() != patch_json_name)
      root_["format"].fail("expected \"" + std::string(patch_json_name) + '"');
    root_["version"].integer(patch_json_version, patch_json_version);
    switch (root_["type"].choice(all_patch_types)) {
    case Patch_type::concave_bezier:
      return concave_bezier();
    case Patch_type::generalized_bezier:
      return generalized_bezier();
    case Patch_type::s_patch:
      return s_patch();
    case Patch_type::tensor_product:
      return tensor_product();
    case Patch_type::bezier_triangle:
      break;
    }
    return bezier_triangle();
  }

private:
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;
  using Point_3 = typename Traits::Point_3;
  using Limits = Patch_json_limits;

  Concave_bezier_description_3<Traits> concave_bezier() const {
    expect_keys({"coordinates", "domain", "central_weight", "central_point", "parameter_dilation",
                 "reflex_weight", "sides", "corner_control_points"});
    const Json_reader sides = root_["sides"];
    const std::size_t n = sides.size("sides", 3, Limits::max_sides);
    std::vector<Bezier_ribbon_3<Traits>> ribbons;
    for (std::size_t i = 0; i < n; ++i)
      ribbons.push_back(ribbon(sides[i]));
    using Description = Concave_bezier_description_3<Traits>;
    Description result =
        at(sides, [&] { return Description(Ribbon_loop_3<Traits>(std::move(ribbons))); });
    read_plane(result, n);
    if (root_.has("central_weight"))
      result.central_weight = root_["central_weight"].choice(all_central_weights);
    if (root_.has("central_point"))
      result.central_point = point(root_["central_point"]);
    if (root_.has("parameter_dilation"))
      result.parameter_dilation = root_["parameter_dilation"].number();
    if (root_.has("reflex_weight")) {
      result.reflex_weight = root_["reflex_weight"].number();
      if (!(result.reflex_weight > 0))
        root_["reflex_weight"].fail("expected a positive number");
    }
    if (root_.has("corner_control_points"))
      read_corners(result, root_["corner_control_points"]);
    return result;
  }

  static Bezier_ribbon_3<Traits> ribbon(const Json_reader& side) {
    side.expect_keys({"degree", "layers", "control_points"});
    const std::size_t degree = side["degree"].integer(1, Limits::max_degree);
    const std::size_t layers = side["layers"].integer(1, Limits::max_layers);
    return {degree, layers, points(side["control_points"], (degree + 1) * layers)};
  }

  static void read_corners(Concave_bezier_description_3<Traits>& result,
                           const Json_reader& corners) {
    const std::size_t n = result.loop.size();
    const std::size_t k = corners.size("corner control points", 0, n);
    for (std::size_t i = 0; i < k; ++i) {
      corners[i].expect_keys({"side", "point"});
      result.corner_control_points.push_back(
          {corners[i]["side"].integer(0, n - 1), point(corners[i]["point"])});
    }
  }

  Generalized_bezier_description_3<Traits> generalized_bezier() const {
    expect_keys({"coordinates", "domain", "number_of_sides", "degree", "control_points"});
    using Net = Generalized_bezier_net_3<Traits>;
    const std::size_t n = root_["number_of_sides"].integer(3, Limits::max_sides);
    const std::size_t degree = root_["degree"].integer(1, Limits::max_degree);
    Generalized_bezier_description_3<Traits> result(
        Net(n, degree, points(root_["control_points"], Net::number_of_control_points(n, degree))));
    read_plane(result, n);
    return result;
  }

  S_patch_description_3<Traits> s_patch() const {
    expect_keys({"coordinates", "domain", "number_of_sides", "depth", "control_points"});
    using Net = S_patch_net_3<Traits>;
    const std::size_t n = root_["number_of_sides"].integer(3, Limits::max_sides);
    const std::size_t depth = root_["depth"].integer(1, Limits::max_degree);
    const std::size_t number =
        at(root_["depth"], [&] { return Net::number_of_control_points(n, depth); });
    S_patch_description_3<Traits> result(Net(n, depth, points(root_["control_points"], number)));
    read_plane(result, n);
    return result;
  }

  Tensor_product_patch_3<Traits> tensor_product() const {
    expect_keys({"degree_u", "degree_v", "control_points"});
    const std::size_t u = root_["degree_u"].integer(1, Limits::max_degree);
    const std::size_t v = root_["degree_v"].integer(1, Limits::max_degree);
    auto control_points = points(root_["control_points"], (u + 1) * (v + 1));
    return at(root_["control_points"],
              [&] { return Tensor_product_patch_3<Traits>(u, v, std::move(control_points)); });
  }

  Bezier_triangle_3<Traits> bezier_triangle() const {
    expect_keys({"domain", "degree", "control_points"});
    using Patch = Bezier_triangle_3<Traits>;
    const std::size_t degree = root_["degree"].integer(1, Limits::max_degree);
    auto control_points = points(root_["control_points"], Patch::number_of_control_points(degree));
    if (!root_.has("domain"))
      return at(root_["control_points"], [&] { return Patch(degree, std::move(control_points)); });
    root_["domain"].expect_keys({"vertices"});
    Polygonal_domain_2<Traits> domain(polygon(root_["domain"]["vertices"], 3));
    return at(root_["control_points"],
              [&] { return Patch(degree, std::move(control_points), std::move(domain)); });
  }

  void expect_keys(std::vector<std::string> keys) const {
    for (const char* key : {"format", "version", "type"})
      keys.emplace_back(key);
    root_.expect_keys(keys);
  }

  // The domain and the coordinates on it, each if it is there.
  template <typename Description>
  void read_plane(Description& result, std::size_t sides) const {
    if (root_.has("coordinates"))
      result.coordinates = root_["coordinates"].choice(all_coordinates);
    if (!root_.has("domain"))
      return;
    const Json_reader domain = root_["domain"];
    if (domain.has("vertices")) {
      domain.expect_keys({"vertices"});
      result.domain_vertices = polygon(domain["vertices"], sides);
      return;
    }
    domain.expect_keys({"generator", "clearance"});
    result.domain.generator = domain["generator"].choice(all_generators);
    if (domain.has("clearance")) {
      result.domain.clearance = domain["clearance"].number();
      if (result.domain.clearance < 0)
        domain["clearance"].fail("expected a number that is not negative");
    }
  }

  // The vertices of a valid domain.
  static std::vector<Point_2> polygon(const Json_reader& value, std::size_t sides) {
    value.size("vertices, one for each side", sides, sides);
    std::vector<Point_2> vertices;
    for (std::size_t i = 0; i < sides; ++i) {
      const std::array<double, 2> p = value[i].template numbers<2>();
      vertices.emplace_back(FT(p[0]), FT(p[1]));
    }
    at(value, [&] { return Polygonal_domain_2<Traits>(vertices); });
    return vertices;
  }

  static std::vector<Point_3> points(const Json_reader& value, std::size_t number) {
    if (number > Limits::max_control_points)
      value.fail("expected at most " + std::to_string(Limits::max_control_points) +
                 " points; here are to be " + std::to_string(number));
    value.size("points", number, number);
    std::vector<Point_3> result;
    result.reserve(number);
    for (std::size_t i = 0; i < number; ++i)
      result.push_back(point(value[i]));
    return result;
  }
  static Point_3 point(const Json_reader& value) {
    const std::array<double, 3> p = value.template numbers<3>();
    return Point_3(FT(p[0]), FT(p[1]), FT(p[2]));
  }

  // Returns f(); an error gets the place in the file to which it belongs.
  template <typename Function>
  static auto at(const Json_reader& place, const Function& f) {
    try {
      return f();
    } catch (const Input_error& error) {
      place.fail(error.what());
    }
  }

  Json_reader root_;
};

} // namespace internal
} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PATCH_JSON_READER_H
