// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_EXAMPLES_MODEL_BUILDER_H
#define MULTISIDED_PATCHES_EXAMPLES_MODEL_BUILDER_H

#include "taylor_series.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_model_3.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/binomial.hpp>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Vector_2 = Kernel::Vector_2;
using Ribbon = MP::Bezier_ribbon_3<Kernel>;
using Loop = MP::Ribbon_loop_3<Kernel>;
using Model = MP::Concave_bezier_model_3<Kernel>;
using MP::Corner_type;

// A smooth surface that a model is cut out of: (x, y) to a point, its normal along x cross y.
using Surface = std::function<std::array<Taylor, 3>(Taylor, Taylor)>;

// A corner of the loop in the (x, y) plane and the side that leaves it. The side starts and ends
// turned away from its chord by the given angles (degrees, positive to the left).
struct Stop {
  double x, y;
  Corner_type corner = Corner_type::convex;
  std::size_t degree = 3, layers = 2;
  double start_turn = 0, end_turn = 0;
  double reach = std::numeric_limits<double>::infinity(); // as in Model_plan, for this side
};

struct Model_plan {
  std::string name, description;
  Surface surface;
  std::vector<Stop> stops; // counterclockwise
  // An upper bound on the derivatives of the sides at their ends, hence also on those across the
  // sides (units of the plane). With 2 layers a third of it is how far row 1 reaches inwards.
  double reach = std::numeric_limits<double>::infinity();
  Vector_2 center = Vector_2(0, 0); // the central control point is the surface point here
  MP::Central_weight central_weight = MP::Central_weight::automatic;
  MP::Domain_generator generator = MP::Domain_generator::similarity;
  double clearance = 0.05;
  bool has_corner_control_points = false; // at reflex corners
};

// Builds the ribbons of a plan. In the plane every ribbon is a strip σ(s,h) = P(s) + h E(s), where
// P is the side and E leads inwards: at a convex corner along the neighbouring side, at a reflex
// corner along its continuation. So the strips of adjacent sides are the same affine map at their
// corner, up to as many derivatives as there are layers less one. The surface takes the strips into
// space, and Bézier rows are fitted to the images.
class Model_builder {
public:
  explicit Model_builder(const Model_plan& plan) : plan_(plan), n_(plan.stops.size()) {}

  Model build() {
    plan_sides();
    for (std::size_t i = 0; i < n_; ++i)
      nets_.push_back(fit_net(i));
    for (std::size_t i = 0; i < n_; ++i)
      join((i + n_ - 1) % n_, i);
    std::vector<Ribbon> ribbons;
    for (std::size_t i = 0; i < n_; ++i)
      ribbons.push_back(make_ribbon(i));
    Model model{Loop(std::move(ribbons), 0)};
    check(model.loop);
    const auto c = plan_.surface(plan_.center.x(), plan_.center.y());
    model.central_point = to_point({c[0].value(), c[1].value(), c[2].value()});
    model.central_weight = plan_.central_weight;
    model.domain.generator = plan_.generator;
    model.domain.clearance = plan_.clearance;
    if (plan_.has_corner_control_points)
      for (const auto& corner : model.default_corner_control_points())
        model.corner_control_points.push_back(
            {corner.index, to_point({corner.point.x(), corner.point.y(), corner.point.z()})});
    return model;
  }

private:
  using Vec3 = Eigen::Vector3d;
  using Net = std::vector<std::vector<Vec3>>; // rows, the boundary first
  struct Side {
    std::size_t layers;
    Vector_2 from, to;
    Vector_2 start_derivative, end_derivative; // of P
    Vector_2 start_cross, end_cross;           // E at the ends
  };

  static Vector_2 rotated(const Vector_2& v, double degrees) {
    const double a = degrees * boost::math::constants::degree<double>();
    return Vector_2(std::cos(a) * v.x() - std::sin(a) * v.y(),
                    std::sin(a) * v.x() + std::cos(a) * v.y());
  }
  static double choose(std::size_t n, std::size_t k) {
    return boost::math::binomial_coefficient<double>(unsigned(n), unsigned(k));
  }
  // Six decimals, and no negative zero, keep the files readable.
  static Vec3 rounded(const Vec3& v) {
    return v.unaryExpr([](double x) { return std::round(x * 1e6) / 1e6 + 0.0; });
  }
  static Point_3 to_point(const Vec3& v) {
    const Vec3 r = rounded(v);
    return Point_3(r[0], r[1], r[2]);
  }
  [[noreturn]] void fail(std::size_t i, const std::string& what) const {
    throw std::logic_error(plan_.name + ", at corner or side " + std::to_string(i) + ": " + what);
  }

  void plan_sides() {
    const auto& stops = plan_.stops;
    for (std::size_t i = 0; i < n_; ++i) {
      const Stop &a = stops[i], &b = stops[(i + 1) % n_];
      const Vector_2 chord(b.x - a.x, b.y - a.y);
      const double factor =
          std::min(1.0, std::min(plan_.reach, a.reach) / std::sqrt(chord.squared_length()));
      sides_.push_back({a.layers,
                        {a.x, a.y},
                        {b.x, b.y},
                        factor * rotated(chord, a.start_turn),
                        factor * rotated(chord, a.end_turn),
                        {},
                        {}});
    }
    for (std::size_t i = 0; i < n_; ++i) {
      Side &in = sides_[(i + n_ - 1) % n_], &out = sides_[i];
      if (stops[i].corner == Corner_type::straight) {
        if (out.start_derivative.squared_length() < in.end_derivative.squared_length())
          in.end_derivative = out.start_derivative;
        else
          out.start_derivative = in.end_derivative;
        in.end_cross = out.start_cross = rotated(out.start_derivative, 90);
      } else {
        const double sign = stops[i].corner == Corner_type::convex ? 1 : -1;
        in.end_cross = sign * out.start_derivative;
        out.start_cross = -sign * in.end_derivative;
      }
    }
  }

  // σ as a Taylor series in s and h around (s0, 0).
  static std::array<Taylor, 2> planar_strip(const Side& side, double s0) {
    const Taylor s = Taylor::s(s0), h = Taylor::h(0);
    const std::size_t layers = side.layers;
    // Hermite polynomials of value and derivative at the ends, cubic or quintic; with the quintic
    // ones the second derivatives are 0 there.
    const Taylor v1 = layers < 3 ? s * s * (3 - 2 * s) : s * s * s * (10 - s * (15 - s * 6));
    const Taylor v0 = 1 - v1;
    const auto slope = [layers](const Taylor& t) {
      return layers < 3 ? t * (1 - t) * (1 - t) : t * (1 - t * t * (6 - t * (8 - t * 3)));
    };
    const Taylor d0 = slope(s), d1 = -slope(1 - s);
    const auto coordinate = [&](int i) {
      return side.from[i] * v0 + side.to[i] * v1 + side.start_derivative[i] * d0 +
             side.end_derivative[i] * d1 + h * (side.start_cross[i] * v0 + side.end_cross[i] * v1);
    };
    return {coordinate(0), coordinate(1)};
  }
  // The same composed with the surface.
  std::array<Taylor, 3> strip(const Side& side, double s0) const {
    const std::array<Taylor, 2> xy = planar_strip(side, s0);
    return plan_.surface(xy[0], xy[1]);
  }
  Vec3 surface_normal(std::size_t i, double s) const {
    const std::array<Taylor, 2> xy = planar_strip(sides_[i], s);
    const auto p = plan_.surface(Taylor::s(xy[0].value()), Taylor::h(xy[1].value()));
    const Vec3 along_x(p[0].at(1, 0), p[1].at(1, 0), p[2].at(1, 0));
    const Vec3 along_y(p[0].at(0, 1), p[1].at(0, 1), p[2].at(0, 1));
    return along_x.cross(along_y).normalized();
  }

  // Row k of a ribbon of cross degree m at s0, with its s-derivatives divided by factorials.
  std::array<Vec3, Taylor::size> row_series(const Side& side, double s0, std::size_t k,
                                            std::size_t m) const {
    const std::array<Taylor, 3> x = strip(side, s0);
    std::array<Vec3, Taylor::size> row;
    for (std::size_t i = 0; i < Taylor::size; ++i) {
      row[i].setZero();
      for (std::size_t j = 0; j <= k; ++j)
        row[i] += choose(k, j) / choose(m, j) * Vec3(x[0].at(i, j), x[1].at(i, j), x[2].at(i, j));
    }
    return row;
  }

  // Rows with the value and as many derivatives at the ends as there are layers, if the degree
  // allows; the points between them by least squares.
  Net fit_net(std::size_t i) const {
    const Side& side = sides_[i];
    const std::size_t d = plan_.stops[i].degree, l = plan_.stops[i].layers;
    const std::size_t fixed = std::min(l, (d + 1) / 2), free = d + 1 - 2 * fixed;
    Net net(l, std::vector<Vec3>(d + 1, Vec3::Zero()));
    for (std::size_t k = 0; k < l; ++k) {
      const auto start = row_series(side, 0, k, 2 * l - 1), end = row_series(side, 1, k, 2 * l - 1);
      for (std::size_t j = 0; j < fixed; ++j)
        for (std::size_t t = 0; t <= j; ++t) {
          net[k][j] += choose(j, t) / choose(d, t) * start[t];
          net[k][d - j] += (t % 2 ? -1 : 1) * choose(j, t) / choose(d, t) * end[t];
        }
      if (free == 0)
        continue;
      const int samples = 24;
      Eigen::MatrixXd a(samples, free), b(samples, 3);
      for (int row = 0; row < samples; ++row) {
        const double s = (row + 0.5) / samples;
        Vec3 rest = row_series(side, s, k, 2 * l - 1)[0];
        for (std::size_t j = 0; j <= d; ++j) {
          const double bernstein = choose(d, j) * std::pow(s, j) * std::pow(1 - s, d - j);
          if (fixed <= j && j < fixed + free)
            a(row, j - fixed) = bernstein;
          else
            rest -= bernstein * net[k][j];
        }
        b.row(row) = rest.transpose();
      }
      const Eigen::MatrixXd x = a.colPivHouseholderQr().solve(b);
      for (std::size_t j = 0; j < free; ++j)
        net[k][fixed + j] = x.row(j).transpose();
    }
    for (auto& row : net)
      for (Vec3& p : row)
        p = rounded(p);
    return net;
  }

  // Makes exact at corner i what the fit gives up to rounding, so far as the nets of side i and of
  // the one before have the control points in common.
  void join(std::size_t before, std::size_t i) {
    Net &in = nets_[before], &out = nets_[i];
    const std::size_t l = out.size(), d = out[0].size() - 1, e = in[0].size() - 1;
    const Vec3 corner = out[0][0];
    if ((in[0][e] - corner).norm() > 1e-5)
      fail(i, "the sides do not meet");
    in[0][e] = corner;
    if (in.size() != l || e != 2 * l - 1 || d != 2 * l - 1)
      return;
    switch (plan_.stops[i].corner) {
    case Corner_type::convex:
      for (std::size_t j = 0; j < l; ++j)
        for (std::size_t k = 0; k < l; ++k)
          share(i, out[k][j], in[j][e - k]);
      break;
    case Corner_type::straight:
      for (std::size_t k = 0; k < l; ++k)
        share(i, out[k][0], in[k][e]);
      share(i, rounded(2 * corner - out[0][1]), in[0][e - 1]);
      break;
    case Corner_type::reflex:
      share(i, rounded(2 * corner - in[0][e - 1]), out[1][0]);
      share(i, rounded(2 * corner - out[0][1]), in[1][e]);
      share(i,
            rounded(corner + (in[1][e] - corner) + (in[0][e - 1] - corner) +
                    (out[1][1] - out[1][0] - out[0][1] + corner)),
            in[1][e - 1]);
      break;
    }
  }
  void share(std::size_t i, const Vec3& from, Vec3& to) const {
    if ((from - to).norm() > 2e-5)
      fail(i, "the ribbons are not compatible");
    to = from;
  }

  Ribbon make_ribbon(std::size_t i) const {
    std::vector<Point_3> points;
    for (const auto& row : nets_[i])
      for (const Vec3& p : row)
        points.push_back(Point_3(p[0], p[1], p[2]));
    return Ribbon(plan_.stops[i].degree, plan_.stops[i].layers, std::move(points));
  }

  void check(const Loop& loop) const {
    const double degree = boost::math::constants::degree<double>();
    for (std::size_t i = 0; i < n_; ++i) {
      if (loop.corner_type(i) != plan_.stops[i].corner)
        fail(i, std::string("the corner is ") + to_string(loop.corner_type(i)));
      if (!(loop.corner_normal_mismatch(i) < 1e-4 * degree))
        fail(i, "the tangent planes differ by " +
                    std::to_string(loop.corner_normal_mismatch(i) / degree) + " degrees");
      for (int k = 0; k <= 32; ++k) {
        const double s = k / 32.0;
        const auto x = strip(sides_[i], s);
        const Vec3 along(x[0].at(1, 0), x[1].at(1, 0), x[2].at(1, 0));
        const Vec3 across(x[0].at(0, 1), x[1].at(0, 1), x[2].at(0, 1));
        const Vec3 planned = along.cross(across).normalized();
        const auto n =
            CGAL::cross_product(loop[i].boundary_derivative(s), loop[i].cross_derivative(s));
        const Vec3 normal(n.x(), n.y(), n.z());
        // Within 10 degrees of the surface, on the right side of it, and far from degenerate.
        if (!(normal.dot(planned) > 0.985 * normal.norm()) ||
            !(planned.dot(surface_normal(i, s)) > 0.999) ||
            !(normal.norm() > 0.2 * along.norm() * across.norm()))
          fail(i, "the ribbon folds or leaves the surface at s = " + std::to_string(s));
      }
    }
  }

  Model_plan plan_;
  std::size_t n_;
  std::vector<Side> sides_;
  std::vector<Net> nets_;
};

#endif // MULTISIDED_PATCHES_EXAMPLES_MODEL_BUILDER_H
