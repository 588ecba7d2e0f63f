// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_LOOP_CASES_H
#define MULTISIDED_PATCHES_TEST_FUZZ_LOOP_CASES_H

#include "random_loops.h"

#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/meshing/is_valid_domain_mesh.h>
#include <CGAL/Multisided_patches/meshing/mesh_domain.h>
#include <CGAL/Multisided_patches/meshing/triangulate_domain.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Random loops and domains, and what has to be true of their meshes.
namespace fuzz {

// Larger meshes than a case is to have, because the surface is larger than its loop suggests, are
// given up. That is no finding.
constexpr std::size_t max_points = 4000;

struct Size_limit {
  bool go_further(MP::Tessellation_stage stage, std::size_t done, std::size_t total) {
    return stage != MP::Tessellation_stage::meshing ||
           (done < max_points && total < 2 * max_points);
  }
};

// What is wrong with the library.
struct Finding {
  std::string text;
};

// What came of a case that ended well.
struct Outcome {
  std::size_t triangles = 0;
  // The number of triangles, relative to that asked for; 0 if there was none, or a small one.
  double share_of_target = 0;
};

// A case in the making: what it is, known before it runs, and what is to be done.
struct Case {
  std::string text, group;
  std::function<Outcome()> run;
};

inline Outcome checked(const Domain& domain, const MP::Domain_mesh_2<Kernel>& mesh) {
  const std::string defect = MP::domain_mesh_defect(domain, mesh);
  if (!defect.empty())
    throw Finding{"invalid mesh: " + defect};
  return {mesh.triangles.size(), 0};
}

template <typename Patch>
Outcome mesh_patch(const Patch& patch, const MP::Mesh_density& density, bool parallel) {
  const auto mesh =
      parallel ? MP::mesh_domain<CGAL::Parallel_if_available_tag>(patch, density, Size_limit())
               : MP::mesh_domain<CGAL::Sequential_tag>(patch, density, Size_limit());
  Outcome outcome = checked(patch.domain(), mesh);
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    const Point_3 p = patch.point(mesh.points[k], mesh.locations[k]);
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw Finding{"not finite: point " + std::to_string(k)};
  }
  const auto target = density.target_triangles().value_or(0);
  if (target >= 1000)
    outcome.share_of_target = double(mesh.triangles.size()) / double(target);
  return outcome;
}

enum class Coordinate_type { mean_value, harmonic, wachspress };

inline Outcome mesh_loop(const Raw_loop& raw, const MP::Domain_options& domain,
                         Coordinate_type type, MP::Central_weight central_weight,
                         const std::function<MP::Mesh_density(double)>& density, bool parallel) {
  const Loop loop = raw.loop();
  if (raw.is_broken)
    throw Finding{"accepted: a loop that cannot be one"};
  MP::Concave_bezier_model_3<Kernel> model(loop);
  model.domain = domain;
  model.central_weight = central_weight;
  const MP::Mesh_density d = density(loop.diagonal());
  switch (type) {
  case Coordinate_type::mean_value:
    return mesh_patch(
        MP::Concave_bezier_patch_3<Kernel, MP::Mean_value_coordinates_2<Kernel>>(model), d,
        parallel);
  case Coordinate_type::wachspress:
    return mesh_patch(
        MP::Concave_bezier_patch_3<Kernel, MP::Wachspress_coordinates_2<Kernel>>(model), d,
        parallel);
  default:
    return mesh_patch(MP::Concave_bezier_patch_3<Kernel>(model), d, parallel);
  }
}

// A density for loops of any diagonal, and its description.
inline std::pair<std::function<MP::Mesh_density(double)>, std::string>
random_density(Random& random) {
  using MP::Mesh_density;
  const double u = random.in(0, 1);
  // Most of what can go wrong does so in small meshes, of which there is time for many more.
  const bool is_large = chance(random, 0.03);
  const double edge = power_of_ten(random, std::log10(is_large ? 0.02 : 0.1), std::log10(3));
  const double chordal = power_of_ten(random, is_large ? -3 : -2, -1),
               normal = power_of_ten(random, 0.7, 1.78);
  const auto count = static_cast<std::size_t>(power_of_ten(random, 0, is_large ? 3.5 : 2.5));
  const auto text = [](const char* name, double x) {
    return std::string(name) + ' ' + MP::internal::to_short_text(x);
  };
  if (u < 0.4)
    return {[=](double) { return Mesh_density::triangles(count); },
            "triangles " + std::to_string(count)};
  if (u < 0.78)
    return {[=](double size) { return Mesh_density::edge_length(edge * size); },
            text("edge length", edge)};
  if (u < 0.92)
    return {[=](double size) { return Mesh_density::chordal_deviation(chordal * size); },
            text("chordal deviation", chordal)};
  if (u < 0.98)
    return {[=](double) { return Mesh_density::normal_deviation(normal); },
            text("normal deviation", normal)};
  return {[=](double size) {
            return Mesh_density::edge_length(edge * size) &
                   Mesh_density::chordal_deviation(chordal * size) &
                   Mesh_density::normal_deviation(normal);
          },
          text("combined, edge length", edge) + text(", chordal deviation", chordal) +
              text(", normal deviation", normal)};
}

inline Case loop_case(Random& random) {
  using G = MP::Domain_generator;
  const Raw_loop raw = random_raw_loop(random);
  MP::Domain_options domain;
  domain.generator = pick(random, std::vector<G>{G::automatic, G::projected, G::similarity,
                                                 G::similarity_outer, G::circular, G::regular});
  if (chance(random, 0.2))
    domain.clearance = power_of_ten(random, -6, 0);
  // Mean value coordinates are harmless on convex domains only.
  const double harmonic = !raw.is_harmless ? 0.08 : raw.is_convex ? 0.2 : 1, u = random.in(0, 1);
  const Coordinate_type type = u < harmonic                       ? Coordinate_type::harmonic
                               : u > (raw.is_convex ? 0.9 : 0.98) ? Coordinate_type::wachspress
                                                                  : Coordinate_type::mean_value;
  const MP::Central_weight weight =
      pick(random,
           std::vector<MP::Central_weight>{MP::Central_weight::none, MP::Central_weight::none,
                                           static_cast<MP::Central_weight>(random.integer(0, 3))});
  const bool parallel = chance(random, 0.02);
  const auto [density, density_text] = random_density(random);
  constexpr const char* types[] = {"mean value", "harmonic", "Wachspress"};
  const std::string kind = density_text.substr(0, density_text.find_first_of(" ,"));
  return {raw.text + "; " + to_string(domain.generator) + " domain, " +
              types[static_cast<int>(type)] + "; " + density_text,
          (raw.is_harmless ? "harmless loops, "
           : raw.is_broken ? "broken loops, "
                           : "other loops, ") +
              kind,
          [=] { return mesh_loop(raw, domain, type, weight, density, parallel); }};
}

// Points of a plan, with a random size and place.
inline Points placed(Random& random, Points points) {
  const double size = chance(random, 0.3) ? power_of_ten(random, -100, 100) : 1;
  const double distance = chance(random, 0.2) ? power_of_ten(random, 0, 12) : 0;
  for (Point_2& p : points)
    p = Point_2(size * (p.x() + distance), size * (p.y() - distance));
  return points;
}

inline Case domain_case(Random& random) {
  const bool has_holes = chance(random, 0.5);
  const Plan plan = random_plan(random);
  const std::uint64_t engine = random.integer(0, 1u << 30);
  const int smoothing = chance(random, 0.3) ? static_cast<int>(random.integer(1, 3)) : 0;
  const double fineness = power_of_ten(
      random, 0, chance(random, 0.03) ? 3.5 : 2.5); // triangles that a square would have
  const double most_segments = power_of_ten(random, 0, 2);
  const std::string text =
      has_holes ? "domain with holes" : std::to_string(plan.points.size()) + " sides, " + plan.name;
  const auto run = [=] {
    Random local(static_cast<unsigned>(engine));
    const Domain domain = has_holes
                              ? random_domain(local, local.integer(3, 20), local.integer(1, 5))
                              : Domain(placed(local, plan.points));
    std::vector<std::size_t> segments;
    for (std::size_t i = 0; i < domain.size(); ++i)
      segments.push_back(
          static_cast<std::size_t>(power_of_ten(local, 0, std::log10(most_segments))));
    const double spacing = domain.diameter() / std::sqrt(fineness);
    return checked(domain, MP::triangulate_domain(domain, segments, spacing, smoothing));
  };
  return {text + "; up to " + MP::internal::to_short_text(most_segments) + " segments a side, " +
              MP::internal::to_short_text(fineness) + " triangles for a square, " +
              std::to_string(smoothing) + " sweeps",
          "domains", run};
}

// The case that is a matter of the seed and of the index alone.
inline Case make_case(std::uint64_t seed, std::uint64_t index) {
  Random random = random_of_case(seed, index);
  return chance(random, 0.12) ? domain_case(random) : loop_case(random);
}

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_LOOP_CASES_H
