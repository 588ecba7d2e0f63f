// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_PATCH_EVALUATOR_H
#define CGAL_MULTISIDED_PATCHES_PATCH_EVALUATOR_H

#include <CGAL/Multisided_patches/internal/Number_pack.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/patches/internal/Weight_block.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The points of a patch at fixed places of its domain, for control points that move: the tool for
 * interactive editing and for fitting.
 *
 * The weights of the control points do not depend on where these are. So they are computed once,
 * and after that all points are one product of a matrix and the control net, and one moved control
 * point adds a multiple of one column. Domain and coordinates stay those of the patch; a patch
 * constructed from the changed net would have the same if it were given `patch.coordinates()`.
 *
 * On the boundary, too, points and normals are those of the weights: the points are those of the
 * boundary curves up to rounding. At a corner that is not straight the derivatives are those with
 * which the surface is tangent to both boundary curves: those of the patch, if it has some, which
 * at reflex corners, or with mean value coordinates, it has not. Close to a corner derivatives lose
 * digits, as the weights of the points that ribbons have there in common have large derivatives of
 * opposite sign: at the distance r the error is about ε / r, where the size of the net and the
 * domain are 1, and ε is the rounding of `Storage`. (The patch itself does better.)
 *
 * Control points that several ribbons
 * have in common, at the corners, are control points of each: they have to move together.
 *
 * Memory: for n control points `sizeof(Storage)` (1 + 2 `Order`) n bytes per sample, less what
 * `number_of_stored_weights()` says is not needed, and 24 (`Order` = 0) or 72 bytes per sample for
 * results. On the boundary most weights are 0; inside, hardly any.
 *
 * The const members may be called from several threads at once.
 *
 * \tparam Patch a patch with a control net and a `ControlNetBasis`: `Concave_bezier_patch_3`,
 * `Generalized_bezier_patch_3` or `S_patch_3`, whose number type is `double`
 * \tparam Order 0 for points only, or 1 for first derivatives and normals, too
 * \tparam Storage the number type of the weights: `double`, or `float`, which takes half the
 * memory, for errors of a few 1e-7 of the size of the net in points
 */
template <typename Patch, int Order = 1, typename Storage = double>
class Patch_evaluator {
  static_assert(std::is_same_v<typename Patch::FT, double>, "samples are computed in double");
  static_assert(Order == 0 || Order == 1, "there are points, or points and first derivatives");
  static_assert(std::is_same_v<Storage, double> || std::is_same_v<Storage, float>,
                "weights are stored as double or float");
  using Block = internal::Weight_block<Storage, Order>;

public:
  using Geom_traits = typename Patch::Geom_traits;
  using Point_3 = typename Patch::Point_3;
  using Vector_3 = typename Patch::Vector_3;
  using Basis = typename Patch::Basis;

  /*!
   * computes the weights, and the samples for the control points that the patch has.
   *
   * \param patch need not outlive this object
   * \param points a random access range of `Point_2` in the domain
   * \param locations a random access range of as many locations, those of the points;
   * `Domain_mesh_2` has both
   * \param concurrency `Parallel_tag` or `Sequential_tag`; the result does not depend on it
   *
   * \pre there are as many locations as points, and none is outside; the basis has less than 2^32
   * weights
   *
   * Complexity: that of evaluating the basis at all points.
   */
  template <typename PointRange, typename LocationRange,
            typename ConcurrencyTag = Parallel_if_available_tag>
  Patch_evaluator(const Patch& patch, const PointRange& points, const LocationRange& locations,
                  ConcurrencyTag concurrency = {})
      : basis_(patch.basis()), size_(points.size()),
        blocks_((size_ + Block::samples - 1) / Block::samples), motion_(basis_.size()) {
    static_cast<void>(concurrency);
    CGAL_precondition(points.size() == locations.size());
    CGAL_precondition(basis_.size() <= (std::numeric_limits<std::uint32_t>::max)());
    for (std::size_t c = 0; c < basis_.size(); ++c)
      net_.push_back(coordinates(patch.control_point(c)));
    set_extent();
    internal::for_each_index<ConcurrencyTag>(
        blocks_.size(),
        [&](std::size_t b) {
          set_weights(patch, points, locations, b);
          blocks_[b].compute(net_, unit());
        },
        1);
  }

  //! the number of samples
  std::size_t size() const { return size_; }
  std::size_t number_of_control_points() const { return net_.size(); }
  /*!
   * the basis, which says what the indices of control points mean: for the concave patch
   * `basis().index(i, j, k)` is control point (j,k) of side i, `basis().central_index()` the
   * central one. For the other patches they are those of the `control_points()` of the net.
   */
  const Basis& basis() const { return basis_; }

  //! \pre `c < number_of_control_points()`
  Point_3 control_point(std::size_t c) const {
    CGAL_precondition(c < net_.size());
    return Point_3(net_[c][0], net_[c][1], net_[c][2]);
  }

  /*!
   * moves all control points, and computes all samples.
   *
   * \param points a range of `number_of_control_points()` elements of type `Point_3`, by index
   *
   * \pre the number of points is right; they are finite
   *
   * Complexity: linear in `number_of_stored_weights()`; the time is that of reading them.
   */
  template <typename ConcurrencyTag = Parallel_if_available_tag, typename PointRange>
  void set_control_points(const PointRange& points) {
    CGAL_precondition(points.size() == net_.size());
    std::size_t c = 0;
    for (const Point_3& p : points)
      net_[c++] = coordinates(p);
    compute<ConcurrencyTag>();
  }

  /*!
   * moves one control point. Only the samples that it has influence on are touched.
   *
   * Samples are changed, not computed anew, so that rounding errors add up; but not for long: every
   * move also computes a part of the samples from the whole net, so that each is after
   * `refresh_period` moves. A move that is far in comparison with the net computes all samples. So
   * samples never differ from those of `set_control_points()` by more than about `refresh_period`
   * roundings of the size that the net had during that many moves.
   *
   * \pre `c < number_of_control_points()`, and the point is finite
   *
   * Complexity: linear in the number of samples on which the control point has influence, plus the
   * number of stored weights / `refresh_period`.
   */
  template <typename ConcurrencyTag = Parallel_if_available_tag>
  void set_control_point(std::size_t c, const Point_3& point) {
    move_control_points<ConcurrencyTag>(
        std::array<std::pair<std::size_t, Point_3>, 1>{{{c, point}}});
  }

  /*!
   * the same for several control points, those of a ribbon for example.
   *
   * \param moves a range of pairs of an index and a `Point_3`, of which no two have the same index
   */
  template <typename ConcurrencyTag = Parallel_if_available_tag, typename MoveRange>
  void move_control_points(const MoveRange& moves) {
    std::vector<std::size_t> indices;
    double farthest = 0;
    for (const auto& [c, point] : moves) {
      CGAL_precondition(c < net_.size());
      const std::array<double, 3> target = coordinates(point);
      for (std::size_t k = 0; k < 3; ++k) {
        motion_[c][k] = target[k] - net_[c][k];
        farthest = (std::max)(farthest, std::abs(motion_[c][k]));
      }
      net_[c] = target;
      indices.push_back(c);
    }
    // Moves that are large for the net before or after leave rounding errors of their own size.
    // Moving more than half of the points takes as long as all of them.
    const double before = extent_;
    set_extent();
    if (!(farthest <= (std::min)(before, extent_)) || 2 * indices.size() > net_.size()) {
      compute<ConcurrencyTag>();
      return;
    }
    std::sort(indices.begin(), indices.end());
    const std::size_t share = (blocks_.size() + refresh_period - 1) / refresh_period;
    const std::size_t first = next_refresh_;
    const auto is_refreshed = [&](std::size_t b) { // cyclically from `first` on
      return (b >= first ? b - first : b + blocks_.size() - first) < share;
    };
    internal::for_each_index<ConcurrencyTag>(
        blocks_.size(),
        [&](std::size_t b) {
          if (b + 1 < blocks_.size())
            blocks_[b + 1].prefetch_move(indices);
          if (is_refreshed(b))
            blocks_[b].compute(net_, unit());
          else
            blocks_[b].move(indices, motion_);
        },
        16);
    if (!blocks_.empty())
      next_refresh_ = (first + share) % blocks_.size();
  }

  //! after how many moves every sample has been computed from the whole net; with fewer blocks of
  //! 64 samples than that, after fewer
  static constexpr std::size_t refresh_period = 128;

  //! the point at sample `k` (model units). \pre `k < size()`
  Point_3 position(std::size_t k) const {
    const std::array<double, 3> p = result(0, k);
    return Point_3(p[0], p[1], p[2]);
  }
  //! its derivative by u, for `variable` 0, or v, for 1. \pre `k < size()` and `variable < 2`
  Vector_3 derivative(std::size_t k, std::size_t variable) const {
    static_assert(Order >= 1, "only points are computed");
    CGAL_precondition(variable < 2);
    const std::array<double, 3> d = result(1 + variable, k);
    return Vector_3(d[0], d[1], d[2]);
  }
  /*!
   * the unit normal there, on the side from which the boundary runs counterclockwise; zero where
   * the derivatives span no plane. It is computed from these whenever it is asked for.
   * \pre `k < size()`
   */
  Vector_3 normal(std::size_t k) const {
    static_assert(Order >= 1, "only points are computed");
    CGAL_precondition(k < size_);
    const std::size_t sample = k % Block::samples, lane = sample % Block::lanes;
    return to_vector(blocks_[k / Block::samples].normals(sample - lane)[lane]);
  }

  //! all points, by sample
  template <typename ConcurrencyTag = Parallel_if_available_tag>
  std::vector<Point_3> positions() const {
    std::vector<Point_3> all(size_);
    internal::for_each_index<ConcurrencyTag>(
        size_, [&](std::size_t k) { all[k] = position(k); }, 2048);
    return all;
  }
  //! all normals, by sample
  template <typename ConcurrencyTag = Parallel_if_available_tag>
  std::vector<Vector_3> normals() const {
    static_assert(Order >= 1, "only points are computed");
    std::vector<Vector_3> all(size_);
    internal::for_each_index<ConcurrencyTag>(
        (size_ + Block::lanes - 1) / Block::lanes,
        [&](std::size_t pack) {
          const std::size_t first = pack * Block::lanes;
          const auto normals = blocks_[first / Block::samples].normals(first % Block::samples);
          for (std::size_t l = 0; l < Block::lanes && first + l < size_; ++l)
            all[first + l] = to_vector(normals[l]);
        },
        2048);
    return all;
  }

  /*!
   * the number of weights in memory, derivatives included: those of 64 consecutive samples and one
   * control point are there or not, depending on whether one of them is not 0. With as many weights
   * as there may be this is (1 + 2 `Order`) times the number of control points times the number of
   * samples, rounded up to a multiple of 64.
   *
   * Complexity: linear in the number of samples.
   */
  std::size_t number_of_stored_weights() const {
    std::size_t sum = 0;
    for (const Block& block : blocks_)
      sum += block.number_of_weights();
    return sum;
  }

  //! the size of everything that grows with the number of samples
  std::size_t number_of_bytes() const {
    std::size_t sum = 0;
    for (const Block& block : blocks_)
      sum += block.number_of_bytes();
    return sum;
  }

private:
  static std::array<double, 3> coordinates(const Point_3& p) {
    CGAL_precondition(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()));
    return {p.x(), p.y(), p.z()};
  }

  static Vector_3 to_vector(const internal::Vec3& v) { return Vector_3(v[0], v[1], v[2]); }

  std::array<double, 3> result(std::size_t part, std::size_t k) const {
    CGAL_precondition(k < size_);
    const Block& block = blocks_[k / Block::samples];
    const std::size_t sample = k % Block::samples;
    return {block.value(part, 0, sample), block.value(part, 1, sample),
            block.value(part, 2, sample)};
  }

  template <typename PointRange, typename LocationRange>
  void set_weights(const Patch& patch, const PointRange& points, const LocationRange& locations,
                   std::size_t b) {
    using Number = internal::Number_pack;
    using Jet = Jet_2<Number, Order>;
    const std::size_t begin = b * Block::samples, end = (std::min)(begin + Block::samples, size_);
    std::vector<Jet> weights(basis_.size());
    std::vector<double> dense(basis_.size() * Block::weights_of_point, 0.0);
    typename Basis::template Workspace<Jet> workspace;
    patch.template for_each_pack<Order, Number>(
        end - begin, [&](std::size_t k) -> const auto& { return points[begin + k]; },
        [&](std::size_t k) -> const auto& { return locations[begin + k]; },
        [&](std::size_t first, std::size_t last, const Jet* lambda) {
          basis_.evaluate(patch.domain(), lambda, weights.data(), workspace);
          for (std::size_t c = 0; c < weights.size(); ++c)
            for (std::size_t part = 0; part < Block::parts; ++part)
              for (std::size_t k = first; k < last; ++k)
                dense[c * Block::weights_of_point + part * Block::samples + k] =
                    weights[c][part][k - first];
        });
    if constexpr (Order >= 1)
      for (std::size_t k = begin; k < end; ++k)
        if (locations[k].kind == Patch::Location::Kind::vertex)
          set_derivatives_at_vertex(patch.domain(), locations[k].index,
                                    &dense[Block::samples + k - begin]);
    blocks_[b].set_weights(dense);
  }

  // Makes the derivatives at a corner that is not straight those with which the surface is tangent
  // to both boundary curves. `at` is where the first weight has its derivative by u.
  template <typename Domain>
  void set_derivatives_at_vertex(const Domain& domain, std::size_t i, double* at) const {
    using Number = internal::Number_pack;
    using Jet = Jet_2<Number, Order>;
    const std::size_t next = domain.next(i), prev = domain.prev(i);
    const auto a = domain.vertex(next) - domain.vertex(i),
               b = domain.vertex(prev) - domain.vertex(i);
    const double determinant = a.x() * b.y() - a.y() * b.x();
    constexpr double straight = 1e-10; // relative to the lengths
    if (!(std::abs(determinant) > straight * std::sqrt(a.squared_length() * b.squared_length())))
      return;
    // Derivatives along the two sides, each in a lane of its own, so close to the corner that
    // nothing differs. At the corner itself the other ribbon would have a say.
    constexpr double s = 1e-20;
    std::vector<Jet> lambda(domain.size()), weights(basis_.size());
    for (const std::size_t lane : {0, 1}) {
      const std::size_t other = lane == 0 ? next : prev;
      lambda[i][0].set(lane, 1);
      lambda[i][1].set(lane, -1);
      lambda[other][0].set(lane, s);
      lambda[other][1].set(lane, 1);
    }
    typename Basis::template Workspace<Jet> workspace;
    basis_.evaluate(domain, lambda.data(), weights.data(), workspace);
    for (std::size_t c = 0; c < weights.size(); ++c, at += Block::weights_of_point) {
      const double along_a = weights[c][1][0], along_b = weights[c][1][1];
      at[0] = (along_a * b.y() - along_b * a.y()) / determinant;
      at[Block::samples] = (along_b * a.x() - along_a * b.x()) / determinant;
    }
  }

  template <typename ConcurrencyTag>
  void compute() {
    set_extent();
    internal::for_each_index<ConcurrencyTag>(
        blocks_.size(), [&](std::size_t b) { blocks_[b].compute(net_, unit()); }, 1);
  }

  // The size of the net, the largest difference of two coordinates.
  void set_extent() {
    std::array<double, 3> low = net_.front(), high = low;
    for (const std::array<double, 3>& p : net_)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = (std::min)(low[k], p[k]);
        high[k] = (std::max)(high[k], p[k]);
      }
    extent_ = (std::max)({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  }

  // The power of two above the size of the net, in which single precision has room for it; lengths
  // that vanish or overflow in `double` are not divided.
  double unit() const {
    return std::is_same_v<Storage, float> && std::isnormal(extent_)
               ? std::ldexp(1.0, std::ilogb(extent_))
               : 1.0;
  }

  Basis basis_;
  std::size_t size_;
  std::vector<std::array<double, 3>> net_;
  std::vector<Block> blocks_;
  std::vector<std::array<double, 3>> motion_; // of the control points that move just now
  double extent_ = 0;
  std::size_t next_refresh_ = 0; // the first block
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_PATCH_EVALUATOR_H
