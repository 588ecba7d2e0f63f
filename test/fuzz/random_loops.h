// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_RANDOM_LOOPS_H
#define MULTISIDED_PATCHES_TEST_FUZZ_RANDOM_LOOPS_H

#include "random_plans.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Random loops of ribbons, from harmless ones to such as nobody would draw.
namespace fuzz {

// A random similarity, for some with a size of 1e-150 to 1e150 or far away.
class Placement {
public:
  Placement(Random& random, bool is_harmless) {
    const double angle = random.in(0, 2 * pi);
    cos_ = std::cos(angle);
    sin_ = std::sin(angle);
    if (chance(random, 0.3))
      exponent_ = random.in(-150, 150);
    else if (!is_harmless && chance(random, 0.2))
      distance_ = power_of_ten(random, 1, 8);
    scale_ = std::pow(10, exponent_);
  }

  Point_3 operator()(const Point_3& p) const {
    return {scale_ * (cos_ * p.x() - sin_ * p.z() + distance_), scale_ * p.y(),
            scale_ * (sin_ * p.x() + cos_ * p.z() - distance_)};
  }
  std::string text() const {
    std::ostringstream out;
    if (exponent_ != 0)
      out << ", size 1e" << exponent_;
    if (distance_ > 0)
      out << ", at distance " << distance_;
    return out.str();
  }

private:
  double cos_, sin_, exponent_ = 0, distance_ = 0, scale_;
};

struct Raw_ribbon {
  std::size_t degree, layers;
  std::vector<Point_3> points;

  Point_3& at(std::size_t j, std::size_t k) { return points[k * (degree + 1) + j]; }
};

// The ribbons of a loop, before anything has been checked, and what is known about them.
struct Raw_loop {
  std::vector<Raw_ribbon> ribbons;
  std::string text;
  bool is_harmless = false; // nothing about it should give a mesher trouble
  bool is_convex = false;   // its plan is
  bool is_broken = false;   // no loop can be made of it

  Loop loop() const {
    std::vector<Ribbon> checked;
    for (const Raw_ribbon& r : ribbons)
      checked.emplace_back(r.degree, r.layers, r.points);
    return Loop(std::move(checked));
  }
};

class Loop_maker {
public:
  explicit Loop_maker(Random& random) : random_(random) {}

  Raw_loop make() {
    result_.is_harmless = chance(random_, 0.3);
    const Plan plan = result_.is_harmless ? harmless_plan(random_) : random_plan(random_);
    result_.is_convex = plan.name == std::string("convex");
    const Placement placement(random_, result_.is_harmless);
    result_.text = std::to_string(plan.points.size()) + " sides, " + plan.name + placement.text();
    choose_height();
    make_ribbons(plan.points);
    if (!result_.is_harmless && chance(random_, 0.5))
      spoil();
    for (Raw_ribbon& r : result_.ribbons)
      for (Point_3& p : r.points)
        p = placement(p);
    if (!result_.is_harmless && chance(random_, 0.04))
      break_somewhere();
    return std::move(result_);
  }

private:
  void remark(const std::string& text) { result_.text += ", " + text; }

  Raw_ribbon& any_ribbon() {
    return result_.ribbons[random_.integer(0, result_.ribbons.size() - 1)];
  }

  Vector_3 jitter(double size) {
    const double x = random_.in(-size, size), y = random_.in(-size, size),
                 z = random_.in(-size, size);
    return {x, y, z};
  }

  void choose_height() {
    amplitude_ =
        chance(random_, 0.2) ? 0 : power_of_ten(random_, -3, result_.is_harmless ? -0.7 : 0);
    frequency_ = power_of_ten(random_, -0.3, result_.is_harmless ? 0.2 : 0.5);
    phase_ = random_.in(0, 2 * pi);
    if (!result_.is_harmless && chance(random_, 0.4))
      waviness_ = power_of_ten(random_, -4, 0.5);
  }

  Point_3 lift(const Point_2& p) const {
    return {p.x(), p.y(),
            amplitude_ * std::sin(frequency_ * (p.x() * std::cos(phase_) + p.y()) + phase_)};
  }

  void make_ribbons(const Points& plan) {
    const std::size_t n = plan.size();
    const double depth = random_.in(0.1, result_.is_harmless ? 0.25 : 0.5);
    const std::size_t least_degree = result_.is_harmless ? 3 : 1,
                      least_layers = result_.is_harmless ? 2 : 1;
    const auto random_degree = [&] { return random_.integer(least_degree, 7); };
    const auto random_layers = [&] { return random_.integer(least_layers, 3); };
    const std::size_t degree = random_degree(), layers = random_layers();
    const bool mixed = chance(random_, 0.5);
    std::vector<Point_3> corners;
    for (const Point_2& p : plan)
      corners.push_back(lift(p) + jitter(waviness_));
    for (std::size_t i = 0; i < n; ++i) {
      Raw_ribbon r{
          mixed ? random_.integer(1, 7) : degree, mixed ? random_.integer(1, 3) : layers, {}};
      const Point_2 &before = plan[(i + n - 1) % n], &a = plan[i], &b = plan[(i + 1) % n],
                    &after = plan[(i + 2) % n];
      const Kernel::Vector_2 first = inwards(before, a, b, true),
                             last = inwards(a, b, after, false);
      const double size = std::sqrt(CGAL::squared_distance(a, b)) / double(r.degree);
      for (std::size_t k = 0; k < r.layers; ++k)
        for (std::size_t j = 0; j <= r.degree; ++j) {
          const double s = double(j) / double(r.degree);
          const Point_2 at = a + s * (b - a) + double(k) * depth * ((1 - s) * first + s * last);
          r.points.push_back(lift(at) + jitter(waviness_ * size));
        }
      r.at(0, 0) = corners[i];
      r.at(r.degree, 0) = corners[(i + 1) % n];
      result_.ribbons.push_back(std::move(r));
    }
    if (result_.is_harmless || chance(random_, 0.3))
      for (std::size_t i = 0; i < n; ++i)
        align(result_.ribbons[i], result_.ribbons[(i + 1) % n],
              CGAL::orientation(plan[i], plan[(i + 1) % n], plan[(i + 2) % n]) == CGAL::RIGHT_TURN);
  }

  // Makes the tangent planes of two ribbons at their common corner one plane.
  static void align(Raw_ribbon& in, Raw_ribbon& out, bool is_reflex) {
    const Point_3 corner = out.at(0, 0);
    const double sign = is_reflex ? -1 : 1;
    const Vector_3 back = in.at(in.degree - 1, 0) - corner, ahead = out.at(1, 0) - corner;
    if (in.layers > 1)
      in.at(in.degree, 1) = corner + sign * ahead;
    if (out.layers > 1)
      out.at(0, 1) = corner + sign * back;
  }

  // At the middle corner q of p, q, r: along the other side, or away from it at a reflex corner.
  static Kernel::Vector_2 inwards(const Point_2& p, const Point_2& q, const Point_2& r,
                                  bool at_start) {
    const Kernel::Vector_2 along = at_start ? p - q : r - q;
    return CGAL::orientation(p, q, r) == CGAL::RIGHT_TURN ? -along : along;
  }

  // Does something to some ribbons that leaves the loop closed.
  void spoil() {
    result_.is_harmless = false;
    remark("spoiled");
    const double share = chance(random_, 0.3) ? 1 : random_.in(0, 0.5);
    const bool all_alike = chance(random_, 0.5);
    std::size_t kind = random_.integer(0, 9);
    for (std::size_t i = 0; i < result_.ribbons.size(); ++i)
      if (chance(random_, share))
        spoil(i, all_alike ? kind : random_.integer(0, 9));
  }

  void spoil(std::size_t i, std::size_t kind) {
    Raw_ribbon& r = result_.ribbons[i];
    const std::size_t d = r.degree, l = r.layers;
    const auto for_each_free_point = [&](const auto& f) {
      for (std::size_t k = 0; k < l; ++k)
        for (std::size_t j = 0; j <= d; ++j)
          if (k > 0 || (j > 0 && j < d))
            f(j, k);
    };
    const Point_3 a = r.at(0, 0), b = r.at(d, 0);
    switch (kind) {
    case 0: // inner rows upon the boundary
      for_each_free_point([&](std::size_t j, std::size_t) { r.at(j, l - 1) = r.at(j, 0); });
      break;
    case 1: // repeated control points
      for_each_free_point([&](std::size_t j, std::size_t k) {
        if (j > 0 && chance(random_, 0.5))
          r.at(j, k) = r.at(j - 1, k);
      });
      break;
    case 2: // a curve that stands still at its start
      for (std::size_t j = 1; j < d; ++j)
        r.at(j, 0) = a;
      break;
    case 3: // a straight side that doubles back
      for (std::size_t j = 1; j < d; ++j)
        r.at(j, 0) = a + random_.in(-1.5, 2.5) * (b - a);
      break;
    case 4: // folded: the inner rows lie outside
      for_each_free_point([&](std::size_t j, std::size_t k) {
        if (k > 0)
          r.at(j, k) = r.at(j, 0) - (r.at(j, k) - r.at(j, 0));
      });
      break;
    case 5: // rows that cross each other
      for (std::size_t k = 1; k < l; ++k)
        std::reverse(&r.at(0, k), &r.at(0, k) + d + 1);
      break;
    case 6: { // wild waves
      const double size = power_of_ten(random_, -1, 1.5);
      for_each_free_point(
          [&](std::size_t j, std::size_t k) { r.at(j, k) = r.at(j, k) + jitter(size); });
      break;
    }
    case 7: { // an inner row that is one point
      const std::size_t k = l - 1;
      if (k > 0)
        for (std::size_t j = 0; j <= d; ++j)
          r.at(j, k) = a;
      break;
    }
    case 8: // a curve that runs back the way it came, from a corner that is its own neighbour
      move_corner(result_.ribbons[(i + 1) % result_.ribbons.size()], r, a);
      for (std::size_t j = 0; 2 * j < d; ++j)
        r.at(d - j, 0) = r.at(j, 0);
      break;
    default: { // corners that nearly or really coincide
      const double size = chance(random_, 0.3) ? 0 : power_of_ten(random_, -14, -4);
      move_corner(result_.ribbons[(i + 1) % result_.ribbons.size()], r, a + size * (b - a));
    }
    }
  }

  static void move_corner(Raw_ribbon& next, Raw_ribbon& r, const Point_3& p) {
    next.at(0, 0) = r.at(r.degree, 0) = p;
  }

  // Does something for which the loop has to be refused.
  void break_somewhere() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    result_.is_broken = true;
    remark("broken");
    Raw_ribbon& r = any_ribbon();
    Point_3& p = r.points[random_.integer(0, r.points.size() - 1)];
    switch (random_.integer(0, 6)) {
    case 0:
      p = Point_3(p.x(), std::numeric_limits<double>::quiet_NaN(), p.z());
      break;
    case 1:
      p = Point_3(chance(random_, 0.5) ? infinity : -infinity, p.y(), p.z());
      break;
    case 2:
      open_gap(r);
      break;
    case 3:
      result_.ribbons.resize(2, r);
      break;
    case 4:
      collapse(r, p);
      break;
    case 5:
      r.points.pop_back();
      break;
    default:
      r.layers = chance(random_, 0.5) ? 0 : 100;
    }
  }

  // Now the side is a point, or the loop open. But if its corners nearly coincide, and the point
  // with them, then the loop closes within the tolerance of its corners, and by that the side may
  // become a short curve again.
  void collapse(Raw_ribbon& r, Point_3 p) {
    constexpr double tolerance = 1e-8; // more than that of a loop
    const Point_3 a = r.at(0, 0), b = r.at(r.degree, 0);
    const double far = tolerance * size_around(p);
    result_.is_broken = p == b || distance(a, p) > far || distance(b, p) > far;
    for (std::size_t j = 0; j <= r.degree; ++j)
      r.at(j, 0) = p;
  }

  void open_gap(Raw_ribbon& r) {
    const double gap = size_around(r.points[0]) * power_of_ten(random_, -6, 3);
    r.at(0, 0) = r.at(0, 0) + Vector_3(0, gap, 0);
  }

  // The largest difference of coordinates: squares could overflow, or vanish.
  static double distance(const Point_3& p, const Point_3& q) {
    return (std::max)({std::abs(q.x() - p.x()), std::abs(q.y() - p.y()), std::abs(q.z() - p.z())});
  }
  double size_around(const Point_3& p) const {
    double size = 0;
    for (const Raw_ribbon& r : result_.ribbons)
      for (const Point_3& q : r.points)
        size = (std::max)(size, distance(p, q));
    return size;
  }

  Random& random_;
  Raw_loop result_;
  double amplitude_ = 0, frequency_ = 1, phase_ = 0, waviness_ = 0;
};

inline Raw_loop random_raw_loop(Random& random) {
  return Loop_maker(random).make();
}

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_RANDOM_LOOPS_H
