// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_ANY_PATCH_H
#define MULTIPATCH_ANY_PATCH_H

#include "commands.h"

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
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
  // what a patch has that can choose it itself
  std::optional<CGAL::Multisided_patches::Central_weight> central_weight;
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
  template <typename ConcurrencyTag, typename Points, typename Locations, typename Iterator>
  Iterator points_and_normals(const Points& points, const Locations& locations,
                              Iterator out) const {
    constexpr std::size_t block = 256; // takes far longer than handing it to a thread
    const std::size_t n = points.size();
    CGAL::Multisided_patches::internal::for_each_index<ConcurrencyTag>(
        (n + block - 1) / block,
        [&](std::size_t b) {
          const std::size_t first = b * block, count = (std::min)(block, n - first);
          std::array<Point_and_normal, block> results;
          patch_->points_and_normals(&points[first], &locations[first], count, results.data());
          std::copy_n(results.begin(), count, out + first);
        },
        1);
    return out + n;
  }
  // By the formula of the patch, on the boundary, too.
  template <int Order>
  Surface_jet<Order> evaluate(const Point_2& uv, const Location& location) const {
    static_assert(Order == 2, "nothing asks for other orders");
    return patch_->second_order(uv, location);
  }

private:
  using Point_and_normal = std::pair<Point_3, Vector_3>;

  struct Interface {
    virtual ~Interface() = default;
    virtual const Loop& loop() const = 0;
    virtual const Domain& domain() const = 0;
    virtual Point_3 point(const Point_2& uv, const Location& location) const = 0;
    virtual std::pair<Point_3, Vector_3> point_and_normal(const Point_2& uv,
                                                          const Location& location) const = 0;
    virtual void points_and_normals(const Point_2* points, const Location* locations,
                                    std::size_t count, Point_and_normal* results) const = 0;
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
    void points_and_normals(const Point_2* points, const Location* locations, std::size_t count,
                            Point_and_normal* results) const override {
      patch_.template points_and_normals<CGAL::Sequential_tag>(
          boost::make_iterator_range(points, points + count),
          boost::make_iterator_range(locations, locations + count), results);
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
