// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_S_PATCH_NET_3_H
#define CGAL_MULTISIDED_PATCHES_S_PATCH_NET_3_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/bernstein.h>
#include <CGAL/Multisided_patches/internal/check_finite.h>
#include <CGAL/Multisided_patches/ribbons/Bezier_ribbon_3.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>
#include <CGAL/Multisided_patches/ribbons/internal/multi_index.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The control net of an S-patch with n sides and depth d: one point P_i for every multi-index
 * i = (i_0, …, i_{n-1}) of non-negative integers whose sum is d, which are (n + d - 1 choose d)
 * (Loop and DeRose, *A multisided generalization of Bézier surfaces*, ACM Transactions on Graphics
 * 8, 1989).
 *
 * P_i has the weight d! / (i_0! ⋯ i_{n-1}!) λ_0^{i_0} ⋯ λ_{n-1}^{i_{n-1}}. For three sides this is
 * the control net of a Bézier triangle. Side i has the control polygon of all points whose indices
 * are 0 but for entries i and i + 1.
 *
 * Points are stored in lexicographically descending order of their indices: that of (d, 0, …, 0)
 * first, that of (0, …, 0, d) last.
 *
 * \tparam Traits a CGAL kernel
 */
template <typename Traits>
class S_patch_net_3 {
public:
  using Geom_traits = Traits;
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;
  using Loop = Ribbon_loop_3<Traits>;
  //! an index of a control point: n non-negative integers with the sum d
  using Multi_index = std::vector<std::size_t>;

  //! the largest number of sides, and of control points
  static constexpr std::size_t max_sides = 1000, max_control_points = internal::max_multi_indices;
  //! the largest depth: 200, or 60 in `float`, such that second derivatives do not overflow
  static constexpr std::size_t max_depth =
      (std::min)(internal::max_s_patch_depth, internal::max_bernstein_degree<FT>() / 2);

  /*!
   * stores a net.
   *
   * \param sides n, from 3 to 1000
   * \param depth d, from 1 to 200 (60 in `float`)
   * \param control_points (n + d - 1 choose d) points in lexicographically descending order of
   * their multi-indices (model units)
   *
   * \throws Input_error if the net would have more than 5 million points, the sizes do not fit
   * together or a coordinate is not finite
   */
  S_patch_net_3(std::size_t sides, std::size_t depth, std::vector<Point_3> control_points)
      : sides_(sides), depth_(depth), control_points_(std::move(control_points)) {
    const std::size_t expected = number_of_control_points(sides, depth);
    if (control_points_.size() != expected)
      throw Input_error("the net of " + text(sides, depth) + " has " + std::to_string(expected) +
                        " points, not " + std::to_string(control_points_.size()));
    internal::check_finite(control_points_, "the net");
  }

  /*!
   * the number of points that such a net has.
   *
   * \throws Input_error if there is no such net, or it is too large
   */
  static std::size_t number_of_control_points(std::size_t sides, std::size_t depth) {
    if (sides < 3 || depth < 1)
      throw Input_error("an S-patch needs at least 3 sides and depth 1, not " +
                        std::to_string(sides) + " sides and depth " + std::to_string(depth));
    if (sides > max_sides || depth > max_depth)
      throw Input_error(text(sides, depth) + " is beyond the largest, " +
                        std::to_string(max_sides) + " sides and depth " +
                        std::to_string(max_depth));
    const std::size_t number = internal::number_of_multi_indices(sides, depth);
    if (number > max_control_points)
      throw Input_error("the net of " + text(sides, depth) + " has more than " +
                        std::to_string(max_control_points) + " points");
    return number;
  }

  //! the number n of sides
  std::size_t size() const { return sides_; }
  //! the sum d of every multi-index
  std::size_t depth() const { return depth_; }
  std::size_t next(std::size_t i) const { return i + 1 == sides_ ? 0 : i + 1; }
  std::size_t prev(std::size_t i) const { return i == 0 ? sides_ - 1 : i - 1; }

  /*!
   * the index in `control_points()` of the point with this multi-index. Complexity: O(n min(n, d)).
   * \pre it has `size()` entries with the sum `depth()`
   */
  std::size_t index(const Multi_index& multi_index) const {
    CGAL_precondition(multi_index.size() == sides_);
    CGAL_precondition(std::accumulate(multi_index.begin(), multi_index.end(), std::size_t(0)) ==
                      depth_);
    return internal::rank_of_multi_index(multi_index);
  }
  //! the multi-index of the point `control_points()[index]`
  Multi_index multi_index(std::size_t index) const {
    CGAL_precondition(index < control_points_.size());
    return internal::multi_index_of_rank(sides_, depth_, index);
  }
  /*!
   * calls `function(multi_index, point)` for every control point, in order. Complexity: O(n) for
   * each.
   */
  template <typename Function>
  void for_each_control_point(const Function& function) const {
    Multi_index multi_index = internal::first_multi_index(sides_, depth_);
    for (const Point_3& p : control_points_) {
      function(static_cast<const Multi_index&>(multi_index), p);
      internal::advance(multi_index);
    }
  }

  //! the control point with this multi-index. \pre as for `index()`
  const Point_3& control_point(const Multi_index& multi_index) const {
    return control_points_[index(multi_index)];
  }
  //! all control points, in order
  const std::vector<Point_3>& control_points() const { return control_points_; }

  //! the same net with other points. \throws Input_error as the constructor
  S_patch_net_3 with_control_points(std::vector<Point_3> control_points) const {
    return S_patch_net_3(sides_, depth_, std::move(control_points));
  }

  //! the multi-index of control point `j` of side `i`: d - j at entry i, j at the next one
  Multi_index boundary_index(std::size_t i, std::size_t j) const {
    CGAL_precondition(i < sides_ && j <= depth_);
    Multi_index multi_index(sides_, 0);
    multi_index[i] = depth_ - j;
    multi_index[next(i)] = j;
    return multi_index;
  }

  //! the boundary curve of side `i` as a ribbon with one layer, of degree d
  Bezier_ribbon_3<Traits> boundary(std::size_t i) const {
    std::vector<Point_3> points;
    for (std::size_t j = 0; j <= depth_; ++j)
      points.push_back(control_point(boundary_index(i, j)));
    return Bezier_ribbon_3<Traits>(depth_, 1, std::move(points));
  }

  /*!
   * the boundary curves in order: ribbons with one layer, which tell nothing of tangent planes. A
   * net that was made to meet ribbons, by `fill_with_S_patch()`, does not know them; keep
   * `S_patch_3::loop()` of that patch where they matter.
   *
   * \throws Input_error if they are no loop, because a side is a single point
   */
  Loop loop() const {
    std::vector<Bezier_ribbon_3<Traits>> ribbons;
    for (std::size_t i = 0; i < sides_; ++i)
      ribbons.push_back(boundary(i));
    return Loop(std::move(ribbons));
  }

  /*!
   * the net of depth d + 1 of the same patch, whatever its coordinates: its point with index i is
   * Σ_k i_k / (d + 1) P_{i - e_k}.
   *
   * It is the same surface, but a patch that is made from the net alone has `loop()` with one
   * layer. Where the ribbons of the patch before matter, pass them on:
   * `Patch(patch.net().elevated(), patch.loop(), patch.coordinates())`.
   *
   * \throws Input_error if that net is too large
   *
   * Complexity: O(n² min(n, d)) for each of its points, or less.
   */
  S_patch_net_3 elevated() const {
    const std::size_t number = number_of_control_points(sides_, depth_ + 1);
    const FT depth(static_cast<int>(depth_ + 1));
    std::vector<Point_3> points;
    points.reserve(number);
    Multi_index i = internal::first_multi_index(sides_, depth_ + 1);
    do {
      // Written as steps from one of the points, those that coincide stay as they are.
      const Point_3* origin = nullptr;
      Vector_3 sum(FT(0), FT(0), FT(0));
      for (std::size_t k = 0; k < sides_; ++k) {
        if (i[k] == 0)
          continue;
        const FT share = FT(static_cast<int>(i[k])) / depth;
        --i[k];
        const Point_3& p = control_points_[internal::rank_of_multi_index(i)];
        ++i[k];
        if (origin == nullptr)
          origin = &p;
        else
          sum = sum + share * (p - *origin);
      }
      points.push_back(*origin + sum);
    } while (internal::advance(i));
    return S_patch_net_3(sides_, depth_ + 1, std::move(points));
  }

private:
  static std::string text(std::size_t sides, std::size_t depth) {
    return "an S-patch with " + std::to_string(sides) + " sides and depth " + std::to_string(depth);
  }

  std::size_t sides_, depth_;
  std::vector<Point_3> control_points_;
};

/*!
 * evaluates an S-patch by the algorithm of de Casteljau: d times, every n points with indices
 * i + e_k are replaced by their combination Σ_k λ_k P_{i + e_k}. It is slower than
 * `S_patch_basis::combine()`, and depends on nothing else.
 *
 * \tparam T the number type: `FT`, a `Jet_2`, or any other with the operations of a ring into which
 * `FT` converts
 *
 * \param net the control points
 * \param lambda `net.size()` coordinates
 *
 * \return the coordinates of the point
 *
 * Complexity: O(n² min(n, d)) for each point of the nets of all depths up to d.
 */
template <typename Traits, typename T>
std::array<T, 3> s_patch_de_casteljau(const S_patch_net_3<Traits>& net, const T* lambda) {
  using FT = typename Traits::FT;
  using Scalar = typename internal::Scalar_of<T>::type;
  std::vector<std::array<T, 3>> points;
  for (const auto& p : net.control_points())
    points.push_back({T(Scalar(FT(p.x()))), T(Scalar(FT(p.y()))), T(Scalar(FT(p.z())))});
  for (std::size_t depth = net.depth(); depth > 0; --depth) {
    std::vector<std::array<T, 3>> combined;
    internal::Multi_index i = internal::first_multi_index(net.size(), depth - 1);
    do {
      std::array<T, 3> sum{T(0), T(0), T(0)};
      for (std::size_t k = 0; k < net.size(); ++k) {
        ++i[k];
        const std::array<T, 3>& p = points[internal::rank_of_multi_index(i)];
        --i[k];
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += lambda[k] * p[c];
      }
      combined.push_back(std::move(sum));
    } while (internal::advance(i));
    points = std::move(combined);
  }
  return points.front();
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_S_PATCH_NET_3_H
