// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/bases/Concave_bezier_basis.h>
#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/parameters/barycentric_side_parameters.h>

using namespace fixtures;
using Jet = MP::Jet_2<double, 1>;
using Parameters = std::vector<MP::Side_parameter<Jet>>;

namespace {

template <typename Coordinates>
Parameters parameters_at(const Coordinates& coordinates, const Point_2& p,
                         const Domain::Location& location, double dilation = 0) {
  const Domain& domain = coordinates.domain();
  std::vector<Jet> lambda(domain.size());
  Parameters parameters(domain.size());
  coordinates.template evaluate<1>(p, location, lambda.data());
  MP::compute_side_parameters(domain, lambda.data(), dilation, parameters);
  return parameters;
}

} // namespace

TEST_CASE("On its side s runs from 0 to 1 and h is exactly 0; elsewhere h is 1") {
  for (const double dilation : {0.0, 0.7}) {
    const MP::Harmonic_coordinates_2<Kernel> coordinates{Domain(u_shape())};
    const Domain& domain = coordinates.domain();
    for (std::size_t i = 0; i < domain.size(); ++i)
      for (const double s : {0.125, 0.5, 0.75}) {
        const auto p = parameters_at(coordinates, domain.point_on_side(i, s),
                                     Domain::Location::on_side(i, s), dilation);
        CHECK(p[i].s.value() == Approx(s));
        CHECK(p[i].h.value() == 0);
        CHECK(p[domain.next(i)].h.value() == Approx(1 - s));
        CHECK(p[domain.next(i)].s.value() == 0);
        CHECK(p[domain.prev(i)].h.value() == Approx(s));
        CHECK(p[domain.prev(i)].s.value() == 1);
        for (std::size_t j = 0; j < domain.size(); ++j)
          if (j != i && j != domain.next(i) && j != domain.prev(i))
            CHECK(p[j].h.value() == Approx(1));
      }
  }
}

TEST_CASE(
    "On a square with Wachspress coordinates the side parameters are u, v and 1 minus these") {
  const MP::Wachspress_coordinates_2<Kernel> coordinates{Domain({{0, 0}, {1, 0}, {1, 1}, {0, 1}})};
  Random random(10);
  for (int k = 0; k < 50; ++k) {
    const double u = random.in(0, 1), v = random.in(0, 1);
    const auto p = parameters_at(coordinates, {u, v}, Domain::Location::interior());
    const double s[4] = {u, v, 1 - u, 1 - v}, h[4] = {v, 1 - u, 1 - v, u};
    for (int i = 0; i < 4; ++i) {
      CHECK(p[i].s.value() == Approx(s[i]).margin(1e-14));
      CHECK(p[i].h.value() == Approx(h[i]).margin(1e-14));
      CHECK(p[i].s[i % 2 == 0 ? 1 : 2] == Approx(i < 2 ? 1 : -1));
      CHECK(p[i].h[i % 2 == 0 ? 2 : 1] == Approx(i == 0 || i == 3 ? 1 : -1));
    }
  }
}

TEST_CASE("h is what the coordinates of the side lack to 1, also on domains with holes") {
  const Domain domain({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}});
  Random random(11);
  std::vector<Jet> lambda(8);
  double sum = 0;
  for (Jet& l : lambda)
    sum += (l = Jet(random.in(0, 1))).value();
  Parameters parameters(8);
  MP::compute_side_parameters(domain, lambda.data(), 0.0, parameters);
  for (std::size_t i = 0; i < 8; ++i)
    CHECK(parameters[i].h.value() ==
          Approx(sum - lambda[i].value() - lambda[domain.next(i)].value()));
}

TEST_CASE("All weights of the basis sum to 1, and their derivatives to 0") {
  const unsigned seed = 20260106;
  CAPTURE(seed);
  Random random(seed);
  using Jet2 = MP::Jet_2<double, 2>;
  for (const auto weight :
       {MP::Central_weight::weight_deficiency, MP::Central_weight::none,
        MP::Central_weight::adjacent_products, MP::Central_weight::full_product})
    for (const auto& polygon : {l_shape(), u_shape(), star_shaped_polygon(random, 9, 0.3)}) {
      const MP::Harmonic_coordinates_2<Kernel> coordinates{Domain(polygon)};
      const Domain& domain = coordinates.domain();
      std::vector<std::pair<std::size_t, std::size_t>> structure;
      for (std::size_t i = 0; i < domain.size(); ++i)
        structure.emplace_back(random.integer(1, 6), random.integer(1, 4));
      const MP::Concave_bezier_basis basis(structure, weight, 0.3);
      for (int k = 0; k < 20; ++k) {
        const Point_2 p = interior_point(random, domain);
        std::vector<Jet2> lambda(domain.size()), weights(basis.size());
        coordinates.evaluate<2>(p, Domain::Location::interior(), lambda.data());
        basis.evaluate(domain, lambda.data(), weights.data());
        Jet2 sum;
        double size = 1;
        for (const Jet2& w : weights) {
          sum += w;
          for (std::size_t e = 0; e < Jet2::size; ++e)
            size = (std::max)(size, std::abs(w[e]));
        }
        CHECK(std::abs(sum.value() - 1) < 1e-13);
        for (std::size_t e = 1; e < Jet2::size; ++e)
          CHECK(std::abs(sum[e]) < 1e-12 * size);
        if (weight == MP::Central_weight::none)
          CHECK(weights[basis.central_index()].value() == 0);
        if (weight == MP::Central_weight::full_product)
          CHECK(weights[basis.central_index()].value() > 0);
      }
    }
}

TEST_CASE("On and close to a side only the ribbon's own first row has weight") {
  Random random(21);
  for (const std::size_t n : {3, 4, 5, 6, 8})
    for (const double dilation : {0.0, 0.5})
      for (const auto weight :
           {MP::Central_weight::weight_deficiency, MP::Central_weight::none,
            MP::Central_weight::adjacent_products, MP::Central_weight::full_product}) {
        CAPTURE(n, dilation, to_string(weight));
        const MP::Wachspress_coordinates_2<Kernel> coordinates{Domain(convex_polygon(random, n))};
        const Domain& domain = coordinates.domain();
        const MP::Concave_bezier_basis basis(
            std::vector<std::pair<std::size_t, std::size_t>>(n, {3, 2}), weight, dilation);
        std::vector<Jet> lambda(n), weights(basis.size());
        for (std::size_t i = 0; i < n; ++i)
          for (const double depth : {0.0, 1e-7}) {
            const auto along = domain.vertex(domain.next(i)) - domain.vertex(i);
            const Point_2 p =
                domain.point_on_side(i, 0.4) + depth * along.perpendicular(CGAL::COUNTERCLOCKWISE);
            coordinates.evaluate<1>(
                p, depth == 0 ? Domain::Location::on_side(i, 0.4) : Domain::Location::interior(),
                lambda.data());
            basis.evaluate(domain, lambda.data(), weights.data());
            double own = 0, others = 0;
            for (std::size_t k = 0; k < basis.size(); ++k)
              if (k >= basis.index(i, 0, 0) && k <= basis.index(i, 3, 0))
                own += weights[k].value();
              else
                others += std::abs(weights[k].value());
            CHECK(std::abs(own - 1) < 1e-5);
            CHECK(others < 1e-5);
          }
      }
}

TEST_CASE("Second derivatives of the basis on a side are the limits of those inside") {
  Random random(22);
  using Jet2 = MP::Jet_2<double, 2>;
  for (const std::size_t n : {5, 6, 9})
    for (const std::size_t layers : {2, 3}) {
      const MP::Wachspress_coordinates_2<Kernel> coordinates{Domain(convex_polygon(random, n))};
      const Domain& domain = coordinates.domain();
      const MP::Concave_bezier_basis basis(
          std::vector<std::pair<std::size_t, std::size_t>>(n, {5, layers}));
      std::vector<Jet2> lambda(n), on_side(basis.size()), inside(basis.size());
      for (std::size_t i = 0; i < n; ++i) {
        const auto along = domain.vertex(domain.next(i)) - domain.vertex(i);
        const Point_2 p = domain.point_on_side(i, 0.45);
        coordinates.evaluate<2>(p, Domain::Location::on_side(i, 0.45), lambda.data());
        basis.evaluate(domain, lambda.data(), on_side.data());
        coordinates.evaluate<2>(p + 1e-7 * along.perpendicular(CGAL::COUNTERCLOCKWISE),
                                Domain::Location::interior(), lambda.data());
        basis.evaluate(domain, lambda.data(), inside.data());
        double size = 0;
        for (const Jet2& w : inside)
          for (std::size_t e = 3; e < 6; ++e)
            size = (std::max)(size, std::abs(w[e]));
        for (std::size_t k = 0; k < basis.size(); ++k)
          for (std::size_t e = 0; e < 6; ++e)
            CHECK(on_side[k][e] == Approx(inside[k][e]).margin(1e-5 * size));
      }
    }
}
