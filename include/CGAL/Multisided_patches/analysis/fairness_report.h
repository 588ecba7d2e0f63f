// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_FAIRNESS_REPORT_H
#define CGAL_MULTISIDED_PATCHES_FAIRNESS_REPORT_H

#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/mesh_domain.h>
#include <CGAL/Multisided_patches/patches/Surface_geometry_3.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! How fair a surface is: how much it bends, and where most.
template <typename Traits>
struct Fairness_report {
  double area = 0; //!< (squared model units)
  //! ∫ (κ₁² + κ₂²) dA, the energy of a bent thin plate; a number without unit, 4π on half a sphere
  double bending_energy = 0;
  //! the curvature max(|κ₁|, |κ₂|) that 99 percent of the area do not exceed (1 / model units)
  double curvature_99 = 0;
  //! the largest one at any sample (1 / model units), and where that is in the domain
  double largest_curvature = 0;
  typename Traits::Point_2 sharpest_point = {};
  std::size_t samples = 0;   //!< the number of samples
  std::size_t undefined = 0; //!< the number of those at which there are no curvatures
};

namespace internal {

// A sample of a surface: the area that it stands for and the curvatures there.
struct Bending_sample {
  double area = 0, squared = 0, largest = 0; // κ₁² + κ₂² and max(|κ₁|, |κ₂|)
  bool is_defined = false;
};

template <typename Patch>
Bending_sample bending_at(const Patch& patch, const typename Patch::Point_2& uv,
                          double domain_area) {
  const auto geometry = surface_geometry(patch, uv, Patch::Location::interior());
  const auto& form = geometry.first_form;
  Bending_sample sample;
  const double e = CGAL::to_double(form.E), f = CGAL::to_double(form.F),
               g = CGAL::to_double(form.G);
  sample.area = domain_area * std::sqrt((std::max)(0.0, e * g - f * f));
  if (geometry.curvature) {
    const double k1 = geometry.curvature->min_curvature(), k2 = geometry.curvature->max_curvature();
    sample.squared = k1 * k1 + k2 * k2;
    sample.largest = (std::max)(std::abs(k1), std::abs(k2));
    sample.is_defined = true;
  }
  return sample;
}

// The value that a fraction of the whole weight does not exceed; pairs are (value, weight).
inline double weighted_quantile(std::vector<std::pair<double, double>> values, double fraction) {
  std::sort(values.begin(), values.end());
  double whole = 0, sum = 0;
  for (const auto& [value, weight] : values)
    whole += weight;
  for (const auto& [value, weight] : values)
    if ((sum += weight) >= fraction * whole)
      return value;
  return 0;
}

} // namespace internal

/*!
 * measures the fairness of a patch at the centroids of the triangles of a mesh of its domain.
 *
 * At corners, where second derivatives depend on the direction, the curvature of a patch may grow
 * without bound, but on less and less area; so compare energies that come from as many triangles.
 *
 * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the
 * result is the same
 * \tparam Patch a class with the members of `Concave_bezier_patch_3`
 *
 * \param patch the patch
 * \param mesh a mesh of its domain, best of the same density everywhere on the surface
 *
 * Complexity: one evaluation of second derivatives for each triangle.
 */
template <typename ConcurrencyTag = Parallel_if_available_tag, typename Patch>
Fairness_report<typename Patch::Geom_traits>
fairness_report(const Patch& patch, const Domain_mesh_2<typename Patch::Geom_traits>& mesh) {
  using Traits = typename Patch::Geom_traits;
  const std::size_t n = mesh.triangles.size();
  const auto corner = [&](std::size_t t, std::size_t i) {
    return mesh.points[mesh.triangles[t][i]];
  };
  const auto centre = [&](std::size_t t) {
    return CGAL::centroid(corner(t, 0), corner(t, 1), corner(t, 2));
  };
  std::vector<internal::Bending_sample> samples(n);
  internal::for_each_index<ConcurrencyTag>(n, [&](std::size_t t) {
    const double area = CGAL::to_double(CGAL::area(corner(t, 0), corner(t, 1), corner(t, 2)));
    samples[t] = internal::bending_at(patch, centre(t), area);
  });

  Fairness_report<Traits> report;
  report.samples = n;
  std::vector<std::pair<double, double>> curvatures;
  for (std::size_t t = 0; t < n; ++t) {
    const internal::Bending_sample& sample = samples[t];
    report.area += sample.area;
    if (!sample.is_defined) {
      ++report.undefined;
      continue;
    }
    report.bending_energy += sample.squared * sample.area;
    curvatures.emplace_back(sample.largest, sample.area);
    if (sample.largest >= report.largest_curvature) {
      report.largest_curvature = sample.largest;
      report.sharpest_point = centre(t);
    }
  }
  report.curvature_99 = internal::weighted_quantile(std::move(curvatures), 0.99);
  return report;
}

//! the same with a mesh of about as many triangles that has the same density everywhere on the
//! surface, made by `mesh_domain()`
template <typename ConcurrencyTag = Parallel_if_available_tag, typename Patch>
Fairness_report<typename Patch::Geom_traits> fairness_report(const Patch& patch,
                                                             std::size_t triangles = 20000) {
  return fairness_report<ConcurrencyTag>(
      patch, mesh_domain<ConcurrencyTag>(patch, Mesh_density::triangles(triangles)));
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_FAIRNESS_REPORT_H
