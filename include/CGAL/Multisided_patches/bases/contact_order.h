// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_CONTACT_ORDER_H
#define CGAL_MULTISIDED_PATCHES_CONTACT_ORDER_H

#include <CGAL/Multisided_patches/bases/Central_weight.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

namespace internal {

// The order to which the weight of the central control point vanishes on the sides. The deficiency
// vanishes to the order that everything else leaves it; and what is chosen automatically never
// lowers an order of contact.
inline std::size_t vanishing_order(Central_weight weight) {
  const bool product =
      weight == Central_weight::adjacent_products || weight == Central_weight::full_product;
  return product ? 2 : (std::numeric_limits<std::size_t>::max)();
}

// The order to which the weights of a side of this degree vanish on its neighbours, if those have
// no more layers than that.
inline std::size_t vanishing_order_on_neighbours(std::size_t degree) {
  return (degree + 1) / 2;
}

// 1 + the order of contact that side i would have if the degrees of its neighbours were high.
template <typename Loop>
std::size_t order_without_neighbours(const Loop& loop, std::size_t i, Central_weight weight) {
  std::size_t order = (std::min)(loop[i].layers(), vanishing_order(weight));
  for (std::size_t j = loop.next(loop.next(i)); j != loop.prev(i); j = loop.next(j))
    order = (std::min)(order, loop[j].layers());
  return order;
}

// "a, b and c"
inline std::string enumeration(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t k = 0; k < items.size(); ++k)
    text += (k == 0 ? "" : k + 1 < items.size() ? ", " : " and ") + items[k];
  return text;
}

inline std::string continuity_name(std::size_t order) {
  switch (order) {
  case 0:
    return "position continuity";
  case 1:
    return "tangent plane continuity";
  case 2:
    return "curvature continuity";
  default:
    return "continuity of order " + std::to_string(order);
  }
}

// "side a" or "sides a, b and c"; of many it names a few.
inline std::string sides_text(const std::vector<std::size_t>& sides) {
  const std::size_t named = sides.size() <= 6 ? sides.size() : 5;
  std::vector<std::string> items;
  for (std::size_t k = 0; k < named; ++k)
    items.push_back(std::to_string(sides[k]));
  if (named < sides.size())
    items.push_back(std::to_string(sides.size() - named) + " more");
  return (sides.size() == 1 ? "side " : "sides ") + enumeration(items);
}

// What it takes for side i to be met to the order of its layers, and is missing.
template <typename Loop>
std::vector<std::string> missing_for_contact(const Loop& loop, std::size_t i,
                                             Central_weight weight) {
  const std::size_t layers = loop[i].layers(), before = loop.prev(i), after = loop.next(i);
  std::vector<std::size_t> low, shallow;
  for (std::size_t j = 0; j < loop.size(); ++j)
    if (j == before || j == after) {
      if (vanishing_order_on_neighbours(loop[j].degree()) < layers)
        low.push_back(j);
    } else if (loop[j].layers() < layers) {
      shallow.push_back(j);
    }
  std::vector<std::string> missing;
  if (!low.empty())
    missing.push_back("degree " + std::to_string(2 * layers - 1) + " on " + sides_text(low));
  if (!shallow.empty())
    missing.push_back(std::to_string(layers) + " layers on " + sides_text(shallow));
  if (vanishing_order(weight) < layers)
    missing.push_back("the central weight none or weight-deficiency");
  return missing;
}

} // namespace internal

/*!
 * the order up to which the concave Bézier patch of a loop has the derivatives of ribbon `i` all
 * along side `i`, up to a change of parameters: 0 for the boundary curve only, 1 for the tangent
 * planes too (G1), 2 for the curvatures too (G2), and so on. Ribbon `i` promises
 * `loop[i].layers() - 1`, and the order is never higher.
 *
 * The order is r if r is the largest number for which the loop has at least
 *
 * | order | layers of side i | degrees of its 2 neighbours | layers of all other sides |
 * | ----- | ---------------- | --------------------------- | ------------------------- |
 * | 0     | 1                | 1                           | 1                         |
 * | 1     | 2                | 3                           | 2                         |
 * | 2     | 3                | 5                           | 3                         |
 * | r     | r + 1            | 2r + 1                      | r + 1                     |
 *
 * and with the central weights `adjacent_products` and `full_product` it is not higher than 1;
 * `automatic` has the orders of `none`. The degree of side i itself and the layers of its
 * neighbours do not matter, nor do the domain and the parameter dilation. At the corners, where
 * weights are discontinuous, nothing is said. The manual has the reasons.
 *
 * \tparam Loop `Ribbon_loop_3`, or a class with its `size()`, `next()` and `prev()` whose
 * `operator[]` gives objects with `degree()` and `layers()`
 *
 * Complexity: linear in the number of sides.
 */
template <typename Loop>
std::size_t contact_order(const Loop& loop, std::size_t i,
                          Central_weight central_weight = Central_weight::none) {
  CGAL_precondition(i < loop.size());
  const std::size_t order = internal::order_without_neighbours(loop, i, central_weight);
  const std::size_t degree = (std::min)(loop[loop.prev(i)].degree(), loop[loop.next(i)].degree());
  return (std::min)(order, internal::vanishing_order_on_neighbours(degree)) - 1;
}

/*!
 * says in words that `contact_order()` is lower than the layers of side `i` promise, and what is
 * missing; empty if it is not. For instance "side 3 promises curvature continuity by its 3 layers
 * but gets tangent plane continuity only; it takes degree 5 on side 4 and 3 layers on sides 0 and
 * 6".
 *
 * \tparam Loop as for `contact_order()`
 *
 * Complexity: linear in the number of sides.
 */
template <typename Loop>
std::string contact_shortfall(const Loop& loop, std::size_t i,
                              Central_weight central_weight = Central_weight::none) {
  const std::size_t order = contact_order(loop, i, central_weight), layers = loop[i].layers();
  if (order + 1 == layers)
    return {};
  return "side " + std::to_string(i) + " promises " + internal::continuity_name(layers - 1) +
         " by its " + std::to_string(layers) + " layers but gets " +
         internal::continuity_name(order) + " only; it takes " +
         internal::enumeration(internal::missing_for_contact(loop, i, central_weight));
}

/*!
 * the degrees that the ribbons of a loop need so that every `contact_order()` is as high as the
 * numbers of layers and the central weight allow: for each ribbon the smallest such degree that is
 * not below the ribbon's own.
 *
 * \tparam Loop as for `contact_order()`
 *
 * Complexity: quadratic in the number of sides.
 */
template <typename Loop>
std::vector<std::size_t> degrees_for_contact(const Loop& loop,
                                             Central_weight central_weight = Central_weight::none) {
  std::vector<std::size_t> degrees;
  for (std::size_t i = 0; i < loop.size(); ++i)
    degrees.push_back(loop[i].degree());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t needed = 2 * internal::order_without_neighbours(loop, i, central_weight) - 1;
    for (const std::size_t j : {loop.prev(i), loop.next(i)})
      degrees[j] = (std::max)(degrees[j], needed);
  }
  return degrees;
}

/*!
 * the same loop with its ribbons elevated to `degrees_for_contact()`. All ribbons stay the same
 * surfaces; the patch between them changes, as elevated control points have other weights.
 *
 * With inexact arithmetic, elevated boundary curves are rounded. So two patches that share a curve
 * agree on it bit for bit only if both elevate it to the same degree, or neither does.
 *
 * Complexity: quadratic in the number of sides, plus the elevations.
 */
template <typename Traits>
Ribbon_loop_3<Traits> elevated_for_contact(const Ribbon_loop_3<Traits>& loop,
                                           Central_weight central_weight = Central_weight::none) {
  const std::vector<std::size_t> degrees = degrees_for_contact(loop, central_weight);
  std::vector<Bezier_ribbon_3<Traits>> ribbons;
  for (std::size_t i = 0; i < loop.size(); ++i)
    ribbons.push_back(loop[i].elevated(degrees[i]));
  return Ribbon_loop_3<Traits>(std::move(ribbons));
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_CONTACT_ORDER_H
