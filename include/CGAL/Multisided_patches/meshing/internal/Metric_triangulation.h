// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_TRIANGULATION_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_TRIANGULATION_H

#include <CGAL/Multisided_patches/internal/Boundary_triangulation.h>
#include <CGAL/Multisided_patches/meshing/internal/Metric_at_points.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The triangulation of a domain with a metric at its vertices, in which it is kept Delaunay. The
// metric says where edges are wanted; what is inside what, and which edges may be flipped, is
// decided by exact predicates.
template <typename Traits, typename Field>
class Metric_triangulation {
public:
  using Boundary = Boundary_triangulation<Traits>;
  using Triangulation = typename Boundary::Triangulation;
  using Face_handle = typename Boundary::Face_handle;
  using Vertex_handle = typename Boundary::Vertex_handle;
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;

  // New points are appended to `points` and `metric`, which have the others. Those inside may be
  // moved, the first ones on the boundary are not.
  Metric_triangulation(Boundary& boundary, std::vector<Point_2>& points,
                       Metric_at_points<Field>& metric, std::size_t number_of_boundary_points)
      : cdt_(boundary.triangulation()), points_(points), metric_(metric),
        number_of_boundary_points_(number_of_boundary_points) {
    make_delaunay();
  }

  // ------------------------------------------------------------------------------------ access

  Triangulation& cdt() { return cdt_; }
  const Triangulation& cdt() const { return cdt_; }
  std::size_t number_of_points() const { return points_.size(); }
  static bool is_inside(Face_handle f) { return Boundary::is_inside(f); }

  Uv position(Vertex_handle v) const { return to_uv(v->point()); }
  const Metric_2& metric(Vertex_handle v) const { return metric_[v->info()]; }
  Metric_2 metric(Face_handle f) const {
    return 1. / 3 * (metric(f->vertex(0)) + metric(f->vertex(1)) + metric(f->vertex(2)));
  }
  Metric_triangle triangle(Face_handle f) const {
    return Metric_triangle({position(f->vertex(0)), position(f->vertex(1)), position(f->vertex(2))},
                           metric(f));
  }

  Uv centroid(Face_handle f) const {
    return 1. / 3 * (position(f->vertex(0)) + position(f->vertex(1)) + position(f->vertex(2)));
  }

  // The face that contains p, if it is seen from face f; no face, if a side is in between.
  Face_handle walk(Face_handle f, const Point_2& p) const {
    constexpr int max_steps = 200; // a straight line of faces, unless the triangulation is odd
    for (int step = 0; step < max_steps; ++step) {
      bool blocked = false, moved = false;
      for (int i = 0; i < 3 && !moved; ++i)
        if (orientation(f->vertex(Triangulation::ccw(i))->point(),
                        f->vertex(Triangulation::cw(i))->point(), p) == RIGHT_TURN) {
          blocked = blocked || f->is_constrained(i);
          if (!f->is_constrained(i)) {
            f = f->neighbor(i);
            moved = true;
          }
        }
      if (!moved)
        return blocked ? Face_handle() : f;
    }
    return Face_handle();
  }

  // --------------------------------------------------------------------------------- new points

  // Adds a point to a face that contains it, unless rounding has put it elsewhere. All faces that
  // change then have the new vertex, and the new ones among them carry the number 0. Returns no
  // vertex if the point was not added.
  Vertex_handle insert(Face_handle f, Uv p) {
    // A point on an edge is moved off it.
    if (!is_strictly_inside(f, p))
      p = p + 1e-3 * (centroid(f) - p);
    if (!is_strictly_inside(f, p))
      return Vertex_handle();
    const Point_2 point(FT(p.x), FT(p.y));
    const std::size_t hint = metric_.hint(f->vertex(0)->info());
    const Vertex_handle v = cdt_.Triangulation::Ctr::insert(point, Triangulation::FACE, f, 0);
    v->info() = points_.size();
    points_.push_back(point);
    metric_.add(p, hint);
    auto face = cdt_.incident_faces(v), done = face;
    do
      if (face != f) // f has become one of the three; the others are new
        face->info() = 0;
    while (++face != done);
    flip_around(v);
    return v;
  }

  // Moves every point inside towards the centroid of the triangles around it, if that makes their
  // sharpest angle less sharp, and restores the Delaunay property; as many times as it is told.
  void smooth(int sweeps) {
    for (int k = 0; k < sweeps; ++k) {
      for (const Vertex_handle v : cdt_.finite_vertex_handles())
        smooth_point(v);
      make_delaunay();
    }
  }

  // Does the same to the points of sharp triangles, and around these. Now and then it calls
  // progress(number of points).
  template <typename Progress>
  void smooth_where_sharp(int sweeps, const Progress& progress) {
    std::vector<Face_handle> faces = faces_inside();
    for (int k = 0; k < sweeps && !faces.empty(); ++k) {
      const std::vector<Vertex_handle> vertices = points_of_sharp_triangles(faces);
      faces.clear();
      for (const Vertex_handle v : vertices)
        if (smooth_point(v) || nudge_point(v))
          for_each_face_around(v, [&](Face_handle f) { faces.push_back(f); });
      make_delaunay(faces);
      progress(points_.size());
    }
  }

private:
  std::vector<Face_handle> faces_inside() const {
    std::vector<Face_handle> faces;
    for (const Face_handle f : cdt_.finite_face_handles())
      if (is_inside(f))
        faces.push_back(f);
    return faces;
  }

  bool is_strictly_inside(Face_handle f, const Uv& p) const {
    const Point_2 point(FT(p.x), FT(p.y));
    for (int i = 0; i < 3; ++i)
      if (orientation(f->vertex(Triangulation::ccw(i))->point(),
                      f->vertex(Triangulation::cw(i))->point(), point) != LEFT_TURN)
        return false;
    return true;
  }

  // ------------------------------------------------------------------------------------- flips

  // Whether the edge of f opposite to its vertex i ought to be flipped, and can be.
  bool wants_flip(Face_handle f, int i) const {
    if (f->is_constrained(i))
      return false;
    const Face_handle g = f->neighbor(i);
    const Vertex_handle a = f->vertex(Triangulation::ccw(i)), c = f->vertex(Triangulation::cw(i)),
                        v = f->vertex(i), w = g->vertex(cdt_.mirror_index(f, i));
    const Metric_2 m = 0.25 * (metric(a) + metric(c) + metric(v) + metric(w));
    return prefers_other_diagonal(position(a), position(w), position(c), position(v), m) &&
           orientation(v->point(), a->point(), w->point()) == LEFT_TURN &&
           orientation(v->point(), w->point(), c->point()) == LEFT_TURN;
  }

  // Restores the Delaunay property around a new vertex. Every flip adds an edge to it, so they end.
  void flip_around(Vertex_handle v) {
    boost::container::small_vector<Face_handle, 16> stack;
    auto face = cdt_.incident_faces(v), done = face;
    do
      stack.push_back(face);
    while (++face != done);
    while (!stack.empty()) {
      Face_handle f = stack.back();
      stack.pop_back();
      const int i = f->index(v);
      if (!wants_flip(f, i))
        continue;
      const Face_handle g = f->neighbor(i);
      cdt_.flip(f, i);
      stack.push_back(f);
      stack.push_back(g);
    }
  }

  void make_delaunay() { make_delaunay(faces_inside()); }

  // Restores the Delaunay property where only edges of these faces may lack it. As the metric is
  // not the same everywhere, flips could go round in circles; so their number is limited.
  void make_delaunay(std::vector<Face_handle> stack) {
    std::size_t budget = 20 * stack.size();
    while (!stack.empty() && budget > 0) {
      Face_handle f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i)
        if (wants_flip(f, i)) {
          const Face_handle g = f->neighbor(i);
          cdt_.flip(f, i);
          stack.push_back(g);
          stack.push_back(f);
          --budget;
          break;
        }
    }
  }

  // --------------------------------------------------------------------------------- smoothing

  // Calls f with the faces inside.
  template <typename Function>
  void for_each_face_around(Vertex_handle v, const Function& f) const {
    auto face = cdt_.incident_faces(v), done = face;
    do
      if (is_inside(face))
        f(Face_handle(face));
    while (++face != done);
  }

  // The points that may be moved of sharp triangles and of those around them.
  std::vector<Vertex_handle>
  points_of_sharp_triangles(const std::vector<Face_handle>& faces) const {
    std::vector<bool> is_corner(points_.size(), false), is_found(points_.size(), false);
    std::vector<Vertex_handle> vertices;
    const auto add_points_of = [&](Face_handle f) {
      for (int i = 0; i < 3; ++i) {
        const Vertex_handle v = f->vertex(i);
        if (is_movable(v) && !is_found[v->info()]) {
          is_found[v->info()] = true;
          vertices.push_back(v);
        }
      }
    };
    for (const Face_handle f : faces) {
      if (is_sharp(triangle(f)))
        for (int i = 0; i < 3; ++i)
          if (!is_corner[f->vertex(i)->info()]) {
            is_corner[f->vertex(i)->info()] = true;
            for_each_face_around(f->vertex(i), add_points_of);
          }
    }
    return vertices;
  }

  bool is_movable(Vertex_handle v) const { return v->info() >= number_of_boundary_points_; }

  bool smooth_point(Vertex_handle v) {
    if (!is_movable(v))
      return false;
    Uv sum{0, 0};
    double weight = 0;
    for_each_face_around(v, [&](Face_handle f) {
      const Metric_triangle t = triangle(f);
      sum = sum + t.area() * centroid(f);
      weight += t.area();
    });
    return move_point(v, 1 / weight * sum, worst_quality(v));
  }

  // Moves a point that smoothing leaves where it is a little towards or away from one of its
  // neighbours, if that helps. Returns whether it did.
  bool nudge_point(Vertex_handle v) {
    constexpr std::size_t max_neighbors = 12; // in a fan from side to side there is nothing to gain
    boost::container::small_vector<Uv, max_neighbors> directions;
    const Uv p = position(v);
    for_each_face_around(v, [&](Face_handle f) {
      directions.push_back(position(f->vertex(Triangulation::ccw(f->index(v)))) - p);
    });
    if (directions.size() > max_neighbors)
      return false;
    const double quality = worst_quality(v);
    for (const double step : {0.2, -0.2, 0.05, -0.05})
      for (const Uv& d : directions)
        if (move_point(v, p + step * d, quality))
          return true;
    return false;
  }

  // Moves a point if that makes the quality around it better than it was. Returns whether it did.
  bool move_point(Vertex_handle v, const Uv& target, double quality) {
    const Point_2 old = v->point();
    v->set_point(Point_2(FT(target.x), FT(target.y)));
    if (!is_star_valid(v) || !(worst_quality(v) > quality)) {
      v->set_point(old);
      return false;
    }
    points_[v->info()] = v->point();
    return true;
  }

  bool is_star_valid(Vertex_handle v) const {
    auto face = cdt_.incident_faces(v), done = face;
    do
      if (orientation(face->vertex(0)->point(), face->vertex(1)->point(),
                      face->vertex(2)->point()) != LEFT_TURN)
        return false;
    while (++face != done);
    return true;
  }

  // The smallest ratio of shortest edge and circumradius, which is a matter of the sharpest angle.
  double worst_quality(Vertex_handle v) const {
    double worst = std::numeric_limits<double>::infinity();
    for_each_face_around(v, [&](Face_handle f) {
      const Metric_triangle t = triangle(f);
      worst = (std::min)(worst, t.squared_length(t.shortest_edge()) / t.squared_circumradius());
    });
    return worst;
  }

  Triangulation& cdt_;
  std::vector<Point_2>& points_;
  Metric_at_points<Field>& metric_;
  std::size_t number_of_boundary_points_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_METRIC_TRIANGULATION_H
