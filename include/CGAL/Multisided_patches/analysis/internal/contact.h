// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_ANALYSIS_INTERNAL_CONTACT_H
#define CGAL_MULTISIDED_PATCHES_ANALYSIS_INTERNAL_CONTACT_H

#include <CGAL/Multisided_patches/analysis/Side_continuity.h>
#include <CGAL/Multisided_patches/analysis/internal/ribbon_derivatives.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/patches/internal/surface_derivatives.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// How two surfaces that should meet at a point of a curve do so.
struct Contact {
  double position;                             // model units
  std::optional<double> tangent_plane = {};    // degrees
  std::optional<double> normal_curvature = {}; // relative
};

// What to compare, and how.
struct Contact_rule {
  std::size_t layers;  // 1: position, 2: and tangent plane, 3 or more: and normal curvature
  bool opposite;       // whether the normals should point to opposite sides
  double flat;         // curvatures are compared relative to this at least
  bool mutual = false; // whether the wanted surface has to have what the actual one has
};

// The normal curvature in a tangent direction d; the normal may be the negative of S_u × S_v.
inline double normal_curvature(const Surface_derivatives& s, const Vec3& normal, const Vec3& d) {
  const Tangent_frame frame(s, normal);
  return Shape_operator(s, normal, frame).normal_curvature(dot(d, frame.e1), dot(d, frame.e2));
}

// Values that are not numbers are no contact at all.
inline double at_most(double largest, double x) {
  return x <= largest ? x : largest;
}

// `tangent` is that of the common curve. What the wanted surface does not determine is not
// compared, what the actual one lacks is as wrong as can be.
inline Contact measure_contact(const Surface_derivatives& actual, const Surface_derivatives& wanted,
                               const Vec3& tangent, const Contact_rule& rule) {
  Contact contact{at_most(std::numeric_limits<double>::infinity(),
                          norm(difference(actual.point, wanted.point)))};
  const Vec3 zero{0, 0, 0};
  Vec3 normal = tangent_plane_normal(wanted);
  const Vec3 actual_normal = tangent_plane_normal(actual);
  const bool is_determined = normal != zero || (rule.mutual && actual_normal != zero);
  if (rule.layers < 2 || !is_determined)
    return contact;
  if (rule.opposite)
    normal = difference(zero, normal);
  const bool has_plane = actual_normal != zero && normal != zero;
  contact.tangent_plane = has_plane ? angle_between(actual_normal, normal) * 180 / pi : 180;
  if (rule.layers < 3)
    return contact;
  const Vec3 across = cross(normal, normalized(tangent));
  const double a = has_plane ? normal_curvature(actual, actual_normal, across) : 0;
  const double b = has_plane ? normal_curvature(wanted, normal, across) : 0;
  const double scale = std::fmax(std::fmax(std::abs(a), std::abs(b)), rule.flat);
  contact.normal_curvature = has_plane ? at_most(2, std::abs(a - b) / scale) : 2;
  return contact;
}

// The evenly spaced samples first, strictly inside the side, and then those next to its ends.
inline std::vector<double> sample_parameters(const Side_samples& samples) {
  CGAL_precondition(samples.even + samples.decades > 0 && samples.decades <= 15);
  std::vector<double> parameters;
  for (std::size_t k = 0; k < samples.even; ++k)
    parameters.push_back((static_cast<double>(k) + 0.5) / static_cast<double>(samples.even));
  double distance = 1;
  for (std::size_t k = 0; k < samples.decades; ++k) {
    distance /= 10;
    parameters.push_back(distance);
    parameters.push_back(1 - distance);
  }
  return parameters;
}

// Collects what contacts have in one respect.
class Deviation_statistics {
public:
  void add(double value, double s, bool counts_for_mean) {
    if (count_++ == 0 || value > deviation_.max) {
      deviation_.max = value;
      deviation_.s = s;
    }
    if (counts_for_mean) {
      sum_ += value;
      ++mean_count_;
    }
  }
  std::optional<Deviation> result() const {
    if (count_ == 0)
      return std::nullopt;
    Deviation result = deviation_;
    result.mean = mean_count_ > 0 ? sum_ / static_cast<double>(mean_count_) : 0;
    return result;
  }

private:
  Deviation deviation_;
  double sum_ = 0;
  std::size_t count_ = 0, mean_count_ = 0;
};

// `contact_at(s)` is the Contact at parameter s.
template <typename Function>
Continuity measure_continuity(const Side_samples& samples, const Function& contact_at) {
  Deviation_statistics position, tangent_plane, normal_curvature;
  const std::vector<double> parameters = sample_parameters(samples);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const double s = parameters[k];
    const bool even = k < samples.even;
    const Contact contact = contact_at(s);
    position.add(contact.position, s, even);
    if (contact.tangent_plane)
      tangent_plane.add(*contact.tangent_plane, s, even);
    if (contact.normal_curvature)
      normal_curvature.add(*contact.normal_curvature, s, even);
  }
  return {position.result().value_or(Deviation()), tangent_plane.result(),
          normal_curvature.result()};
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_ANALYSIS_INTERNAL_CONTACT_H
