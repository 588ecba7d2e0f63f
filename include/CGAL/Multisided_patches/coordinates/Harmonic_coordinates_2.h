// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_COORDINATES_HARMONIC_COORDINATES_2_H
#define CGAL_MULTISIDED_PATCHES_COORDINATES_HARMONIC_COORDINATES_2_H

#include <CGAL/Multisided_patches/coordinates/internal/Coordinates_base.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/Affine_correction.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/nearest_convex_combination.h>
#include <CGAL/Multisided_patches/coordinates/internal/harmonic/solve_to_accuracy.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/internal/to_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
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
 * A small linear correction makes Σ λ_i = 1 and Σ λ_i v_i = (u,v) hold up to rounding. Where values
 * would be below zero, they are replaced by the nearest ones that are not and for which this holds,
 * too; derivatives stay.
 *
 * Derivatives: inside and on the sides they are finite, and on the sides the limits from inside. At
 * a convex vertex, the gradient is its limit, that of the affine function which interpolates the
 * adjacent sides. At straight and reflex vertices gradients are infinite in general, and so may
 * Hessians be at all vertices; what is returned then is the finite value at a nearby point on the
 * bisector of the corner. It is 10^-6 times as far away as the nearest other vertex that is not
 * behind the sides of the corner or, where this is nearer, the mirror image of the corner in a side
 * across from it. On domains of a size below about 1e-154 Hessians overflow.
 *
 * Setting up for errors of 1e-8 takes 1.3 to 9 ms for n = 8 vertices, 12 to 32 ms for 20 and 65 to
 * 240 ms for 64 on one core, a third less with AVX2, and grows with n^1.3 to n^1.5 (combs,
 * spirals, random polygons), n^1.9 (regular ones) or n^2 (stars). Slots take longer, as cells
 * shrink towards the end of a slot: 20 ms where its width is 0.1 of what is around it, 45 ms with
 * 0.01, 0.2 s with 1e-7, and up to 1.2 s below; to find that a target is out of reach there, up to
 * 7 s. Evaluating all coordinates with gradients at a point takes less than a microsecond for n =
 * 8, and allocates hardly any memory up to n = 32; `evaluate_batch()` does it for many points in
 * parallel. All queries may be made from several threads.
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
   * one matrix each for the values and, depending on `Order`, the partial derivatives d/du, d/dv,
   * d²/du², d²/dudv and d²/dv², as in `Jet_2`: row `i` belongs to vertex `i`, column `j` to point
   * `j`. With the vertices, or whatever sits there, in the columns of a matrix X, X times the first
   * are the interpolated points.
   */
  template <int Order>
  using Batch =
      std::array<Eigen::Matrix<FT, Eigen::Dynamic, Eigen::Dynamic>, Jet_2<FT, Order>::size>;

  /*!
   * solves Laplace's equation for all coordinates of a domain.
   *
   * \param domain any valid domain
   * \param target_error the error that values may have, absolute, as coordinates have no unit.
   * Errors of about 1e-12 are the best that can be had on benign domains; gradients and Hessians,
   * in units of the size of the domain, lose about 2 and 3 to 4 digits.
   * \param acceptable_error what is accepted where the target is out of reach, as it may be on
   * domains with gaps or sides below 1e-6 of their size; the target itself, if 0
   * \param concurrency `Parallel_tag` or `Sequential_tag`; the result does not depend on it
   *
   * \throws Input_error unless `target_error` > 0 and `acceptable_error` >= 0, both finite
   * \throws Accuracy_error if the target, and the acceptable error, could not be reached. It says
   * what was, which is within reach as the acceptable error of the same target. As a target it may
   * be out of reach, as other targets lead to other subdivisions. \throws Numerical_error if the
   * extent of the domain, or the inverse of that, overflows
   *
   * Complexity: O(n²) time and memory, 2 kB · n² in the worst case; from n^1.3 on where
   * distant vertices do not see each other. The error asked for enters by its logarithm squared.
   * A target out of reach is given up when finer solutions hardly lessen the error.
   */
  template <typename ConcurrencyTag = Parallel_if_available_tag>
  explicit Harmonic_coordinates_2(const Domain& domain, double target_error = 1e-8,
                                  double acceptable_error = 0, ConcurrencyTag concurrency = {})
      : Base(domain) {
    check_errors(target_error, acceptable_error);
    static_cast<void>(concurrency);
    set_frame();
    std::vector<std::size_t> next;
    for (std::size_t i = 0; i < domain.size(); ++i) {
      vertices_.push_back(normalized<double>(domain.vertex(i).x(), domain.vertex(i).y()));
      next.push_back(domain.next(i));
    }
    const internal::harmonic::Boundary boundary(vertices_, next);
    set_vertex_probes(boundary);
    correction_ = internal::harmonic::Affine_correction(vertices_);
    const double acceptable = (std::max)(target_error, acceptable_error);
    internal::harmonic::Best_solution best = internal::harmonic::solve_to_accuracy<ConcurrencyTag>(
        boundary, internal::harmonic::triangulate_boundary(boundary), target_error, acceptable);
    if (!(best.error <= acceptable))
      throw_accuracy_error(target_error, best);
    error_bound_ = best.error;
    basis_ = std::move(best.basis);
  }

  /*!
   * an estimate of the largest error of any value: the largest jump of value or scaled normal
   * derivative that was measured between neighbouring cells, times 4, or more if the cells differ
   * greatly in size. What makes the values reproduce linear functions and keeps them from being
   * negative does, but for rounding, not increase the Euclidean norm of their errors. On 1,000
   * random domains errors were below a quarter of the bound.
   */
  double error_bound() const { return error_bound_; }

  /*!
   * evaluates all coordinates, and their derivatives up to `Order`, at many points, in parallel
   * with `Parallel_tag`. The results are those of `evaluate()`.
   *
   * \param points in or on the domain
   *
   * \throws Outside_domain_error if a point lies outside the domain
   *
   * Complexity: O(n) for each point.
   */
  template <int Order = 0, typename ConcurrencyTag = Parallel_if_available_tag>
  Batch<Order> evaluate_batch(const std::vector<Point_2>& points) const {
    std::vector<Location> locations(points.size());
    internal::for_each_index<ConcurrencyTag>(points.size(), [&](std::size_t j) {
      locations[j] = this->domain().locate_inside(points[j]);
    });
    return evaluate_batch<Order, ConcurrencyTag>(points, locations);
  }

  //! the same for points whose locations are known
  template <int Order = 0, typename ConcurrencyTag = Parallel_if_available_tag>
  Batch<Order> evaluate_batch(const std::vector<Point_2>& points,
                              const std::vector<Location>& locations) const {
    CGAL_precondition(points.size() == locations.size());
    Batch<Order> result;
    for (auto& matrix : result)
      matrix.resize(static_cast<Eigen::Index>(this->domain().size()),
                    static_cast<Eigen::Index>(points.size()));
    constexpr std::size_t range = 512; // points that are worth a task
    internal::for_each_index<ConcurrencyTag>(
        (points.size() + range - 1) / range,
        [&](std::size_t r) {
          evaluate_range<Order>(r * range, (std::min)((r + 1) * range, points.size()), points,
                                locations, result);
        },
        1);
    return result;
  }

  /*!
   * evaluates the same approximation in a wider floating-point type: the yardstick for the rounding
   * of values and derivatives. Values below zero are left as they are.
   *
   * \tparam Real `long double`, for instance
   * \param u,v the point, inside the domain
   * \param lambda room for the coordinates of all vertices, with derivatives up to `Order`
   */
  template <int Order, typename Real>
  void evaluate_extended(const Real& u, const Real& v, Jet_2<Real, Order>* lambda) const {
    evaluate_in_frame(normalized(u, v), lambda);
  }

#ifndef DOXYGEN_RUNNING
  // Called by the base class.
  template <int Order, typename Real>
  void evaluate_formula(const Real& u, const Real& v, const Domain_location<Real>& location,
                        Jet_2<Real, Order>* lambda) const {
    const bool at_vertex = location.kind == Domain_location<Real>::Kind::vertex;
    if constexpr (std::is_same_v<Real, FT>) {
      const Complex z = at_vertex ? vertex_probes_[location.index] : normalized<double>(u, v);
      evaluate_nonnegative(z, lambda);
    } else {
      static_assert(std::is_floating_point_v<Real> &&
                        std::numeric_limits<Real>::digits >= std::numeric_limits<double>::digits,
                    "harmonic coordinates are approximated in double precision: other number types "
                    "would not be more exact. Take their values, and go on with these exactly.");
      evaluate_in_frame(at_vertex ? std::complex<Real>(vertex_probes_[location.index])
                                  : normalized(u, v),
                        lambda);
    }
    if constexpr (Order >= 1)
      if (at_vertex && this->domain().corner_type(location.index) == Corner_type::convex)
        set_gradients_at_convex_vertex(location.index, lambda);
  }
#endif

private:
  template <int Order>
  static constexpr int number_of_parts = internal::harmonic::number_of_parts<Order>;

  static void check_errors(double target, double acceptable) {
    if (!(target > 0 && std::isfinite(target)))
      throw Input_error(
          "the target error of harmonic coordinates has to be positive and finite, not " +
          internal::to_short_text(target));
    if (!(acceptable >= 0 && std::isfinite(acceptable)))
      throw Input_error(
          "the acceptable error of harmonic coordinates has to be at least 0 and finite, "
          "not " +
          internal::to_short_text(acceptable));
  }

  // The domain is scaled to unit size, by a power of two, and moved to the origin if it is far
  // away. But for underflow both are exact, for all points in its box: no gap gets wider or
  // narrower by rounding.
  void set_frame() {
    const Bbox_2 box = this->domain().bbox();
    origin_ = {exact_origin(box.xmin(), box.xmax()), exact_origin(box.ymin(), box.ymax())};
    const double extent = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    if (!std::isfinite(extent) || !std::isfinite(1 / extent))
      throw Numerical_error("the domain is too large or too small for harmonic coordinates: its "
                            "extent is " +
                            internal::to_short_text(extent));
    int exponent = 0;
    std::frexp(extent, &exponent);
    scale_ = std::ldexp(1., -exponent);
  }

  // The difference of two numbers is exact if neither is more than twice as large as the other
  // (Sterbenz). In all other intervals, no number is more than twice as large as their length.
  static double exact_origin(double low, double high) {
    const bool is_far = (low > 0 && high <= 2 * low) || (high < 0 && low >= 2 * high);
    return is_far ? low + (high - low) / 2 : 0;
  }

  template <typename Real>
  std::complex<Real> normalized(const Real& u, const Real& v) const {
    return Real(scale_) * (std::complex<Real>(u, v) - std::complex<Real>(origin_));
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

  [[noreturn]] void throw_accuracy_error(double target_error,
                                         const internal::harmonic::Best_solution& best) const {
    std::string result = "nothing was reached";
    if (std::isfinite(best.error))
      result = internal::to_short_text_above(best.error) + " was reached";
    else if (!best.failure.empty())
      result += "; " + best.failure;
    throw Accuracy_error("harmonic coordinates on a domain of " +
                             std::to_string(this->domain().size()) + " sides: errors below " +
                             internal::to_short_text(target_error) + " were asked for, and " +
                             result,
                         best.error);
  }

  // makes all parts fit to 1, x and y
  template <int Order, typename Real>
  void correct(const std::complex<Real>& z, Real* parts) const {
    // 1, x and y relative to z, and their derivatives by x, by y, and twice
    const std::array<Real, 3> affine[5] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
    for (int k = 0; k < number_of_parts<Order>; ++k)
      correction_(z, affine[k], parts + static_cast<std::size_t>(k) * basis_.stride());
  }

  // entry k of the jet of a coordinate in the domain, from its parts in the normalized frame
  template <typename Real>
  Real entry(const Real* parts, std::size_t k) const {
    constexpr std::size_t part[6] = {0, 1, 2, 3, 4, 3}; // the last is minus the fourth
    const Real value = parts[part[k] * basis_.stride()];
    if (k == 0)
      return value;
    if (k <= 2)
      return Real(scale_) * value;
    // the square of the scale may overflow where this does not
    return Real(scale_) * (Real(scale_) * (k == 5 ? -value : value));
  }

  // evaluates the approximation at a point of the normalized frame
  template <int Order, typename Real>
  void evaluate_in_frame(const std::complex<Real>& z, Jet_2<Real, Order>* lambda) const {
    std::vector<Real> parts(basis_.stride() * number_of_parts<Order>);
    const Complex rounded(static_cast<double>(z.real()), static_cast<double>(z.imag()));
    basis_.template evaluate<Order>(basis_.locate(rounded), z, parts.data());
    correct<Order>(z, parts.data());
    store(parts.data(), lambda);
  }

  // the same, without values below zero
  template <int Order>
  void evaluate_nonnegative(const Complex& z, Jet_2<FT, Order>* lambda) const {
    boost::container::small_vector<double, 32 * number_of_parts<Order>> parts(
        basis_.stride() * number_of_parts<Order>);
    basis_.template evaluate<Order>(basis_.locate(z), z, parts.data());
    correct<Order>(z, parts.data());
    internal::harmonic::make_nonnegative(vertices_, z, parts.data());
    store(parts.data(), lambda);
  }

  template <int Order, typename Real, typename Result>
  void store(const Real* parts, Jet_2<Result, Order>* lambda) const {
    for (std::size_t i = 0; i < this->domain().size(); ++i)
      for (std::size_t k = 0; k < Jet_2<Result, Order>::size; ++k)
        lambda[i][k] = static_cast<Result>(entry(parts + i, k));
  }

  // evaluates consecutive points
  template <int Order>
  void evaluate_range(std::size_t begin, std::size_t end, const std::vector<Point_2>& points,
                      const std::vector<Location>& locations, Batch<Order>& result) const {
    const std::size_t n = this->domain().size();
    std::vector<Jet_2<FT, Order>> lambda(n);
    for (std::size_t j = begin; j < end; ++j) {
      if (locations[j].kind == Location::Kind::outside)
        throw Outside_domain_error("point " + std::to_string(j) + " lies outside the domain");
      this->template evaluate<Order>(points[j], locations[j], lambda.data());
      for (std::size_t k = 0; k < result.size(); ++k)
        for (std::size_t i = 0; i < n; ++i)
          result[k].data()[j * n + i] = lambda[i][k];
    }
  }

  // the affine functions with the slopes of the hat functions along both sides
  template <typename Jet>
  void set_gradients_at_convex_vertex(std::size_t k, Jet* lambda) const {
    const std::size_t next = this->domain().next(k), prev = this->domain().prev(k);
    const Complex a = vertices_[next] - vertices_[k], b = vertices_[prev] - vertices_[k];
    const double area = internal::harmonic::cross(a, b) / scale_;
    const Complex gradient_next = Complex(b.imag(), -b.real()) / area, // 1 along a, 0 along b
        gradient_prev = Complex(-a.imag(), a.real()) / area;
    for (std::size_t i = 0; i < this->domain().size(); ++i)
      set_gradient(lambda[i], 0);
    set_gradient(lambda[next], gradient_next);
    set_gradient(lambda[prev], gradient_prev);
    set_gradient(lambda[k], -gradient_next - gradient_prev);
  }

  template <typename Jet>
  static void set_gradient(Jet& jet, const Complex& gradient) {
    jet[1] = typename Jet::FT(gradient.real());
    jet[2] = typename Jet::FT(gradient.imag());
  }

  Complex origin_ = 0;
  double scale_ = 1;
  double error_bound_ = std::numeric_limits<double>::infinity();
  internal::harmonic::Harmonic_basis basis_;
  internal::harmonic::Affine_correction correction_;
  std::vector<Complex> vertices_;      // in the normalized frame, as all that follows
  std::vector<Complex> vertex_probes_; // where derivatives at the vertices are taken
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_COORDINATES_HARMONIC_COORDINATES_2_H
