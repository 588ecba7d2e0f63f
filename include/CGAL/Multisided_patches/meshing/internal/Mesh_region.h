// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_REGION_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_REGION_H

#include <CGAL/Multisided_patches/internal/Linked_triangle.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A part of a mesh of triangles, as a mesh with numbers of its own, which can be refined and put
// back. It need not be connected; but its border passes through no point twice, and so it is
// sometimes larger than asked for.
class Mesh_region {
public:
  // Takes the chosen triangles, those with a point in common with one of them, and so on, as many
  // times as `rings` says. Around each point of the mesh the triangles are neighbours.
  //
  // Complexity: linear in the size of the region, but for tables of the size of the mesh, which are
  // cleared.
  Mesh_region(const Linked_triangles& mesh, std::size_t number_of_points,
              std::vector<char> is_chosen, int rings)
      : is_inside_(std::move(is_chosen)), is_surrounded_(number_of_points, false),
        local_(number_of_points, none) {
    for (std::size_t t = 0; t < mesh.size(); ++t)
      if (is_inside_[t])
        numbers_.push_back(t);
    for (std::size_t first = 0; rings > 0; --rings) {
      const std::size_t end = numbers_.size();
      for (; first < end; ++first)
        for (int i = 0; i < 3; ++i)
          surround(numbers_[first], i, mesh);
    }
    while (close_pinches(mesh))
      ;
    std::sort(numbers_.begin(), numbers_.end());
    number_points(mesh);
    make_triangles(mesh);
  }

  // The points of the region: first those on its border, of which there are
  // `number_of_border_points()`. points()[k] is the number in the mesh of point k of the region.
  const std::vector<std::size_t>& points() const { return points_; }
  std::size_t number_of_border_points() const { return outside_.size(); }
  // With the numbers of the region. On its border there are no neighbours.
  const Linked_triangles& triangles() const { return triangles_; }

  // Replaces the triangles of the region in the mesh that it is from by others with the same
  // border. New points of the region have become the last ones of the mesh, in the same order.
  void replace(const Linked_triangles& triangles, std::size_t number_of_points,
               Linked_triangles& mesh) {
    // Their numbers in the mesh: those of the old triangles, and then new ones.
    for (std::size_t k = numbers_.size(), next = mesh.size(); k < triangles.size(); ++k)
      numbers_.push_back(next++);
    mesh.resize(numbers_.empty() ? mesh.size() : (std::max)(mesh.size(), numbers_.back() + 1));
    const auto number_of_point = [&](std::size_t v) {
      return v < points_.size() ? points_[v] : number_of_points + (v - points_.size());
    };
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      Linked_triangle& t = mesh[numbers_[k]];
      for (int i = 0; i < 3; ++i) {
        t.vertices[i] = number_of_point(triangles[k].vertices[i]);
        const std::size_t neighbor = triangles[k].neighbors[i];
        t.neighbors[i] = neighbor != none ? numbers_[neighbor] : outside_[start(triangles[k], i)];
      }
      for (int i = 0; i < 3; ++i)
        if (triangles[k].neighbors[i] == none && t.neighbors[i] != none)
          link(mesh[t.neighbors[i]], end(t, i), numbers_[k]);
    }
  }

private:
  static constexpr std::size_t none = Linked_triangle::none;

  // Where the edge opposite to corner i starts and ends.
  static std::size_t start(const Linked_triangle& t, int i) { return t.vertices[(i + 1) % 3]; }
  static std::size_t end(const Linked_triangle& t, int i) { return t.vertices[(i + 2) % 3]; }

  // Makes a triangle the neighbour of another one across the edge that starts at a point.
  static void link(Linked_triangle& other, std::size_t start_of_edge, std::size_t triangle) {
    for (int i = 0; i < 3; ++i)
      if (start(other, i) == start_of_edge)
        other.neighbors[i] = triangle;
  }

  bool is_inside(std::size_t t) const { return t != none && is_inside_[t]; }

  void add(std::size_t t) {
    if (is_inside_[t])
      return;
    is_inside_[t] = true;
    numbers_.push_back(t);
  }

  // Adds all triangles around corner i of triangle t.
  void surround(std::size_t t, int i, const Linked_triangles& mesh) {
    const std::size_t v = mesh[t].vertices[i];
    if (is_surrounded_[v])
      return;
    is_surrounded_[v] = true;
    for (const int turn :
         {1, 2}) { // over the edge that ends at v, and over that which starts there
      std::size_t next = t;
      do {
        add(next);
        const auto& vertices = mesh[next].vertices;
        const auto corner = std::find(vertices.begin(), vertices.end(), v) - vertices.begin();
        next = mesh[next].neighbors[(static_cast<int>(corner) + turn) % 3];
      } while (next != none && next != t);
      if (next == t)
        return;
    }
  }

  // Calls f(t, i) for the edges on the border.
  template <typename Function>
  void for_each_border_edge(const Linked_triangles& mesh, const Function& f) const {
    for (const std::size_t t : numbers_)
      for (int i = 0; i < 3; ++i)
        if (!is_inside(mesh[t].neighbors[i]))
          f(t, i);
  }

  // Adds all triangles around points through which the border passes twice. Returns whether there
  // were some.
  bool close_pinches(const Linked_triangles& mesh) {
    std::vector<char> is_start(local_.size(), false);
    std::vector<std::pair<std::size_t, int>> pinches; // triangles and their corners there
    for_each_border_edge(mesh, [&](std::size_t t, int i) {
      const int corner = (i + 1) % 3;
      char& is_start_here = is_start[mesh[t].vertices[corner]];
      if (is_start_here)
        pinches.emplace_back(t, corner);
      is_start_here = true;
    });
    const std::size_t before = numbers_.size();
    for (const auto& [t, corner] : pinches)
      surround(t, corner, mesh);
    return numbers_.size() > before;
  }

  void number_points(const Linked_triangles& mesh) {
    const auto add = [&](std::size_t v) {
      if (local_[v] != none)
        return;
      local_[v] = static_cast<Linked_triangle::Index>(points_.size());
      points_.push_back(v);
    };
    for_each_border_edge(mesh, [&](std::size_t t, int i) {
      add(start(mesh[t], i));
      outside_.push_back(mesh[t].neighbors[i]);
    });
    for (const std::size_t t : numbers_)
      for (const std::size_t v : mesh[t].vertices)
        add(v);
  }

  void make_triangles(const Linked_triangles& mesh) {
    std::vector<Linked_triangle::Index> local(mesh.size(), none);
    for (std::size_t k = 0; k < numbers_.size(); ++k)
      local[numbers_[k]] = static_cast<Linked_triangle::Index>(k);
    triangles_.reserve(numbers_.size());
    for (const std::size_t t : numbers_) {
      Linked_triangle triangle;
      for (int i = 0; i < 3; ++i) {
        triangle.vertices[i] = local_[mesh[t].vertices[i]];
        const std::size_t neighbor = mesh[t].neighbors[i];
        triangle.neighbors[i] = neighbor == none ? none : local[neighbor];
      }
      triangles_.push_back(triangle);
    }
  }

  std::vector<char> is_inside_;     // by triangle of the mesh
  std::vector<char> is_surrounded_; // by point of the mesh: whether all triangles there are inside
  std::vector<Linked_triangle::Index> local_; // by point of the mesh: its number in the region
  std::vector<std::size_t> points_;           // by point of the region
  std::vector<std::size_t> outside_; // by point on the border: the triangle behind the edge from it
  std::vector<std::size_t> numbers_; // by triangle of the region: its number in the mesh
  Linked_triangles triangles_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_MESH_REGION_H
