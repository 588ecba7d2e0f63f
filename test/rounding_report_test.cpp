// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/analysis/rounding_report.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/Exact_rational.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <filesystem>

using namespace fixtures;

namespace {

using Multiple = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                               boost::multiprecision::et_off>;
using Sample = MP::Domain_sample<double>;
template <typename Coordinates>
using Patch = MP::Concave_bezier_patch_3<Kernel, Coordinates>;
using Mean_value = MP::Mean_value_coordinates_2<Kernel>;
using Wachspress = MP::Wachspress_coordinates_2<Kernel>;

void check_bars(const MP::Rounding_report& report, const std::vector<Sample>& samples) {
  const auto check = [&](const char* what, const MP::Rounding_error& error, double bar) {
    const Sample& worst = samples[error.worst_sample];
    INFO(what << " at " << worst.u << " " << worst.v);
    CHECK(error.max_relative < bar);
    CHECK(error.mean_relative <= error.max_relative);
  };
  check("coordinates", report.coordinates, 1e-14);
  check("h", report.h, 1e-14);
  check("weights", report.weights, 1e-13);
  check("points", report.points, 1e-14);
  check("first derivatives", report.first_derivatives, 1e-12);
  check("second derivatives", report.second_derivatives, 1e-12);
}

template <typename Coordinates>
void check_model(const MP::Concave_bezier_model_3<Kernel>& model, const Domain& domain,
                 std::size_t stride, std::size_t offset = 0) {
  const Patch<Coordinates> patch(model, Coordinates(domain));
  std::vector<Sample> samples;
  const std::vector<Sample> all = MP::domain_samples(domain, 20, static_cast<unsigned>(offset));
  for (std::size_t k = offset % stride; k < all.size(); k += stride)
    samples.push_back(all[k]);
  check_bars(MP::rounding_report<Multiple>(patch, samples), samples);
}

} // namespace

// Mean value coordinates can be negative where a domain is not convex. On the plus, two of them
// cancel by symmetry on sides across from theirs: s, their quotient, has a pole there.
TEST_CASE("All stages of all models are as exact as double allows") {
  std::size_t models = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MODELS_DIR)) {
    if (entry.path().extension() != ".cgb")
      continue;
    CAPTURE(entry.path().filename().string());
    const auto model = MP::IO::read_CGB<Kernel>(entry.path().string());
    const Domain domain = MP::make_domain(model.loop, model.domain).domain;
    if (domain.is_strictly_convex())
      check_model<Wachspress>(model, domain, 1);
    if (entry.path().stem() != "plus_hub")
      check_model<Mean_value>(model, domain, 1);
    ++models;
  }
  CHECK(models > 10);
}

TEST_CASE("All stages of random loops are as exact as double allows") {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto polygon = convex_polygon(random, 3 + seed % 5);
    const MP::Concave_bezier_model_3<Kernel> model(random_loop(random, 3 + seed % 5, 0.3));
    check_model<Wachspress>(model, Domain(polygon), 5, seed);
  }
}

// Where a domain is not convex, mean values may be negative and s = λ / (λ + λ') have poles, close
// to which all digits are lost. These polygons are nearly convex.
TEST_CASE("All stages of random concave loops are as exact as double allows") {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const std::size_t n = 4 + seed % 5;
    const auto polygon = star_shaped_polygon(random, n, 0.7);
    const MP::Concave_bezier_model_3<Kernel> model(random_loop(random, n, 0.3));
    check_model<Mean_value>(model, Domain(polygon), 5, seed);
  }
}

TEST_CASE("A point that rounding puts on a side though it is inside has coordinates") {
  Random random(9);
  std::size_t inside = 0;
  for (int k = 0; k < 300; ++k) {
    const Domain domain(convex_polygon(random, 5));
    const Mean_value mean_value(domain);
    const Wachspress wachspress(domain);
    const Point_2 p = domain.point_on_side(random.integer(0, 4), random.in(0, 1));
    const auto location = domain.locate(p);
    if (location.kind != Domain::Location::Kind::interior)
      continue;
    ++inside;
    std::vector<MP::Jet_2<double, 1>> a(5), b(5);
    mean_value.evaluate<1>(p, location, a.data());
    wachspress.evaluate<1>(p, location, b.data());
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(std::abs(a[i].value() - b[i].value()) < 1e-14);
      CHECK((std::isfinite(a[i][1]) && std::isfinite(a[i][2])));
    }
  }
  CHECK(inside > 50);
}

TEST_CASE("An exact number type and a hundred digits give the same report") {
  Random random(3);
  const auto polygon = convex_polygon(random, 4);
  const Patch<Wachspress> patch(MP::Concave_bezier_model_3<Kernel>(
                                    lifted_loop(polygon, [](double x, double y) { return x * y; })),
                                Wachspress(Domain(polygon)));
  std::vector<Sample> samples = MP::domain_samples(patch.domain(), 2);
  samples.resize(12);
  const auto exact = MP::rounding_report<CGAL::Exact_rational>(patch, samples);
  const auto multiple = MP::rounding_report<Multiple>(patch, samples);
  check_bars(exact, samples);
  CHECK(exact.samples == 12);
  CHECK(exact.points.max_ulps > 0);
  for (const auto quantity :
       {&MP::Rounding_report::coordinates, &MP::Rounding_report::s, &MP::Rounding_report::h,
        &MP::Rounding_report::weights, &MP::Rounding_report::points,
        &MP::Rounding_report::first_derivatives, &MP::Rounding_report::second_derivatives}) {
    CHECK((exact.*quantity).max_relative == Approx((multiple.*quantity).max_relative));
    CHECK((exact.*quantity).mean_ulps == Approx((multiple.*quantity).mean_ulps));
    CHECK((exact.*quantity).worst_sample == (multiple.*quantity).worst_sample);
  }
}

TEST_CASE("Errors are counted in units of the last place, and against the unit") {
  MP::internal::Rounding_errors errors(53);
  errors.add(0, 1., Multiple(1), 1);
  errors.add(1, 1 + 4 * std::numeric_limits<double>::epsilon(), Multiple(1), 1);
  errors.add(2, 1e-33, Multiple(0), 1); // in units of the rounding of the rounding of 1
  CHECK(errors.result().max_ulps == 4);
  CHECK(errors.result().mean_ulps == Approx((0 + 4 + 1e-33 / std::ldexp(1, -104)) / 3));
  CHECK(errors.result().max_relative == 4 * std::numeric_limits<double>::epsilon());
  CHECK(errors.result().worst_sample == 1);
  errors.add(3, std::nan(""), CGAL::Exact_rational(1), 1);
  CHECK(std::isinf(errors.result().max_relative));
  CHECK(std::isinf(errors.result().mean_ulps));
  CHECK(errors.result().worst_sample == 3);
}

TEST_CASE("Samples of a domain lie where they say, down to 1e-12 from vertices and sides") {
  for (const Domain& domain : {Domain(l_shape()), Domain(u_shape())}) {
    const auto samples = MP::domain_samples(domain, 10);
    CHECK(samples.size() > 10 + 15 * domain.size());
    double nearest = 1;
    std::size_t vertices = 0;
    for (const Sample& s : samples) {
      const Point_2 p(s.u, s.v);
      if (s.location.kind == Domain::Location::Kind::interior) {
        CHECK(domain.locate(p).kind == Domain::Location::Kind::interior);
        for (const Point_2& v : domain.vertices())
          nearest = (std::min)(nearest, std::sqrt(CGAL::squared_distance(p, v)));
      } else {
        const Point_2 on = s.location.kind == Domain::Location::Kind::vertex
                               ? domain.vertex(s.location.index)
                               : domain.point_on_side(s.location.index, s.location.s);
        CHECK(std::sqrt(CGAL::squared_distance(p, on)) < 1e-15);
        vertices += s.location.kind == Domain::Location::Kind::vertex;
      }
    }
    CHECK(vertices == domain.size());
    CHECK(nearest < 5e-12);
  }
}
