// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "any_model.h"
#include "report_output.h"

#include <CGAL/Multisided_patches/analysis/rounding_report.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/Exact_rational.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

using Hundred_digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                                     boost::multiprecision::et_off>;
using Sample = MP::Domain_sample<double>;

struct Row {
  const char *key, *title, *unit;
  MP::Rounding_error error;
};

std::vector<Row> rows(const MP::Rounding_report& report) {
  return {{"coordinates", "coordinates", "1", report.coordinates},
          {"s", "side parameter s", "1", report.s},
          {"h", "side parameter h", "1", report.h},
          {"weights", "weights", "1", report.weights},
          {"points", "points", "bounding box", report.points},
          {"first_derivatives", "first derivatives", "own size", report.first_derivatives},
          {"second_derivatives", "second derivatives", "own size", report.second_derivatives}};
}

struct Comparison {
  const char *coordinates, *yardstick;
  MP::Rounding_report report;
  std::vector<Sample> samples;
};

template <typename Reference, typename Coordinates>
MP::Rounding_report compare(const Concave_model& model, const Domain& domain,
                            const std::vector<Sample>& samples) {
  const MP::Concave_bezier_patch_3<Kernel, Coordinates> patch(model, Coordinates(domain));
  return MP::rounding_report<Reference>(patch, samples);
}

Comparison compare(const Concave_model& model, const Domain& domain, std::size_t number_inside) {
  std::vector<Sample> samples = MP::domain_samples(domain, number_inside);
  Comparison result;
  if (domain.is_strictly_convex())
    result = {
        "Wachspress",
        "exact rational numbers",
        compare<CGAL::Exact_rational, MP::Wachspress_coordinates_2<Kernel>>(model, domain, samples),
        {}};
  else
    result = {"mean value",
              "numbers of 100 digits",
              compare<Hundred_digits, MP::Mean_value_coordinates_2<Kernel>>(model, domain, samples),
              {}};
  result.samples = std::move(samples);
  return result;
}

void print(const Comparison& comparison) {
  std::printf("%s coordinates, double precision against %s at %zu points\n", comparison.coordinates,
              comparison.yardstick, comparison.report.samples);
  std::printf("%-19s %12s %12s   %12s %12s   %-12s   %s\n", "", "max ulps", "mean ulps",
              "max error", "mean error", "relative to", "largest at (u, v)");
  for (const Row& row : rows(comparison.report)) {
    const Sample& worst = comparison.samples[row.error.worst_sample];
    std::printf("%-19s %12.4g %12.4g   %12.2e %12.2e   %-12s   (%.15g, %.15g)\n", row.title,
                row.error.max_ulps, row.error.mean_ulps, row.error.max_relative,
                row.error.mean_relative, row.unit, worst.u, worst.v);
  }
}

std::string to_json(const Comparison& comparison, const std::string& input) {
  nlohmann::ordered_json errors;
  for (const Row& row : rows(comparison.report)) {
    const Sample& worst = comparison.samples[row.error.worst_sample];
    errors[row.key] = {{"max_ulps", row.error.max_ulps},
                       {"mean_ulps", row.error.mean_ulps},
                       {"max_relative", row.error.max_relative},
                       {"mean_relative", row.error.mean_relative},
                       {"relative_to", row.unit},
                       {"largest_at", {worst.u, worst.v}}};
  }
  const nlohmann::ordered_json json{{"input", input},
                                    {"coordinates", comparison.coordinates},
                                    {"yardstick", comparison.yardstick},
                                    {"samples", comparison.report.samples},
                                    {"errors", errors}};
  // File names need not be UTF-8.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

} // namespace

void exact_command(const Exact_options& options) {
  const Report_output output(options.json, options.quiet, {options.patch.input});
  const Any_model model = read_model(options.patch);
  const auto* concave = std::get_if<Concave_model>(&model);
  if (concave == nullptr)
    throw MP::Input_error(
        options.patch.input +
        ": expected a concave generalized Bezier patch, found: " + type_name(model));
  const Domain domain = make_domain(model).domain;
  const Comparison comparison = compare(*concave, domain, options.samples);
  output.write([&] { return to_json(comparison, options.patch.input); },
               [&] { print(comparison); });
}

} // namespace multipatch
