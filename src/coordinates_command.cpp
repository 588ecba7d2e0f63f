// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "coordinates_csv.h"
#include "coordinates_svg.h"
#include "domain_input.h"
#include "point_file.h"
#include "sample_domain.h"
#include "stage_clock.h"
#include "with_file_name.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

enum class Format { picture, table };

// The option given that says how accurate harmonic coordinates shall be, if any is.
const char* accuracy_option(const Coordinates_options& options) {
  return options.target_error       ? "--target-error"
         : options.acceptable_error ? "--acceptable-error"
                                    : nullptr;
}

Format output_format(const std::string& output) {
  const bool is_picture = MP::internal::file_extension(output) == ".svg";
  return is_picture ? Format::picture : Format::table;
}

// An option without effect is a misunderstanding, which is better cleared up than passed over.
void check_options(const Coordinates_options& options, Format format) {
  const auto only_for = [](bool given, const char* option, bool applies, const char* what) {
    if (given && !applies)
      throw Usage_error(std::string(option) + " is for " + what + " only");
  };
  const bool table = format == Format::table;
  only_for(options.samples.has_value(), "--samples", table, ".csv files");
  only_for(!options.at.empty(), "--at", table, ".csv files");
  only_for(options.derivatives.has_value(), "--derivatives", table, ".csv files");
  only_for(options.vertex.has_value(), "--vertex", !table, ".svg files");
  const char* accuracy = accuracy_option(options);
  only_for(accuracy != nullptr, accuracy,
           options.patch.coordinates.value_or(Coordinates_choice::harmonic) ==
               Coordinates_choice::harmonic,
           "harmonic coordinates");
  check_different(options.output, {options.patch.input});
  if (!options.at.empty())
    check_different(options.output, {options.at});
}

void check_files(const Coordinates_options& options) {
  if (!options.at.empty())
    MP::internal::open_for_reading(options.at);
  MP::internal::check_writable(options.output);
}

// What the chosen coordinates cannot do is said in the numbers that the user knows.
void check_domain(const Coordinates_options& options, const Domain_input& input) {
  constexpr std::size_t max_harmonic = 1000; // more would take too much time and memory
  const Domain& domain = input.domain;
  const std::string& name = options.patch.input;
  const bool is_harmonic = input.coordinates == Coordinates_choice::harmonic;
  const char* accuracy = accuracy_option(options);
  if (accuracy != nullptr && !is_harmonic)
    throw MP::Input_error(std::string(accuracy) + " is for harmonic coordinates only");
  if (is_harmonic && domain.size() > max_harmonic)
    throw MP::Input_error(name + ": " + std::to_string(domain.size()) +
                          " vertices are too many for harmonic coordinates; the limit is " +
                          std::to_string(max_harmonic) + ", but not for mean-value coordinates");
  if (input.coordinates != Coordinates_choice::wachspress)
    return;
  const auto fail = [&](const std::string& reason) {
    throw MP::Input_error(name + ": Wachspress coordinates need a strictly convex domain, and " +
                          reason + "; harmonic and mean-value coordinates are for any domain");
  };
  if (domain.number_of_loops() > 1)
    fail("this one has holes");
  for (std::size_t i = 0; i < domain.size(); ++i) {
    const MP::Corner_type type = domain.corner_type(input.vertices[i]);
    if (type != MP::Corner_type::convex)
      fail("corner " + std::to_string(i) + " is " + to_string(type));
  }
}

std::vector<Located_point> located_points(const Domain_mesh& mesh) {
  std::vector<Located_point> points;
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    points.push_back({mesh.points[k], mesh.locations[k]});
  return points;
}

void warn_of_outside_points(const Point_file& file, std::size_t points) {
  if (file.outside() > 0)
    warn(std::to_string(file.outside()) + " of " + std::to_string(points) +
         " points lie outside the domain and have nan for coordinates; the first is " +
         file.first_outside());
}

std::size_t write_table(const Coordinates_options& options, const Domain_input& input,
                        const Any_coordinates& coordinates, Stage_clock& clock) {
  constexpr std::size_t default_samples = 1000;
  MP::internal::Atomic_file file(options.output);
  const auto write = [&](const Point_source& next) {
    const std::size_t count = write_coordinates_csv(file.stream(), coordinates, input.vertices,
                                                    options.derivatives.value_or(0), next, clock);
    file.commit();
    return count;
  };
  if (options.at.empty()) {
    const std::size_t samples = options.samples.value_or(default_samples);
    const auto points =
        located_points(clock.run("meshing", [&] { return sample_domain(input.domain, samples); }));
    return write([&, k = std::size_t(0)](Located_point& p) mutable {
      if (k < points.size())
        p = points[k];
      return k++ < points.size();
    });
  }
  Point_file points(options.at, input.domain);
  const std::size_t count = write([&](Located_point& p) { return points.next(p); });
  if (!options.quiet)
    warn_of_outside_points(points, count);
  return count;
}

// The vertices that a picture shows, numbered as the user does.
std::vector<std::size_t> drawn_vertices(const Coordinates_options& options, std::size_t n) {
  constexpr std::size_t max_panels = 12;
  if (options.vertex)
    return {*options.vertex};
  std::vector<std::size_t> drawn((std::min)(n, max_panels));
  std::iota(drawn.begin(), drawn.end(), std::size_t(0));
  return drawn;
}

std::size_t draw(const Coordinates_options& options, const Domain_input& input,
                 const Any_coordinates& coordinates, const std::vector<std::size_t>& drawn,
                 Stage_clock& clock) {
  const Domain_mesh mesh =
      clock.run("meshing", [&] { return sample_domain(input.domain, picture_points); });
  std::vector<std::size_t> vertices;
  for (const std::size_t i : drawn)
    vertices.push_back(input.vertices[i]);
  const std::vector<double> values = clock.run(
      "evaluation", [&] { return evaluate(coordinates, vertices, 0, located_points(mesh)); });
  clock.run("writing", [&] {
    MP::internal::Atomic_file file(options.output);
    write_coordinates_svg(file.stream(), input, mesh, drawn, values, to_string(input.coordinates));
    file.commit();
  });
  return mesh.points.size();
}

void print_summary(const Coordinates_options& options, const Domain_input& input,
                   const Any_coordinates& coordinates, std::size_t points,
                   const Stage_clock& clock) {
  const Domain& domain = input.domain;
  std::printf("%s: %zu sides, %zu loop%s, %zu points; %s coordinates", options.output.c_str(),
              domain.size(), domain.number_of_loops(), domain.number_of_loops() == 1 ? "" : "s",
              points, to_string(input.coordinates));
  if (const auto bound = error_bound(coordinates))
    std::printf(", error bound %.2g", *bound);
  if (input.report)
    std::printf("; domain %s, %s", domain_name(*input.report),
                clearance_text(*input.report).c_str());
  std::printf("; setup %.3f s, evaluation %.3f s\n", clock.seconds("setup"),
              clock.seconds("evaluation"));
  if (input.report)
    warn_of_remarks(*input.report);
}

void print_choice(const std::vector<std::size_t>& drawn, std::size_t n) {
  if (drawn.size() > 1 && drawn.size() < n)
    std::printf("  drawn: the vertices 0 to %zu of %zu; --vertex draws another one\n", drawn.back(),
                n);
}

void write_coordinates(const Coordinates_options& options, Format format, const Domain_input& input,
                       Stage_clock& clock) {
  const Any_coordinates coordinates = clock.run("setup", [&] {
    return make_coordinates(input.coordinates, input.domain,
                            options.target_error.value_or(default_target_error),
                            options.acceptable_error.value_or(0));
  });
  const std::vector<std::size_t> drawn = drawn_vertices(options, input.domain.size());
  const std::size_t points = format == Format::picture
                                 ? draw(options, input, coordinates, drawn, clock)
                                 : write_table(options, input, coordinates, clock);
  if (options.quiet)
    return;
  print_summary(options, input, coordinates, points, clock);
  if (format == Format::picture)
    print_choice(drawn, input.domain.size());
}

} // namespace

void coordinates_command(const Coordinates_options& options) {
  // What cannot succeed fails before the work, not after it.
  const Format format = output_format(options.output);
  check_options(options, format);
  Stage_clock clock(options.quiet);
  const Domain_input input = clock.run("reading", [&] { return read_domain(options.patch); });
  check_domain(options, input);
  check_index(options.vertex.value_or(0), input.domain.size(), "--vertex");
  check_files(options);
  with_file_name(options.patch.input, [&] { write_coordinates(options, format, input, clock); });
}

} // namespace multipatch
