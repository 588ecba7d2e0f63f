// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DOMAIN_MESHER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DOMAIN_MESHER_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/Boundary_triangulation.h>
#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/internal/run_both.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>
#include <CGAL/Multisided_patches/meshing/internal/Edge_halver.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_refiner.h>
#include <CGAL/Multisided_patches/meshing/internal/Side_parameters.h>
#include <CGAL/Multisided_patches/meshing/internal/refine_where_needed.h>
#include <CGAL/Multisided_patches/meshing/internal/refine_where_steep.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// What matters if lengths turn out to be other ones when they are measured on a finer mesh.
enum class Keep { edge_length, number_of_triangles };

// A mesh of a domain in the making: samples on the sides, which stay as they are, and points
// inside, as many as a metric asks for.
//
// A large mesh begins as a coarse one, on some of the samples, with edges 2 or 4 or more times as
// long as wanted. Then these are halved, which takes in the other samples; and what is not good
// enough after that, near the sides mostly, is refined point by point.
//
// The concurrency tag says how edges are halved, and whether samples are checked meanwhile. The
// mesh is the same, bit for bit.
template <typename Traits, typename Field, typename ConcurrencyTag>
class Domain_mesher {
public:
  using Domain = Polygonal_domain_2<Traits>;
  using Mesh = Domain_mesh_2<Traits>;
  using Location = typename Domain::Location;
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;

  // How many times the edges of a coarse mesh can be halved to get so many triangles. The coarse
  // mesh has to show the shape of the domain, and how the metric changes; and where most points are
  // samples on the sides, there is nothing to halve.
  static int possible_halvings(const Side_parameters& sides, double expected_triangles) {
    std::size_t samples = sides.size();
    for (const std::vector<double>& side : sides)
      samples += side.size();
    if (4 * static_cast<double>(samples) > expected_triangles)
      return 0;
    const double least = (std::max)(1500., 16. * static_cast<double>(sides.size()));
    int halvings = 0;
    for (; expected_triangles >= 4 * least; expected_triangles /= 4)
      ++halvings;
    return halvings;
  }

  // Triangulates the samples or, if edges will be halved, some of them. The hints are those with
  // which the field is asked at the vertices of the domain.
  Domain_mesher(const Domain& domain, const Side_parameters& sides, const Field& field,
                const std::vector<std::size_t>& hints, int halvings = 0)
      : mesh_(sample_boundary(domain, sides)), metric_(field), halvings_(halvings),
        first_points_(first_points(domain, sides)) {
    for (std::size_t i = 0, k = 0; i < sides.size(); ++i)
      for (std::size_t j = 0, hint = hints[i]; j <= sides[i].size(); ++j, ++k) {
        metric_.add(to_uv(mesh_.points[k]), hint);
        hint = metric_.hint(k);
      }
    choose_samples(sides, std::size_t(1) << halvings);
    if (halvings > 0)
      metric_.scale_lengths(1. / (1 << halvings));
    start_with(next_points(segments_));
  }
  Domain_mesher(const Domain_mesher&) = delete;
  Domain_mesher& operator=(const Domain_mesher&) = delete;

  // Adds points inside, up to `max_points` points in all. Now and then it calls
  // progress(number of points), which may throw.
  template <typename Progress>
  void refine(std::size_t max_points, const Progress& progress) {
    CGAL_precondition(refiner_.has_value());
    refiner_->refine(max_points, progress);
    set_locations();
  }

  // About how many triangles there will be once edges have been halved.
  std::size_t expected_triangles() const {
    const std::size_t all = mesh_.number_of_boundary_points, inside = mesh_.points.size() - all,
                      factor = std::size_t(1) << halvings_;
    std::size_t samples = 0;
    for (const std::size_t m : segments_)
      samples += m > 0;
    const std::size_t coarse = 2 * inside + samples + 2 * first_points_.size() - 4;
    return factor * factor * coarse + all - factor * samples;
  }

  // Halves edges as many times as the constructor was told to, and refines what is not good enough.
  // On the way it calls remeasure(mesh without triangles, triangles), which may return a field that
  // is more accurate than the one so far.
  template <typename Progress, typename Remeasure>
  void halve_edges(std::size_t max_points, const Progress& progress, const Remeasure& remeasure,
                   Keep keep) {
    if (halvings_ == 0)
      return;
    CGAL_precondition(refiner_.has_value());
    run_both<ConcurrencyTag>(
        [&] {
          if (halvings_ >= 2)
            adapt_coarse_mesh(max_points, progress, remeasure, keep);
          refiner_->smooth(coarse_sweeps);
        },
        // A copy, as points are added meanwhile.
        [samples = boundary_points(), this] { check_all_samples(samples); });
    if (!try_to_halve_edges(max_points, progress, remeasure, keep)) {
      // Then the points inside are looked for one by one.
      mesh_.points.resize(mesh_.number_of_boundary_points);
      metric_.resize(mesh_.number_of_boundary_points);
      start_with(all_next_points());
      refiner_->refine(max_points, progress);
    }
  }

  // Measures the field anew where it changes fast, and refines and mends the mesh there; for
  // `remeasure` and `mend` see the function of this name. After that the mesh can only be finished.
  template <typename Progress, typename Remeasure, typename Mend>
  void refine_where_steep(std::size_t max_points, const Progress& progress,
                          const Remeasure& remeasure, const Mend& mend) {
    end_triangulation();
    internal::refine_where_steep<ConcurrencyTag>(mesh_, metric_, triangles_, remeasure, mend,
                                                 max_points, progress);
  }

  // pre: edges have not been halved
  void keep_off_sides(double share_of_length) {
    CGAL_precondition(refiner_.has_value());
    refiner_->keep_off_sides(share_of_length);
  }
  void smooth(int sweeps) {
    CGAL_precondition(metric_.size() == mesh_.points.size());
    if (sweeps > 0 && !triangulation_)
      start_with(triangles_);
    if (sweeps > 0)
      refiner_->smooth(sweeps);
  }
  // Divides triangles, given by their numbers in triangles(). pre: edges have not been halved
  void divide(const std::vector<std::size_t>& triangles) {
    CGAL_precondition(refiner_.has_value());
    refiner_->divide(triangles);
    set_locations();
  }

  // Without triangles and, once edges have been halved, without the locations of points inside.
  const Mesh& mesh() const { return mesh_; }
  Linked_triangles triangles() const {
    return triangulation_ ? triangulation_->triangles() : triangles_;
  }

  // The finished mesh. Ends the use of this object.
  Mesh finish() {
    end_triangulation();
    run_both<ConcurrencyTag>(
        [&] {
          mesh_.triangles.reserve(triangles_.size());
          for (const Linked_triangle& t : triangles_)
            mesh_.triangles.push_back({t.vertices[0], t.vertices[1], t.vertices[2]});
        },
        [&] { set_locations(); });
    return std::move(mesh_);
  }

private:
  static constexpr int coarse_sweeps = 2;

  // Of the points inside that have been added.
  void set_locations() { mesh_.locations.resize(mesh_.points.size(), Location::interior()); }

  std::vector<Point_2> boundary_points() const {
    return {mesh_.points.begin(),
            mesh_.points.begin() + static_cast<std::ptrdiff_t>(mesh_.number_of_boundary_points)};
  }

  // Throws Numerical_error, as start_with() does, if not all samples can be triangulated: a coarse
  // mesh is without some of them.
  void check_all_samples(const std::vector<Point_2>& samples) const {
    Boundary_triangulation<Traits>(samples, all_next_points());
  }

  // Replaces the triangulation by triangles_. Returns false if rounding is in the way; the metric
  // is that of the fine mesh then, too.
  template <typename Progress, typename Remeasure>
  bool try_to_halve_edges(std::size_t max_points, const Progress& progress,
                          const Remeasure& remeasure, Keep keep) {
    const std::size_t expected = expected_triangles();
    mesh_.points.reserve(expected * 5 / 9);
    metric_.reserve(expected * 5 / 9);
    end_triangulation();
    Edge_halver<Traits, Field, ConcurrencyTag> halver(mesh_.points, metric_, triangles_, segments_);
    for (std::size_t length = std::size_t(1) << halvings_; length > 1; length /= 2) {
      if (length >= 4 && length < std::size_t(1) << halvings_) { // few points in comparison
        if (update_field(remeasure, keep))
          refine_where_needed<ConcurrencyTag, Traits>(mesh_.points, metric_, triangles_, max_points,
                                                      progress);
      }
      metric_.scale_lengths(2);
      const std::size_t least =
          keep == Keep::number_of_triangles ? expected / (length / 2 * (length / 2)) : 0;
      if (!halver.halve(length / 2, least, progress)) {
        metric_.scale_lengths(static_cast<double>(length / 2));
        return false;
      }
    }
    refine_where_needed<ConcurrencyTag, Traits>(mesh_.points, metric_, triangles_, max_points,
                                                progress);
    return true;
  }

  // Measures the metric on the coarse mesh, and makes the mesh fit: if much of it does not, it is
  // made anew.
  template <typename Progress, typename Remeasure>
  void adapt_coarse_mesh(std::size_t max_points, const Progress& progress,
                         const Remeasure& remeasure, Keep keep) {
    triangles_ = triangulation_->triangles();
    if (!update_field(remeasure, keep))
      return;
    const std::vector<char> is_bad =
        find_bad_triangles<ConcurrencyTag>(mesh_.points, metric_, triangles_);
    const auto count = std::count(is_bad.begin(), is_bad.end(), true);
    if (50 * static_cast<std::size_t>(count) > is_bad.size()) {
      mesh_.points.resize(mesh_.number_of_boundary_points);
      metric_.resize(mesh_.number_of_boundary_points);
      start_with(next_points(segments_));
    }
    refiner_->refine(max_points, progress);
  }

  // Measures the metric on the mesh as it is. Returns false if that is known already.
  template <typename Remeasure>
  bool update_field(const Remeasure& remeasure, Keep keep) {
    set_locations();
    std::optional<Field> field = remeasure(mesh_, triangles_);
    if (!field)
      return false;
    const double old_area = area();
    finer_field_ = std::move(*field);
    metric_.set_field(*finer_field_);
    std::vector<std::size_t> hints(mesh_.points.size(), Linked_triangle::none);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const std::size_t v : triangles_[t].vertices)
        hints[v] = t;
    for (std::size_t k = 1; k < mesh_.number_of_boundary_points; ++k)
      if (hints[k] == Linked_triangle::none) // a sample that is not yet in the mesh
        hints[k] = hints[k - 1];
    for_each_index<ConcurrencyTag>(mesh_.points.size(), [&](std::size_t k) {
      metric_.set(k, to_uv(mesh_.points[k]), hints[k]);
    });
    if (keep == Keep::number_of_triangles)
      metric_.scale_lengths(std::sqrt(old_area / area()));
    return true;
  }

  // Of the triangles, in the metric.
  double area() const {
    double sum = 0;
    for (const Linked_triangle& t : triangles_)
      sum += metric_.triangle(mesh_.points, t.vertices).area();
    return sum;
  }

  // From the boundary, or from triangles.
  template <typename Structure>
  void start_with(const Structure& structure) {
    refiner_.reset();
    triangulation_.emplace(mesh_.points, structure);
    refiner_.emplace(*triangulation_, mesh_.points, metric_, mesh_.number_of_boundary_points);
  }

  // From now on the triangles are in triangles_.
  void end_triangulation() {
    if (!triangulation_)
      return;
    triangles_ = triangulation_->triangles();
    refiner_.reset();
    triangulation_.reset();
  }

  // --------------------------------------------------------------------------------- the boundary

  // The sizes of domains in which products of four lengths neither vanish nor overflow.
  static void check_size(const Domain& domain) {
    constexpr double smallest = 1e-70, largest = 1e70;
    const double diameter = domain.diameter();
    if (!(diameter > smallest && diameter < largest))
      throw Input_error("the domain is too large or too small for meshing: its diameter is " +
                        to_short_text(diameter) + ", not between 1e-70 and 1e70");
  }

  static Mesh sample_boundary(const Domain& domain, const Side_parameters& sides) {
    check_size(domain);
    Mesh mesh;
    for (std::size_t i = 0; i < domain.size(); ++i) {
      mesh.points.push_back(domain.vertex(i));
      mesh.locations.push_back(Location::on_vertex(i));
      for (const double s : sides[i]) {
        mesh.points.push_back(domain.point_on_side(i, FT(s)));
        mesh.locations.push_back(Location::on_side(i, FT(s)));
      }
    }
    mesh.number_of_boundary_points = mesh.points.size();
    return mesh;
  }

  static std::vector<std::size_t> first_points(const Domain& domain, const Side_parameters& sides) {
    std::vector<std::size_t> result;
    std::size_t point = 0;
    for (std::size_t loop = 0; loop < domain.number_of_loops(); ++loop) {
      result.push_back(point);
      for (std::size_t i = domain.loop_begin(loop); i < domain.loop_begin(loop + 1); ++i)
        point += sides[i].size() + 1;
    }
    return result;
  }

  // Takes the vertices of the domain, and of the samples on its sides as many as it needs for no
  // more than `step` segments from one to the next.
  void choose_samples(const Side_parameters& sides, std::size_t step) {
    segments_.clear();
    for (const std::vector<double>& side : sides) {
      const std::size_t first = segments_.size(), all = side.size() + 1,
                        parts = (all + step - 1) / step;
      segments_.resize(first + all, 0);
      for (std::size_t k = 0; k < parts; ++k)
        segments_[first + k * all / parts] = (k + 1) * all / parts - k * all / parts;
    }
  }

  // For those the one that follows it on the boundary.
  std::vector<std::size_t> next_points(const std::vector<std::size_t>& segments) const {
    std::vector<std::size_t> next(segments.size(), Linked_triangle::none);
    for (std::size_t loop = 0; loop < first_points_.size(); ++loop) {
      const std::size_t first = first_points_[loop], end = loop + 1 < first_points_.size()
                                                               ? first_points_[loop + 1]
                                                               : segments.size();
      for (std::size_t k = first; k < end; k += segments[k])
        next[k] = k + segments[k] < end ? k + segments[k] : first;
    }
    return next;
  }
  // For each point on the boundary.
  std::vector<std::size_t> all_next_points() const {
    return next_points(std::vector<std::size_t>(mesh_.number_of_boundary_points, 1));
  }

  Mesh mesh_;
  Metric_at_points<Field> metric_;
  int halvings_;
  std::vector<std::size_t> first_points_; // of each loop
  // For each point on the boundary that is triangulated at first the number of segments up to the
  // next one, for others 0.
  std::vector<std::size_t> segments_;
  std::optional<Field> finer_field_;
  std::optional<Boundary_triangulation<Traits>> triangulation_;
  std::optional<Metric_refiner<Traits, Field>> refiner_;
  Linked_triangles triangles_; // once edges have been halved, instead of these
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DOMAIN_MESHER_H
