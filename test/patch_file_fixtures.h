// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_PATCH_FILE_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_PATCH_FILE_FIXTURES_H

#include "program_fixtures.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Small files of patches of every type, for tests that run the program.
namespace patch_file_fixtures {

using namespace program_fixtures;
using Json = nlohmann::json;

// A control net over a regular polygon, on a paraboloid.
inline std::string gbp(std::size_t sides, std::size_t degree) {
  std::ostringstream out;
  out << std::setprecision(17) << sides << ' ' << degree << "\n0 0 1\n";
  const auto corner = [&](std::size_t i) {
    const double angle =
        6.283185307179586 * static_cast<double>(i % sides) / static_cast<double>(sides);
    return std::pair(std::cos(angle), std::sin(angle));
  };
  for (std::size_t k = 0; k < (degree + 1) / 2; ++k)
    for (std::size_t i = 0; i < sides; ++i)
      for (std::size_t j = k; j < degree - k; ++j) {
        const double t = static_cast<double>(j - k) / static_cast<double>(degree - 2 * k);
        const double radius = 1 - 2 * static_cast<double>(k) / static_cast<double>(degree + 1);
        const auto [ax, ay] = corner(i);
        const auto [bx, by] = corner(i + 1);
        const double x = radius * ((1 - t) * ax + t * bx), y = radius * ((1 - t) * ay + t * by);
        out << x << ' ' << y << ' ' << 1 - x * x - y * y << '\n';
      }
  return out.str();
}

inline const std::string head = R"({"format": "multisided-patch", "version": 1, "type": )";

// Corners of a pentagon.
inline const std::string s_patch = head + R"("s-patch", "number_of_sides": 5, "depth": 1,
  "control_points": [[1, 0, 0], [0.3, 1, 0.1], [-0.8, 0.6, 0], [-0.8, -0.6, 0.1], [0.3, -1, 0]]})";

inline const std::string tensor_product = head + R"("tensor-product", "degree_u": 2, "degree_v": 1,
  "control_points": [[0, 0, 0], [1, 0, 1], [2, 0, 0], [0, 1, 0], [1, 1, 1], [2, 1, 0.5]]})";

inline const std::string triangle = head + R"("bezier-triangle", "degree": 2, "control_points":
  [[0, 0, 0], [1, 0, 0.5], [2, 0, 0], [0.5, 1, 0.5], [1.5, 1, 0.5], [1, 2, 0]]})";

// The corners of a flat polygon as a patch whose sides have degree 1 and one layer.
inline std::string cgb(const std::vector<std::pair<int, int>>& corners) {
  std::ostringstream out;
  out << "1\n1\n0.05\n0\n" << corners.size() << "\n0 0 0\n";
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [x, y] = corners[i];
    const auto& [end_x, end_y] = corners[(i + 1) % corners.size()];
    out << "1 1\n" << x << ' ' << y << " 0\n" << end_x << ' ' << end_y << " 0\n";
  }
  out << "0\n";
  return out.str();
}

inline Json json_of(const Scratch& work, const std::string& name) {
  return Json::parse(contents(work / name));
}

// A file of each type of patch but the first.
inline std::vector<std::string> write_one_of_each(const Scratch& work) {
  work.write("five.gbp", gbp(5, 4));
  work.write("s.patch.json", s_patch);
  work.write("tensor.patch.json", tensor_product);
  work.write("triangle.patch.json", triangle);
  return {"five.gbp", "s.patch.json", "tensor.patch.json", "triangle.patch.json"};
}

} // namespace patch_file_fixtures

#endif // MULTISIDED_PATCHES_TEST_PATCH_FILE_FIXTURES_H
