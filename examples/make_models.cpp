// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes the example models: make_models [DIRECTORY], by default "models".
//
// Every model is a piece of something one could hold or build, cut out of a smooth surface along a
// loop that is drawn in the surface's parameter plane. Lengths are millimetres unless said
// otherwise. A closed body has a directory of its own, with one file for each of its parts.

#include "body_builder.h"
#include "model_builder.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/patches/with_resolved_central_weight.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

constexpr Corner_type convex = Corner_type::convex;
constexpr Corner_type reflex = Corner_type::reflex;
constexpr Corner_type straight = Corner_type::straight;
const double pi = boost::math::constants::pi<double>();

Model_plan l_bracket() {
  Model_plan plan{"l_bracket",
                  "pressed-steel shelf bracket, both arms curling down",
                  [](Taylor x, Taylor y) -> std::array<Taylor, 3> {
                    return {x, y, 14 - 0.0022 * (x - y) * (x - y)};
                  },
                  {{0, 0}, {100, 0}, {100, 40}, {40, 40, reflex}, {40, 100}, {0, 100}}};
  plan.reach = 78;
  plan.center = {20, 20};
  return plan;
}

Model_plan u_vent() {
  const double radius = 130;
  Model_plan plan{
      "u_vent",
      "surround of an air vent in a mudguard",
      [=](Taylor x, Taylor y) -> std::array<Taylor, 3> {
        return {radius * sin(x / radius), y, radius * cos(x / radius) - radius - 0.0015 * y * y};
      },
      {{-80, -60},
       {80, -60, convex, 3, 2, 0, 0, 75},
       {80, 60},
       {35, 60},
       {25, -10, reflex},
       {-25, -10, reflex},
       {-35, 60},
       {-80, 60, convex, 3, 2, 0, 0, 75}}};
  plan.reach = 120;
  plan.center = {0, -35};
  plan.clearance = 0.1;
  return plan;
}

Model_plan t_junction() {
  Model_plan plan{"t_junction",
                  "canopy where two walkways meet, 12 metres across",
                  [](Taylor x, Taylor y) -> std::array<Taylor, 3> {
                    return {x, y, 2800 - x * x / 24000 - (y - 1500) * (y - 1500) / 22000};
                  },
                  {{-1500, -6000},
                   {1500, -6000},
                   {1500, 0, reflex, 3, 2, 0, 0, 4200},
                   {6000, 0},
                   {6000, 3000, convex, 5, 2},
                   {-6000, 3000},
                   {-6000, 0, convex, 3, 2, 0, 0, 4200},
                   {-1500, 0, reflex}}};
  plan.reach = 6000;
  plan.center = {0, 1000};
  plan.clearance = 0.1;
  return plan;
}

Model_plan star_knob() {
  Model_plan plan{"star_knob",
                  "top of a five-lobed clamping knob of radius 1",
                  [](Taylor x, Taylor y) -> std::array<Taylor, 3> {
                    return {x, y, sqrt(1.6 * 1.6 - x * x - y * y) - 1.2};
                  },
                  {}};
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 ? 0.52 : 1, angle = pi / 2 + i * pi / 5;
    plan.stops.push_back({r * std::cos(angle), r * std::sin(angle), i % 2 ? reflex : convex, 3, 2,
                          -8, 8}); // lobes bulge outwards
  }
  plan.generator = MP::Domain_generator::similarity_outer;
  plan.has_corner_control_points = true; // the gaps between the lobes are sharp
  return plan;
}

Model_plan spiral_volute() {
  Model_plan plan{"spiral_volute",
                  "scroll of a column's capital, a little more than one turn",
                  [](Taylor x, Taylor y) -> std::array<Taylor, 3> {
                    return {x, y, 36 * exp((x * x + y * y) / -3600)};
                  },
                  {}};
  const int steps = 7;
  const auto add = [&plan](int step, double factor, Corner_type corner, double turn) {
    const double angle = step * pi / 3, radius = 100 * std::exp(-0.138 * angle);
    plan.stops.push_back({factor * radius * std::cos(angle), factor * radius * std::sin(angle),
                          corner, 3, 2, -turn, turn, 0.75 * radius});
  };
  for (int i = 0; i <= steps; ++i)
    add(i, 1, convex, i == steps ? 0 : 9);
  for (int i = steps; i >= 0; --i)
    add(i, 0.62, 0 < i && i < steps ? reflex : convex, i == 0 ? 0 : -9);
  plan.center = {-53, 0};
  plan.clearance = 0.05;
  return plan;
}

Model_plan saddle_seat() {
  Model_plan plan{"saddle_seat",
                  "seat of a bicycle saddle",
                  [](Taylor x, Taylor y) -> std::array<Taylor, 3> {
                    return {x, y, 0.0011 * x * x - 0.0045 * y * y};
                  },
                  {{-120, -65, convex, 3, 2, 10, -10},
                   {120, -16},
                   {120, 16, convex, 3, 2, 10, -10},
                   {-120, 65},
                   {-145, 0}}};
  plan.reach = 170;
  plan.center = {-45, 0};
  plan.central_weight = MP::Central_weight::adjacent_products;
  plan.clearance = 0.1;
  return plan;
}

Model_plan twisted_handle_root() {
  // A sheet twisted by 100 degrees around its axis, which is bent to an arc.
  const double twist = 100 * pi / 180 / 130, radius = 110;
  Model_plan plan{
      "twisted_handle_root",
      "root of a jug's handle, twisted and bent",
      [=](Taylor x, Taylor y) -> std::array<Taylor, 3> {
        const Taylor out = radius - y * sin(twist * x);
        return {out * sin(x / radius), y * cos(twist * x), radius - out * cos(x / radius)};
      },
      {{0, -38},
       {42, -34},
       {50, -15, reflex, 5, 2},
       {120, -13},
       {130, 0},
       {120, 14, convex, 5, 2},
       {0, 22}}};
  plan.reach = 60;
  plan.center = {30, -4};
  return plan;
}

Model_plan pentagon_cap() {
  Model_plan plan{"pentagon_cap",
                  "vertex cap of a rounded housing, part of a sphere",
                  [](Taylor x, Taylor y) -> std::array<Taylor, 3> {
                    return {x, y, sqrt(75 * 75 - x * x - y * y) - 55};
                  },
                  {}};
  for (int i = 0; i < 5; ++i) {
    const double angle = pi / 2 + i * 2 * pi / 5;
    plan.stops.push_back({50 * std::cos(angle), 50 * std::sin(angle), convex, 3, 2, -8, 8});
  }
  plan.central_weight = MP::Central_weight::weight_deficiency;
  plan.generator = MP::Domain_generator::projected;
  plan.clearance = 0.2;
  return plan;
}

Model_plan triangle_corner() {
  Model_plan plan{"triangle_corner",
                  "corner of a suitcase, a spherical triangle",
                  [](Taylor x, Taylor y) -> std::array<Taylor, 3> {
                    return {x, y, sqrt(40 * 40 - x * x - y * y)};
                  },
                  {}};
  for (int i = 0; i < 3; ++i) {
    const double angle = pi / 2 + i * 2 * pi / 3;
    plan.stops.push_back({30 * std::cos(angle), 30 * std::sin(angle), convex, 3, 2, -12, 12});
  }
  plan.clearance = 0.2;
  return plan;
}

Model_plan mixed_duct() {
  const double radius = 90;
  Model_plan plan{"mixed_duct",
                  "elbow cover on an air duct, its sides from different sources",
                  [=](Taylor x, Taylor y) -> std::array<Taylor, 3> {
                    return {x, radius * sin(y / radius), radius * cos(y / radius)};
                  },
                  {{0, -50, convex, 4, 2},
                   {75, -50, straight, 5, 3},
                   {140, -50, convex, 3, 2},
                   {140, 3, convex, 3, 2},
                   {55, 3, reflex, 5, 4},
                   {55, 60, convex, 2, 2},
                   {0, 60, convex, 6, 3}}};
  plan.reach = 55;
  plan.center = {30, -20};
  return plan;
}

Model_plan plus_hub() {
  Model_plan plan{"plus_hub",
                  "four-armed hub of a fan wheel",
                  [](Taylor x, Taylor y) -> std::array<Taylor, 3> {
                    return {x, y, 18 * exp((x * x + y * y) / -1800)};
                  },
                  {}};
  const double arm[3][2] = {{-20, -60}, {20, -60}, {20, -20}};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) {
      double x = arm[j][0], y = arm[j][1];
      for (int quarter_turns = 0; quarter_turns < i; ++quarter_turns) {
        const double old_x = x;
        x = -y;
        y = old_x;
      }
      plan.stops.push_back({x, y, j == 2 ? reflex : convex});
    }
  plan.reach = 40;
  plan.generator = MP::Domain_generator::projected;
  return plan;
}

Model_plan g2_blend() {
  Model_plan plan{"g2_blend",
                  "transition from the grip of a drill to its housing",
                  [](Taylor x, Taylor y) -> std::array<Taylor, 3> {
                    return {x, y, 16 * cos((x - 20) / 55) * cos((y - 30) / 60)};
                  },
                  {{0, 0, convex, 5, 3},
                   {90, -10, convex, 5, 3},
                   {100, 35, convex, 5, 3},
                   {45, 45, reflex, 5, 3},
                   {40, 100, convex, 5, 3},
                   {-5, 90, convex, 5, 3}}};
  plan.reach = 45;
  plan.center = {25, 25};
  return plan;
}

Model_plan split_side_panel() {
  Model_plan plan{"split_side_panel",
                  "car door panel, its sill split where the hinge sits",
                  [](Taylor x, Taylor y) -> std::array<Taylor, 3> {
                    return {x, y,
                            60 - 0.0006 * (y - 150) * (y - 150) - 0.00016 * (x - 280) * (x - 280) +
                                0.0001 * x * y};
                  },
                  {{0, 0}, {200, 0, straight}, {520, 0}, {560, 300}, {60, 340}}};
  plan.reach = 300;
  plan.center = {285, 165};
  plan.clearance = 0.1;
  return plan;
}

// The seam between the right and the left half runs once around the body, with two bends on the top
// and two on the bottom. From it curves go to the sides that the hand grips. The poles of the
// sphere are on the right and on the left, longitudes run from the front over the top.
Body_plan computer_mouse() {
  enum Vertex : std::size_t {
    front,
    front_top,
    top_front,
    top_rear,
    rear_top,
    rear,
    rear_bottom,
    bottom_rear,
    bottom_front,
    front_bottom,
    right,           // the first of 5
    left = right + 5 // likewise
  };
  // Between an ellipsoid and a box, highest in the rear and narrowest in front, with a flat bottom.
  const auto deformation = [](const std::array<Taylor, 3>& p) -> std::array<Taylor, 3> {
    const Taylor x2 = p[0] * p[0], y2 = p[1] * p[1], z2 = p[2] * p[2];
    const Taylor fourth_power = x2 * x2 + y2 * y2 + z2 * z2 + 1.4 * (x2 * y2 + y2 * z2 + z2 * x2);
    const Taylor factor = pow(fourth_power, -0.25);
    const Taylor x = factor * p[0], y = -factor * p[2], z = factor * p[1];
    return {56 * x, (31 - 3 * x) * y, (1 - 0.14 * x) * (18 * z + 3.5 * z * z)};
  };
  return {
      "computer_mouse",
      "part of a computer mouse, closed all around",
      deformation,
      {{0, 0},    {45, 0},    {84, 24},   {96, -24},  {135, 0},    // front to rear_top
       {180, 0},  {225, 0},   {264, -24}, {276, 24},  {315, 0},    // rear to front_bottom
       {0, 50},   {68, 50},   {137, 50},  {223, 50},  {292, 50},   // right
       {43, -50}, {112, -50}, {180, -50}, {248, -50}, {317, -50}}, // left
      {{"right_side", {right, right + 1, right + 2, right + 3, right + 4}},
       {"left_side", {left + 4, left + 3, left + 2, left + 1, left}},
       {"top_right", {right + 2, right + 1, front_top, top_front, top_rear, rear_top}},
       {"top_left", {left, left + 1, rear_top, top_rear, top_front, front_top}},
       {"bottom_right",
        {right + 4, right + 3, rear_bottom, bottom_rear, bottom_front, front_bottom}},
       {"bottom_left", {left + 3, left + 4, front_bottom, bottom_front, bottom_rear, rear_bottom}},
       {"front_right_upper", {right + 1, right, front, front_top}},
       {"front_right_lower", {right, right + 4, front_bottom, front}},
       {"front_left", {left + 4, left, front_top, front, front_bottom}},
       {"rear_right", {right + 3, right + 2, rear_top, rear, rear_bottom}},
       {"rear_left_upper", {left + 1, left + 2, rear, rear_top}},
       {"rear_left_lower", {left + 2, left + 3, rear_bottom, rear}}}};
}

void write_model(const std::filesystem::path& directory, const std::string& name,
                 const Model& planned) {
  // The format has a place for the choice only, not for leaving it to the patch.
  const Model model = MP::with_resolved_central_weight(planned);
  MP::IO::write_CGB((directory / (name + ".cgb")).string(), model);
  std::cout << name << ", sides: " << model.loop.size()
            << ", reflex corners: " << model.loop.number_of_corners(reflex)
            << ", central weight: " << to_string(model.central_weight)
            << (planned.central_weight == model.central_weight ? "" : " (automatic)") << ", ";
}

void write_body(const std::filesystem::path& directory, const Body_plan& plan) {
  std::filesystem::create_directories(directory / plan.name);
  const std::vector<Model> models = Body_builder(plan).build();
  for (std::size_t i = 0; i < models.size(); ++i) {
    write_model(directory, plan.name + '/' + plan.parts[i].name, models[i]);
    std::cout << plan.description << '\n';
  }
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    const std::filesystem::path directory = argc > 1 ? argv[1] : "models";
    std::filesystem::create_directories(directory);
    for (const Model_plan& plan :
         {l_bracket(), u_vent(), t_junction(), star_knob(), spiral_volute(), saddle_seat(),
          twisted_handle_root(), pentagon_cap(), triangle_corner(), mixed_duct(), plus_hub(),
          g2_blend(), split_side_panel()}) {
      write_model(directory, plan.name, Model_builder(plan).build());
      std::cout << plan.description << '\n';
    }
    write_body(directory, computer_mouse());
  } catch (const std::exception& error) {
    std::cerr << "make_models: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
