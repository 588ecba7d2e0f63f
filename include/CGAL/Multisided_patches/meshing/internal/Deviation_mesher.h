// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DEVIATION_MESHER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DEVIATION_MESHER_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/internal/Domain_mesher.h>
#include <CGAL/Multisided_patches/meshing/internal/Refinement_outlook.h>
#include <CGAL/Multisided_patches/meshing/internal/Sampled_mesh.h>
#include <CGAL/Multisided_patches/meshing/internal/Surface_metric.h>
#include <CGAL/Multisided_patches/meshing/internal/Surface_sampler.h>
#include <CGAL/Multisided_patches/meshing/internal/edge_lengths.h>
#include <CGAL/Multisided_patches/meshing/internal/expected_triangles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Whether there may be another try with more samples on the sides.
enum class Sides { may_get_finer, are_final };

// There should be another try with more samples on the sides.
class Coarse_sides_error : public std::exception {
public:
  const char* what() const noexcept override { return "the sides are too coarse"; }
};

// What a mesh tells about lengths on the surface, for the next one.
struct Surface_lengths {
  Surface_metric metric;
  std::vector<std::size_t> hints; // where in it the vertices of the domain are to be looked for

  Surface_lengths() = default;
  // The sides are those with whose samples the mesh was made, which come first.
  Surface_lengths(const Sampled_mesh& mesh, const Side_parameters& sides) : metric(mesh) {
    std::size_t vertex = 0;
    for (const std::vector<double>& side : sides) {
      hints.push_back(metric.triangle_at(vertex));
      vertex += side.size() + 1;
    }
  }
};

// Meshes the domain of a patch so that no triangle deviates from the surface by more than bounds.
//
// The deviations of the triangles of one mesh tell the edge lengths for the next one; when only few
// triangles are left that exceed the bounds, these alone are refined.
template <typename Patch, typename ConcurrencyTag, typename Visitor>
class Deviation_mesher {
public:
  using Sampler = Surface_sampler<Patch, ConcurrencyTag, Visitor>;
  using Traits = typename Sampler::Traits;
  using Mesh = typename Sampler::Mesh;

  Deviation_mesher(Sampler& sampler, const Side_parameters& sides, Sides finality,
                   const Mesh_density& density)
      : sampler_(sampler), surface_(sampler.surface()), sides_(sides), finality_(finality),
        max_chordal_(density.max_chordal_deviation().value_or(infinity) / surface_.unit()),
        max_normal_(density.max_normal_deviation().value_or(infinity)),
        meter_(surface_, max_chordal_, max_normal_, reserve),
        longest_((std::min)(max_edge_length,
                            density.target_edge_length().value_or(infinity) / surface_.unit())) {}

  // Begins with what a coarse mesh of the domain tells.
  Mesh mesh(const Sampled_mesh& coarse, Surface_lengths lengths) {
    const std::vector<double> coarse_excess = sampler_.measure(meter_, coarse, Effort::estimate);
    check_number_of_triangles(missing_triangles(coarse_excess), "these deviations");
    set_edge_lengths(lengths.metric, coarse_excess);
    Refinement_outlook outlook;
    std::size_t least_count = (std::numeric_limits<std::size_t>::max)();
    constexpr int max_rounds = 8;
    for (int round = 1;; ++round) {
      check_number_of_triangles(expected_triangles(lengths.metric, sides_), "these deviations");
      Mesher mesher(surface_.domain(), sides_, lengths.metric, lengths.hints);
      mesher.keep_off_sides(least_height_on_sides);
      sampler_.refine(mesher, expected_points(lengths.metric, sides_));
      Sampled_mesh sampled;
      sampler_.sample(mesher, sampled);
      const std::vector<double> excess = sampler_.measure(meter_, sampled);
      const std::size_t count = sampled.triangles.size();
      outlook.update(count, excess);
      Surface_lengths next(sampled, sides_);
      set_edge_lengths(next.metric, excess);
      // The next mesh may have fewer triangles, unless the last one already failed to.
      constexpr double worthwhile = 0.8;
      const bool is_coarser = count < least_count && expected_triangles(next.metric, sides_) <
                                                         worthwhile * static_cast<double>(count);
      if (round == max_rounds || outlook.is_hopeless() || (do_few_exceed(excess) && !is_coarser)) {
        if (finality_ == Sides::may_get_finer && !outlook.is_hopeless() &&
            are_sides_coarse(next.metric))
          throw Coarse_sides_error();
        refine_where_exceeded(mesher, sampled, excess);
        return finish(mesher, sampled);
      }
      least_count = (std::min)(least_count, count);
      lengths = std::move(next);
    }
  }

private:
  using Surface = typename Sampler::Surface;
  using Meter = typename Sampler::Meter;
  using Effort = typename Sampler::Effort;
  using Mesher = Domain_mesher<Traits, Surface_metric, ConcurrencyTag>;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  // Where nothing else limits them, relative to the size of the patch.
  static constexpr double max_edge_length = 0.3;
  // Of triangles on sides, if there is a bound on deviations; relative to the segment of the side.
  // The flatter they are, the more the height of the boundary curve over the segment tilts them.
  static constexpr double least_height_on_sides = 0.15;

  // Deviations between the samples are a little larger than at them, so less is aimed at.
  static constexpr double reserve = 0.9;

  static bool exceeds(double excess) { return excess > 1; }

  static bool do_few_exceed(const std::vector<double>& excess) {
    constexpr double few = 0.05;
    const auto failures = std::count_if(excess.begin(), excess.end(), exceeds);
    return static_cast<double>(failures) <= few * static_cast<double>(excess.size());
  }

  // A triangle gives way to as many as the square of its excess.
  static double missing_triangles(const std::vector<double>& excess) {
    double count = 0;
    for (const double e : excess)
      count += std::isfinite(e) ? e * e : 0;
    return count;
  }

  void set_edge_lengths(Surface_metric& metric, const std::vector<double>& excess) const {
    metric.set_edge_lengths(edge_lengths_for_excess(metric, excess, longest_));
  }

  // Whether one in twenty segments of sides is much longer than the edges that are wanted next to
  // it. There the bounds are kept by slivers only, and after many rounds, if at all.
  static bool are_sides_coarse(const Surface_metric& metric) {
    constexpr double longest_good = 3, many = 0.05;
    std::size_t all = 0, long_ones = 0;
    for (const Linked_triangle& t : metric.triangles())
      for (std::size_t i = 0; i < 3; ++i)
        if (t.neighbors[i] == Linked_triangle::none) {
          ++all;
          long_ones += metric.length_in_edges(t.vertices[(i + 1) % 3], t.vertices[(i + 2) % 3]) >
                       longest_good;
        }
    return static_cast<double>(long_ones) > many * static_cast<double>(all);
  }

  // With the triangles of the sampled mesh, of which sharp ones are mended.
  Mesh finish(Mesher& mesher, Sampled_mesh& sampled) {
    Mesh mesh = mesher.finish();
    sampler_.mend_sharp_triangles(mesh.points, mesh.number_of_boundary_points, sampled, meter_);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& v = sampled.triangles[t].vertices;
      mesh.triangles[t] = {v[0], v[1], v[2]};
    }
    return mesh;
  }

  // Adds points where triangles exceed the bounds, until none does.
  void refine_where_exceeded(Mesher& mesher, Sampled_mesh& sampled,
                             const std::vector<double>& all_excess) {
    Refinement_outlook outlook;
    outlook.update(sampled.triangles.size(), all_excess);
    constexpr int max_rounds = 40;
    std::vector<std::size_t> failing;
    for (std::size_t t = 0; t < all_excess.size(); ++t)
      if (exceeds(all_excess[t]))
        failing.push_back(t);
    double height = least_height_on_sides;
    for (int round = 0; !failing.empty(); ++round) {
      if (round == max_rounds || outlook.is_hopeless() || outlook.is_stuck())
        return accept_or_throw(sampled);
      const std::size_t old = sampled.uv.size();
      const std::set<Corners> corners = corners_of(sampled, failing);
      mesher.divide(failing);
      if (mesher.mesh().points.size() == old) {
        // All that is left are triangles on sides. Flatter ones are closer to the surface.
        constexpr double least_height = 0.02;
        height /= 2;
        if (height < least_height)
          return accept_or_throw(sampled);
        mesher.keep_off_sides(height);
        continue;
      }
      sampler_.sample(mesher, sampled);
      const std::vector<std::size_t> suspects = changed_triangles(sampled, old, corners);
      const std::vector<double> excess = sampler_.measure(meter_, sampled, suspects);
      failing.clear();
      for (std::size_t k = 0; k < suspects.size(); ++k)
        if (exceeds(excess[k]))
          failing.push_back(suspects[k]);
      outlook.update(sampled.triangles.size(), excess);
    }
  }

  using Corners = Linked_triangle::Indices; // in increasing order

  static Corners corners_of(const Linked_triangle& t) {
    Corners v = t.vertices;
    std::sort(v.begin(), v.end());
    return v;
  }
  static std::set<Corners> corners_of(const Sampled_mesh& mesh,
                                      const std::vector<std::size_t>& triangles) {
    std::set<Corners> corners;
    for (const std::size_t t : triangles)
      corners.insert(corners_of(mesh.triangles[t]));
    return corners;
  }

  // Those that are new, because every new triangle has a new vertex, their neighbours, whose
  // distances are measured from them, too, and those that were failing.
  static std::vector<std::size_t> changed_triangles(const Sampled_mesh& mesh,
                                                    std::size_t old_vertices,
                                                    const std::set<Corners>& failing) {
    std::vector<std::size_t> result;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto is_new = [&](std::size_t n) {
        return n != Linked_triangle::none && corners_of(mesh.triangles[n]).back() >= old_vertices;
      };
      const auto& neighbors = mesh.triangles[t].neighbors;
      if (is_new(t) || failing.count(corners_of(mesh.triangles[t])) > 0 ||
          std::any_of(neighbors.begin(), neighbors.end(), is_new))
        result.push_back(t);
    }
    return result;
  }

  // Ends the refinement of a mesh that does not get better: it may still do without the reserve.
  void accept_or_throw(const Sampled_mesh& mesh) {
    const Meter strict(surface_, max_chordal_, max_normal_, 1);
    const std::vector<double> excess = sampler_.measure(strict, mesh);
    const auto worst =
        static_cast<std::size_t>(std::max_element(excess.begin(), excess.end()) - excess.begin());
    if (!exceeds(excess[worst]))
      return;
    if (finality_ == Sides::may_get_finer && may_be_due_to_sides(mesh, excess))
      throw Coarse_sides_error();
    const Linked_triangle& t = mesh.triangles[worst];
    const auto deviation = strict(mesh, t);
    const std::string distance = to_short_text(deviation.chordal * surface_.unit()),
                      angle = to_short_text(deviation.normal * 180 / pi) + " degrees";
    const std::string message =
        "however fine the triangles are, the mesh deviates from the surface by " +
        (deviation.normal == 0    ? distance
         : deviation.chordal == 0 ? angle
                                  : distance + " and " + angle) +
        " at (u,v) = (" + to_short_text(mesh.uv[t.vertices[0]].x) + ", " +
        to_short_text(mesh.uv[t.vertices[0]].y) + ")";
    throw Accuracy_error(message, excess[worst]);
  }

  // Whether more samples on the sides may help: triangles that deviate too much touch them, and are
  // more than hardly any of all that do, as they are along a crease or a fold.
  bool may_be_due_to_sides(const Sampled_mesh& mesh, const std::vector<double>& excess) const {
    std::size_t samples = 0;
    for (const std::vector<double>& side : sides_)
      samples += side.size() + 1;
    std::size_t all = 0, on_sides = 0;
    for (std::size_t t = 0; t < excess.size(); ++t)
      if (exceeds(excess[t])) {
        const auto& v = mesh.triangles[t].vertices;
        ++all;
        on_sides += std::any_of(v.begin(), v.end(), [&](std::size_t k) { return k < samples; });
      }
    constexpr std::size_t few = 100;
    return on_sides > 0 && (all <= few || 10 * on_sides >= all);
  }

  Sampler& sampler_;
  const Surface& surface_;
  const Side_parameters& sides_;
  Sides finality_;
  double max_chordal_, max_normal_; // units of the surface, degrees
  Meter meter_;
  double longest_; // edge
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_DEVIATION_MESHER_H
