// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_LIGHTNING_COORDINATES_H
#define MULTISIDED_PATCHES_TEST_LIGHTNING_COORDINATES_H

#include "fixtures.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

/*
 * Harmonic coordinates once more, by a method that has nothing in common with that of the library:
 * global approximation by a "lightning solver" (Gopal and Trefethen, "Solving Laplace problems with
 * corner singularities via rational functions", SIAM J. Numer. Anal. 57, 2019).
 *
 * Every coordinate is a combination of real and imaginary parts of functions that are analytic in
 * the domain: powers z^(j/a) at corners of angle a pi, poles that cluster exponentially at the
 * corners, more poles on the medial axis of the outside, polynomials, and logarithms and
 * polynomials in 1/(z - c) for points c in holes. The coefficients fit the boundary values in the
 * least-squares sense. As such functions are harmonic, no error inside is larger than the largest
 * on the boundary, and that can be measured.
 */
namespace fixtures {
namespace lightning {

using Complex = std::complex<double>;

// A point, as an offset from the nearest vertex: close to it, no digit is lost.
struct Place {
  std::size_t vertex;
  Complex offset;
};

struct Boundary_point {
  Place place;
  std::size_t side;
  double s; // the parameter on the side
};

inline Eigen::Index index(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

// A domain in complex numbers, scaled to about unit size by a power of two, which is exact.
class Polygon {
public:
  explicit Polygon(const Domain& domain)
      : domain_(domain), scale_(std::ldexp(1., -std::ilogb(domain.diameter()))) {
    for (const Point_2& p : domain.vertices())
      vertices_.push_back(scale_ * Complex(p.x(), p.y()));
  }

  const Domain& domain() const { return domain_; }
  std::size_t size() const { return vertices_.size(); }
  double diameter() const { return scale_ * domain_.diameter(); }
  Complex vertex(std::size_t k) const { return vertices_[k]; }
  Complex side(std::size_t k) const { return vertex(domain_.next(k)) - vertex(k); }
  Complex exterior_normal(std::size_t k) const {
    return Complex(0, -1) * side(k) / std::abs(side(k));
  }
  // the interior angle at a vertex over pi
  double angle(std::size_t k) const {
    const double a = std::arg(-side(domain_.prev(k)) / side(k)) / MP::internal::pi;
    return a > 0 ? a : a + 2;
  }
  // By reflection, solutions are analytic at a corner of pi/2, pi/3...
  bool is_regular(std::size_t k) const {
    const double power = 1 / angle(k);
    return power > 1.5 && std::abs(power - std::round(power)) < 1e-12;
  }
  // The way along the exterior bisector of a corner that its poles may use.
  Complex reach(std::size_t k) const {
    const Complex bisector =
        -side(k) / std::abs(side(k)) * std::polar(1., angle(k) * MP::internal::pi / 2);
    const double sides = (std::max)(std::abs(side(k)), std::abs(side(domain_.prev(k))));
    return (std::min)(sides, 0.6 * free_distance(k, bisector)) * bisector;
  }
  bool is_outside(Complex z) const {
    return domain_.locate({z.real() / scale_, z.imag() / scale_}).kind ==
           Domain::Location::Kind::outside;
  }

  Complex at(const Place& p) const { return vertex(p.vertex) + p.offset; }
  Complex difference(const Place& p, std::size_t k) const {
    return (vertex(p.vertex) - vertex(k)) + p.offset;
  }
  Place place(const Point_2& p) const {
    const auto offset = [&](std::size_t k) {
      return scale_ * Complex(p.x() - domain_.vertex(k).x(), p.y() - domain_.vertex(k).y());
    };
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < size(); ++k)
      if (std::abs(offset(k)) < std::abs(offset(nearest)))
        nearest = k;
    return {nearest, offset(nearest)};
  }
  Boundary_point before_target(std::size_t k, double rest) const {
    return {{domain_.next(k), -rest * side(k)}, k, 1 - rest};
  }
  Boundary_point on_side(std::size_t k, double s) const {
    return s <= 0.5 ? Boundary_point{{k, s * side(k)}, k, s} : before_target(k, 1 - s);
  }
  Complex nearest_on_boundary(Complex z) const {
    Complex nearest = vertex(0);
    for (std::size_t k = 0; k < size(); ++k) {
      const double s = ((z - vertex(k)) / side(k)).real();
      const Complex foot = vertex(k) + (std::min)(1., (std::max)(0., s)) * side(k);
      if (std::abs(z - foot) < std::abs(z - nearest))
        nearest = foot;
    }
    return nearest;
  }

private:
  // how far one can go from a vertex before meeting a side it does not belong to
  double free_distance(std::size_t k, Complex direction) const {
    double distance = diameter();
    for (std::size_t i = 0; i < size(); ++i) {
      if (i == k || i == domain_.prev(k))
        continue;
      const Complex a = (vertex(i) - vertex(k)) / direction, d = side(i) / direction;
      const double s = -a.imag() / d.imag(), t = a.real() + s * d.real();
      if (s >= 0 && s <= 1 && t > 0)
        distance = (std::min)(distance, t);
    }
    return distance;
  }

  Domain domain_;
  double scale_;
  std::vector<Complex> vertices_;
};

// A circle that touches a side from outside.
struct Circle {
  Complex centre;
  double radius;
  std::size_t side;
  bool in_use; // neither inside by rounding, nor so close to a corner that this has its own poles
};

// The largest circle that touches the boundary in a given point and does not cross it (its centre
// is on the medial axis), but no larger than the distance of the nearest singular corner: up to
// there, by reflection, the solution is analytic. Found by shrinking (Ma, Bae and Choi 2012).
inline Circle exterior_circle(const Polygon& polygon, const Boundary_point& b, Complex normal) {
  const Complex p = polygon.at(b.place);
  double radius = polygon.diameter();
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (!polygon.is_regular(k))
      radius = (std::min)(radius, std::abs(polygon.difference(b.place, k)));
  Complex q = polygon.nearest_on_boundary(p + radius * normal);
  for (int step = 0; step < 100 && std::abs(p + radius * normal - q) < (1 - 1e-6) * radius;
       ++step) {
    radius = std::norm(q - p) / (2 * (std::conj(q - p) * normal).real());
    q = polygon.nearest_on_boundary(p + radius * normal);
  }
  const bool left_to_corner =
      !polygon.is_regular(b.place.vertex) &&
      std::abs(b.place.offset) < 0.15 * std::abs(polygon.reach(b.place.vertex));
  const Complex centre = p + radius * normal;
  return {centre, radius, b.side, !left_to_corner && polygon.is_outside(centre)};
}

// Adds circles between two others, by bisection, until their centres are close to each other.
template <typename Circle_at>
void add_circles(const Circle_at& circle_at, double t0, const Circle& c0, double t1,
                 const Circle& c1, double spacing, std::vector<Circle>& circles) {
  const bool close = std::abs(c0.centre - c1.centre) <= spacing * (std::min)(c0.radius, c1.radius);
  const bool unused = !c0.in_use && !c1.in_use;
  if (t1 - t0 < 1e-3 || (t1 - t0 < 0.5 && (close || unused)))
    return;
  const double t = (t0 + t1) / 2;
  const Circle c = circle_at(t);
  add_circles(circle_at, t0, c0, t, c, spacing, circles);
  circles.push_back(c);
  add_circles(circle_at, t, c, t1, c1, spacing, circles);
}

// Those in use whose centres are not too close to each other.
inline std::vector<Circle> thinned(const std::vector<Circle>& circles, double spacing) {
  std::vector<Circle> kept;
  for (const Circle& c : circles)
    if (c.in_use && std::none_of(kept.begin(), kept.end(), [&](const Circle& other) {
          return std::abs(c.centre - other.centre) < spacing * (std::min)(c.radius, other.radius);
        }))
      kept.push_back(c);
  return kept;
}

// Circles along the boundary, and around the corners where the solution is regular. (Others have
// poles of their own.) `spacing` is in units of the radius.
inline std::vector<Circle> exterior_circles(const Polygon& polygon, double spacing) {
  std::vector<Circle> circles;
  const auto add = [&](const auto& circle_at) {
    circles.push_back(circle_at(0));
    const Circle first = circles.back();
    add_circles(circle_at, 0, first, 1, circle_at(1), spacing, circles);
  };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Complex normal = polygon.exterior_normal(k);
    const double turn = MP::internal::pi * (1 - polygon.angle(k));
    if (polygon.is_regular(k))
      add([&](double t) {
        return exterior_circle(polygon, polygon.on_side(k, 0),
                               normal * std::polar(1., (t - 1) * turn));
      });
    add([&](double t) { return exterior_circle(polygon, polygon.on_side(k, t), normal); });
  }
  return thinned(circles, 0.6 * spacing);
}

inline Complex expm1(Complex z) {
  const double half = std::sin(z.imag() / 2);
  return {std::expm1(z.real()) * std::cos(z.imag()) - 2 * half * half,
          std::exp(z.real()) * std::sin(z.imag())};
}

// w^exponent for w = z / (z - end), whose cut is the segment from the corner 0 to `end`. If the
// exponent is almost an integer m, (w^exponent - w^m) / (exponent - m), in the limit w^m log w.
struct Corner_power {
  std::size_t vertex;
  Complex end;
  double exponent;

  Complex operator()(Complex z) const {
    if (z == 0.)
      return 0;
    const Complex log_w = std::log(z / (z - end));
    const double m = std::round(exponent), e = exponent - m;
    if (std::abs(e) > 0.1)
      return std::exp(exponent * log_w);
    return std::exp(m * log_w) * (e == 0 ? log_w : expm1(e * log_w) / e);
  }
};

struct Pole {
  Place place;
  double size; // of the neighbourhood it is responsible for
  double step; // between points of the boundary that see it well, if it is near
  int steps;   // how many points, on either side
};

// What is singular at a vertex: the powers j/a + m (j from reflection, m from the map to w) below
// `max_power` exactly, what is left of higher ones by poles.
class Corner {
public:
  Corner(const Polygon& polygon, std::size_t k)
      : vertex_(k), regular_(polygon.is_regular(k)), angle_(polygon.angle(k)),
        end_(polygon.reach(k)) {}

  double poles_for_error(double error) const {
    const double root = std::log(1 / error) / (clustering() * first_power_left());
    return regular_ ? 0 : root * root / 2 + 5;
  }
  std::vector<Corner_power> powers() const {
    std::vector<Corner_power> powers;
    for (double j = 1 / angle_; j < max_power && !regular_; j += 1 / angle_)
      for (double e = j; e < max_power; e += 1)
        if (std::none_of(powers.begin(), powers.end(), [&](const Corner_power& other) {
              return std::abs(e - other.exponent) < 1e-4;
            }))
          powers.push_back({vertex_, end_, e});
    return powers;
  }
  // exponentially close to the vertex, but the closer the sparser
  std::vector<Pole> poles(double count) const {
    const double n = regular_ ? 0 : std::floor(count);
    const double sigma = (std::min)(clustering(), 29 / std::sqrt(n));
    std::vector<Pole> poles;
    for (double j = 1; j <= n; ++j) {
      const Complex offset = std::exp(sigma * (std::sqrt(j) - std::sqrt(n))) * end_;
      const double r = std::abs(offset);
      poles.push_back({{vertex_, offset}, r, 0.3 * r, 3});
    }
    return poles;
  }

private:
  static constexpr double max_power = 5.1;

  double first_power_left() const { return (std::max)(1 / angle_, max_power); }
  double clustering() const {
    return MP::internal::pi * std::sqrt(2 * (std::max)(0.1, 2 - angle_) / first_power_left());
  }

  std::size_t vertex_;
  bool regular_;
  double angle_;
  Complex end_;
};

// Polynomials that are orthonormal over given points ("Vandermonde with Arnoldi"): powers would
// be as good as linearly dependent.
class Orthonormal_polynomials {
public:
  Orthonormal_polynomials(const Eigen::VectorXcd& points, Eigen::Index degree)
      : hessenberg_(Eigen::MatrixXcd::Zero(degree + 1, degree)) {
    const double count = static_cast<double>(points.size());
    Eigen::MatrixXcd q = Eigen::MatrixXcd::Ones(points.size(), degree + 1);
    for (Eigen::Index k = 0; k < degree; ++k) {
      q.col(k + 1) = points.cwiseProduct(q.col(k));
      for (int pass = 0; pass < 2; ++pass)
        for (Eigen::Index j = 0; j <= k; ++j) {
          const Complex h = q.col(j).dot(q.col(k + 1)) / count;
          hessenberg_(j, k) += h;
          q.col(k + 1) -= h * q.col(j);
        }
      hessenberg_(k + 1, k) = q.col(k + 1).norm() / std::sqrt(count);
      q.col(k + 1) /= hessenberg_(k + 1, k);
    }
  }

  Eigen::VectorXcd operator()(Complex z) const {
    Eigen::VectorXcd q = Eigen::VectorXcd::Ones(hessenberg_.rows());
    for (Eigen::Index k = 0; k < hessenberg_.cols(); ++k) {
      const Complex lower = (hessenberg_.col(k).head(k + 1).array() * q.head(k + 1).array()).sum();
      q[k + 1] = (z * q[k] - lower) / hessenberg_(k + 1, k);
    }
    return q;
  }

private:
  Eigen::MatrixXcd hessenberg_;
};

// The functions whose real and imaginary parts are combined.
struct Basis {
  std::vector<Corner_power> powers;
  std::vector<Pole> poles;
  std::vector<Complex> hole_centres;
  std::vector<Orthonormal_polynomials> polynomials; // in z and in 1/(z - c) for each hole

  Complex variable(std::size_t i, Complex z) const {
    return i == 0 ? z : 1. / (z - hole_centres[i - 1]);
  }
  void set_polynomials(const Polygon& polygon, const std::vector<Boundary_point>& points,
                       Eigen::Index degree) {
    for (std::size_t i = 0; i <= hole_centres.size(); ++i) {
      Eigen::VectorXcd t(index(points.size()));
      for (std::size_t k = 0; k < points.size(); ++k)
        t[index(k)] = variable(i, polygon.at(points[k].place));
      polynomials.emplace_back(t, degree);
    }
  }

  Eigen::VectorXd evaluate(const Polygon& polygon, const Place& p) const {
    std::vector<double> parts{1};
    const auto add = [&](Complex f) { parts.insert(parts.end(), {f.real(), f.imag()}); };
    for (const Corner_power& f : powers)
      add(f(polygon.difference(p, f.vertex)));
    for (const Pole& pole : poles)
      add(pole.size / (polygon.difference(p, pole.place.vertex) - pole.place.offset));
    for (std::size_t i = 0; i < polynomials.size(); ++i) {
      const Complex t = variable(i, polygon.at(p));
      const Eigen::VectorXcd q = polynomials[i](t);
      std::for_each(q.data() + 1, q.data() + q.size(), add);
      if (i > 0)
        parts.push_back(std::log(std::abs(t)));
    }
    return Eigen::Map<const Eigen::VectorXd>(parts.data(), index(parts.size()));
  }
  Eigen::MatrixXd matrix(const Polygon& polygon, const std::vector<Boundary_point>& points) const {
    Eigen::MatrixXd a;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::VectorXd row = evaluate(polygon, points[i].place);
      if (i == 0)
        a.resize(index(points.size()), row.size());
      a.row(index(i)) = row.transpose();
    }
    return a;
  }
};

// Least squares with columns of unit length, in place.
inline Eigen::MatrixXd solve(Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::VectorXd scales = a.colwise().norm().cwiseInverse();
  a *= scales.asDiagonal();
  const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(a);
  return scales.asDiagonal() * Eigen::MatrixXd(qr.solve(b));
}

} // namespace lightning

class Lightning_coordinates {
public:
  // Tries to keep all errors below `target_error`; `error_bound()` tells whether this worked. No
  // second attempt is made with more than `max_functions`, which take seconds if there are 1500.
  Lightning_coordinates(const Domain& domain, double target_error,
                        Eigen::Index max_functions = 2000)
      : polygon_(domain), spacing_(-5 / std::log(target_error)) {
    for (std::size_t k = 0; k < domain.size(); ++k) {
      corners_.emplace_back(polygon_, k);
      poles_.push_back(corners_[k].poles_for_error(target_error));
    }
    constexpr int max_rounds = 8;
    for (int round = 0; round < max_rounds && !(error_bound_ <= target_error); ++round)
      if (!improve(target_error, max_functions))
        break;
  }

  // Twice the largest error of any coordinate that was measured on the boundary. By the maximum
  // principle, it holds inside, too.
  double error_bound() const { return error_bound_; }

  // all coordinates of a point inside
  std::vector<double> operator()(const Point_2& p) const {
    const Eigen::VectorXd values =
        coefficients_.transpose() * basis_.evaluate(polygon_, polygon_.place(p));
    return std::vector<double>(values.data(), values.data() + values.size());
  }

private:
  static Eigen::Index index(std::size_t i) { return lightning::index(i); }
  using Circles = std::vector<lightning::Circle>;
  using Boundary_points = std::vector<lightning::Boundary_point>;

  lightning::Basis make_basis(const Circles& circles) const {
    lightning::Basis basis;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const auto powers = corners_[k].powers();
      const auto poles = corners_[k].poles(poles_[k]);
      basis.powers.insert(basis.powers.end(), powers.begin(), powers.end());
      basis.poles.insert(basis.poles.end(), poles.begin(), poles.end());
    }
    for (const lightning::Circle& c : circles)
      basis.poles.push_back(
          {{0, c.centre - polygon_.vertex(0)}, c.radius, 0.3 * spacing_ * c.radius, 1});
    const Domain& domain = polygon_.domain();
    for (std::size_t loop = 1; loop < domain.number_of_loops(); ++loop)
      basis.hole_centres.push_back(
          largest_circle(circles, domain.loop_begin(loop), domain.loop_begin(loop + 1)).centre);
    return basis;
  }
  static lightning::Circle largest_circle(const Circles& circles, std::size_t first_side,
                                          std::size_t end_side) {
    lightning::Circle largest{0, 0, 0, false};
    for (const lightning::Circle& c : circles)
      if (first_side <= c.side && c.side < end_side && c.radius > largest.radius)
        largest = c;
    if (largest.radius == 0)
      throw std::runtime_error("no circle found in a hole");
    return largest;
  }

  // Points on the boundary, as dense as the functions vary: exponentially close to corners,
  // Chebyshev points for the polynomials, and some where the circles touch.
  Boundary_points sample(const std::vector<lightning::Pole>& poles, double density,
                         double closest) const {
    Boundary_points points;
    for (std::size_t k = 0; k < polygon_.size(); ++k) {
      points.push_back(polygon_.on_side(k, 0));
      for (double r = 0.5; r > closest; r *= std::exp(-0.25 / density)) {
        points.push_back(polygon_.on_side(k, r));
        points.push_back(polygon_.before_target(k, r));
      }
      const double count = std::ceil(3 * density * degree_);
      for (double j = 0.5; j < count; ++j)
        points.push_back(polygon_.on_side(k, 0.5 - 0.5 * std::cos(MP::internal::pi * j / count)));
      for (const lightning::Pole& pole : poles)
        add_near(pole, k, density, points);
    }
    return points;
  }

  // Points on a side around the foot of a pole, if that is not far.
  void add_near(const lightning::Pole& pole, std::size_t side, double density,
                Boundary_points& points) const {
    const double length = std::abs(polygon_.side(side));
    const lightning::Complex foot = polygon_.difference(pole.place, side) / polygon_.side(side);
    const double steps = std::ceil(density * pole.steps), step = pole.step / density / length;
    for (double j = -steps; j <= steps && std::abs(foot.imag()) * length < 1.5 * pole.size; ++j)
      if (const double s = foot.real() + j * step; s > 0 && s < 1)
        points.push_back(polygon_.on_side(side, s));
  }

  // the coordinates of a point on the boundary
  Eigen::VectorXd hat_functions(const lightning::Boundary_point& p) const {
    Eigen::VectorXd hats = Eigen::VectorXd::Zero(index(polygon_.size()));
    hats[index(p.side)] = 1 - p.s;
    hats[index(polygon_.domain().next(p.side))] = p.s;
    return hats;
  }
  Eigen::MatrixXd hat_functions(const Boundary_points& points) const {
    Eigen::MatrixXd hats(index(points.size()), index(polygon_.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      hats.row(index(i)) = hat_functions(points[i]).transpose();
    return hats;
  }
  std::vector<double> errors(const lightning::Basis& basis, const Eigen::MatrixXd& coefficients,
                             const Boundary_points& points) const {
    std::vector<double> errors;
    for (const lightning::Boundary_point& p : points)
      errors.push_back(
          (coefficients.transpose() * basis.evaluate(polygon_, p.place) - hat_functions(p))
              .lpNorm<Eigen::Infinity>());
    return errors;
  }

  // Fits with the present numbers of functions, then asks for more where the error is too large.
  // Returns whether there is a point in going on.
  bool improve(double target_error, Eigen::Index max_functions) {
    lightning::Basis basis = make_basis(lightning::exterior_circles(polygon_, spacing_));
    const Boundary_points fitted = sample(basis.poles, 1, 1e-11);
    basis.set_polynomials(polygon_, fitted, Eigen::Index(degree_));
    Eigen::MatrixXd a = basis.matrix(polygon_, fitted);
    if (a.cols() > max_functions && coefficients_.size() > 0)
      return false;
    const Eigen::MatrixXd x = lightning::solve(a, hat_functions(fitted));
    const Boundary_points checked = sample(basis.poles, 2.7, 1e-15);
    const std::vector<double> error = errors(basis, x, checked);
    // Between the points, 1.4 times as much was met.
    const double bound = 2 * *std::max_element(error.begin(), error.end());
    if (x.allFinite() && bound < error_bound_) {
      error_bound_ = bound;
      basis_ = basis;
      coefficients_ = x;
    }
    refine(checked, error, target_error / 4);
    return true;
  }

  void refine(const Boundary_points& points, const std::vector<double>& errors, double tolerance) {
    bool smooth_part = false;
    std::vector<bool> at_corner(polygon_.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      if (errors[i] > tolerance) {
        if ((std::min)(points[i].s, 1 - points[i].s) > 0.1)
          smooth_part = true;
        else
          at_corner[points[i].place.vertex] = true;
      }
    for (std::size_t k = 0; k < polygon_.size(); ++k)
      if (at_corner[k])
        poles_[k] = 1.25 * poles_[k] + 1;
    if (smooth_part) {
      degree_ = std::ceil(1.25 * degree_);
      spacing_ *= 0.8;
    }
  }

  lightning::Polygon polygon_;
  std::vector<lightning::Corner> corners_;
  std::vector<double> poles_; // how many, at every corner
  double degree_ = 16;        // of the polynomials
  double spacing_;            // of the poles on the medial axis, in radii
  double error_bound_ = std::numeric_limits<double>::infinity();
  lightning::Basis basis_;
  Eigen::MatrixXd coefficients_;
};

} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_LIGHTNING_COORDINATES_H
