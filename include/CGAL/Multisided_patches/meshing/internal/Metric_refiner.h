// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_REFINER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_REFINER_H

#include <CGAL/Multisided_patches/meshing/internal/Metric_2.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_triangulation.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Fills the triangulation of a domain with points, until no edge is much longer than 1 in a metric
// and no triangle has a sharp angle that a point inside could spare. No point is added on a side.
//
// This is Delaunay refinement (Chew, *Guaranteed-quality triangular meshes*, 1989; Ruppert 1995)
// with the Delaunay property taken in the metric, and with points placed in the manner of an
// advancing front: not at the circumcenter, but nearer to the shortest edge, where they complete it
// to a triangle of the wanted size (Rebay, *Efficient unstructured mesh generation by means of
// Delaunay triangulation and Bowyer-Watson algorithm*, 1993; Üngör, *Off-centers*, 2004). So rows
// of equilateral triangles grow from the boundary inwards.
template <typename Traits, typename Field>
class Metric_refiner : private Metric_triangulation<Traits, Field> {
  using Base = Metric_triangulation<Traits, Field>;
  using Base::cdt;
  using Base::centroid;
  using Base::is_inside;
  using Base::metric;
  using Base::number_of_points;
  using Base::position;
  using Base::triangle;
  using Base::walk;
  using typename Base::Face_handle;
  using typename Base::FT;
  using typename Base::Point_2;
  using typename Base::Triangulation;
  using typename Base::Vertex_handle;

public:
  using Base::Base;
  using Base::smooth;
  using Base::smooth_where_sharp;

  // Adds points until all is as it should be, or there are `max_points`. Now and then it calls
  // progress(number of points), which may throw.
  template <typename Progress>
  void refine(std::size_t max_points, const Progress& progress) {
    front_.clear();
    rest_.clear();
    for (const Face_handle f : cdt().finite_face_handles())
      if (is_inside(f)) {
        f->info() = idle; // whoever asked for the triangles has numbered them
        enqueue_if_bad(f);
      }
    constexpr std::size_t block = 4096;
    std::size_t next_report = number_of_points() + block;
    while (number_of_points() < max_points && !(front_.empty() && rest_.empty())) {
      std::deque<Face_handle>& queue = front_.empty() ? rest_ : front_;
      const Face_handle f = queue.front();
      queue.pop_front();
      f->info() = idle;
      if (is_too_large_or_sharp(triangle(f)))
        refine(f);
      if (number_of_points() >= next_report) {
        progress(number_of_points());
        next_report += block;
      }
    }
  }

  // From now on new points keep this distance from sides, relative to their length, even where
  // short edges are wanted: triangles on long sides become flat otherwise, and the flatter they
  // are, the more their normals tilt with the height of an arc over its chord.
  void keep_off_sides(double share_of_length) { least_height_ = share_of_length; }

  // Adds a point for each of some triangles, at their circumcenters or, where a side is in the way,
  // at their centroids: for triangles that are too large for reasons of their own. They are given
  // by their numbers in Boundary_triangulation::triangles(), in order.
  void divide(const std::vector<std::size_t>& triangles) {
    std::vector<Face_handle> faces;
    std::size_t number = 0, next = 0;
    for (const Face_handle f : cdt().finite_face_handles()) {
      if (!is_inside(f))
        continue;
      if (next < triangles.size() && number == triangles[next]) {
        faces.push_back(f);
        ++next;
      }
      ++number;
      f->info() = idle;
    }
    std::vector<std::array<Vertex_handle, 3>> corners;
    for (const Face_handle f : faces)
      corners.push_back({f->vertex(0), f->vertex(1), f->vertex(2)});
    for (std::size_t k = 0; k < faces.size(); ++k)
      divide(faces[k], corners[k]);
    front_.clear();
    rest_.clear();
  }

private:
  enum State : std::size_t { idle, queued };

  // An edge up to this length is one to which a front can be attached.
  static constexpr double max_front_edge = 1.5;
  // How fast triangles grow away from short edges.
  static constexpr double growth = 1.5;
  // The least distance of new points from sides and from other points, relative to the wanted one.
  static constexpr double margin = 0.45;

  void enqueue_if_bad(Face_handle f) {
    if (f->info() == queued)
      return;
    const Metric_triangle t = triangle(f);
    if (!is_too_large_or_sharp(t))
      return;
    f->info() = queued;
    const bool is_front = t.squared_length(t.shortest_edge()) <= max_front_edge * max_front_edge;
    (is_front ? front_ : rest_).push_back(f);
  }

  // ------------------------------------------------------------------------------- new points

  // All lengths are those of the face that asks for the point.
  struct Proposal {
    Uv point;
    Metric_2 metric;
    double spacing; // the distance from the ends of the edge to which the point belongs
  };

  // The point on the bisector of the shortest edge that makes the other two as long as wanted, but
  // at the farthest the circumcenter.
  Proposal propose(Face_handle f) const {
    const Metric_triangle t = triangle(f);
    const int i = t.shortest_edge();
    const Uv a = position(f->vertex(Triangulation::ccw(i))),
             b = position(f->vertex(Triangulation::cw(i)));
    const Uv middle = 0.5 * (a + b), center = t.circumcenter();
    const double length = std::sqrt(t.squared_length(i));
    const double wanted =
        length > 1 ? (std::max)(1.0, 0.8 * length) : (std::min)(1.0, growth * length);
    const double height = std::sqrt(wanted * wanted - length * length / 4);
    const Metric_2 m = metric(f);
    const double distance = m.norm(center - middle);
    if (!(height < distance))
      return {center, m, std::sqrt(t.squared_circumradius())};
    return {middle + height / distance * (center - middle), m, wanted};
  }

  void refine(Face_handle f) {
    // Where a side of the domain is in the way, nothing can be done about sharp angles. But
    // triangles that are too large all over are divided all the same.
    const Metric_triangle t = triangle(f);
    if (!add(f, propose(f)) && t.squared_length(t.shortest_edge()) > 1)
      add(f, {centroid(f), metric(f), 1});
  }

  static bool has_corners(Face_handle f, const std::array<Vertex_handle, 3>& corners) {
    return std::all_of(corners.begin(), corners.end(),
                       [&](Vertex_handle v) { return f->has_vertex(v); });
  }

  // Unless what was done before has divided the face already.
  void divide(Face_handle f, const std::array<Vertex_handle, 3>& corners) {
    if (!has_corners(f, corners))
      return;
    const Uv center = triangle(f).circumcenter();
    if (std::isfinite(center.x) && std::isfinite(center.y)) {
      const Face_handle at = walk(f, Point_2(FT(center.x), FT(center.y)));
      if (at != Face_handle() && !is_flat_over_side(at, center))
        insert(at, center);
    }
    if (has_corners(f, corners) && !is_flat_over_side(f, centroid(f)))
      insert(f, centroid(f));
  }

  // Whether a point in a face makes a flat triangle with a side of the domain.
  bool is_flat_over_side(Face_handle f, const Uv& p) const {
    for (int i = 0; i < 3; ++i)
      if (f->is_constrained(i) &&
          relative_height(f->vertex(Triangulation::ccw(i)), f->vertex(Triangulation::cw(i)), p) <
              least_height_)
        return true;
    return false;
  }

  // Of a point over the edge from v to w, in units of its length.
  double relative_height(Vertex_handle v, Vertex_handle w, const Uv& p) const {
    const Uv a = position(v), b = position(w);
    const Metric_2 m = 0.5 * (metric(v) + metric(w));
    return m.area_factor() * cross(b - a, p - a) / m.squared_norm(b - a);
  }

  // Adds a point that face f has asked for, if there is room for it.
  bool add(Face_handle f, const Proposal& proposal) {
    if (!std::isfinite(proposal.point.x) || !std::isfinite(proposal.point.y))
      return false;
    const Face_handle at = walk(f, Point_2(FT(proposal.point.x), FT(proposal.point.y)));
    return at != Face_handle() && !is_too_close(at, proposal) && insert(at, proposal.point);
  }

  // Adds a point to a face that contains it. Returns whether it did.
  bool insert(Face_handle f, const Uv& p) {
    const Vertex_handle v = Base::insert(f, p);
    if (v == Vertex_handle())
      return false;
    auto face = cdt().incident_faces(v), done = face;
    do
      enqueue_if_bad(face);
    while (++face != done);
    return true;
  }

  // Whether a point would be too close to a side or to another point: to one of those that it will
  // be joined to, which are those of the faces whose circumcircles contain it.
  bool is_too_close(Face_handle at, const Proposal& proposal) const {
    constexpr std::size_t max_faces = 40;
    boost::container::small_vector<Face_handle, 40> cavity{at};
    for (std::size_t k = 0; k < cavity.size(); ++k)
      for (int i = 0; i < 3; ++i) {
        const Face_handle f = cavity[k];
        if (is_close_to_vertex(f->vertex(i), proposal))
          return true;
        if (f->is_constrained(i)) {
          if (is_close_to_side(f->vertex(Triangulation::ccw(i)), f->vertex(Triangulation::cw(i)),
                               proposal.point))
            return true;
        } else if (cavity.size() < max_faces && is_in_conflict(f->neighbor(i), proposal.point) &&
                   std::find(cavity.begin(), cavity.end(), f->neighbor(i)) == cavity.end()) {
          cavity.push_back(f->neighbor(i));
        }
      }
    return false;
  }

  bool is_in_conflict(Face_handle f, const Uv& p) const {
    const Metric_triangle t = triangle(f);
    return metric(f).squared_norm(p - t.circumcenter()) < t.squared_circumradius();
  }

  bool is_close_to_vertex(Vertex_handle v, const Proposal& proposal) const {
    const double least = margin * proposal.spacing;
    return proposal.metric.squared_norm(proposal.point - position(v)) < least * least;
  }

  bool is_close_to_side(Vertex_handle v, Vertex_handle w, const Uv& p) const {
    const Uv a = position(v), b = position(w);
    const Metric_2 m = 0.5 * (metric(v) + metric(w));
    const double square = m.squared_norm(b - a), along = m.dot(b - a, p - a);
    if (along <= 0 || along >= square)
      return false;
    const double length = std::sqrt(square);
    const double height = m.area_factor() * cross(b - a, p - a) / length;
    return height < (std::max)(margin * (std::min)(1.0, length), least_height_ * length);
  }

  double least_height_ = 0;              // of triangles on sides, relative to the length of these
  std::deque<Face_handle> front_, rest_; // bad triangles; those with edges of the right size first
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_REFINER_H
