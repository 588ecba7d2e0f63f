// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_NEW_ELEMENTS_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_NEW_ELEMENTS_H

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Adds an edge. (Members called `halfedge` would hide that of the mesh.)
template <typename FaceGraph>
auto add_halfedge(FaceGraph& mesh) {
  return halfedge(add_edge(mesh), mesh);
}

// Vertices, edges and faces added to a mesh, by their numbers. They are not linked yet. Halfedges
// 2e and 2e + 1 are those of edge e.
template <typename FaceGraph>
class New_elements {
  using Graph = boost::graph_traits<FaceGraph>;

public:
  using Vertex = typename Graph::vertex_descriptor;
  using Halfedge = typename Graph::halfedge_descriptor;
  using Face = typename Graph::face_descriptor;
  // How elements that differ may be changed.
  template <typename>
  using Concurrency = Sequential_tag;
  static constexpr bool are_removable = false;

  New_elements(FaceGraph& mesh, std::size_t vertices, std::size_t edges, std::size_t faces)
      : mesh_(mesh) {
    using Size = typename Graph::vertices_size_type;
    reserve(mesh, static_cast<Size>(num_vertices(mesh) + vertices),
            static_cast<Size>(num_edges(mesh) + edges), static_cast<Size>(num_faces(mesh) + faces));
    vertices_.reserve(vertices);
    halfedges_.reserve(edges);
    faces_.reserve(faces);
    for (std::size_t k = 0; k < vertices; ++k)
      vertices_.push_back(add_vertex(mesh));
    for (std::size_t k = 0; k < edges; ++k)
      halfedges_.push_back(add_halfedge(mesh));
    for (std::size_t k = 0; k < faces; ++k)
      faces_.push_back(add_face(mesh));
  }

  Vertex vertex(std::size_t k) const { return vertices_[k]; }
  Halfedge halfedge(std::size_t k) const {
    return k % 2 == 0 ? halfedges_[k / 2] : opposite(halfedges_[k / 2], mesh_);
  }
  Face face(std::size_t k) const { return faces_[k]; }

private:
  const FaceGraph& mesh_;
  std::vector<Vertex> vertices_;
  std::vector<Halfedge> halfedges_; // one of each edge
  std::vector<Face> faces_;
};

// Those of a Surface_mesh are numbered in it, and are added all at once.
template <typename Point_3>
class New_elements<Surface_mesh<Point_3>> {
  using Mesh = Surface_mesh<Point_3>;
  using Size = typename Mesh::size_type;

public:
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Face = typename Mesh::Face_index;
  template <typename ConcurrencyTag>
  using Concurrency = ConcurrencyTag;
  static constexpr bool are_removable = true;

  New_elements(Mesh& mesh, std::size_t vertices, std::size_t edges, std::size_t faces)
      : first_vertex_(mesh.num_vertices()), first_edge_(mesh.num_edges()), // removed ones, too
        first_face_(mesh.num_faces()) {
    try {
      resize(mesh, vertices, edges, faces);
    } catch (...) { // some of its arrays may be larger now
      remove(mesh);
      throw;
    }
  }
  // pre: no other elements have been added since.
  void remove(Mesh& mesh) const { resize(mesh, 0, 0, 0); }

  Vertex vertex(std::size_t k) const { return Vertex(static_cast<Size>(first_vertex_ + k)); }
  Halfedge halfedge(std::size_t k) const {
    return Halfedge(static_cast<Size>(2 * first_edge_ + k));
  }
  Face face(std::size_t k) const { return Face(static_cast<Size>(first_face_ + k)); }

private:
  void resize(Mesh& mesh, std::size_t vertices, std::size_t edges, std::size_t faces) const {
    mesh.resize(static_cast<Size>(first_vertex_ + vertices), static_cast<Size>(first_edge_ + edges),
                static_cast<Size>(first_face_ + faces));
  }

  std::size_t first_vertex_, first_edge_, first_face_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_NEW_ELEMENTS_H
