// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_LINKED_ELEMENTS_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_LINKED_ELEMENTS_H

#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/meshing/internal/Mesh_connectivity.h>
#include <CGAL/Multisided_patches/meshing/internal/New_elements.h>

#include <CGAL/boost/graph/properties.h>

#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Vertices, edges and triangles that are added to a mesh and linked as a connectivity says. Nothing
// is joined to what the mesh already has.
//
// Where that costs next to nothing they are removed again at the end of this object, unless they
// are kept; so they can be added before it is known whether the mesh is to change at all.
template <typename ConcurrencyTag, typename FaceGraph>
class Linked_elements {
  using Elements = New_elements<FaceGraph>;

public:
  using Halfedge = typename Elements::Halfedge;
  // How elements that differ may be changed.
  using Concurrency = typename Elements::template Concurrency<ConcurrencyTag>;
  static constexpr bool are_removable = Elements::are_removable;

  // The connectivity has to outlive this object.
  Linked_elements(FaceGraph& mesh, const Mesh_connectivity& connectivity)
      : Linked_elements(mesh, connectivity, Not_linked()) { // what follows may throw
    link_triangles();
    link_vertices();
    link_border();
  }
  Linked_elements(const Linked_elements&) = delete;
  Linked_elements& operator=(const Linked_elements&) = delete;
  ~Linked_elements() {
    if constexpr (are_removable)
      if (!are_kept_)
        elements_.remove(mesh_);
  }
  void keep() { are_kept_ = true; }

  // (Members called `face` or `halfedge` would hide those of the mesh.)
  auto new_vertex(std::size_t number) const { return elements_.vertex(number); }
  auto new_face(std::size_t triangle) const { return elements_.face(triangle); }
  // Of the triangle of a corner, along the edge that starts there.
  Halfedge corner_halfedge(std::size_t corner) const {
    return elements_.halfedge(connectivity_.halfedge(corner));
  }

private:
  struct Not_linked {};
  Linked_elements(FaceGraph& mesh, const Mesh_connectivity& connectivity, Not_linked)
      : mesh_(mesh), connectivity_(connectivity),
        elements_(mesh, connectivity.number_of_vertices(), connectivity.number_of_edges(),
                  connectivity.number_of_triangles()) {}

  auto corner_vertex(std::size_t corner) const { return new_vertex(connectivity_.vertex(corner)); }

  void link_triangles() {
    for_each_index<Concurrency>(connectivity_.number_of_triangles(), [&](std::size_t t) {
      const auto face = new_face(t);
      for (std::size_t c = 3 * t; c < 3 * t + 3; ++c) {
        const Halfedge h = corner_halfedge(c);
        const std::size_t next = Mesh_connectivity::next_corner(c);
        set_target(h, corner_vertex(next), mesh_);
        set_next(h, corner_halfedge(next), mesh_);
        set_face(h, face, mesh_);
      }
      set_halfedge(face, corner_halfedge(3 * t), mesh_);
    });
  }

  void link_vertices() {
    for_each_index<Concurrency>(connectivity_.number_of_vertices(), [&](std::size_t v) {
      const auto c = connectivity_.corner_at(v);
      if (c != Mesh_connectivity::none)
        set_halfedge(new_vertex(v), corner_halfedge(Mesh_connectivity::previous_corner(c)), mesh_);
    });
  }

  void link_border() {
    const auto none = boost::graph_traits<FaceGraph>::null_face();
    for (const auto c : connectivity_.border()) {
      const Halfedge h = opposite(corner_halfedge(c), mesh_);
      set_target(h, corner_vertex(c), mesh_);
      set_face(h, none, mesh_);
      set_halfedge(corner_vertex(c), h, mesh_);
    }
    for (const auto c : connectivity_.border()) {
      const Halfedge h = opposite(corner_halfedge(c), mesh_);
      // Around the vertex where it ends, from face to face, up to the next one on the border.
      Halfedge other = corner_halfedge(c);
      do
        other = opposite(prev(other, mesh_), mesh_);
      while (face(other, mesh_) != none);
      set_next(h, other, mesh_);
    }
  }

  FaceGraph& mesh_;
  const Mesh_connectivity& connectivity_;
  Elements elements_;
  bool are_kept_ = false;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_LINKED_ELEMENTS_H
