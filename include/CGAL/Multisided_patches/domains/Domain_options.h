// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_DOMAIN_OPTIONS_H
#define CGAL_MULTISIDED_PATCHES_DOMAIN_OPTIONS_H

namespace CGAL {
namespace Multisided_patches {

//! The ways to make a planar domain from a ribbon loop.
enum class Domain_generator {
  automatic,        //!< the first of the others, in a fixed order, that gives a good domain
  projected,        //!< corner points projected onto their least-squares plane
  similarity,       //!< arc lengths and interior angles of the loop, all angles scaled alike
  similarity_outer, //!< the same, but at reflex corners the outer angle is scaled
  curved,           //!< sides that follow the boundary curves; until these exist: similarity
  circular,         //!< corners on a circle; convex loops only
  regular           //!< a regular polygon, dented where the loop has reflex corners
};

//! the name of a generator as the command line and reports spell it
inline const char* to_string(Domain_generator generator) {
  switch (generator) {
  case Domain_generator::automatic:
    return "automatic";
  case Domain_generator::projected:
    return "projected";
  case Domain_generator::similarity:
    return "similarity";
  case Domain_generator::similarity_outer:
    return "similarity-outer";
  case Domain_generator::curved:
    return "curved";
  case Domain_generator::circular:
    return "circular";
  case Domain_generator::regular:
    return "regular";
  }
  return "";
}

//! What a user may say about the domain of a patch.
struct Domain_options {
  //! the generator to try first
  Domain_generator generator = Domain_generator::automatic;
  /*!
   * the wanted distance between sides that share no vertex, as a fraction of the larger side of the
   * domain's bounding box. It is a wish: where it cannot be reached, the best valid domain is taken
   * and the `Domain_report` says so.
   */
  double clearance = 0.05;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_DOMAIN_OPTIONS_H
