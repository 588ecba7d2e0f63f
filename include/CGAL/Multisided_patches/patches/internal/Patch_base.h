// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_PATCH_BASE_H
#define CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_PATCH_BASE_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/patches/internal/surface_derivatives.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

/*!
 * What all patches offer: a surface over a polygonal domain whose sides are the boundary curves of
 * a loop of ribbons. On the boundary points are those of the curves, and normals those of the
 * ribbons; inside both come from the formula of the patch.
 *
 * A patch never changes after its construction, and can be evaluated from many threads at once.
 *
 * \tparam Patch the class that derives from this one; it has
 *   - `const Polygonal_domain_2<Traits>& domain() const`,
 *   - `template <int Order> Surface_jet<Order> evaluate(const Point_2&, const Location&) const`,
 * and brings `Patch_base::evaluate` into scope
 * \tparam Traits a CGAL kernel with exact predicates
 */
template <typename Patch, typename Traits>
class Patch_base {
public:
  using Geom_traits = Traits;
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;
  using Loop = Ribbon_loop_3<Traits>;
  using Domain = Polygonal_domain_2<Traits>;
  using Location = typename Domain::Location;
  //! x, y and z as functions of (u,v): a point of the surface with its partial derivatives
  template <int Order, typename Real = FT>
  using Surface_jet = std::array<Jet_2<Real, Order>, 3>;

  //! the ribbons that the patch meets
  const Loop& loop() const { return loop_; }

  //! the length of the boundary curve of side `i` (model units)
  double side_length(std::size_t i) const { return loop_[i].arc_length(); }

  /*!
   * the point of the patch at `uv` (model units). On the boundary this is the point of the boundary
   * curve itself.
   *
   * \throws Outside_domain_error if `uv` lies outside the domain
   *
   * Complexity: that of `evaluate<0>()`.
   */
  Point_3 operator()(const Point_2& uv) const {
    return point(uv, patch().domain().locate_inside(uv));
  }

  //! the same where the caller knows where `uv` lies. \pre `uv` is not outside the domain
  Point_3 point(const Point_2& uv, const Location& location) const {
    if (location.is_on_boundary())
      return point_on_side(location.index, location.s);
    return to_point(patch().template evaluate<0>(uv, location));
  }

  /*!
   * the point at parameter `s` in [0,1] of boundary curve `i` (model units). In the domain this is
   * `domain().point_on_side(i, s)`, which as a rounded point may lie outside.
   */
  Point_3 point_on_side(std::size_t i, const FT& s) const { return loop_[i].boundary_point(s); }
  //! the unit normal there
  Vector_3 normal_on_side(std::size_t i, const FT& s) const {
    const Domain& domain = patch().domain();
    return normal(domain.point_on_side(i, s), domain.location_on_side(i, s));
  }

  /*!
   * the point and its partial derivatives up to `Order` (0, 1 or 2) at a point of which only the
   * position is known. \throws Outside_domain_error
   */
  template <int Order>
  Surface_jet<Order> evaluate(const Point_2& uv) const {
    return patch().template evaluate<Order>(uv, patch().domain().locate_inside(uv));
  }

  /*!
   * evaluates many points at once.
   *
   * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the
   * result is the same
   * \param points a random access range of `Point_2` in the domain
   * \param out receives one `Point_3` for each, in order, as `operator()()` gives it
   * \return one past the last element written
   *
   * \throws Outside_domain_error if one of the points lies outside the domain
   */
  template <typename ConcurrencyTag = Parallel_if_available_tag, typename PointRange,
            typename OutputIterator>
  OutputIterator evaluate_points(const PointRange& points, OutputIterator out) const {
    std::vector<Location> locations(points.size());
    for_each_index<ConcurrencyTag>(points.size(), [&](std::size_t k) {
      locations[k] = patch().domain().locate_inside(points[k]);
    });
    return write_results<ConcurrencyTag, Point_3>(
        points.size(), out, [&](std::size_t begin, std::size_t end, auto results) {
          evaluate_inside<0>(
              begin, end, points, locations,
              [&](std::size_t k) { results[k] = point(points[k], locations[k]); },
              [&](std::size_t k, const Surface_jet<0>& surface) {
                results[k] = to_point(surface);
              });
        });
  }

  /*!
   * the points and their partial derivatives up to `Order` (0, 1 or 2) at many points: what
   * `evaluate()` gives for each, to the last bit, but several times faster if `FT` is `double` and
   * the patch has a control net. (If the compiler is allowed to contract products and sums, last
   * bits may differ. Neither the number of threads nor what else is evaluated ever matters.)
   *
   * \param points a random access range of `Point_2`
   * \param locations a random access range of as many `Location`s, those of the points
   * \param out receives one `Surface_jet<Order>` for each point, in order
   * \return one past the last element written
   *
   * \pre no point is outside the domain
   */
  template <int Order, typename ConcurrencyTag = Parallel_if_available_tag, typename PointRange,
            typename LocationRange, typename OutputIterator>
  OutputIterator evaluate_batch(const PointRange& points, const LocationRange& locations,
                                OutputIterator out) const {
    CGAL_precondition(points.size() == locations.size());
    return write_results<ConcurrencyTag, Surface_jet<Order>>(
        points.size(), out, [&](std::size_t begin, std::size_t end, auto results) {
          patch().template evaluate_block<Order>(
              end - begin, [&](std::size_t k) -> const auto& { return points[begin + k]; },
              [&](std::size_t k) -> const auto& { return locations[begin + k]; },
              [&](std::size_t k, const Surface_jet<Order>& surface) {
                results[begin + k] = surface;
              });
        });
  }

  /*!
   * the points and normals at many points: what `point_and_normal()` gives for each, to the last
   * bit as far as `evaluate_batch()` does, and as fast.
   *
   * \param points, locations as for `evaluate_batch()`
   * \param out receives one `std::pair<Point_3, Vector_3>` for each point, in order
   * \return one past the last element written
   *
   * \pre no point is outside the domain
   */
  template <typename ConcurrencyTag = Parallel_if_available_tag, typename PointRange,
            typename LocationRange, typename OutputIterator>
  OutputIterator points_and_normals(const PointRange& points, const LocationRange& locations,
                                    OutputIterator out) const {
    CGAL_precondition(points.size() == locations.size());
    return write_results<ConcurrencyTag, std::pair<Point_3, Vector_3>>(
        points.size(), out, [&](std::size_t begin, std::size_t end, auto results) {
          evaluate_inside<1>(
              begin, end, points, locations,
              [&](std::size_t k) { results[k] = point_and_normal(points[k], locations[k]); },
              [&](std::size_t k, const Surface_jet<1>& surface) {
                results[k] =
                    std::make_pair(to_point(surface), to_vector(tangent_plane_normal(surface)));
              });
        });
  }

  //! the unit normal at `uv`, on the side from which the boundary runs counterclockwise; zero where
  //! the patch has no tangent plane. \throws Outside_domain_error
  Vector_3 normal(const Point_2& uv) const {
    return normal(uv, patch().domain().locate_inside(uv));
  }

  /*!
   * the same where the caller knows where `uv` lies. On the boundary the normal is that of the
   * ribbon, as far as the ribbon has cross-derivatives. \pre `uv` is not outside the domain
   */
  Vector_3 normal(const Point_2& uv, const Location& location) const {
    Vec3 n{0, 0, 0};
    if (location.is_on_boundary())
      n = ribbon_normal(location);
    if (n == Vec3{0, 0, 0})
      n = tangent_plane_normal(patch().template evaluate<1>(uv, location));
    return to_vector(n);
  }

  //! `point()` and `normal()` at the cost of one evaluation
  std::pair<Point_3, Vector_3> point_and_normal(const Point_2& uv, const Location& location) const {
    if (location.is_on_boundary())
      return {point(uv, location), normal(uv, location)};
    const Surface_jet<1> surface = patch().template evaluate<1>(uv, location);
    return {to_point(surface), to_vector(tangent_plane_normal(surface))};
  }

#ifndef DOXYGEN_RUNNING
  // What patches without a faster way have; see Control_net_patch.
  template <int Order, typename PointOf, typename LocationOf, typename Function>
  void evaluate_block(std::size_t count, const PointOf& point_of, const LocationOf& location_of,
                      const Function& f) const {
    for (std::size_t k = 0; k < count; ++k)
      f(k, patch().template evaluate<Order>(point_of(k), location_of(k)));
  }
#endif

protected:
  explicit Patch_base(Loop loop) : loop_(std::move(loop)) {}

private:
  const Patch& patch() const {
    return static_cast<const Patch&>(*this);
  }

  // Calls f(begin, end, results) for blocks that make up all indices below `count`, in parallel;
  // results[k] is what is written to `out` for index k.
  template <typename ConcurrencyTag, typename Result, typename OutputIterator, typename Function>
  static OutputIterator write_results(std::size_t count, OutputIterator out, const Function& f) {
    using Category = typename std::iterator_traits<OutputIterator>::iterator_category;
    if constexpr (std::is_convertible_v<Category, std::random_access_iterator_tag>) {
      constexpr std::size_t block = 256; // takes far longer than handing it to a thread
      for_each_index<ConcurrencyTag>(
          (count + block - 1) / block,
          [&](std::size_t b) { f(b * block, (std::min)((b + 1) * block, count), out); }, 1);
      return out + static_cast<std::ptrdiff_t>(count);
    } else {
      std::vector<Result> results(count);
      write_results<ConcurrencyTag, Result>(count, results.begin(), f);
      return std::copy(results.begin(), results.end(), out);
    }
  }

  // Calls inside(k, jets) for the points inside the domain, and on_boundary(k) for all others.
  template <int Order, typename PointRange, typename LocationRange, typename OnBoundary,
            typename Inside>
  void evaluate_inside(std::size_t begin, std::size_t end, const PointRange& points,
                       const LocationRange& locations, const OnBoundary& on_boundary,
                       const Inside& inside) const {
    boost::container::small_vector<std::size_t, 256> indices;
    for (std::size_t k = begin; k < end; ++k)
      if (locations[k].is_on_boundary())
        on_boundary(k);
      else
        indices.push_back(k);
    patch().template evaluate_block<Order>(
        indices.size(), [&](std::size_t k) -> const auto& { return points[indices[k]]; },
        [&](std::size_t k) -> const auto& { return locations[indices[k]]; },
        [&](std::size_t k, const Surface_jet<Order>& surface) { inside(indices[k], surface); });
  }

  Vec3 ribbon_normal(const Location& location) const {
    if (location.kind == Location::Kind::vertex)
      return to_vec3(loop_.corner_normal(location.index));
    const auto& ribbon = loop_[location.index];
    if (ribbon.layers() < 2)
      return {0, 0, 0};
    return internal::tangent_plane_normal(to_vec3(ribbon.boundary_derivative(location.s)),
                                          to_vec3(ribbon.cross_derivative(location.s)));
  }

  template <int Order>
  static Point_3 to_point(const Surface_jet<Order>& surface) {
    return Point_3(surface[0].value(), surface[1].value(), surface[2].value());
  }

  static Vec3 tangent_plane_normal(const Surface_jet<1>& surface) {
    const auto derivative = [&](std::size_t i) {
      return Vec3{CGAL::to_double(surface[0][i]), CGAL::to_double(surface[1][i]),
                  CGAL::to_double(surface[2][i])};
    };
    return internal::tangent_plane_normal(derivative(1), derivative(2));
  }

  static Vector_3 to_vector(const Vec3& v) {
    return Vector_3(FT(v[0]), FT(v[1]), FT(v[2]));
  }

  Loop loop_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_PATCH_BASE_H
