// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_VISIT_PATCH_H
#define CGAL_MULTISIDED_PATCHES_IO_VISIT_PATCH_H

#include <CGAL/Multisided_patches/IO/Any_coordinates_2.h>
#include <CGAL/Multisided_patches/IO/Any_patch_model.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/domains/make_regular_domain.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/Generalized_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/S_patch_3.h>

#include <utility>
#include <variant>

namespace CGAL {
namespace Multisided_patches {
namespace IO {

namespace internal {

// How descriptions become domains and patches.
template <typename Traits>
struct Description_reader {
  using Coordinates = Any_coordinates_2<Traits>;
  using Domain = Polygonal_domain_2<Traits>;
  using Generated = Generated_domain<Traits>;

  static Generated as_it_is(Domain domain) {
    Domain_report report;
    report.clearance = domain.clearance();
    return {std::move(domain), std::move(report)};
  }

  static Generated domain(const Concave_bezier_description_3<Traits>& d) {
    return d.domain_vertices.empty() ? Multisided_patches::make_domain(d.loop, d.domain)
                                     : as_it_is(Domain(d.domain_vertices));
  }
  template <typename Net>
  static Generated domain(const Net_description_3<Traits, Net>& d) {
    if (!d.domain_vertices.empty())
      return as_it_is(Domain(d.domain_vertices));
    if (d.domain.generator != Domain_generator::regular)
      return Multisided_patches::make_domain(d.net.loop(), d.domain);
    // Whatever the corners of the net are: the patch is made for convex domains.
    Generated generated = as_it_is(make_regular_domain<Traits>(d.net.size()));
    generated.report.requested = generated.report.used = Domain_generator::regular;
    generated.report.wanted_clearance = d.domain.clearance;
    return generated;
  }
  static Generated domain(const Tensor_product_patch_3<Traits>& patch) {
    return as_it_is(patch.domain());
  }
  static Generated domain(const Bezier_triangle_3<Traits>& patch) {
    return as_it_is(patch.domain());
  }

  template <typename Description>
  static Coordinates coordinates(const Description& d) {
    return Coordinates(domain(d).domain, d.coordinates);
  }

  static Concave_bezier_patch_3<Traits, Coordinates>
  patch(const Concave_bezier_description_3<Traits>& d) {
    return Concave_bezier_patch_3<Traits, Coordinates>(d, coordinates(d));
  }
  static Generalized_bezier_patch_3<Traits, Coordinates>
  patch(const Generalized_bezier_description_3<Traits>& d) {
    return Generalized_bezier_patch_3<Traits, Coordinates>(d.net, coordinates(d));
  }
  static S_patch_3<Traits, Coordinates> patch(const S_patch_description_3<Traits>& d) {
    return S_patch_3<Traits, Coordinates>(d.net, coordinates(d));
  }
  static const Tensor_product_patch_3<Traits>& patch(const Tensor_product_patch_3<Traits>& d) {
    return d;
  }
  static const Bezier_triangle_3<Traits>& patch(const Bezier_triangle_3<Traits>& d) { return d; }
};

} // namespace internal

/*!
 * makes the domain of a patch as its description says: the polygon with the given vertices, or what
 * the generator makes of the ribbons.
 *
 * \tparam Traits a CGAL kernel with exact predicates
 *
 * \return the domain, and how it came about; of a domain that is given, the report has its
 * clearance only
 *
 * \throws Input_error if the vertices are those of no valid domain, or the ribbons of a net are no
 * loop
 *
 * Complexity: O(n²) for n sides, because of the clearance.
 */
template <typename Traits>
Generated_domain<Traits> make_domain(const Any_patch_model<Traits>& description) {
  return std::visit([](const auto& d) { return internal::Description_reader<Traits>::domain(d); },
                    description);
}

/*!
 * makes the patch that a file describes, with its domain and coordinates, and calls a function with
 * it. For `IO::read_patch_json()`, of which the type of patch is known only when the program runs.
 *
 * \tparam Traits a CGAL kernel with exact predicates and inexact constructions
 * \tparam Function a function object that takes any model of `MultisidedPatch_3`, as a lambda with
 * the parameter `const auto& patch` does
 *
 * \param description what the file says
 * \param function is called once, with a `Concave_bezier_patch_3`, `Generalized_bezier_patch_3` or
 * `S_patch_3` on `Any_coordinates_2`, a `Tensor_product_patch_3` or a `Bezier_triangle_3`; it
 * returns the same type of all of them. References into the patch do not outlive the call; patches
 * can be copied.
 *
 * \return what the function returns
 *
 * \throws Input_error, Accuracy_error as `make_domain()`, the coordinates and the patch do, and
 * what the function throws
 *
 * Complexity: that of making the domain, the coordinates and the patch.
 */
template <typename Traits, typename Function>
auto visit_patch(const Any_patch_model<Traits>& description, Function&& function) {
  return std::visit(
      [&](const auto& d) { return function(internal::Description_reader<Traits>::patch(d)); },
      description);
}

} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_VISIT_PATCH_H
