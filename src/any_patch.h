// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_ANY_PATCH_H
#define MULTIPATCH_ANY_PATCH_H

#include "commands.h"

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace multipatch {

// What a patch was made with.
struct Patch_origin {
  CGAL::Multisided_patches::Domain_report domain;
  std::optional<Coordinates_choice> coordinates; // if the patch needs any
  std::optional<double> error_bound;             // of the coordinates, if they have one
};

// A patch of any class: a model of MultisidedPatch_3 with which meshers and reports are compiled
// once. Copies share the patch, which never changes.
class Any_patch {
public:
  using Geom_traits = Kernel;
  using FT = Kernel::FT;
  using Point_2 = Kernel::Point_2;
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;
  using Loop = CGAL::Multisided_patches::Ribbon_loop_3<Kernel>;
  using Domain = multipatch::Domain;
  using Location = Domain::Location;
  template <int Order>
  using Surface_jet = std::array<CGAL::Multisided_patches::Jet_2<FT, Order>, 3>;

  template <typename Patch>
  Any_patch(Patch patch, Patch_origin origin)
      : patch_(std::make_shared<const Model<Patch>>(std::move(patch))), origin_(std::move(origin)) {
  }

  const Patch_origin& origin() const { return origin_; }
  const Loop& loop() const { return patch_->loop(); }
  const Domain& domain() const { return patch_->domain(); }
  double side_length(std::size_t i) const { return loop()[i].arc_length(); }

  Point_3 point(const Point_2& uv, const Location& location) const {
    return patch_->point(uv, location);
  }
  std::pair<Point_3, Vector_3> point_and_normal(const Point_2& uv, const Location& location) const {
    return patch_->point_and_normal(uv, location);
  }
  Vector_3 normal(const Point_2& uv, const Location& location) const {
    return point_and_normal(uv, location).second;
  }
  // By the formula of the patch, on the boundary, too.
  template <int Order>
  Surface_jet<Order> evaluate(const Point_2& uv, const Location& location) const {
    static_assert(Order == 2, "nothing asks for other orders");
    return patch_->second_order(uv, location);
  }

private:
  struct Interface {
    virtual ~Interface() = default;
    virtual const Loop& loop() const = 0;
    virtual const Domain& domain() const = 0;
    virtual Point_3 point(const Point_2& uv, const Location& location) const = 0;
    virtual std::pair<Point_3, Vector_3> point_and_normal(const Point_2& uv,
                                                          const Location& location) const = 0;
    virtual Surface_jet<2> second_order(const Point_2& uv, const Location& location) const = 0;
  };

  template <typename Patch>
  struct Model final : Interface {
    explicit Model(Patch patch) : patch_(std::move(patch)) {}
    const Loop& loop() const override { return patch_.loop(); }
    const Domain& domain() const override { return patch_.domain(); }
    Point_3 point(const Point_2& uv, const Location& location) const override {
      return patch_.point(uv, location);
    }
    std::pair<Point_3, Vector_3> point_and_normal(const Point_2& uv,
                                                  const Location& location) const override {
      return patch_.point_and_normal(uv, location);
    }
    Surface_jet<2> second_order(const Point_2& uv, const Location& location) const override {
      return patch_.template evaluate<2>(uv, location);
    }

    Patch patch_;
  };

  std::shared_ptr<const Interface> patch_;
  Patch_origin origin_;
};

} // namespace multipatch

#endif // MULTIPATCH_ANY_PATCH_H
