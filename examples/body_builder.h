// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_EXAMPLES_BODY_BUILDER_H
#define MULTISIDED_PATCHES_EXAMPLES_BODY_BUILDER_H

#include "model_builder.h"

#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What makes a body of the unit sphere.
using Deformation = std::function<std::array<Taylor, 3>(const std::array<Taylor, 3>&)>;

struct Body_part {
  std::string name;
  std::vector<std::size_t> loop; // its vertices, counterclockwise seen from outside
};

// A closed body whose parts meet along curves. From the number of its neighbours follows what a
// vertex is:
//   2, a bend     a curve turns: one of its two parts has a reflex corner there, the other a convex
//   3, a fork     three curves, at convex corners
//   3, a junction a curve ends on another one, which goes on: one part has a straight corner there
//   4, a crossing two curves, at convex corners
// Three curves make a junction if two of them leave within 20 degrees of opposite directions.
struct Body_plan {
  std::string name, description;
  Deformation deformation;
  std::vector<std::array<double, 2>> vertices; // longitude and latitude on the sphere, in degrees
  std::vector<Body_part> parts;
};

// Builds parts whose ribbons meet with common tangent planes, exactly but for the rounding of
// control points. Everything is of degree 3 and has 2 layers. Let T be the derivative of a curve
// and E and F the cross-derivatives of the ribbons on its left and right. They satisfy
//
//   E(s) + F(s) = β(s) T(s),  β linear, so that the right side has degree 3 as the left has,
//
// where β is -1 at a start at a fork, 1 at an end at a fork, and 0 elsewhere. For this to fit what
// corners ask of E and F, that they be the derivatives of the adjacent curves, it suffices
//   - that the derivatives of the three curves of a fork have the sum 0;
//   - that a curve goes through crossings and junctions without change of its derivative.
// Forks find their places on the sphere as if the curves were springs: where forces balance, the
// sum is 0 by itself. At a bend the ribbons of the part with the reflex corner continue the curves,
// so that β = 0 suits both parts. The derivatives of E and F at corners are the twists of the parts
// there. At forks the condition determines them, elsewhere it leaves the choice of one, which is
// taken from the body.
class Body_builder {
public:
  explicit Body_builder(const Body_plan& plan)
      : plan_(plan), neighbours_(plan.vertices.size()), kinds_(plan.vertices.size()) {}

  // The models of the parts, in order.
  std::vector<Model> build() {
    for (const auto& [longitude, latitude] : plan_.vertices) {
      const double l = longitude * degree, b = latitude * degree;
      places_.push_back({std::cos(b) * std::cos(l), std::cos(b) * std::sin(l), std::sin(b)});
    }
    find_neighbours();
    for (std::size_t v = 0; v < places_.size(); ++v)
      kinds_[v] = kind_of(v);
    place_forks();
    for (std::size_t v = 0; v < places_.size(); ++v)
      plan_derivatives(v);
    for (std::size_t v = 0; v < places_.size(); ++v)
      plan_twists(v);
    std::vector<Model> models;
    for (const Body_part& part : plan_.parts)
      models.push_back(make_model(part));
    return models;
  }

private:
  using Vec3 = Eigen::Vector3d;
  enum class Kind { bend, fork, junction, crossing };
  using Edge = std::pair<std::size_t, std::size_t>; // seen from the first of its vertices
  static constexpr double degree = boost::math::constants::degree<double>();

  [[noreturn]] void fail(std::size_t v, const std::string& what) const {
    throw std::logic_error(plan_.name + ", at vertex " + std::to_string(v) + ": " + what);
  }
  // Six decimals, as in all models.
  static Vec3 rounded(const Vec3& v) {
    return v.unaryExpr([](double x) { return std::round(x * 1e6) / 1e6 + 0.0; });
  }

  // Sorts the neighbours of every vertex counterclockwise. At a corner of a part the one before
  // follows the one after.
  void find_neighbours() {
    for (const Body_part& part : plan_.parts)
      for (std::size_t i = 0, n = part.loop.size(); i < n; ++i) {
        const std::size_t before = part.loop[(i + n - 1) % n], v = part.loop[i];
        if (!following_.insert({{v, part.loop[(i + 1) % n]}, before}).second)
          fail(v, "two parts are on the same side of a curve");
      }
    for (const auto& [edge, following] : following_) {
      const auto& [v, first] = edge;
      if (!neighbours_[v].empty())
        continue;
      std::size_t w = first;
      do {
        neighbours_[v].push_back(w);
        if (following_.count({v, w}) == 0)
          fail(v, "the body is not closed");
        w = following_.at({v, w});
      } while (w != first);
    }
  }

  // The derivative at v of the curve to w, for the arc of a great circle and the speed at which a
  // cubic curve follows it best.
  Vec3 arc_derivative(std::size_t v, std::size_t w) const {
    const Vec3 &a = places_[v], &b = places_[w];
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    return 4 * std::tan(angle / 4) * (b - a.dot(b) * a).normalized();
  }

  // Brings the curve that goes through a junction to the front.
  Kind kind_of(std::size_t v) {
    auto& around = neighbours_[v];
    if (around.size() == 2)
      return Kind::bend;
    if (around.size() == 4)
      return Kind::crossing;
    if (around.size() != 3)
      fail(v, "the number of curves is not 2, 3 or 4");
    for (int turn = 0; turn < 3; ++turn) {
      const Vec3 a = arc_derivative(v, around[0]), b = arc_derivative(v, around[1]);
      if (a.dot(b) < -std::cos(20 * degree) * a.norm() * b.norm())
        return Kind::junction;
      std::rotate(around.begin(), around.begin() + 1, around.end());
    }
    return Kind::fork;
  }

  void place_forks() {
    for (int step = 0; step < 200; ++step)
      for (std::size_t v = 0; v < places_.size(); ++v)
        if (kinds_[v] == Kind::fork) {
          Vec3 force = Vec3::Zero();
          for (const std::size_t w : neighbours_[v])
            force += arc_derivative(v, w);
          places_[v] = (places_[v] + 0.25 * force).normalized();
        }
  }

  // The body around a place on the sphere, in the directions a and b there: the point and its
  // derivatives along a, along b and along both.
  std::array<Vec3, 4> expand(const Vec3& place, const Vec3& a, const Vec3& b) const {
    std::array<Taylor, 3> x;
    Taylor squared_length;
    for (int i = 0; i < 3; ++i) {
      x[i] = place[i] + a[i] * Taylor::s(0) + b[i] * Taylor::h(0);
      squared_length = squared_length + x[i] * x[i];
    }
    for (Taylor& coordinate : x)
      coordinate = coordinate / sqrt(squared_length);
    x = plan_.deformation(x);
    const auto term = [&x](std::size_t i, std::size_t j) {
      return Vec3(x[0].at(i, j), x[1].at(i, j), x[2].at(i, j));
    };
    return {term(0, 0), term(1, 0), term(0, 1), term(1, 1)};
  }

  // The points of the vertices, and the control points next to them as vectors from there. Their
  // sums are made to vanish once they are rounded.
  void plan_derivatives(std::size_t v) {
    const auto& around = neighbours_[v];
    std::vector<Vec3> arcs, vectors;
    for (const std::size_t w : around)
      arcs.push_back(arc_derivative(v, w) / 3);
    const auto join = [&arcs](std::size_t i, std::size_t j) {
      arcs[i] = (arcs[i] - arcs[j]) / 2;
      arcs[j] = -arcs[i];
    };
    if (kinds_[v] == Kind::junction || kinds_[v] == Kind::crossing)
      join(0, kinds_[v] == Kind::junction ? 1 : 2);
    if (kinds_[v] == Kind::crossing)
      join(1, 3);
    for (const Vec3& arc : arcs)
      vectors.push_back(rounded(expand(places_[v], arc, arc)[1]));
    if (kinds_[v] == Kind::fork)
      vectors[2] = -(vectors[0] + vectors[1]);
    points_.push_back(rounded(expand(places_[v], arcs[0], arcs[1])[0]));
    for (std::size_t i = 0; i < around.size(); ++i) {
      arcs_[{v, around[i]}] = arcs[i];
      vectors_[{v, around[i]}] = vectors[i];
    }
  }

  // β at the start of a curve from v.
  double beta(std::size_t v) const { return kinds_[v] == Kind::fork ? -1 : 0; }

  // A third of the Bézier coefficients of β T along the curve from v to w: what the vectors from
  // row 0 to row 1 on its two sides have as their sum.
  std::array<Vec3, 4> sums_across(std::size_t v, std::size_t w) const {
    const Vec3 &start = vectors_.at({v, w}), end = -vectors_.at({w, v});
    const Vec3 middle = points_[w] - end - points_[v] - start;
    const double b0 = beta(v), b1 = -beta(w);
    return {b0 * start, (b1 * start + 2 * b0 * middle) / 3, (2 * b1 * middle + b0 * end) / 3,
            b1 * end};
  }

  // A ninth of the mixed derivative of the part between the curves from v to w and to the neighbour
  // after w.
  void plan_twists(std::size_t v) {
    const auto& around = neighbours_[v];
    const std::size_t n = around.size();
    const auto vector = [&](std::size_t i) { return vectors_.at({v, around[i % n]}); };
    const auto sum = [&](std::size_t i) -> Vec3 { return sums_across(v, around[i % n])[1]; };
    if (kinds_[v] == Kind::crossing && (sum(0) + sum(2)).norm() + (sum(1) + sum(3)).norm() > 1e-5)
      fail(v, "of two opposite curves only one ends at a fork");
    for (std::size_t i = 0; i < n; ++i) {
      Vec3 twist;
      if (kinds_[v] == Kind::fork) {
        twist = (sum(i) + sum(i + 1) - sum(i + 2) + vector(i) + vector(i + 1) - vector(i + 2)) / 2;
      } else {
        const Vec3 &a = arcs_.at({v, around[i]}), &b = arcs_.at({v, around[(i + 1) % n]});
        twist = expand(places_[v], a, b)[3] + (sum(i) + sum(i + 1)) / 2;
      }
      inner_points_[{v, around[i]}] = rounded(points_[v] + vector(i) + vector(i + 1) + twist);
    }
  }

  // Whether the part between the curves from v to w and to the neighbour after w has a convex
  // corner there.
  bool is_convex(std::size_t v, std::size_t w) const {
    if (kinds_[v] == Kind::junction)
      return w != neighbours_[v][0];
    if (kinds_[v] != Kind::bend)
      return true;
    const Vec3 &a = arcs_.at({v, w}), &b = arcs_.at({v, following_.at({v, w})});
    return a.cross(b).dot(places_[v]) > 0;
  }

  // The first two vectors from row 0 to row 1, on the left of the curve from v to w.
  std::array<Vec3, 2> start_on_left(std::size_t v, std::size_t w) const {
    if (is_convex(v, w))
      return {vectors_.at({v, following_.at({v, w})}),
              inner_points_.at({v, w}) - points_[v] - vectors_.at({v, w})};
    return complement(v, w, start_on_right(v, w));
  }
  std::array<Vec3, 2> start_on_right(std::size_t v, std::size_t w) const {
    const auto& around = neighbours_[v];
    const std::size_t i = std::find(around.begin(), around.end(), w) - around.begin();
    const std::size_t before = around[(i + around.size() - 1) % around.size()];
    if (is_convex(v, before))
      return {vectors_.at({v, before}),
              inner_points_.at({v, before}) - points_[v] - vectors_.at({v, w})};
    return complement(v, w, start_on_left(v, w));
  }
  std::array<Vec3, 2> complement(std::size_t v, std::size_t w,
                                 const std::array<Vec3, 2>& other) const {
    const auto sums = sums_across(v, w);
    return {sums[0] - other[0], sums[1] - other[1]};
  }

  Ribbon make_ribbon(std::size_t v, std::size_t w) const {
    const std::array<Vec3, 4> row{points_[v], points_[v] + vectors_.at({v, w}),
                                  points_[w] + vectors_.at({w, v}), points_[w]};
    const auto start = start_on_left(v, w), end = start_on_right(w, v);
    const std::array<Vec3, 4> across{start[0], start[1], end[1], end[0]};
    std::vector<Point_3> points;
    const auto add = [&points](const Vec3& p) {
      const Vec3 r = rounded(p);
      points.push_back(Point_3(r[0], r[1], r[2]));
    };
    for (const Vec3& p : row)
      add(p);
    for (std::size_t j = 0; j < 4; ++j)
      add(row[j] + across[j]);
    return Ribbon(3, 2, std::move(points));
  }

  Model make_model(const Body_part& part) const {
    std::vector<Ribbon> ribbons;
    const std::size_t n = part.loop.size();
    for (std::size_t i = 0; i < n; ++i)
      ribbons.push_back(make_ribbon(part.loop[i], part.loop[(i + 1) % n]));
    Model model{Loop(std::move(ribbons), 0)};
    for (std::size_t i = 0; i < n; ++i)
      if (!(model.loop.corner_normal_mismatch(i) < 1e-4 * degree))
        fail(part.loop[i], "the tangent planes of " + part.name + " differ");
    model.central_weight = MP::Central_weight::adjacent_products;
    model.domain.clearance = 0.1;
    Vec3 middle = Vec3::Zero();
    for (const std::size_t v : part.loop)
      middle += places_[v];
    fit_central_point(model, middle.normalized());
    return model;
  }

  // Without it, parts would be flat far from their sides. As the patch depends linearly on its
  // central control point, that is found by least squares of the distances from the body.
  void fit_central_point(Model& model, const Vec3& middle) const {
    const Point_3 start = model.default_central_point();
    model.central_point = start;
    const MP::Concave_bezier_patch_3<Kernel> patch(model);
    model.central_point = start + Kernel::Vector_3(1, 0, 0);
    const MP::Concave_bezier_patch_3<Kernel> moved(model, patch.coordinates());
    Vec3 sum = Vec3::Zero();
    double squares = 0;
    const auto box = patch.domain().bbox();
    const int steps = 16;
    for (int i = 1; i < steps; ++i)
      for (int j = 1; j < steps; ++j) {
        const Kernel::Point_2 uv(box.xmin() + i * (box.xmax() - box.xmin()) / steps,
                                 box.ymin() + j * (box.ymax() - box.ymin()) / steps);
        const auto location = patch.domain().locate(uv);
        if (location.kind != MP::Domain_location<double>::Kind::interior)
          continue;
        const Point_3 p = patch.point(uv, location);
        const double weight = moved.point(uv, location).x() - p.x();
        sum += weight * (closest_point({p.x(), p.y(), p.z()}, middle) - Vec3(p.x(), p.y(), p.z()));
        squares += weight * weight;
      }
    const Vec3 center = rounded(Vec3(start.x(), start.y(), start.z()) + sum / squares);
    model.central_point = Point_3(center[0], center[1], center[2]);
  }
  // The point of the body closest to p, by the method of Gauss and Newton from a place nearby.
  Vec3 closest_point(const Vec3& p, Vec3 place) const {
    for (int step = 0; step < 12; ++step) {
      const Vec3 a = place.unitOrthogonal(), b = place.cross(a);
      const auto [point, along_a, along_b, twist] = expand(place, a, b);
      Eigen::Matrix<double, 3, 2> derivative;
      derivative << along_a, along_b;
      Eigen::Vector2d move = derivative.colPivHouseholderQr().solve(p - point);
      move *= std::min(1.0, 0.3 / move.norm());
      place = (place + move[0] * a + move[1] * b).normalized();
    }
    return expand(place, Vec3::Zero(), Vec3::Zero())[0];
  }

  const Body_plan plan_;
  std::vector<std::vector<std::size_t>> neighbours_; // of every vertex, counterclockwise
  std::map<Edge, std::size_t> following_;            // (v,w): the neighbour of v after w
  std::vector<Kind> kinds_;
  std::vector<Vec3> places_, points_;   // of the vertices, on the sphere and on the body
  std::map<Edge, Vec3> arcs_, vectors_; // from v to the next control point towards w, likewise
  std::map<Edge, Vec3> inner_points_;   // the control point that two ribbons share at a corner
};

#endif // MULTISIDED_PATCHES_EXAMPLES_BODY_BUILDER_H
