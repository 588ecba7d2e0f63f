// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_WITH_RESOLVED_CENTRAL_WEIGHT_H
#define CGAL_MULTISIDED_PATCHES_WITH_RESOLVED_CENTRAL_WEIGHT_H

#include <CGAL/Multisided_patches/bases/Central_weight.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_model_3.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <cstddef>

namespace CGAL {
namespace Multisided_patches {

/*!
 * the same model with the central weight that its patch has, with its own domain and harmonic
 * coordinates, in place of `Central_weight::automatic`, and the central control point that goes
 * with it. A model that names a weight stays as it is.
 *
 * A patch that you have at hand has them in `basis().central_weight()` and
 * `control_point(basis().central_index())`.
 *
 * \tparam Traits a CGAL kernel with inexact constructions, as `Harmonic_coordinates_2` needs it
 *
 * \throws Input_error, Accuracy_error if the model leaves the choice to the patch, and its patch
 * cannot be made
 *
 * Complexity: that of making the patch, if the model leaves it the choice.
 */
template <typename Traits>
Concave_bezier_model_3<Traits> with_resolved_central_weight(Concave_bezier_model_3<Traits> model) {
  if (model.central_weight != Central_weight::automatic)
    return model;
  const Concave_bezier_patch_3<Traits> patch(model);
  model.central_weight = patch.basis().central_weight();
  model.central_point = patch.control_point(patch.basis().central_index());
  return model;
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_WITH_RESOLVED_CENTRAL_WEIGHT_H
