// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_FREE_POINT_PLACEMENT_H
#define CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_FREE_POINT_PLACEMENT_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/ribbons/internal/multi_index.h>

#include <CGAL/Kernel_traits.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Calls function(j) for the ranks j of all neighbours of an index in the net of an S-patch: those
// where one of the integers is 1 less and one of its two neighbours 1 more.
template <typename Function>
void for_each_neighbor(Multi_index index, const Function& function) {
  const std::size_t n = index.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (index[k] == 0)
      continue;
    --index[k];
    for (const std::size_t neighbor : {(k + 1) % n, (k + n - 1) % n}) {
      ++index[neighbor];
      function(rank_of_multi_index(index));
      --index[neighbor];
    }
    ++index[k];
  }
}

// The points Σ_k i_k / d V_k of the net of depth d of the patch whose only control points are its
// corners V_k, which is that of depth 1.
template <typename Point_3>
std::vector<Point_3> net_of_corners(const std::vector<Point_3>& corners, std::size_t depth) {
  using FT = typename Kernel_traits<Point_3>::Kernel::FT;
  std::vector<Point_3> points;
  Multi_index index = first_multi_index(corners.size(), depth);
  do {
    Point_3 p = corners[0];
    for (std::size_t k = 1; k < corners.size(); ++k)
      if (index[k] > 0)
        p = p + FT(FT(static_cast<int>(index[k])) / FT(static_cast<int>(depth))) *
                    (corners[k] - corners[0]);
    points.push_back(p);
  } while (advance(index));
  return points;
}

/*!
 * minimizes |A x - b| for every column of b, by conjugate gradients (Hestenes and Stiefel, *Methods
 * of conjugate gradients for solving linear systems*, Journal of Research of the National Bureau of
 * Standards 49, 1952).
 *
 * The columns of A are scaled to length 1, which is a diagonal preconditioner. The tolerance is
 * relative to all of b, as a column that is zero but for rounding errors could not reach one of its
 * own.
 *
 * \throws Numerical_error if this takes too many iterations
 */
inline Eigen::MatrixXd least_squares_solution(Eigen::SparseMatrix<double> a,
                                              const Eigen::MatrixXd& b) {
  constexpr double tolerance = 1e-12;
  // More than ten times what 20 sides of depth 6, or 3 sides of depth 100, take.
  constexpr int max_iterations = 20000;
  Eigen::VectorXd scale(a.cols());
  for (Eigen::Index column = 0; column < a.cols(); ++column) {
    scale[column] = 1 / a.col(column).norm();
    a.col(column) *= scale[column];
  }
  Eigen::MatrixXd solution(a.cols(), b.cols());
  for (Eigen::Index column = 0; column < b.cols(); ++column) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(a.cols()), residual = b.col(column);
    Eigen::VectorXd gradient = a.transpose() * residual, direction = gradient;
    double squared = gradient.squaredNorm();
    for (int k = 0; squared > tolerance * tolerance * b.squaredNorm(); ++k) {
      if (k == max_iterations)
        throw Numerical_error("the inner control points of the S-patch could not be computed: the "
                              "iteration does not converge");
      const Eigen::VectorXd change = a * direction;
      const double step = squared / change.squaredNorm();
      x += step * direction;
      residual -= step * change;
      gradient = a.transpose() * residual;
      const double previous = std::exchange(squared, gradient.squaredNorm());
      direction = gradient + (squared / previous) * direction;
    }
    solution.col(column) = scale.cwiseProduct(x);
  }
  return solution;
}

/*!
 * Places the points of the net of an S-patch that are not fixed: the displacements of all points
 * from `net_of_corners()` get the smallest discrete biharmonic energy, the sum over all points of
 * the squared lengths of Σ (displacement of a neighbour - own displacement). That is a linear
 * least-squares problem, solved in double precision. If the fixed points are those of
 * `net_of_corners()`, so are the others.
 */
template <typename Point_3>
class Free_point_placement {
  using Traits = typename Kernel_traits<Point_3>::Kernel;
  using FT = typename Traits::FT;

public:
  /*!
   * \param corners the corners of the patch
   * \param depth the depth of the net
   * \param is_fixed for each point of the net whether it is fixed
   * \param size the size of the patch (model units)
   */
  Free_point_placement(const std::vector<Point_3>& corners, std::size_t depth,
                       const std::vector<bool>& is_fixed, double size)
      : sides_(corners.size()), depth_(depth), reference_(net_of_corners(corners, depth)),
        unknown_(is_fixed.size(), -1), size_(size) {
    for (std::size_t i = 0; i < unknown_.size(); ++i)
      if (!is_fixed[i])
        unknown_[i] = number_of_unknowns_++;
  }

  /*!
   * replaces the points of the net that are not fixed.
   *
   * \throws Numerical_error if the problem cannot be solved
   *
   * Complexity: O(N min(n, d)) for N points and each of the iterations, whose number grows about
   * as n² for a given depth d: 50 for n = 5 and d = 6, 1000 for n = 20 and d = 6, and 1600 for n =
   * 3 and d = 100.
   */
  void operator()(std::vector<Point_3>& points) const {
    if (number_of_unknowns_ == 0)
      return;
    const auto rows = static_cast<Eigen::Index>(points.size());
    Eigen::SparseMatrix<double> laplacian(rows, number_of_unknowns_);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(rows, 3);
    set_up(points, laplacian, right);
    const Eigen::MatrixXd solution = least_squares_solution(std::move(laplacian), right);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (unknown_[i] >= 0) {
        const auto d = solution.row(unknown_[i]);
        points[i] = reference_[i] +
                    typename Traits::Vector_3(FT(size_ * d[0]), FT(size_ * d[1]), FT(size_ * d[2]));
      }
  }

private:
  // One row for each point: the Laplacian of the unknown displacements, and minus that of the fixed
  // ones. Lengths are divided by the size, so that squares stay in range.
  void set_up(const std::vector<Point_3>& points, Eigen::SparseMatrix<double>& laplacian,
              Eigen::MatrixXd& right) const {
    std::vector<Eigen::Triplet<double>> entries;
    Multi_index index = first_multi_index(sides_, depth_);
    for (std::size_t i = 0; i < points.size(); ++i, advance(index)) {
      const auto row = static_cast<int>(i);
      const auto add = [&](std::size_t j, double weight) {
        if (unknown_[j] >= 0) {
          entries.emplace_back(row, unknown_[j], weight);
          return;
        }
        const Vec3 displacement = to_vec3(points[j] - reference_[j]);
        for (int c = 0; c < 3; ++c)
          right(row, c) -= weight * (displacement[static_cast<std::size_t>(c)] / size_);
      };
      double number_of_neighbors = 0;
      for_each_neighbor(index, [&](std::size_t j) {
        add(j, 1);
        ++number_of_neighbors;
      });
      add(i, -number_of_neighbors);
    }
    laplacian.setFromTriplets(entries.begin(), entries.end());
  }

  std::size_t sides_, depth_;
  std::vector<Point_3> reference_;
  std::vector<int> unknown_; // the number of each point, or -1 if it is fixed
  int number_of_unknowns_ = 0;
  double size_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_PATCHES_INTERNAL_FREE_POINT_PLACEMENT_H
