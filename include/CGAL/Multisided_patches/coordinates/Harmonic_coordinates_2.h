// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_HARMONIC_COORDINATES_2_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_HARMONIC_COORDINATES_2_H

#include <CGAL/Multisided_patches/coordinates/internal/Coordinates_base.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Affine_correction.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/solve_laplace.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * Harmonic coordinates: λ_i is the harmonic function on the domain whose boundary values are linear
 * on every side, 1 at vertex i and 0 at all others. They are positive inside any domain, convex or
 * not, with or without holes (as computed: up to rounding and `error_bound()`), which makes them
 * the coordinates of choice for concave patches \cite sv-mcsps-18.
 *
 * There is no formula for them, but they can be computed to many digits. The constructor cuts the
 * domain into cells (around the corners, between sides that face each other, along the sides, and
 * inside). On each cell the harmonic functions with the right boundary values are known as series,
 * which include the singular powers at the corners, and converge geometrically; their coefficients
 * follow from gluing the cells together in the least-squares sense. This is a Trefftz method
 * \cite t-gsr-26; the rational approximation of \cite gt-slhps-19 is a relative. The boundary
 * values are exact by construction, and so are the derivatives of the approximation, which is
 * analytic in every cell.
 *
 * A small linear correction makes Σ λ_i = 1 and Σ λ_i v_i = (u,v) hold up to rounding. Values may
 * be negative by about `error_bound()` where they are almost 0.
 *
 * Derivatives: inside and on the sides they are finite, and on the sides the limits from inside. At
 * a convex vertex, the gradient is its limit, that of the affine function which interpolates the
 * adjacent sides. At straight and reflex vertices gradients are infinite in general, and so may
 * Hessians be at all vertices; what is returned then is the finite value at a nearby point, on the
 * bisector of the corner, 10^-6 times the distance to the nearest other vertex or visible side
 * away.
 *
 * Setting up takes some milliseconds for 8 vertices, and grows a little faster than n^1.6.
 * Evaluating all coordinates with gradients at a point takes less than a microsecond for n = 8, and
 * allocates no memory up to n = 32.
 *
 * \cgalModels{BarycentricCoordinates_2}
 *
 * \tparam Traits a CGAL kernel with exact predicates and a floating-point `FT`
 */
template <typename Traits>
class Harmonic_coordinates_2
    : public internal::Coordinates_base<Harmonic_coordinates_2<Traits>, Traits> {
  using Base = internal::Coordinates_base<Harmonic_coordinates_2<Traits>, Traits>;
  using Complex = internal::harmonic::Complex;

public:
  using typename Base::Domain;
  using typename Base::FT;
  using typename Base::Location;
  using typename Base::Point_2;

  static_assert(std::is_floating_point<FT>::value,
                "harmonic coordinates are transcendental: exact number types do not apply");

  /*!
   * solves Laplace's equation for all coordinates of a domain.
   *
   * \param domain any valid domain
   * \param target_error the error that values may have, absolute, as coordinates have no unit.
   * Errors of about 1e-12 are the best that can be had; gradients and Hessians, in units of the
   * size of the domain, lose about 2 and 3 to 4 digits.
   *
   * If the target is out of reach, the best approximation found is accepted: see `error_bound()`.
   *
   * \throws Numerical_error if that is not even good to 1e-3; the message says what was reached
   *
   * \pre `target_error > 0`
   */
  explicit Harmonic_coordinates_2(const Domain& domain, double target_error = 1e-8) : Base(domain) {
    CGAL_precondition(target_error > 0);
    set_frame();
    std::vector<Complex> exact, points;
    std::vector<std::size_t> next;
    for (std::size_t i = 0; i < domain.size(); ++i) {
      exact.push_back(scale_ * complex(domain.vertex(i)));
      points.push_back(normalized(domain.vertex(i)));
      next.push_back(domain.next(i));
    }
    const internal::harmonic::Boundary boundary(points, next);
    set_vertex_probes(boundary);
    correction_ = internal::harmonic::Affine_correction(points);
    solve(boundary, internal::harmonic::triangulate_boundary(exact, next, points), target_error);
  }

  /*!
   * an estimate, on the safe side in all experiments, of the largest error of any value: the
   * largest jump of value or scaled normal derivative that was measured between neighbouring cells,
   * times 4, or more if the cells differ greatly in size.
   */
  double error_bound() const { return error_bound_; }

#ifndef DOXYGEN_RUNNING
  // Called by the base class.
  template <int Order>
  void evaluate_formula(const Point_2& p, const Location& location,
                        Jet_2<FT, Order>* lambda) const {
    namespace harmonic = internal::harmonic;
    constexpr int parts = harmonic::number_of_parts<Order>;
    const bool at_vertex = location.kind == Location::Kind::vertex;
    const Complex z = at_vertex ? vertex_probes_[location.index] : normalized(p);
    const std::size_t stride = basis_.stride();
    boost::container::small_vector<double, 32 * parts> values(stride * parts);
    basis_.template evaluate<Order>(basis_.locate(z), z, values.data());
    // 1, x, y and their derivatives by x, by y, and twice
    const std::array<double, 3> affine[5] = {
        {1, z.real(), z.imag()}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
    for (int k = 0; k < parts; ++k)
      correction_(affine[k], values.data() + k * stride);
    for (std::size_t i = 0; i < this->domain().size(); ++i)
      set_jet(values.data() + i, stride, lambda[i]);
    if constexpr (Order >= 1)
      if (at_vertex && this->domain().corner_type(location.index) == Corner_type::convex)
        set_gradients_at_convex_vertex(location.index, lambda);
  }
#endif

private:
  // The polygon is moved to the origin and scaled to unit size; by a power of two, which is exact.
  void set_frame() {
    const Bbox_2 box = this->domain().bbox();
    centre_ = {box.xmin() + (box.xmax() - box.xmin()) / 2,
               box.ymin() + (box.ymax() - box.ymin()) / 2};
    int exponent = 0;
    std::frexp((std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()), &exponent);
    scale_ = std::ldexp(1., -exponent);
  }

  static Complex complex(const Point_2& p) {
    return {static_cast<double>(p.x()), static_cast<double>(p.y())};
  }
  Complex normalized(const Point_2& p) const {
    return scale_ * (complex(p) - centre_);
  }

  void set_vertex_probes(const internal::harmonic::Boundary& boundary) {
    constexpr double offset = 1e-6; // of the radius of convergence at the corner
    for (std::size_t k = 0; k < boundary.size(); ++k) {
      const Complex bisector =
          boundary.direction(k) * std::polar(1., boundary.angle(k) * internal::pi / 2);
      vertex_probes_.push_back(boundary.vertex(k) +
                               offset * internal::harmonic::corner_radius(boundary, k) * bisector);
    }
  }

  // tau from the target: fitted to the errors that were measured on many shapes. The error is about
  // tau^1.7 at first.
  void solve(const internal::harmonic::Boundary& boundary,
             const internal::harmonic::Bisection_mesh& mesh, double target_error) {
    constexpr int max_rounds = 3;
    constexpr double tau_min = 1e-13, tau_max = 1e-2, acceptable = 1e-3;
    double tau = 10 * std::pow(target_error, 0.83);
    std::string failure;
    for (int round = 0; round < max_rounds && error_bound_ > target_error; ++round) {
      tau = (std::min)(tau_max, (std::max)(tau_min, tau));
      try {
        internal::harmonic::Solution s = internal::harmonic::solve_laplace(boundary, mesh, tau);
        if (s.error < error_bound_) {
          error_bound_ = s.error;
          basis_ = std::move(s.basis);
        }
      } catch (const Numerical_error& error) { // what an earlier round found may do
        failure = std::string("; ") + error.what();
      }
      if (tau == tau_min)
        break;
      tau *= (std::min)(0.1, (std::max)(1e-2, std::pow(target_error / error_bound_, 1 / 1.7)));
    }
    if (!(error_bound_ <= acceptable)) {
      std::ostringstream message;
      message << "harmonic coordinates: the error of the values is not below " << error_bound_
              << " on this domain of " << boundary.size() << " sides; " << target_error
              << " was asked for" << failure;
      throw Numerical_error(message.str());
    }
  }

  // from the parts of one coordinate, in the normalized frame
  template <int Order>
  void set_jet(const double* parts, std::size_t stride, Jet_2<FT, Order>& jet) const {
    jet[0] = static_cast<FT>(parts[0]);
    if constexpr (Order >= 1) {
      jet[1] = static_cast<FT>(scale_ * parts[stride]);
      jet[2] = static_cast<FT>(scale_ * parts[2 * stride]);
    }
    if constexpr (Order >= 2) {
      const double uu = scale_ * scale_ * parts[3 * stride];
      jet[3] = static_cast<FT>(uu);
      jet[4] = static_cast<FT>(scale_ * scale_ * parts[4 * stride]);
      jet[5] = static_cast<FT>(-uu);
    }
  }

  // the affine functions with the slopes of the hat functions along both sides
  template <int Order>
  void set_gradients_at_convex_vertex(std::size_t k, Jet_2<FT, Order>* lambda) const {
    const std::size_t next = this->domain().next(k), prev = this->domain().prev(k);
    const Complex v = complex(this->domain().vertex(k));
    const Complex a = complex(this->domain().vertex(next)) - v,
                  b = complex(this->domain().vertex(prev)) - v;
    const double area = internal::harmonic::cross(a, b);
    const Complex gradient_next = Complex(b.imag(), -b.real()) / area, // 1 along a, 0 along b
        gradient_prev = Complex(-a.imag(), a.real()) / area;
    for (std::size_t i = 0; i < this->domain().size(); ++i)
      set_gradient(lambda[i], 0);
    set_gradient(lambda[next], gradient_next);
    set_gradient(lambda[prev], gradient_prev);
    set_gradient(lambda[k], -gradient_next - gradient_prev);
  }

  template <int Order>
  static void set_gradient(Jet_2<FT, Order>& jet, const Complex& gradient) {
    jet[1] = static_cast<FT>(gradient.real());
    jet[2] = static_cast<FT>(gradient.imag());
  }

  Complex centre_ = 0;
  double scale_ = 1;
  double error_bound_ = std::numeric_limits<double>::infinity();
  internal::harmonic::Harmonic_basis basis_;
  internal::harmonic::Affine_correction correction_;
  std::vector<Complex> vertex_probes_; // where derivatives at the vertices are taken
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_HARMONIC_COORDINATES_2_H
