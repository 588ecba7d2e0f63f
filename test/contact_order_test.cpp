// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Everything here that is not text is exact: weights vanish to an order or do not, there is no
// tolerance.

#include "Power_series.h"
#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/bases/Concave_bezier_basis.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace MP = CGAL::Multisided_patches;
using fixtures::Random;
using MP::Central_weight;

namespace {

using FT = CGAL::Exact_rational;
using Exact = CGAL::Simple_cartesian<FT>;
using Domain = MP::Polygonal_domain_2<Exact>;
using Ribbon = MP::Bezier_ribbon_3<Exact>;
using Loop = MP::Ribbon_loop_3<Exact>;
using Point_3 = Exact::Point_3;
using Series = fixtures::Power_series<FT, 6>;
using Jet = MP::Jet_2<FT, 2>;
using Structure = std::vector<std::pair<std::size_t, std::size_t>>; // degrees and layers

const Central_weight central_weights[] = {Central_weight::weight_deficiency, Central_weight::none,
                                          Central_weight::adjacent_products,
                                          Central_weight::full_product};

// A strictly convex polygon without symmetries or parallel sides.
Domain polygon(std::size_t n) {
  const std::vector<Exact::Point_2> points{{0, 0}, {4, -1}, {6, 2}, {5, 5}, {2, 7}, {-1, 3}};
  return Domain({points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n)});
}

// What `contact_order()` needs to know about a loop.
struct Loop_structure {
  struct Side {
    std::pair<std::size_t, std::size_t> numbers;
    std::size_t degree() const { return numbers.first; }
    std::size_t layers() const { return numbers.second; }
  };
  Structure sides;
  std::size_t size() const { return sides.size(); }
  std::size_t next(std::size_t i) const { return (i + 1) % size(); }
  std::size_t prev(std::size_t i) const { return (i + size() - 1) % size(); }
  Side operator[](std::size_t i) const { return {sides[i]}; }
};

Loop_structure uniform_structure(std::size_t n, std::size_t degree, std::size_t layers) {
  return {Structure(n, {degree, layers})};
}

Loop_structure random_structure(Random& random, std::size_t n) {
  Loop_structure loop;
  for (std::size_t i = 0; i < n; ++i)
    loop.sides.emplace_back(random.integer(1, 7), random.integer(1, 4));
  return loop;
}

std::size_t vanishing_order(const Series& series) {
  return series.vanishing_order();
}
// all partial derivatives below this order are 0; at most 3
std::size_t vanishing_order(const Jet& jet) {
  std::size_t k = 0;
  while (k < Jet::size && jet[k] == FT(0))
    ++k;
  return k == 0 ? 0 : k < 3 ? 1 : k < 6 ? 2 : 3;
}

// Wachspress coordinates along a ray that starts on side i: the areas are linear on it, and of the
// products of all but two of them no factor is divided by.
std::vector<Series> coordinates_on_ray(const Domain& domain, std::size_t i, const FT& s) {
  const std::size_t n = domain.size();
  const Exact::Point_2 start = domain.point_on_side(i, s), target(3, 0);
  std::vector<Series> lambda;
  Series sum;
  for (std::size_t k = 0; k < n; ++k) {
    Series product(
        CGAL::area(domain.vertex(domain.prev(k)), domain.vertex(k), domain.vertex(domain.next(k))));
    for (std::size_t j = 0; j < n; ++j)
      if (j != k && j != domain.prev(k)) {
        const FT a = CGAL::area(domain.vertex(j), domain.vertex(domain.next(j)), start);
        const FT b = CGAL::area(domain.vertex(j), domain.vertex(domain.next(j)), target);
        product *= Series(a, b - a);
      }
    lambda.push_back(product);
    sum += product;
  }
  for (Series& l : lambda)
    l /= sum;
  return lambda;
}

std::vector<Jet> coordinates_on_side(const Domain& domain, std::size_t i, const FT& s) {
  std::vector<Jet> lambda(domain.size());
  MP::Wachspress_coordinates_2<Exact>(domain).evaluate<2>(
      domain.point_on_side(i, s), domain.location_on_side(i, s), lambda.data());
  return lambda;
}

template <typename T>
std::vector<T> bernstein(std::size_t degree, const T& t) {
  std::vector<T> b(degree + 1);
  MP::internal::bernstein_polynomials(degree, t, b.data());
  return b;
}

// The weights on side i of a patch with this structure.
template <typename T>
class Weights {
public:
  Weights(const Domain& domain, const Loop_structure& loop, Central_weight central_weight,
          const std::vector<T>& lambda, double dilation = 0)
      : loop_(loop), basis_(loop.sides, central_weight, dilation), weights_(basis_.size()) {
    basis_.evaluate(domain, lambda.data(), weights_.data());
  }

  const T& weight(std::size_t side, std::size_t j, std::size_t k) const {
    return weights_[basis_.index(side, j, k)];
  }
  const std::vector<T>& all() const { return weights_; }

  // to which order the weights of a column of side a vanish
  std::size_t order_of_column(std::size_t a, std::size_t j) const {
    std::size_t order = 99;
    for (std::size_t k = 0; k < loop_[a].layers(); ++k)
      order = (std::min)(order, vanishing_order(weight(a, j, k)));
    return order;
  }
  std::size_t order_of_side(std::size_t a) const {
    std::size_t order = 99;
    for (std::size_t j = 0; j <= loop_[a].degree(); ++j)
      order = (std::min)(order, order_of_column(a, j));
    return order;
  }
  std::size_t order_of_center() const { return vanishing_order(weights_[basis_.central_index()]); }
  std::size_t order_of_all_but(std::size_t i) const {
    std::size_t order = order_of_center();
    for (std::size_t a = 0; a < loop_.size(); ++a)
      if (a != i)
        order = (std::min)(order, order_of_side(a));
    return order;
  }

private:
  Loop_structure loop_;
  MP::Concave_bezier_basis basis_;
  std::vector<T> weights_;
};

// A closed loop with jagged rows; it need not make sense at its corners.
Loop random_loop(Random& random, const Loop_structure& structure) {
  const auto coordinate = [&](int k) -> FT {
    return FT(k) + FT(static_cast<int>(random.integer(0, 40))) / FT(100);
  };
  const Domain plan = polygon(structure.size());
  std::vector<Ribbon> ribbons;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    std::vector<Point_3> points;
    for (std::size_t k = 0; k < structure[i].layers(); ++k)
      for (std::size_t j = 0; j <= structure[i].degree(); ++j)
        points.emplace_back(coordinate(static_cast<int>(j)), coordinate(static_cast<int>(k)),
                            coordinate(0));
    const auto corner = [&](std::size_t v) {
      return Point_3(plan.vertex(v).x(), plan.vertex(v).y(), FT(static_cast<int>(v * v)) / FT(20));
    };
    points.front() = corner(i);
    points[structure[i].degree()] = corner(plan.next(i));
    ribbons.emplace_back(structure[i].degree(), structure[i].layers(), points);
  }
  return Loop(ribbons);
}

Loop_structure structure_of(const Loop& loop) {
  Loop_structure structure;
  for (const Ribbon& ribbon : loop.ribbons())
    structure.sides.emplace_back(ribbon.degree(), ribbon.layers());
  return structure;
}

// The difference of heights between the patch and the surface of ribbon i, at the same side
// parameters, along a ray that starts on side i.
Series distance_to_ribbon(const Loop& loop, std::size_t i, Central_weight central_weight,
                          double dilation) {
  const Domain domain = polygon(loop.size());
  const auto lambda = coordinates_on_ray(domain, i, FT(2) / FT(7));
  const Weights<Series> weights(domain, structure_of(loop), central_weight, lambda, dilation);
  Series difference = weights.all().back() * Series(FT(3)); // the central control point's height
  for (std::size_t a = 0; a < loop.size(); ++a)
    for (std::size_t k = 0; k < loop[a].layers(); ++k)
      for (std::size_t j = 0; j <= loop[a].degree(); ++j)
        difference += weights.weight(a, j, k) * Series(loop[a].control_point(j, k).z());

  std::vector<MP::Side_parameter<Series>> parameters(loop.size());
  MP::compute_side_parameters(domain, lambda.data(), dilation, parameters);
  const auto along = bernstein(loop[i].degree(), parameters[i].s);
  const auto across = bernstein(loop[i].cross_degree(), parameters[i].h);
  // Rows that the ribbon does not have would change terms of order layers() and higher only.
  for (std::size_t k = 0; k < loop[i].layers(); ++k)
    for (std::size_t j = 0; j <= loop[i].degree(); ++j)
      difference -= along[j] * across[k] * Series(loop[i].control_point(j, k).z());
  return difference;
}

} // namespace

TEST_CASE("Weights of other sides vanish with just as many derivatives as contact_order says") {
  for (std::size_t n = 3; n <= 6; ++n) {
    const Domain domain = polygon(n);
    const std::vector<Jet> lambda = coordinates_on_side(domain, 1, FT(3) / FT(8));
    for (std::size_t degree = 1; degree <= 7; ++degree)
      for (std::size_t layers = 1; layers <= 4; ++layers)
        for (const Central_weight central : central_weights) {
          const Loop_structure loop = uniform_structure(n, degree, layers);
          CAPTURE(n, degree, layers, to_string(central));
          const Weights<Jet> weights(domain, loop, central, lambda);
          const std::size_t order = MP::contact_order(loop, 1, central);
          CHECK(weights.order_of_all_but(1) == (std::min)(order + 1, std::size_t{3}));
        }
  }
}

TEST_CASE("Weights of other sides vanish likewise where degrees and layers are mixed") {
  const unsigned seed = 20260216;
  CAPTURE(seed);
  Random random(seed);
  for (int k = 0; k < 100; ++k) {
    const std::size_t n = random.integer(3, 6), i = random.integer(0, n - 1);
    const Domain domain = polygon(n);
    const Loop_structure loop = random_structure(random, n);
    const Central_weight central = central_weights[random.integer(0, 3)];
    const Weights<Jet> weights(domain, loop, central,
                               coordinates_on_side(domain, i, FT(5) / FT(8)));
    const std::size_t order = MP::contact_order(loop, i, central);
    CHECK(weights.order_of_all_but(i) >= (std::min)(order + 1, std::size_t{3}));
    if (order + 1 < loop[i].layers()) // otherwise they may vanish with more derivatives than needed
      CHECK(weights.order_of_all_but(i) == (std::min)(order + 1, std::size_t{3}));
  }
}

TEST_CASE("Columns vanish on the neighbours by their corner weight or their polynomial") {
  const Domain domain = polygon(5);
  const std::vector<Series> lambda = coordinates_on_ray(domain, 1, FT(3) / FT(8));
  for (std::size_t degree = 1; degree <= 7; ++degree)
    for (std::size_t layers = 1; layers <= 4; ++layers)
      for (std::size_t layers_2 = 1; layers_2 <= 4; ++layers_2) {
        // p is the larger number of layers at corner 2, where the sides 1 and 2 meet.
        Loop_structure loop = uniform_structure(5, 3, 1);
        loop.sides[1].second = layers;
        loop.sides[2] = {degree, layers_2};
        const Weights<Series> weights(domain, loop, Central_weight::none, lambda);
        const std::size_t p = (std::max)(layers, layers_2), cut_off = 6;
        CAPTURE(degree, layers, layers_2);
        for (std::size_t j = 0; j <= degree; ++j)
          CHECK(weights.order_of_column(2, j) == (std::min)(2 * j < degree ? j + p : j, cut_off));
        CHECK(weights.order_of_side(2) == (std::min)(p, (degree + 1) / 2));
      }
}

TEST_CASE("Sides that do not touch a side vanish on it to the order of their layers") {
  for (std::size_t n = 4; n <= 6; ++n)
    for (const double dilation : {0.0, 0.5, -2.0})
      for (std::size_t layers = 1; layers <= 4; ++layers) {
        const Domain domain = polygon(n);
        const auto lambda = coordinates_on_ray(domain, 0, FT(3) / FT(8));
        Loop_structure loop = uniform_structure(n, 4, layers);
        for (const Central_weight central : central_weights) {
          const Weights<Series> weights(domain, loop, central, lambda, dilation);
          for (std::size_t j = 2; j + 1 < n; ++j)
            CHECK(weights.order_of_side(j) == layers);
        }
      }
}

TEST_CASE("The products that weight the central control point vanish to order 2 on the sides") {
  for (std::size_t n = 3; n <= 6; ++n) {
    const Domain domain = polygon(n);
    const auto lambda = coordinates_on_ray(domain, 1, FT(3) / FT(8));
    const Loop_structure loop = uniform_structure(n, 7, 4);
    const auto order = [&](Central_weight central) {
      return Weights<Series>(domain, loop, central, lambda).order_of_center();
    };
    CHECK(order(Central_weight::adjacent_products) == 2);
    CHECK(order(Central_weight::full_product) == 2);
    CHECK(order(Central_weight::weight_deficiency) >= 4);
    CHECK(order(Central_weight::none) == 6); // it is 0
  }
}

TEST_CASE("The patch and a ribbon have just the contact that contact_order says") {
  const unsigned seed = 20260211;
  CAPTURE(seed);
  Random random(seed);
  for (int k = 0; k < 100; ++k) {
    const std::size_t n = random.integer(3, 6);
    const Loop loop = random_loop(random, random_structure(random, n));
    const Central_weight central = central_weights[random.integer(0, 3)];
    const double dilation = random.integer(0, 1) ? 0.25 : 0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t order = MP::contact_order(loop, i, central);
      const Series distance = distance_to_ribbon(loop, i, central, dilation);
      CHECK(vanishing_order(distance) >= order + 1);
      if (order + 1 < loop[i].layers()) // beyond its layers a ribbon says nothing
        CHECK(vanishing_order(distance) == order + 1);
    }
  }
}

TEST_CASE("The table of contact orders") {
  const auto order = [](std::size_t degree, std::size_t layers) {
    return MP::contact_order(uniform_structure(5, degree, layers), 0);
  };
  const std::size_t table[7][4] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 1, 1, 1}, {0, 1, 1, 1},
                                   {0, 1, 2, 2}, {0, 1, 2, 2}, {0, 1, 2, 3}};
  for (std::size_t degree = 1; degree <= 7; ++degree)
    for (std::size_t layers = 1; layers <= 4; ++layers)
      CHECK(order(degree, layers) == table[degree - 1][layers - 1]);
}

TEST_CASE("What a side lacks for the order that its layers promise is said in words") {
  Loop_structure loop = uniform_structure(6, 5, 3);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(MP::contact_shortfall(loop, i).empty());
  loop.sides[4].first = 4;
  CHECK(MP::contact_shortfall(loop, 3) ==
        "side 3 promises curvature continuity by its 3 layers but gets tangent plane continuity "
        "only; it takes degree 5 on side 4");
  CHECK(MP::contact_shortfall(loop, 4).empty());
  loop.sides[0].second = 1;
  CHECK(MP::contact_shortfall(loop, 3, Central_weight::full_product) ==
        "side 3 promises curvature continuity by its 3 layers but gets position continuity only; "
        "it takes degree 5 on side 4, 3 layers on side 0 and the central weight none or "
        "weight-deficiency");
  loop = uniform_structure(12, 6, 3);
  loop.sides[2].second = 4;
  CHECK(MP::contact_shortfall(loop, 2) ==
        "side 2 promises continuity of order 3 by its 4 layers but gets curvature continuity only; "
        "it takes degree 7 on sides 1 and 3 and 4 layers on sides 0, 4, 5, 6, 7 and 4 more");
}

TEST_CASE("A loop elevated for contact keeps the promises of its layers, and no degree is wasted") {
  const unsigned seed = 20260214;
  CAPTURE(seed);
  Random random(seed);
  for (int k = 0; k < 30; ++k) {
    const std::size_t n = random.integer(3, 6), layers = random.integer(1, 4);
    Loop_structure structure = random_structure(random, n);
    for (auto& side : structure.sides)
      side.second = layers;
    const Loop loop = random_loop(random, structure), elevated = MP::elevated_for_contact(loop);
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(MP::contact_order(elevated, i) == layers - 1);
      CHECK(MP::contact_shortfall(elevated, i).empty());
      CHECK(elevated[i].degree() == (std::max)(loop[i].degree(), 2 * layers - 1));
      CHECK(elevated.corner_point(i) == loop.corner_point(i));
    }
    CHECK(vanishing_order(distance_to_ribbon(elevated, 1, Central_weight::none, 0)) >= layers);
  }
}

TEST_CASE("Degrees are not elevated for an order that is out of reach for other reasons") {
  Random random(20260215);
  Loop_structure structure = uniform_structure(5, 2, 3);
  structure.sides[3].second = 2; // does not matter to its neighbours, the sides 2 and 4
  const Loop loop = random_loop(random, structure);
  const auto degrees = [&](Central_weight central) {
    const Loop elevated = MP::elevated_for_contact(loop, central);
    std::vector<std::size_t> result;
    for (const Ribbon& ribbon : elevated.ribbons())
      result.push_back(ribbon.degree());
    return result;
  };
  CHECK(degrees(Central_weight::none) == std::vector<std::size_t>{5, 5, 3, 5, 3});
  CHECK(degrees(Central_weight::full_product) == std::vector<std::size_t>{3, 3, 3, 3, 3});
}
