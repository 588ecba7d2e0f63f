// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_MESHER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_MESHER_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/Linked_triangle.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/Tessellation_visitor.h>
#include <CGAL/Multisided_patches/meshing/internal/Deviation_meter.h>
#include <CGAL/Multisided_patches/meshing/internal/Domain_mesher.h>
#include <CGAL/Multisided_patches/meshing/internal/Refinement_outlook.h>
#include <CGAL/Multisided_patches/meshing/internal/Scaled_surface.h>
#include <CGAL/Multisided_patches/meshing/internal/Sharp_triangle_mender.h>
#include <CGAL/Multisided_patches/meshing/internal/Surface_metric.h>
#include <CGAL/Multisided_patches/meshing/internal/Uniform_metric.h>
#include <CGAL/Multisided_patches/meshing/internal/edge_lengths.h>
#include <CGAL/Multisided_patches/meshing/internal/even_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Deviations that more samples on the sides may bring within their bounds.
class Coarse_sides_error : public Accuracy_error {
public:
  using Accuracy_error::Accuracy_error;
};

// Meshes the domain of a patch so that its image on the surface is as fine as asked for.
//
// At first there is a coarse mesh, evenly spaced in the domain. It tells how lengths on the surface
// relate to those in the domain, which is enough for edges of a given length. For bounds on
// deviations, those of the triangles of one mesh tell the edge lengths for the next one; when only
// few triangles are left that exceed the bounds, these alone are refined.
template <typename Patch, typename ConcurrencyTag, typename Visitor>
class Surface_mesher {
public:
  using Traits = typename Patch::Geom_traits;
  using Domain = Polygonal_domain_2<Traits>;
  using Mesh = Domain_mesh_2<Traits>;

  Surface_mesher(const Patch& patch, Visitor& visitor) : surface_(patch), visitor_(visitor) {
    make_coarse_mesh();
  }

  // Of the surface (squared model units).
  double area() const { return coarse_metric_.area() * surface_.unit() * surface_.unit(); }
  // (model units)
  double boundary_length() const { return coarse_metric_.boundary_length() * surface_.unit(); }

  // Begins a mesh with edges of a length (model units) on the average. Returns about how many
  // triangles it will have.
  std::size_t start(Side_parameters sides, double length) {
    sides_ = std::move(sides);
    metric_ = coarse_metric_;
    length_ = length / surface_.unit();
    metric_.set_edge_length(length_);
    check_count(metric_, sides_, "an edge length of " + to_short_text(length));
    mesher_.emplace(domain(), sides_, metric_, coarse_hints_,
                    Mesher::possible_halvings(sides_, expected_triangles(metric_, sides_)));
    refine(*mesher_, expected_points(metric_, sides_));
    return mesher_->expected_triangles();
  }
  // Finishes it.
  Mesh finish(Keep keep) {
    const auto remeasure = [&](const Mesh& mesh, const Linked_triangles& triangles) {
      Sampled_mesh sampled;
      sample(mesh, triangles, sampled);
      Surface_metric metric(sampled);
      metric.set_edge_length(length_);
      return std::make_optional(std::move(metric));
    };
    const auto mend = [&](Mesh& part, Linked_triangles& triangles, std::size_t fixed_points) {
      Sampled_mesh sampled;
      sample(part, std::move(triangles), sampled);
      mend_sharp_triangles(part.points, fixed_points, sampled,
                           Meter(surface_, infinity, infinity, reserve));
      triangles = std::move(sampled.triangles);
    };
    with_limit(*mesher_, expected_points(metric_, sides_),
               [&](std::size_t limit, const auto& progress) {
                 mesher_->halve_edges(limit, progress, remeasure, keep);
                 mesher_->refine_where_steep(limit, progress, remeasure, mend);
               });
    return mesher_->finish();
  }

  // No deviation larger than the density says, and edges no longer, if it says so.
  Mesh with_deviations(const Side_parameters& sides, const Mesh_density& density) {
    const double unit = surface_.unit();
    const Meter meter(surface_, density.max_chordal_deviation().value_or(infinity) / unit,
                      density.max_normal_deviation().value_or(infinity), reserve);
    const double longest =
        (std::min)(max_edge_length, density.target_edge_length().value_or(infinity) / unit);
    constexpr int max_rounds = 8;
    Surface_metric metric = coarse_metric_;
    std::vector<std::size_t> hints = coarse_hints_;
    Refinement_outlook outlook;
    const std::vector<double> coarse_excess = measure(meter, coarse_, Meter::few_samples);
    check_count(coarse_excess);
    metric.set_edge_lengths(edge_lengths_for_excess(metric, coarse_excess, longest));
    for (int round = 1;; ++round) {
      check_count(metric, sides, "these deviations");
      Mesher mesher(domain(), sides, metric, hints);
      mesher.keep_off_sides(least_height_on_sides);
      refine(mesher, expected_points(metric, sides));
      Sampled_mesh sampled;
      sample(mesher, sampled);
      const std::vector<double> excess = measure(meter, sampled);
      outlook.update(sampled.triangles.size(), excess);
      Surface_metric next(sampled);
      next.set_edge_lengths(edge_lengths_for_excess(next, excess, longest));
      if (round == max_rounds || outlook.is_hopeless() ||
          (do_few_exceed(excess) && expected_triangles(next, sides) >=
                                        0.8 * static_cast<double>(sampled.triangles.size()))) {
        refine_where_exceeded(mesher, meter, sampled, excess);
        Mesh mesh = mesher.finish();
        mend_sharp_triangles(mesh.points, mesh.number_of_boundary_points, sampled, meter);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
          const auto& v = sampled.triangles[t].vertices;
          mesh.triangles[t] = {v[0], v[1], v[2]};
        }
        return mesh;
      }
      hints = vertex_hints(next, sides);
      metric = std::move(next);
    }
  }

private:
  using Location = typename Domain::Location;
  using Point_2 = typename Traits::Point_2;
  using Surface = Scaled_surface<Patch>;
  using Meter = Deviation_meter<Surface>;
  using Mesher = Domain_mesher<Traits, Surface_metric, ConcurrencyTag>;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  // Where nothing else limits them, relative to the size of the patch.
  static constexpr double max_edge_length = 0.3;
  // The mean area of triangles that Metric_refiner makes, relative to that of equilateral ones with
  // edges of length 1; measured on large meshes.
  static constexpr double mean_triangle_area = 0.945;

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

  const Domain& domain() const { return surface_.domain(); }

  void make_coarse_mesh() {
    constexpr double triangles = 3000;
    // In a very thin domain there would be too many samples on the sides.
    constexpr double max_samples = 3000;
    double perimeter = 0;
    for (std::size_t i = 0; i < domain().size(); ++i)
      perimeter += domain().side_length(i);
    const double area = (std::max)(0.0, CGAL::to_double(domain().area()));
    const double spacing =
        (std::max)(std::sqrt(area / triangles * 4 / std::sqrt(3.0)), perimeter / max_samples);
    Side_parameters sides;
    for (std::size_t i = 0; i < domain().size(); ++i)
      sides.push_back(even_parameters(
          static_cast<std::size_t>(std::ceil((std::max)(1.0, domain().side_length(i) / spacing)))));
    const Uniform_metric metric(spacing);
    Domain_mesher<Traits, Uniform_metric, ConcurrencyTag> mesher(
        domain(), sides, metric, std::vector<std::size_t>(domain().size(), 0));
    refine(mesher, static_cast<std::size_t>(triangles));
    sample(mesher, coarse_);
    coarse_metric_ = Surface_metric(coarse_);
    coarse_hints_ = vertex_hints(coarse_metric_, sides);
  }

  // Where to look for the vertices of the domain in a mesh with these samples on the sides.
  static std::vector<std::size_t> vertex_hints(const Surface_metric& metric,
                                               const Side_parameters& sides) {
    std::vector<std::size_t> hints;
    std::size_t vertex = 0;
    for (const std::vector<double>& side : sides) {
      hints.push_back(metric.triangle_at(vertex));
      vertex += side.size() + 1;
    }
    return hints;
  }

  // ------------------------------------------------------------------------------------ counts

  static double expected_triangles(const Surface_metric& metric, const Side_parameters& sides) {
    double count = metric.metric_area() / (mean_triangle_area * std::sqrt(3.0) / 4);
    for (const std::vector<double>& side : sides)
      count += static_cast<double>(side.size());
    return count;
  }

  static std::size_t expected_points(const Surface_metric& metric, const Side_parameters& sides) {
    return static_cast<std::size_t>(expected_triangles(metric, sides) / 2) + 1;
  }

  // Refuses densities beyond the limit before anything large is computed.
  static void check_count(const Surface_metric& metric, const Side_parameters& sides,
                          const std::string& what) {
    const double count = expected_triangles(metric, sides);
    if (!(count <= static_cast<double>(Mesh_density::max_triangles)))
      throw Input_error(what + " would need about " + to_short_text(count) +
                        " triangles; the limit is " + std::to_string(Mesh_density::max_triangles));
  }

  // A triangle gives way to as many as the square of its excess.
  static void check_count(const std::vector<double>& excess) {
    double count = 0;
    for (const double e : excess)
      count += std::isfinite(e) ? e * e : 0;
    if (!(count <= static_cast<double>(Mesh_density::max_triangles)))
      throw Input_error("these deviations would need about " + to_short_text(count) +
                        " triangles; the limit is " + std::to_string(Mesh_density::max_triangles));
  }

  template <typename Any_mesher>
  void refine(Any_mesher& mesher, std::size_t expected) {
    with_limit(mesher, expected,
               [&](std::size_t limit, const auto& progress) { mesher.refine(limit, progress); });
  }

  // Calls f(limit, progress) with a limit for the number of points that a mesher makes, and a
  // function that reports how many there are.
  template <typename Any_mesher, typename Function>
  void with_limit(const Any_mesher& mesher, std::size_t expected, const Function& f) {
    const auto progress = [&](std::size_t done) {
      report_progress(visitor_, Tessellation_stage::meshing, done, (std::max)(done, expected));
    };
    const std::size_t points = mesher.mesh().points.size();
    progress(points);
    // Triangles between short and long segments of the boundary add to what is expected.
    f(4 * expected + 20 * points + 1000, progress);
  }

  // ------------------------------------------------------------------------------- deviations

  // Brings a sampled mesh up to date with the mesh in the making, of which it was a part.
  template <typename Any_mesher>
  void sample(const Any_mesher& mesher, Sampled_mesh& sampled) {
    sample(mesher.mesh(), mesher.triangles(), sampled);
  }
  void sample(const Mesh& mesh, Linked_triangles triangles, Sampled_mesh& sampled) {
    const std::size_t old = sampled.uv.size(), n = mesh.points.size();
    sampled.positions.resize(n);
    for (std::size_t k = old; k < n; ++k)
      sampled.uv.push_back(to_uv(mesh.points[k]));
    in_blocks(n - old, [&](std::size_t k) {
      sampled.positions[old + k] = surface_.position(mesh.points[old + k], mesh.locations[old + k]);
    });
    for (std::size_t k = old; k < n; ++k)
      surface_.check_finite(sampled.positions[k], mesh.points[k]);
    sampled.triangles = std::move(triangles);
  }

  // The excess of each of some triangles, given by their numbers.
  std::vector<double> measure(const Meter& meter, const Sampled_mesh& mesh,
                              const std::vector<std::size_t>& triangles,
                              std::size_t samples = Meter::all_samples) {
    std::vector<double> excess(triangles.size());
    in_blocks(triangles.size(), [&](std::size_t k) {
      const double e = meter.excess(meter(mesh, mesh.triangles[triangles[k]], samples));
      excess[k] = std::isnan(e) ? infinity : e;
    });
    return excess;
  }
  std::vector<double> measure(const Meter& meter, const Sampled_mesh& mesh,
                              std::size_t samples = Meter::all_samples) {
    std::vector<std::size_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    return measure(meter, mesh, all, samples);
  }

  // Adds points where triangles exceed the bounds, until none does.
  void refine_where_exceeded(Mesher& mesher, const Meter& meter, Sampled_mesh& sampled,
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
        return accept_or_throw(meter, sampled);
      const std::size_t old = sampled.uv.size();
      const std::set<Corners> corners = corners_of(sampled, failing);
      mesher.divide(failing);
      if (mesher.mesh().points.size() == old) {
        // All that is left are triangles on sides. Flatter ones are closer to the surface.
        constexpr double least_height = 0.02;
        height /= 2;
        if (height < least_height)
          return accept_or_throw(meter, sampled);
        mesher.keep_off_sides(height);
        continue;
      }
      sample(mesher, sampled);
      const std::vector<std::size_t> suspects = changed_triangles(sampled, old, corners);
      const std::vector<double> excess = measure(meter, sampled, suspects);
      failing.clear();
      for (std::size_t k = 0; k < suspects.size(); ++k)
        if (exceeds(excess[k]))
          failing.push_back(suspects[k]);
      outlook.update(sampled.triangles.size(), excess);
    }
  }

  // The first points stay where they are.
  void mend_sharp_triangles(std::vector<Point_2>& points, std::size_t fixed_points,
                            Sampled_mesh& sampled, const Meter& meter) {
    Sharp_triangle_mender<Surface, Meter>(surface_, meter, sampled, points, fixed_points).mend([&] {
      report_progress(visitor_, Tessellation_stage::meshing, points.size(), points.size());
    });
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

  // Ends the refinement of a mesh that does not get better: it may still do without the
  // reserve.
  void accept_or_throw(const Meter& meter, const Sampled_mesh& mesh) {
    const std::vector<double> excess = measure(meter, mesh);
    const auto worst =
        static_cast<std::size_t>(std::max_element(excess.begin(), excess.end()) - excess.begin());
    const Linked_triangle& t = mesh.triangles[worst];
    const auto deviation = meter(mesh, t);
    if (meter.is_within_bounds(deviation))
      return;
    const std::string distance = to_short_text(deviation.chordal * surface_.unit()),
                      angle = to_short_text(deviation.normal * 180 / pi) + " degrees";
    const std::string message =
        "however fine the triangles are, the mesh deviates from the surface by " +
        (deviation.normal == 0    ? distance
         : deviation.chordal == 0 ? angle
                                  : distance + " and " + angle) +
        " at (u,v) = (" + to_short_text(mesh.uv[t.vertices[0]].x) + ", " +
        to_short_text(mesh.uv[t.vertices[0]].y) + ")";
    if (may_be_due_to_sides(mesh, excess))
      throw Coarse_sides_error(message, excess[worst]);
    throw Accuracy_error(message, excess[worst]);
  }

  // Whether more samples on the sides may help: it is a few triangles that deviate too much, such
  // as next to a side whose segments are too long, or all of them have a segment for an edge. Along
  // a crease or a fold there are many.
  static bool may_be_due_to_sides(const Sampled_mesh& mesh, const std::vector<double>& excess) {
    constexpr int few = 100;
    int inside = 0;
    for (std::size_t t = 0; t < excess.size(); ++t) {
      const auto& neighbors = mesh.triangles[t].neighbors;
      const bool has_segment =
          std::find(neighbors.begin(), neighbors.end(), Linked_triangle::none) != neighbors.end();
      inside += exceeds(excess[t]) && !has_segment;
    }
    return inside <= few;
  }

  // Calls f(k) for k < n, and tells the visitor in between.
  template <typename Function>
  void in_blocks(std::size_t n, const Function& f) {
    constexpr std::size_t block = 1 << 14, grain = 64;
    for (std::size_t first = 0; first < n; first += block) {
      report_progress(visitor_, Tessellation_stage::evaluation, first, n);
      for_each_index<ConcurrencyTag>((std::min)(block, n - first),
                                     [&](std::size_t k) { f(first + k); }, grain);
    }
  }

  Surface surface_;
  Visitor& visitor_;
  Sampled_mesh coarse_;
  Surface_metric coarse_metric_;
  std::vector<std::size_t> coarse_hints_;
  // The mesh that was begun last.
  Side_parameters sides_;
  double length_ = 0;
  Surface_metric metric_;
  std::optional<Mesher> mesher_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SURFACE_MESHER_H
