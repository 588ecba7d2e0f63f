// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_DOMAIN_LOCATION_H
#define CGAL_MULTISIDED_PATCHES_DOMAIN_LOCATION_H

#include <cstddef>

namespace CGAL {
namespace Multisided_patches {

/*!
 * Where a point lies with respect to a `Polygonal_domain_2`.
 *
 * \tparam FT the number type of the domain
 */
template <typename FT>
struct Domain_location {
  enum class Kind { outside, vertex, side, interior };

  Kind kind = Kind::interior;
  std::size_t index = 0; //!< of the vertex or the side, if there is one
  FT s = FT(0);          //!< on a side: the parameter, 0 at its source and 1 at its target

  static Domain_location outside() { return {Kind::outside, 0, FT(0)}; }
  static Domain_location interior() { return {Kind::interior, 0, FT(0)}; }
  static Domain_location on_vertex(std::size_t i) { return {Kind::vertex, i, FT(0)}; }
  //! \pre `0 < s < 1`
  static Domain_location on_side(std::size_t i, const FT& s) { return {Kind::side, i, s}; }

  bool is_on_boundary() const { return kind == Kind::vertex || kind == Kind::side; }
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_DOMAIN_LOCATION_H
