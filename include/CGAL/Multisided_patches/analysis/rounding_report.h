// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_ANALYSIS_ROUNDING_REPORT_H
#define CGAL_MULTISIDED_PATCHES_ANALYSIS_ROUNDING_REPORT_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/analysis/domain_samples.h>
#include <CGAL/Multisided_patches/parameters/barycentric_side_parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! How far numbers that were computed with rounding are from what they should be.
struct Rounding_error {
  //! in units in the last place of the exact number or, where that is smaller, of the rounding of
  //! numbers of unit size, with which it goes on
  double max_ulps = 0, mean_ulps = 0;
  //! relative to the unit of the quantity, see `Rounding_report`
  double max_relative = 0, mean_relative = 0;
  //! the index of the sample with the largest relative error
  std::size_t worst_sample = 0;
};

/*!
 * The errors of all stages of a patch. Coordinates, side parameters and weights have the unit 1,
 * and points the diagonal D of the bounding box of the control points. Derivatives are measured by
 * their own size at the same place, that of all entries together, but at least by D / L and
 * D / (L r), where L is the diameter of the domain and r the distance from the nearest vertex. Of
 * this size are the terms of which derivatives are sums; near a vertex they cancel only if the
 * ribbons agree there.
 */
struct Rounding_report {
  Rounding_error coordinates, s, h, weights, points, first_derivatives, second_derivatives;
  std::size_t samples = 0;
};

namespace internal {

// double from any number type
template <typename Real>
double rounded(const Real& x) {
  if constexpr (std::is_constructible_v<double, Real>)
    return static_cast<double>(x);
  else
    return CGAL::to_double(x);
}

// Collects the errors of one quantity, whose numbers are rounded to `digits` binary digits.
class Rounding_errors {
public:
  explicit Rounding_errors(int digits) : digits_(digits) {}

  template <typename FT, typename Reference>
  void add(std::size_t sample, const FT& computed, const Reference& exact, double unit) {
    if (!std::isfinite(computed)) { // exact numbers have no way to say so
      result_.max_relative = result_.max_ulps = std::numeric_limits<double>::infinity();
      result_.mean_relative = result_.mean_ulps = std::numeric_limits<double>::infinity();
      result_.worst_sample = sample;
      return;
    }
    const Reference difference = Reference(computed) - exact;
    const double value = std::abs(rounded(exact)), error = std::abs(rounded(difference));
    const double ulps = error / ulp((std::max)(value, std::ldexp(unit, 1 - digits_)));
    const double relative = error / unit;
    if (!(relative <= result_.max_relative)) { // not a number is worse than any
      result_.max_relative = relative;
      result_.worst_sample = sample;
    }
    if (!(ulps <= result_.max_ulps))
      result_.max_ulps = ulps;
    result_.mean_ulps += ulps;
    result_.mean_relative += relative;
    ++count_;
  }

  Rounding_error result() const {
    Rounding_error r = result_;
    r.mean_ulps /= static_cast<double>((std::max<std::size_t>)(count_, 1));
    r.mean_relative /= static_cast<double>((std::max<std::size_t>)(count_, 1));
    return r;
  }

private:
  double ulp(double x) const { return std::ldexp(1., std::ilogb(x) + 1 - digits_); }

  int digits_;
  Rounding_error result_;
  std::size_t count_ = 0;
};

// Whether a patch is a basis on coordinates, and whether that goes by side parameters.
template <typename Patch, typename = void>
struct Has_basis : std::false_type {};
template <typename Patch>
struct Has_basis<Patch, std::void_t<decltype(std::declval<const Patch&>().basis())>>
    : std::true_type {};
template <typename Patch, typename = void>
struct Has_side_parameters : std::false_type {};
template <typename Patch>
struct Has_side_parameters<
    Patch, std::void_t<decltype(std::declval<const Patch&>().basis().parameter_options())>>
    : std::true_type {};

// All stages of a patch at one point, in one number type; those that it does not have are empty.
template <typename Real>
struct Patch_stages {
  using Jet = Jet_2<Real, 2>;

  template <typename Patch, typename FT>
  Patch_stages(const Patch& patch, const Domain_sample<FT>& sample) {
    const Domain_location<FT>& at = sample.location;
    using Kind = typename Domain_location<Real>::Kind;
    const Domain_location<Real> location{static_cast<Kind>(at.kind), at.index, Real(at.s)};
    const Real u(sample.u), v(sample.v);
    if constexpr (Has_basis<Patch>::value) {
      lambda.resize(patch.domain().size());
      patch.coordinates().template evaluate<2>(u, v, location, lambda.data());
      if constexpr (Has_side_parameters<Patch>::value) {
        parameters.resize(lambda.size());
        compute_side_parameters(patch.domain(), lambda.data(), patch.basis().parameter_options(),
                                parameters);
      }
      weights.resize(patch.basis().size());
      patch.basis().evaluate(patch.domain(), lambda.data(), weights.data());
      surface = patch.combine(lambda.data());
    } else {
      surface = patch.template evaluate<2>(u, v, location);
    }
  }

  std::vector<Jet> lambda;
  std::vector<Side_parameter<Jet>> parameters;
  std::vector<Jet> weights;
  std::array<Jet, 3> surface;
};

// the size of all derivatives of one order together; entries [begin,end) of a jet
template <typename Real>
double size_of_derivatives(const std::array<Jet_2<Real, 2>, 3>& surface, std::size_t begin,
                           std::size_t end) {
  double square = 0;
  for (const Jet_2<Real, 2>& coordinate : surface)
    for (std::size_t k = begin; k < end; ++k)
      square += rounded(coordinate[k]) * rounded(coordinate[k]);
  return std::sqrt(square);
}

// from a sample to the nearest vertex; at a vertex itself, where limits are taken, the diameter
template <typename Domain, typename FT>
double distance_to_vertices(const Domain& domain, const Domain_sample<FT>& sample) {
  double distance = domain.diameter();
  if (sample.location.kind != Domain_location<FT>::Kind::vertex)
    for (const auto& v : domain.vertices())
      distance = (std::min)(
          distance, std::hypot(rounded(FT(v.x() - sample.u)), rounded(FT(v.y() - sample.v))));
  return distance;
}

} // namespace internal

/*!
 * measures what rounding does to every stage of a patch, by computing all of it in a second number
 * type at the same parameters: barycentric coordinates, side parameters, weights, points, and first
 * and second derivatives.
 *
 * \tparam Reference an exact number type, such as `CGAL::Exact_rational`, if all formulas of the
 * patch are rational (Wachspress coordinates); otherwise a floating-point type with many digits and
 * a square root (mean value coordinates), such as
 * `boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
 * boost::multiprecision::et_off>`. Harmonic coordinates are approximations and compile with
 * `long double` only, which tells about the rounding in their evaluation.
 *
 * \tparam Patch a patch of the control-point family whose number type is `float` or `double`; the
 * errors of stages that it does not have, such as the side parameters of an S-patch and everything
 * but points and derivatives of a `Bezier_triangle_3`, are 0
 *
 * \param patch the patch
 * \param samples where to compare: those of `domain_samples()`, or others
 *
 * Complexity: one evaluation for each sample, in both number types; exact numbers grow with the
 * number of sides and the degrees.
 */
template <typename Reference, typename Patch>
Rounding_report rounding_report(const Patch& patch,
                                const std::vector<Domain_sample<typename Patch::FT>>& samples) {
  using FT = typename Patch::FT;
  static_assert(std::is_floating_point_v<FT>, "only floating-point numbers are rounded");
  constexpr int digits = std::numeric_limits<FT>::digits;
  internal::Rounding_errors coordinates(digits), s(digits), h(digits), weights(digits),
      points(digits), first(digits), second(digits);
  const double diagonal = patch.loop().diagonal(), diameter = patch.domain().diameter();

  for (std::size_t k = 0; k < samples.size(); ++k) {
    const internal::Patch_stages<FT> computed(patch, samples[k]);
    const internal::Patch_stages<Reference> exact(patch, samples[k]);
    for (std::size_t i = 0; i < exact.lambda.size(); ++i) {
      coordinates.add(k, computed.lambda[i].value(), exact.lambda[i].value(), 1);
    }
    for (std::size_t i = 0; i < exact.parameters.size(); ++i) {
      s.add(k, computed.parameters[i].s.value(), exact.parameters[i].s.value(), 1);
      h.add(k, computed.parameters[i].h.value(), exact.parameters[i].h.value(), 1);
    }
    for (std::size_t i = 0; i < exact.weights.size(); ++i)
      weights.add(k, computed.weights[i].value(), exact.weights[i].value(), 1);
    const double unit = diagonal / diameter;
    const double first_size = (std::max)(internal::size_of_derivatives(exact.surface, 1, 3), unit);
    const double second_size =
        (std::max)(internal::size_of_derivatives(exact.surface, 3, 6),
                   unit / internal::distance_to_vertices(patch.domain(), samples[k]));
    for (std::size_t c = 0; c < 3; ++c) {
      const auto &x = computed.surface[c], &y = exact.surface[c];
      points.add(k, x[0], y[0], diagonal);
      for (std::size_t d = 1; d < 3; ++d)
        first.add(k, x[d], y[d], first_size);
      for (std::size_t d = 3; d < 6; ++d)
        second.add(k, x[d], y[d], second_size);
    }
  }
  return {coordinates.result(), s.result(),     h.result(),      weights.result(),
          points.result(),      first.result(), second.result(), samples.size()};
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_ANALYSIS_ROUNDING_REPORT_H
