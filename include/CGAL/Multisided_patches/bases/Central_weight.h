// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CENTRAL_WEIGHT_H
#define CGAL_MULTISIDED_PATCHES_CENTRAL_WEIGHT_H

namespace CGAL {
namespace Multisided_patches {

/*!
 * The weight of the central control point of a patch with n sides; h_i is the side parameter that
 * is 0 on side i. Every variant but `weight_deficiency` is followed by a division by the sum of all
 * weights. The products vanish on the boundary together with their first derivatives, and so does
 * the deficiency if all ribbons have at least 2 layers and degree 3.
 */
enum class Central_weight {
  //! what the weights of the ribbons lack to 1; it can be negative where they exceed 1
  weight_deficiency,
  //! no central control point
  none,
  //! n Σ_i h_i² (1 - h_i)² h_{i+1}² (1 - h_{i+1})², for n = 3 the product 3 Π_i h_i² (1 - h_i)²
  adjacent_products,
  //! 2/9 (1 - 2/n)^{-2n} Π_i h_i², which is 2/9 where all coordinates are equal
  full_product,
  //! one of the others, which a patch chooses for its domain when it is made: see
  //! `automatic_central_weight()`. A basis has no domain, and needs one of the others.
  automatic
};

//! the name of a variant, for messages and files
inline const char* to_string(Central_weight weight) {
  switch (weight) {
  case Central_weight::weight_deficiency:
    return "weight-deficiency";
  case Central_weight::none:
    return "none";
  case Central_weight::adjacent_products:
    return "adjacent-products";
  case Central_weight::full_product:
    return "full-product";
  case Central_weight::automatic:
    return "automatic";
  }
  return "";
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CENTRAL_WEIGHT_H
