// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESH_TOPOLOGY_H
#define CGAL_MULTISIDED_PATCHES_MESH_TOPOLOGY_H

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! What a mesh is, seen as a surface: its faces, glued together along their edges. (So faces that
//! share no more than a vertex are apart.)
struct Mesh_topology {
  std::size_t components = 0;
  std::size_t boundary_loops = 0;
  long euler_characteristic = 0;

  //! whether the mesh is a single disk
  bool is_disk() const {
    return components == 1 && boundary_loops == 1 && euler_characteristic == 1;
  }
  //! whether the mesh has no boundary
  bool is_closed() const { return boundary_loops == 0; }
};

//! The faces of a mesh that belong to one patch.
struct Patch_topology : Mesh_topology {
  std::size_t patch = 0; //!< the number that the faces have in common
  std::size_t faces = 0;
};

namespace internal {

// Counts the pieces of a mesh: `piece_of_face[i]` is that of the face with the index i.
template <typename Mesh>
class Piece_counter {
public:
  using Graph_traits = boost::graph_traits<Mesh>;
  using Face = typename Graph_traits::face_descriptor;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Face_index = typename GetInitializedFaceIndexMap<Mesh>::const_type;

  Piece_counter(const Mesh& mesh, const Face_index& face_index,
                const std::vector<std::size_t>& piece_of_face, std::size_t pieces)
      : mesh_(mesh), face_index_(face_index), piece_of_face_(piece_of_face), result_(pieces) {
    count_faces();
    count_edges();
    count_vertices();
    count_loops();
  }

  const std::vector<Patch_topology>& result() const { return result_; }
  // the number of vertices without a face
  std::size_t isolated_vertices() const { return isolated_vertices_; }

private:
  std::size_t index(Halfedge h) const { return get(face_index_, face(h, mesh_)); }
  std::size_t piece(Halfedge h) const { return piece_of_face_[index(h)]; }
  // whether there are faces of the same piece on either side
  bool is_inside(Halfedge h) const {
    const Halfedge o = opposite(h, mesh_);
    return !is_border(h, mesh_) && !is_border(o, mesh_) && piece(h) == piece(o);
  }

  // The Euler characteristic of a surface is that of its interior, since its boundary consists of
  // circles: faces - edges inside + vertices inside.
  void count_faces() {
    for (const Face f : faces(mesh_)) {
      Patch_topology& topology = result_[piece_of_face_[get(face_index_, f)]];
      ++topology.faces;
      ++topology.components;
      ++topology.euler_characteristic;
    }
  }

  void count_edges() {
    const std::size_t n = piece_of_face_.size();
    std::vector<std::size_t> rank(n), parent(n);
    boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
    for (std::size_t f = 0; f < n; ++f)
      sets.make_set(f);
    for (const auto e : edges(mesh_)) {
      const Halfedge h = halfedge(e, mesh_);
      if (!is_inside(h))
        continue;
      --result_[piece(h)].euler_characteristic;
      const std::size_t a = sets.find_set(index(h));
      const std::size_t b = sets.find_set(index(opposite(h, mesh_)));
      if (a != b) {
        sets.link(a, b);
        --result_[piece(h)].components;
      }
    }
  }

  void count_vertices() {
    const auto vertex_index = get_initialized_vertex_index_map(mesh_);
    std::vector<bool> seen(num_vertices(mesh_), false);
    for (const auto e : edges(mesh_))
      if (!is_inside(halfedge(e, mesh_)))
        seen[get(vertex_index, source(e, mesh_))] = seen[get(vertex_index, target(e, mesh_))] =
            true;
    for (const Face f : faces(mesh_))
      for (const Halfedge h : halfedges_around_face(halfedge(f, mesh_), mesh_)) {
        const std::size_t v = get(vertex_index, target(h, mesh_));
        if (!seen[v]) {
          seen[v] = true;
          ++result_[piece(h)].euler_characteristic;
        }
      }
    for (const auto v : vertices(mesh_))
      isolated_vertices_ += !seen[get(vertex_index, v)];
  }

  void count_loops() {
    const auto halfedge_index = get_initialized_halfedge_index_map(mesh_);
    std::vector<bool> seen(num_halfedges(mesh_), false);
    for (const Halfedge start : halfedges(mesh_)) {
      if (is_border(start, mesh_) || is_inside(start) || seen[get(halfedge_index, start)])
        continue;
      ++result_[piece(start)].boundary_loops;
      for (Halfedge h = start; !seen[get(halfedge_index, h)]; h = next_on_boundary(h))
        seen[get(halfedge_index, h)] = true;
    }
  }
  Halfedge next_on_boundary(Halfedge h) const {
    for (h = next(h, mesh_); is_inside(h); h = next(opposite(h, mesh_), mesh_)) {
    }
    return h;
  }

  const Mesh& mesh_;
  const Face_index& face_index_;
  const std::vector<std::size_t>& piece_of_face_;
  std::vector<Patch_topology> result_;
  std::size_t isolated_vertices_ = 0;
};

} // namespace internal

/*!
 * counts the components and boundary loops of a mesh. A vertex without faces is a component.
 *
 * \tparam Mesh a model of `FaceListGraph` and `HalfedgeListGraph`, such as `CGAL::Surface_mesh` or
 * `CGAL::Polyhedron_3`
 *
 * Complexity: linear in the size of the mesh.
 */
template <typename Mesh>
Mesh_topology mesh_topology(const Mesh& mesh) {
  const std::vector<std::size_t> piece_of_face(num_faces(mesh), 0);
  const auto face_index = get_initialized_face_index_map(mesh);
  const internal::Piece_counter<Mesh> counter(mesh, face_index, piece_of_face, 1);
  Mesh_topology topology = counter.result()[0];
  topology.components += counter.isolated_vertices();
  topology.euler_characteristic += static_cast<long>(counter.isolated_vertices());
  return topology;
}

/*!
 * does the same for each patch of a mesh, whose boundary is where the faces of other patches, or
 * none, follow.
 *
 * \param mesh the mesh
 * \param face_patch_map a readable property map from the faces of the mesh to non-negative integers
 *
 * \return one element for each number that occurs, in ascending order
 *
 * Complexity: O(m log p) for m faces and p patches.
 */
template <typename Mesh, typename FacePatchMap>
std::vector<Patch_topology> patch_topologies(const Mesh& mesh, const FacePatchMap& face_patch_map) {
  const auto face_index = get_initialized_face_index_map(mesh);
  std::vector<std::size_t> piece_of_face(num_faces(mesh), 0), patches;
  for (const auto f : faces(mesh)) {
    const auto patch = static_cast<std::size_t>(get(face_patch_map, f));
    piece_of_face[get(face_index, f)] = patch;
    if (patches.empty() || patches.back() != patch)
      patches.push_back(patch);
  }
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  for (const auto f : faces(mesh)) {
    std::size_t& piece = piece_of_face[get(face_index, f)];
    piece = static_cast<std::size_t>(std::lower_bound(patches.begin(), patches.end(), piece) -
                                     patches.begin());
  }
  std::vector<Patch_topology> topologies =
      internal::Piece_counter<Mesh>(mesh, face_index, piece_of_face, patches.size()).result();
  for (std::size_t k = 0; k < patches.size(); ++k)
    topologies[k].patch = patches[k];
  return topologies;
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESH_TOPOLOGY_H
