// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "harmonic_fixtures.h"

using namespace fixtures;
namespace harmonic = MP::internal::harmonic;

namespace {

// the size of the terms of degree 0, 1, ... in the power series around c of the function of every
// vertex, on a circle: the largest of all vertices
std::vector<double> series_on_circle(const Harmonic_coordinates_2& h, const Point_2& c,
                                     double radius, std::size_t terms) {
  const std::size_t samples = 4 * terms;
  std::vector<std::vector<harmonic::Complex>> sums(
      h.domain().size(), std::vector<harmonic::Complex>(terms, harmonic::Complex(0)));
  for (std::size_t j = 0; j < samples; ++j) {
    const double angle = 2 * MP::internal::pi * static_cast<double>(j) / double(samples);
    const auto lambda =
        evaluate<0>(h, {c.x() + radius * std::cos(angle), c.y() + radius * std::sin(angle)});
    for (std::size_t i = 0; i < lambda.size(); ++i)
      for (std::size_t k = 0; k < terms; ++k)
        sums[i][k] += lambda[i][0] * std::polar(2. / double(samples), -angle * double(k));
  }
  std::vector<double> result(terms, 0);
  for (const std::vector<harmonic::Complex>& sum : sums)
    for (std::size_t k = 0; k < terms; ++k)
      result[k] = (std::max)(result[k], std::abs(sum[k]));
  return result;
}

// the same on an arc around a point of the boundary, from the direction of a side to that of the
// one before, `angle` pi further, for what is left of the functions without the parts of a cell
// that carry the boundary values: in the powers Im zeta^(k / angle), k = 0, 1, ...
template <typename Cell>
std::vector<double> series_on_arc(const Harmonic_coordinates_2& h, const Cell& cell,
                                  const harmonic::Complex& c, const harmonic::Complex& direction,
                                  double angle, double radius, std::size_t terms) {
  const std::size_t samples = 4 * terms;
  std::vector<std::vector<double>> sums(h.domain().size(), std::vector<double>(terms, 0));
  for (std::size_t j = 1; j < samples; ++j) {
    const double t = MP::internal::pi * static_cast<double>(j) / double(samples);
    const harmonic::Complex z = c + radius * direction * std::polar(1., angle * t);
    auto lambda = evaluate<0>(h, {z.real(), z.imag()});
    std::array<harmonic::Hat_term<0>, harmonic::max_hat_terms> hats;
    const std::size_t count = cell.template hats<0>(z, hats.data());
    for (std::size_t i = 0; i < count; ++i)
      lambda[hats[i].vertex][0] -= hats[i].f[0].real();
    for (std::size_t i = 0; i < lambda.size(); ++i)
      for (std::size_t k = 0; k < terms; ++k)
        sums[i][k] += lambda[i][0] * 2 / double(samples) * std::sin(double(k) * t);
  }
  std::vector<double> result(terms, 0);
  for (const std::vector<double>& sum : sums)
    for (std::size_t k = 0; k < terms; ++k)
      result[k] = (std::max)(result[k], std::abs(sum[k]));
  return result;
}

// the distance of a point to all sides but two
double distance_to_others(const harmonic::Boundary& boundary, const harmonic::Complex& z,
                          std::size_t e1, std::size_t e2) {
  double squared = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < boundary.size(); ++e)
    if (e != e1 && e != e2)
      squared = (std::min)(squared, harmonic::squared_distance(z, boundary.side(e)));
  return std::sqrt(squared);
}

} // namespace

// From a circle that the domain contains, so that only the decay of the terms tells how far the
// series converges.
TEST_CASE("Series around points inside converge beyond the sides, up to the nearest vertex",
          "[harmonic]") {
  constexpr std::size_t terms = 24;
  std::size_t beyond = 0;
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-11)) {
    const harmonic::Boundary boundary = boundary_of(h.domain());
    for (const Point_2& c : random_points_inside(h.domain(), 12, 5)) {
      const double distance = distance_to_boundary(h.domain(), c), circle = 0.9 * distance,
                   radius = harmonic::interior_radius(boundary, {c.x(), c.y()});
      beyond += radius > 1.5 * distance;
      const std::vector<double> sizes = series_on_circle(h, c, circle, terms);
      INFO("around " << c << ", " << distance << " from the boundary and " << radius
                     << " from the nearest vertex of " << h.domain().size());
      for (std::size_t k = 0; k < terms; ++k) {
        // A function of size 1 grows with every reflection, at most linearly.
        const double bound = 4 * radius / distance * std::pow(circle / radius, double(k));
        CHECK(sizes[k] <= bound + 1e-10);
      }
    }
  }
  CHECK(beyond > 50);
}

TEST_CASE("Series around points of sides converge up to the nearest vertex on this side",
          "[harmonic]") {
  constexpr std::size_t terms = 24;
  std::size_t beyond = 0;
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-11)) {
    const harmonic::Boundary boundary = boundary_of(h.domain());
    for (std::size_t e = 0; e < boundary.size(); ++e)
      for (const double t : {0.3, 0.5}) {
        const harmonic::Complex &d = boundary.direction(e),
                                c = boundary.vertex(e) + t * boundary.length(e) * d;
        const double distance = (std::min)(distance_to_others(boundary, c, e, e),
                                           (std::min)(t, 1 - t) * boundary.length(e)),
                     circle = 0.9 * distance, radius = harmonic::side_radius(boundary, e, c);
        beyond += radius > 1.2 * distance;
        const harmonic::Side_cell cell(boundary, e, c, radius, 1);
        const std::vector<double> sizes = series_on_arc(h, cell, c, d, 1, circle, terms);
        INFO("around " << c << ", radius " << radius << ", " << distance << " from other sides of "
                       << h.domain().size());
        for (std::size_t k = 0; k < terms; ++k)
          CHECK(sizes[k] <= 4 * radius / distance * std::pow(circle / radius, double(k)) + 1e-10);
      }
  }
  CHECK(beyond > 30);
}

TEST_CASE("Series around corners converge up to the nearest vertex, and to their mirror images",
          "[harmonic]") {
  constexpr std::size_t terms = 32;
  std::size_t beyond = 0, reflex = 0;
  for (const Harmonic_coordinates_2& h : on_all_domains(1e-11)) {
    const harmonic::Boundary boundary = boundary_of(h.domain());
    for (std::size_t k = 0; k < boundary.size(); ++k) {
      const harmonic::Complex& c = boundary.vertex(k);
      const std::size_t prev = boundary.prev(k);
      const double distance = distance_to_others(boundary, c, k, prev), angle = boundary.angle(k),
                   circle = 0.9 * distance, radius = harmonic::corner_radius(boundary, k);
      beyond += radius > 1.2 * distance;
      reflex += angle > 1 && radius > 1.2 * distance;
      const harmonic::Corner_cell cell(boundary, k, radius, 1);
      const std::vector<double> sizes =
          series_on_arc(h, cell, c, boundary.direction(k), angle, circle, terms);
      INFO("around " << c << ", radius " << radius << ", " << distance << " from other sides of "
                     << h.domain().size());
      for (std::size_t j = 0; j < terms; ++j)
        CHECK(sizes[j] <=
              4 * radius / distance * std::pow(circle / radius, double(j) / angle) + 1e-10);
    }
  }
  CHECK(beyond > 10);
  CHECK(reflex > 5);
}

TEST_CASE("Discs at corners end at other vertices, or where the corner sees itself mirrored",
          "[harmonic]") {
  const auto radius = [](const Points& polygon, std::size_t k) {
    return harmonic::corner_radius(boundary_of(Domain(polygon)), k);
  };
  CHECK(radius({{0, 0}, {3, 0}, {3, 2}, {0, 2}}, 0) == Approx(2));
  // a corner that is 1 away from the middle of a side, 5 from its ends
  CHECK(radius({{0, 0}, {3, -4}, {3, 1}, {-3, 1}, {-3, -4}}, 0) == Approx(2));
  // another vertex is 0.002 away, but behind a wall of the corner
  CHECK(radius(slotted(), 3) == Approx(0.8));
}

// The hole reaches into the disc around the first triangle, and hides it from the middle of the
// disc that the one above the hole would get.
TEST_CASE("No cell reaches triangles behind a wall", "[harmonic]") {
  const harmonic::Boundary boundary =
      boundary_of(Domain({{-4, 1.07}, {0, 0}, {4, 1.07}, {4, 4}, {-4, 4}},
                         {{{-2.2, 1}, {-2.2, 1.01}, {2.2, 1.01}, {2.2, 1}}}));
  REQUIRE(harmonic::corner_radius(boundary, 1) > 1.9);
  const std::size_t none = harmonic::Bisection_mesh::none;
  harmonic::Candidate_finder finder(boundary, 1e-6);
  for (const double y : {0.9, 1.1}) {
    const harmonic::Leaf leaf{{{{-0.05, y - 0.05}, {0.05, y - 0.05}, {0, y}}}, {none, none, none}};
    const auto found = finder.find(leaf);
    REQUIRE(found);
    INFO("kind " << static_cast<int>(found->kind) << " at " << found->centre);
    CHECK((found->kind == harmonic::Candidate::Kind::corner) == (y < 1));
  }
}

TEST_CASE("Discs are moved to where their series converge faster, inside or along their side",
          "[harmonic]") {
  using harmonic::Candidate;
  const harmonic::Boundary boundary = boundary_of(Domain(Points{{0, 0}, {4, 0}, {4, 3}, {0, 3}}));
  const std::vector<harmonic::Triangle_points> triangles{{{{1, 0}, {2, 0}, {1.5, 1}}},
                                                         {{{2, 0}, {2.5, 1}, {1.5, 1}}}};
  const auto ratio = [&](const Candidate& c) {
    return harmonic::farthest(triangles, c.centre) / c.radius;
  };
  const harmonic::Complex beginning(1.1, 0);
  Candidate on_side{Candidate::Kind::side, 0, beginning,
                    harmonic::side_radius(boundary, 0, beginning), 0};
  const double before = ratio(on_side);
  harmonic::Disc_centring(boundary, triangles).improve(on_side);
  CHECK(on_side.centre.imag() == 0);
  CHECK(on_side.radius == harmonic::side_radius(boundary, 0, on_side.centre));
  CHECK(ratio(on_side) < 0.8 * before);

  const harmonic::Complex low(1.2, 0.1);
  Candidate inside{Candidate::Kind::interior, 0, low, harmonic::interior_radius(boundary, low), 0};
  const double before_inside = ratio(inside);
  harmonic::Disc_centring(boundary, triangles).improve(inside);
  CHECK(inside.centre.imag() > 0);
  CHECK(inside.centre.imag() < 1);
  CHECK(inside.radius == harmonic::interior_radius(boundary, inside.centre));
  CHECK(ratio(inside) < 0.8 * before_inside);
}

// Two centres that mirror each other are equally good up to rounding, which must not make each of
// them better than the other.
TEST_CASE("Discs come to rest on mirror-symmetric domains", "[harmonic]") {
  for (const Points& polygon :
       {Points{{0, 0}, {406, 0}, {406, 88}, {244, 88}, {244, 203}, {162, 203}, {162, 88}, {0, 88}},
        Points{
            {0, 0}, {434, 0}, {434, 101}, {244, 101}, {244, 113}, {190, 113}, {190, 101}, {0, 101}},
        Points{{0, 0}, {176, 0}, {176, 156}, {99, 156}, {99, 275}, {77, 275}, {77, 156}, {0, 156}}})
    for (const double target : {1e-4, 1e-6, 1e-8, 1e-9, 1e-10})
      CHECK(Harmonic_coordinates_2(Domain(polygon), target).error_bound() <= target);

  using harmonic::Candidate;
  const unsigned seed = 23;
  Random random(seed);
  const harmonic::Boundary boundary = boundary_of(Domain(Points{{0, 0}, {4, 0}, {4, 3}, {0, 3}}));
  for (int k = 0; k < 2000; ++k) {
    const double x = random.in(0.2, 1.5), y = random.in(0.5, 1.2), tip = random.in(1.3, 2);
    const std::vector<harmonic::Triangle_points> triangles{{{{2 - x, y}, {2 + x, y}, {2, tip}}}};
    const harmonic::Complex start(2 + x / 2 * random.in(-1, 1), y + 0.01);
    Candidate c{Candidate::Kind::interior, 0, start, harmonic::interior_radius(boundary, start), 0};
    const double before = harmonic::farthest(triangles, c.centre) / c.radius;
    harmonic::Disc_centring(boundary, triangles).improve(c);
    CHECK(harmonic::farthest(triangles, c.centre) / c.radius <= before);
  }
}

// The height of a gap is known to as few digits as its coordinates tell, and differs between both
// ends; that must not move them.
TEST_CASE("A channel ends where its sides do, however thin it is", "[harmonic]") {
  Random random(11);
  for (int trial = 0; trial < 200; ++trial) {
    const double width = std::pow(10., -random.in(2, 12)), angle = random.in(0, 2 * pi);
    INFO("seed 11, trial " << trial << ", width " << width << ", angle " << angle);
    const harmonic::Complex origin(random.in(-1, 1), random.in(-1, 1)), d = std::polar(1., angle);
    const auto point = [&](double along, double across) {
      return origin + d * harmonic::Complex(along, across);
    };
    const double low = 5 * width, high = 1 - 3 * width;
    const harmonic::Boundary boundary(
        {point(0, 0), point(1, 0), point(high, width), point(low, width)}, {1, 2, 3, 0});
    const std::vector<harmonic::Channel> channels = harmonic::channels(boundary, 0, 2);
    REQUIRE(channels.size() == 1);
    const harmonic::Channel& c = channels.front();
    const harmonic::Complex d1 = boundary.direction(c.e1);
    const double ends[2] = {harmonic::dot(c.origin + c.map.abscissa(c.free.low) * d1 - origin, d),
                            harmonic::dot(c.origin + c.map.abscissa(c.free.high) * d1 - origin, d)};
    CHECK((std::min)(ends[0], ends[1]) == Approx(low).epsilon(0).margin(2e-15));
    CHECK((std::max)(ends[0], ends[1]) == Approx(high).epsilon(0).margin(2e-15));
  }
}

TEST_CASE("Where a cell touches the boundary, it has the boundary values whatever its coefficients",
          "[harmonic]") {
  const unsigned seed = 17;
  std::vector<Domain> domains = all_domains();
  Random random(seed);
  for (std::size_t n = 5; n < 30; n += 4)
    domains.push_back(random_domain(random, n, n % 3));
  INFO("seed " << seed);
  std::size_t touching = 0;
  for (const Domain& domain : domains) {
    const harmonic::Boundary boundary = boundary_of(domain);
    harmonic::Bisection_mesh mesh = harmonic::triangulate_boundary(boundary);
    const harmonic::Cover cover = harmonic::Cover_builder(boundary, 1e-6, mesh).build();
    for (std::size_t t = 0; t < mesh.size(); ++t) {
      if (!mesh.triangle(t).is_leaf())
        continue;
      const harmonic::Cell& cell = cover.cells[cover.cell_of[t]];
      for (const harmonic::Complex& z : mesh.corners(t)) {
        std::size_t side = 0;
        while (side < domain.size() &&
               harmonic::squared_distance(z, boundary.side(side)) > 1e-13 * 1e-13)
          ++side;
        if (side == domain.size())
          continue;
        ++touching;
        const double at = harmonic::dot(z - boundary.vertex(side), boundary.direction(side)) /
                          boundary.length(side);
        std::vector<harmonic::Analytic<0>> f(static_cast<std::size_t>(harmonic::size(cell)));
        harmonic::basis<0>(cell, z, f.data());
        for (const harmonic::Analytic<0>& f_j : f)
          CHECK(std::abs(f_j[0].real()) < 1e-9);
        std::array<harmonic::Hat_term<0>, harmonic::max_hat_terms> hats;
        const std::size_t count = harmonic::hats<0>(cell, z, hats.data());
        std::vector<double> values(domain.size(), 0);
        for (std::size_t k = 0; k < count; ++k)
          values[hats[k].vertex] += hats[k].f[0].real();
        for (std::size_t i = 0; i < domain.size(); ++i) {
          const double expected = i == side ? 1 - at : i == domain.next(side) ? at : 0;
          CHECK(values[i] == Approx(expected).epsilon(0).margin(1e-9));
        }
      }
    }
  }
  CHECK(touching > 1000);
}
