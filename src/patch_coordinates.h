// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_PATCH_COORDINATES_H
#define MULTIPATCH_PATCH_COORDINATES_H

#include "commands.h"

#include <CGAL/Multisided_patches/Jet_2.h>

#include <memory>
#include <optional>

namespace multipatch {

// The coordinates of a patch, whichever the user has chosen: a model of BarycentricCoordinates_2
// with which each patch class is compiled once.
class Patch_coordinates {
public:
  using Geom_traits = Kernel;
  using FT = Kernel::FT;
  using Point_2 = Kernel::Point_2;
  using Domain = multipatch::Domain;
  using Location = Domain::Location;
  template <int Order>
  using Jet = CGAL::Multisided_patches::Jet_2<FT, Order>;

  // As patches make them: harmonic ones that cannot be computed to 1e-8 may be less accurate.
  Patch_coordinates(Coordinates_choice choice, const Domain& domain);

  const Domain& domain() const;

  template <int Order>
  void evaluate(const Point_2& p, const Location& location, Jet<Order>* lambda) const {
    compute(p, location, lambda);
  }

  // Only harmonic coordinates have one.
  std::optional<double> error_bound() const;

private:
  void compute(const Point_2& p, const Location& location, Jet<0>* lambda) const;
  void compute(const Point_2& p, const Location& location, Jet<1>* lambda) const;
  void compute(const Point_2& p, const Location& location, Jet<2>* lambda) const;

  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

} // namespace multipatch

#endif // MULTIPATCH_PATCH_COORDINATES_H
