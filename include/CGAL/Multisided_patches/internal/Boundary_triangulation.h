// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_BOUNDARY_TRIANGULATION_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_BOUNDARY_TRIANGULATION_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/Linked_triangle.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The constrained Delaunay triangulation of a set of points, of which the first ones bound a
// domain, and the triangles inside the domain. All that meshes domains uses this one type, as it is
// costly to compile.
//
// Vertices carry the indices of their points. Faces carry `none` if they are outside the domain; to
// the others whoever works on the triangulation may give any other number.
template <typename Traits>
class Boundary_triangulation {
public:
  using Point_2 = typename Traits::Point_2;

  static constexpr std::size_t none = Linked_triangle::none;

private:
  using Vertex_base = Triangulation_vertex_base_with_info_2<std::size_t, Traits>;
  using Face_base =
      Triangulation_face_base_with_info_2<std::size_t, Traits,
                                          Constrained_triangulation_face_base_2<Traits>>;

public:
  using Triangulation =
      Constrained_Delaunay_triangulation_2<Traits,
                                           Triangulation_data_structure_2<Vertex_base, Face_base>,
                                           No_constraint_intersection_requiring_constructions_tag>;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;

  // The domain is on the left of the edges from points[k] to points[next[k]], k < next.size(),
  // which make up its boundary. Points whose `next` is `none` are left out. Throws Numerical_error
  // if points coincide or edges cross.
  Boundary_triangulation(const std::vector<Point_2>& points, const std::vector<std::size_t>& next) {
    insert(points, next);
    constrain(next);
    std::vector<Face_handle> inside = faces_along_boundary(next);
    add_reachable(inside);
  }

  // Takes over the triangles of a domain, which need not be Delaunay. What is outside is not
  // triangulated: the boundary is that of one infinite face for each of its edges.
  Boundary_triangulation(const std::vector<Point_2>& points, const Linked_triangles& triangles) {
    auto& tds = triangulation_.tds();
    tds.clear();
    tds.set_dimension(2);
    triangulation_.set_infinite_vertex(tds.create_vertex());
    const std::vector<Vertex_handle> vertices = create_vertices(points);
    std::vector<Face_handle> faces;
    faces.reserve(triangles.size());
    for (const Linked_triangle& t : triangles)
      add(faces,
          create_face(vertices[t.vertices[0]], vertices[t.vertices[1]], vertices[t.vertices[2]]));
    std::vector<Face_handle> outside(points.size()); // by the start of the edge that is inside
    for (std::size_t k = 0; k < triangles.size(); ++k)
      for (int i = 0; i < 3; ++i)
        if (triangles[k].neighbors[i] != none)
          faces[k]->set_neighbor(i, faces[triangles[k].neighbors[i]]);
        else
          outside[triangles[k].vertices[(i + 1) % 3]] = close(faces[k], i);
    for (const Face_handle f : outside)
      if (f != Face_handle()) { // its corners are the infinite one, the end and the start
        f->set_neighbor(2, outside[f->vertex(1)->info()]);
        outside[f->vertex(1)->info()]->set_neighbor(1, f);
      }
  }

  Triangulation& triangulation() { return triangulation_; }
  static bool is_inside(Face_handle f) { return f->info() != none; }

  // The triangles of the domain. Numbers their faces.
  Linked_triangles triangles() const {
    std::size_t count = 0;
    for (const Face_handle f : triangulation_.finite_face_handles())
      if (is_inside(f))
        f->info() = count++;
    check_number_of_indices(
        (std::max)(count, static_cast<std::size_t>(triangulation_.number_of_vertices())));
    Linked_triangles result;
    result.reserve(count);
    for (const Face_handle f : triangulation_.finite_face_handles())
      if (is_inside(f))
        result.push_back(triangle(f));
    return result;
  }

private:
  void insert(const std::vector<Point_2>& points, const std::vector<std::size_t>& next) {
    std::vector<std::pair<Point_2, std::size_t>> numbered;
    numbered.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      if (k >= next.size() || next[k] != none)
        numbered.emplace_back(points[k], k);
    triangulation_.insert(numbered.begin(), numbered.end());
    if (triangulation_.number_of_vertices() != numbered.size())
      throw Numerical_error("points of the domain's boundary coincide: its sides are too close to "
                            "each other, or too short, for the precision of the coordinates");
  }

  void constrain(const std::vector<std::size_t>& next) {
    std::vector<Vertex_handle> handles(next.size());
    for (const Vertex_handle v : triangulation_.finite_vertex_handles())
      if (v->info() < next.size())
        handles[v->info()] = v;
    try {
      for (std::size_t k = 0; k < next.size(); ++k)
        if (next[k] != none)
          triangulation_.insert_constraint(handles[k], handles[next[k]]);
      // A constraint with another point on it is divided there, silently.
      for (std::size_t k = 0; k < next.size(); ++k)
        if (next[k] != none && !triangulation_.is_edge(handles[k], handles[next[k]]))
          throw Numerical_error("edges on the domain's boundary touch: its sides are too close to "
                                "each other for the precision of the coordinates");
    } catch (const typename Triangulation::Intersection_of_constraints_exception&) {
      throw Numerical_error("edges on the domain's boundary cross: its sides are too close to each "
                            "other for the precision of the coordinates");
    }
  }

  std::vector<Face_handle> faces_along_boundary(const std::vector<std::size_t>& next) {
    for (const Face_handle f : triangulation_.all_face_handles())
      f->info() = none;
    std::vector<Face_handle> faces;
    const auto is_left_of_boundary = [&](Face_handle f, int i) {
      return f->is_constrained(i) && next[f->vertex(Triangulation::ccw(i))->info()] ==
                                         f->vertex(Triangulation::cw(i))->info();
    };
    for (const Face_handle f : triangulation_.finite_face_handles())
      if (is_left_of_boundary(f, 0) || is_left_of_boundary(f, 1) || is_left_of_boundary(f, 2))
        add(faces, f);
    return faces;
  }

  // A face without an edge on the boundary is where its neighbours are.
  void add_reachable(std::vector<Face_handle>& faces) {
    for (std::size_t t = 0; t < faces.size(); ++t)
      for (int i = 0; i < 3; ++i)
        if (!faces[t]->is_constrained(i) && faces[t]->neighbor(i)->info() == none)
          add(faces, faces[t]->neighbor(i));
  }

  static void add(std::vector<Face_handle>& faces, Face_handle f) {
    f->info() = faces.size();
    faces.push_back(f);
  }

  std::vector<Vertex_handle> create_vertices(const std::vector<Point_2>& points) {
    std::vector<Vertex_handle> vertices;
    vertices.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      vertices.push_back(triangulation_.tds().create_vertex());
      vertices.back()->set_point(points[k]);
      vertices.back()->info() = k;
    }
    return vertices;
  }

  Face_handle create_face(Vertex_handle a, Vertex_handle b, Vertex_handle c) {
    const Face_handle f = triangulation_.tds().create_face(a, b, c);
    for (int i = 0; i < 3; ++i) {
      f->set_constraint(i, false);
      f->vertex(i)->set_face(f);
    }
    return f;
  }

  // Adds the infinite face behind an edge, which becomes a constraint.
  Face_handle close(Face_handle inside, int i) {
    const Face_handle f =
        create_face(triangulation_.infinite_vertex(), inside->vertex(Triangulation::cw(i)),
                    inside->vertex(Triangulation::ccw(i)));
    f->info() = none;
    f->set_neighbor(0, inside);
    f->set_constraint(0, true);
    inside->set_neighbor(i, f);
    inside->set_constraint(i, true);
    return f;
  }

  static Linked_triangle triangle(Face_handle f) {
    Linked_triangle t;
    for (int i = 0; i < 3; ++i) {
      t.vertices[i] = f->vertex(i)->info();
      t.neighbors[i] = f->is_constrained(i) ? none : f->neighbor(i)->info();
    }
    return t;
  }

  Triangulation triangulation_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_BOUNDARY_TRIANGULATION_H
