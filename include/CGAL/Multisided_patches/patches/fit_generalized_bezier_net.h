// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_FIT_GENERALIZED_BEZIER_NET_H
#define CGAL_MULTISIDED_PATCHES_FIT_GENERALIZED_BEZIER_NET_H

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/check_finite.h>
#include <CGAL/Multisided_patches/ribbons/Generalized_bezier_net_3.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! What `fit_generalized_bezier_net()` keeps, and how smooth it wants the net.
struct Net_fit_options {
  //! the number of rows along each side that stay as they are, at least 1: with 1 the boundary
  //! curves stay, with 2 the tangent planes along them, too
  std::size_t fixed_layers = 2;
  //! how much a smooth net counts against a close one: the mean square of the distances of the
  //! points from the patch, plus this number times that of the distances of control points from the
  //! mean of their neighbours in the net, is minimized
  double smoothing = 0;
};

namespace internal {

// The rows of a linear least-squares problem, of which no more are kept at a time than twice the
// number of unknowns: the triangular factor of a QR decomposition stands for all rows before.
class Least_squares_rows {
public:
  // With three right-hand sides.
  explicit Least_squares_rows(std::size_t unknowns)
      : unknowns_(static_cast<Eigen::Index>(unknowns)), rows_(2 * unknowns_ + 1, unknowns_ + 3) {}

  // A row of zeros, to be filled in: coefficients first, then the right-hand sides.
  auto add_row() {
    if (used_ == rows_.rows())
      compress();
    ++count_;
    auto row = rows_.row(used_++);
    row.setZero();
    return row;
  }

  // Of all solutions the smallest.
  Eigen::MatrixXd solve() const {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    // Relative to the largest pivot; the rounding errors of more rows than are here are in them.
    decomposition.setThreshold(std::numeric_limits<double>::epsilon() *
                               static_cast<double>((std::max)(count_, unknowns_)));
    decomposition.compute(rows_.topLeftCorner(used_, unknowns_));
    return decomposition.solve(rows_.topRightCorner(used_, 3));
  }

private:
  void compress() {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows_.topRows(used_));
    used_ = unknowns_; // rows further down have right-hand sides only: what no solution reaches
    rows_.topRows(used_) = qr.matrixQR().topRows(used_).template triangularView<Eigen::Upper>();
  }

  Eigen::Index unknowns_, used_ = 0, count_ = 0;
  Eigen::MatrixXd rows_;
};

// The least-squares system for the control points that may move.
template <typename Traits>
class Net_fit {
public:
  using Net = Generalized_bezier_net_3<Traits>;
  using Point_3 = typename Traits::Point_3;

  Net_fit(const Net& net, const Net_fit_options& options)
      : net_(net), smoothing_(options.smoothing), column_(net.central_index() + 1, fixed) {
    for (std::size_t k = options.fixed_layers; k < net.layers(); ++k)
      for (std::size_t i = 0; i < net.size(); ++i)
        for (std::size_t j = k; j < net.degree() - k; ++j)
          add_unknown(net.index(i, j, k), {neighbor(i, j - 1, k), neighbor(i, j + 1, k),
                                           neighbor(i, j, k - 1), neighbor(i, j, k + 1)});
    std::vector<std::size_t> innermost;
    for (std::size_t i = 0; i < net.size(); ++i)
      innermost.push_back(net.index(i, net.layers(), net.layers() - 1));
    add_unknown(net.central_index(), std::move(innermost));
  }

  // `weights_at(p)` are all weights at point p, and `error_at(p)` is what is missing there.
  template <typename WeightsAt, typename ErrorAt>
  Net solve(std::size_t number_of_points, const WeightsAt& weights_at,
            const ErrorAt& error_at) const {
    const std::size_t unknowns = unknowns_.size();
    Least_squares_rows rows(unknowns);
    const double point_scale = 1 / std::sqrt(static_cast<double>(number_of_points));
    for (std::size_t p = 0; p < number_of_points; ++p) {
      auto row = rows.add_row();
      const auto& weights = weights_at(p);
      for (std::size_t u = 0; u < unknowns; ++u)
        row[static_cast<Eigen::Index>(u)] = point_scale * weights[unknowns_[u].index];
      row.template tail<3>() = point_scale * error_at(p);
    }
    const double net_scale = std::sqrt(smoothing_ / static_cast<double>(unknowns));
    for (const Unknown& unknown : unknowns_)
      add_smoothing(unknown, net_scale, rows.add_row());
    // Of all solutions the one that moves points least: what has no influence stays.
    const Eigen::MatrixXd moves = rows.solve();
    std::vector<Point_3> result = net_.control_points();
    for (std::size_t u = 0; u < unknowns; ++u) {
      Point_3& point = result[unknowns_[u].index];
      const auto move = moves.row(static_cast<Eigen::Index>(u));
      point = Point_3(point.x() + move[0], point.y() + move[1], point.z() + move[2]);
    }
    return net_.with_control_points(std::move(result));
  }

private:
  static constexpr Eigen::Index fixed = -1;

  struct Unknown {
    std::size_t index;
    std::vector<std::size_t> neighbors;
  };

  void add_unknown(std::size_t index, std::vector<std::size_t> neighbors) {
    column_[index] = static_cast<Eigen::Index>(unknowns_.size());
    unknowns_.push_back({index, std::move(neighbors)});
  }

  // Point (j,k) of side i; beyond the innermost row are the rows of other sides, and in the middle
  // the central point.
  std::size_t neighbor(std::size_t i, std::size_t j, std::size_t k) const {
    if (k < net_.layers())
      return net_.index(i, j, k);
    return j < k ? net_.index(net_.prev(i), net_.degree() - k, j) : net_.central_index();
  }

  // The row that says that a point is the mean of its neighbours.
  template <typename Row>
  void add_smoothing(const Unknown& unknown, double scale, Row row) const {
    const auto add = [&](std::size_t index, double factor) {
      if (column_[index] != fixed)
        row[column_[index]] += factor;
      const Point_3& p = net_.control_points()[index];
      row.template tail<3>() -= factor * Eigen::RowVector3d(p.x(), p.y(), p.z());
    };
    add(unknown.index, scale);
    for (const std::size_t neighbor : unknown.neighbors)
      add(neighbor, -scale / static_cast<double>(unknown.neighbors.size()));
  }

  const Net& net_;
  double smoothing_;
  std::vector<Unknown> unknowns_;
  std::vector<Eigen::Index> column_; // of each control point
};

} // namespace internal

/*!
 * moves the inner control points of a generalized Bézier patch such that it comes close to given
 * points (model units), in the sense of least squares; the outer rows, and with them the contact
 * with neighbours, stay.
 *
 * Each point belongs to a fixed place of the domain: the patch there should be the point. For
 * scattered points these places are those of the closest points of the patch, see
 * `closest_parameters()`; fit and look for them in turns.
 *
 * Control points that neither the points nor the smoothing determine stay where they are.
 *
 * \tparam Patch a `Generalized_bezier_patch_3` in `double`
 *
 * \param patch the patch; `patch.net()` says where control points are before
 * \param parameters a random access range of `Point_2` in the domain
 * \param points a random access range of as many `Point_3`
 * \param options what is kept, and how smooth the net is to be
 *
 * \return the net with the control points moved
 *
 * \throws Input_error if the numbers differ, there are no points, or one is not finite
 * \throws Outside_domain_error if a parameter lies outside the domain
 *
 * \pre `options.fixed_layers >= 1`, and `options.smoothing` is not negative
 *
 * Complexity: O((m + f) f²) time for m points and f control points that may move, besides m
 * evaluations of the patch; O(f²) memory, whatever m is.
 */
template <typename Patch, typename ParameterRange, typename PointRange>
Generalized_bezier_net_3<typename Patch::Geom_traits>
fit_generalized_bezier_net(const Patch& patch, const ParameterRange& parameters,
                           const PointRange& points, const Net_fit_options& options = {}) {
  static_assert(std::is_same_v<typename Patch::FT, double>, "least squares are solved in double");
  CGAL_precondition(options.fixed_layers >= 1 && options.smoothing >= 0);
  if (points.size() == 0 || points.size() != parameters.size())
    throw Input_error("a fit needs as many places in the domain as points, and at least one; there "
                      "are " +
                      std::to_string(parameters.size()) + " and " + std::to_string(points.size()));
  for (std::size_t p = 0; p < points.size(); ++p)
    if (!internal::has_finite_coordinates(points[p]))
      throw Input_error("point " + std::to_string(p) + " of a fit is not finite");

  std::vector<Jet_2<double, 0>> lambda(patch.domain().size()), jets(patch.basis().size());
  std::vector<double> weights(jets.size());
  const auto weights_at = [&](std::size_t p) -> const std::vector<double>& {
    patch.coordinates().template evaluate<0>(
        parameters[p], patch.domain().locate_inside(parameters[p]), lambda.data());
    patch.basis().evaluate(patch.domain(), lambda.data(), jets.data());
    for (std::size_t c = 0; c < jets.size(); ++c)
      weights[c] = jets[c].value();
    return weights;
  };
  const auto error_at = [&](std::size_t p) {
    const auto error = points[p] - patch(parameters[p]);
    return Eigen::RowVector3d(error.x(), error.y(), error.z());
  };
  return internal::Net_fit<typename Patch::Geom_traits>(patch.net(), options)
      .solve(points.size(), weights_at, error_at);
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_FIT_GENERALIZED_BEZIER_NET_H
