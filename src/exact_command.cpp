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
#include <CGAL/Multisided_patches/patches/Generalized_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/S_patch_3.h>

#include <CGAL/Exact_rational.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <string>
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

struct Comparison {
  const char* coordinates; // null if the patch is a polynomial in u and v
  const char* yardstick;
  bool has_side_parameters;
  MP::Rounding_report report;
};

// The stages that the patch has.
std::vector<Row> rows(const Comparison& comparison) {
  const MP::Rounding_report& report = comparison.report;
  std::vector<Row> result;
  if (comparison.coordinates != nullptr) {
    result.push_back({"coordinates", "coordinates", "1", report.coordinates});
    if (comparison.has_side_parameters) {
      result.push_back({"s", "side parameter s", "1", report.s});
      result.push_back({"h", "side parameter h", "1", report.h});
    }
    result.push_back({"weights", "weights", "1", report.weights});
  }
  result.push_back({"points", "points", "bounding box", report.points});
  result.push_back(
      {"first_derivatives", "first derivatives", "own size", report.first_derivatives});
  result.push_back(
      {"second_derivatives", "second derivatives", "own size", report.second_derivatives});
  return result;
}

// How each type of patch is compared.
class Compare {
public:
  Compare(const Domain& domain, const std::vector<Sample>& samples)
      : domain_(domain), samples_(samples) {}

  Comparison operator()(const Concave_model& model) const {
    return on_coordinates<MP::Concave_bezier_patch_3>(model, true);
  }
  Comparison operator()(const Generalized_model& model) const {
    return on_coordinates<MP::Generalized_bezier_patch_3>(model.net, true);
  }
  Comparison operator()(const S_patch_model& model) const {
    return on_coordinates<MP::S_patch_3>(model.net, false);
  }
  Comparison operator()(const Tensor_product& patch) const { return polynomial(patch); }
  Comparison operator()(const Triangle& patch) const { return polynomial(patch); }

private:
  // Wachspress coordinates, which are rational, where they exist.
  template <template <typename, typename> class Patch, typename Data>
  Comparison on_coordinates(const Data& data, bool has_side_parameters) const {
    using Wachspress = MP::Wachspress_coordinates_2<Kernel>;
    using Mean_value = MP::Mean_value_coordinates_2<Kernel>;
    if (domain_.is_strictly_convex())
      return {"Wachspress", exact, has_side_parameters,
              MP::rounding_report<CGAL::Exact_rational>(
                  Patch<Kernel, Wachspress>(data, Wachspress(domain_)), samples_)};
    return {"mean value", "numbers of 100 digits", has_side_parameters,
            MP::rounding_report<Hundred_digits>(
                Patch<Kernel, Mean_value>(data, Mean_value(domain_)), samples_)};
  }
  template <typename Patch>
  Comparison polynomial(const Patch& patch) const {
    return {nullptr, exact, false, MP::rounding_report<CGAL::Exact_rational>(patch, samples_)};
  }

  static constexpr const char* exact = "exact rational numbers";

  const Domain& domain_;
  const std::vector<Sample>& samples_;
};

void print(const Comparison& comparison, const std::vector<Sample>& samples) {
  const std::string what = comparison.coordinates == nullptr
                               ? "polynomials"
                               : comparison.coordinates + std::string(" coordinates");
  std::printf("%s, double precision against %s at %zu points\n", what.c_str(), comparison.yardstick,
              comparison.report.samples);
  std::printf("%-19s %12s %12s   %12s %12s   %-12s   %s\n", "", "max ulps", "mean ulps",
              "max error", "mean error", "relative to", "largest at (u, v)");
  for (const Row& row : rows(comparison)) {
    const Sample& worst = samples[row.error.worst_sample];
    std::printf("%-19s %12.4g %12.4g   %12.2e %12.2e   %-12s   (%.15g, %.15g)\n", row.title,
                row.error.max_ulps, row.error.mean_ulps, row.error.max_relative,
                row.error.mean_relative, row.unit, worst.u, worst.v);
  }
}

std::string to_json(const Comparison& comparison, const std::vector<Sample>& samples,
                    const std::string& input) {
  nlohmann::ordered_json errors;
  for (const Row& row : rows(comparison)) {
    const Sample& worst = samples[row.error.worst_sample];
    errors[row.key] = {{"max_ulps", row.error.max_ulps},
                       {"mean_ulps", row.error.mean_ulps},
                       {"max_relative", row.error.max_relative},
                       {"mean_relative", row.error.mean_relative},
                       {"relative_to", row.unit},
                       {"largest_at", {worst.u, worst.v}}};
  }
  const nlohmann::ordered_json coordinates = comparison.coordinates == nullptr
                                                 ? nlohmann::ordered_json()
                                                 : nlohmann::ordered_json(comparison.coordinates);
  const nlohmann::ordered_json json{{"input", input},
                                    {"coordinates", coordinates},
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
  const Domain domain = make_domain(model).domain;
  const std::vector<Sample> samples = MP::domain_samples(domain, options.samples);
  const Comparison comparison = std::visit(Compare(domain, samples), model);
  output.write([&] { return to_json(comparison, samples, options.patch.input); },
               [&] { print(comparison, samples); });
}

} // namespace multipatch
