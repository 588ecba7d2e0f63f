// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_ANY_PATCH_MODEL_H
#define CGAL_MULTISIDED_PATCHES_IO_ANY_PATCH_MODEL_H

#include <CGAL/Multisided_patches/IO/Coordinates_choice.h>
#include <CGAL/Multisided_patches/domains/Domain_options.h>
#include <CGAL/Multisided_patches/patches/Bezier_triangle_3.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_model_3.h>
#include <CGAL/Multisided_patches/patches/Tensor_product_patch_3.h>
#include <CGAL/Multisided_patches/ribbons/Generalized_bezier_net_3.h>
#include <CGAL/Multisided_patches/ribbons/S_patch_net_3.h>

#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace IO {

/*!
 * All that a file says about a concave generalized Bézier patch.
 *
 * \tparam Traits a CGAL kernel
 */
template <typename Traits>
struct Concave_bezier_description_3 : Concave_bezier_model_3<Traits> {
  Concave_bezier_description_3(Concave_bezier_model_3<Traits> model)
      : Concave_bezier_model_3<Traits>(std::move(model)) {}

  //! the vertices of the domain, one for each side, counterclockwise (domain units); if there are
  //! none, the domain is made as `domain` says
  std::vector<typename Traits::Point_2> domain_vertices;
  Coordinates_choice coordinates = Coordinates_choice::harmonic;
};

/*!
 * All that a file says about a patch of one control net over a domain that can be chosen.
 *
 * \tparam Traits a CGAL kernel
 * \tparam Net_ the control net, a class with the member `size()`, the number of sides
 */
template <typename Traits, typename Net_>
struct Net_description_3 {
  using Net = Net_;

  Net_description_3(Net control_net) : net(std::move(control_net)) {}

  Net net;
  //! how the domain is made; `regular` is a regular polygon whatever the corners of the net are
  Domain_options domain{Domain_generator::regular};
  //! as in `Concave_bezier_description_3`
  std::vector<typename Traits::Point_2> domain_vertices;
  Coordinates_choice coordinates = Coordinates_choice::wachspress;
};

//! A generalized Bézier patch. \tparam Traits a CGAL kernel
template <typename Traits>
using Generalized_bezier_description_3 =
    Net_description_3<Traits, Generalized_bezier_net_3<Traits>>;

//! An S-patch. \tparam Traits a CGAL kernel
template <typename Traits>
using S_patch_description_3 = Net_description_3<Traits, S_patch_net_3<Traits>>;

/*!
 * A patch of any type, as files describe it: what determines it, before its domain and coordinates
 * are made. Those that need nothing more are there themselves.
 *
 * \tparam Traits a CGAL kernel with exact predicates
 */
template <typename Traits>
using Any_patch_model =
    std::variant<Concave_bezier_description_3<Traits>, Generalized_bezier_description_3<Traits>,
                 S_patch_description_3<Traits>, Tensor_product_patch_3<Traits>,
                 Bezier_triangle_3<Traits>>;

//! The types of patches, in the order of `Any_patch_model`.
enum class Patch_type {
  concave_bezier,
  generalized_bezier,
  s_patch,
  tensor_product,
  bezier_triangle
};

//! the name of a type as files spell it
inline const char* to_string(Patch_type type) {
  switch (type) {
  case Patch_type::concave_bezier:
    return "concave-bezier";
  case Patch_type::generalized_bezier:
    return "generalized-bezier";
  case Patch_type::s_patch:
    return "s-patch";
  case Patch_type::tensor_product:
    return "tensor-product";
  case Patch_type::bezier_triangle:
    return "bezier-triangle";
  }
  return "";
}

//! the type of a patch
template <typename Traits>
Patch_type patch_type(const Any_patch_model<Traits>& model) {
  return static_cast<Patch_type>(model.index());
}

} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_ANY_PATCH_MODEL_H
