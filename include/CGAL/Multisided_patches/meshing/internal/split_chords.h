// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SPLIT_CHORDS_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SPLIT_CHORDS_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A chord is an edge inside a domain that joins two points of its boundary.
struct Chord {
  std::size_t patch;
  std::array<std::size_t, 2> ends; // vertices
};

// The chords of a mesh, and the edges on its boundary with only one triangle.
template <typename Traits>
void find_chords(const Domain_mesh_2<Traits>& mesh, std::size_t patch, std::vector<Chord>& chords,
                 std::vector<std::array<std::size_t, 2>>& sides) {
  std::set<std::array<std::size_t, 2>> edges; // directed, with the triangle on the left
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = t[i], b = t[(i + 1) % 3];
      if ((std::max)(a, b) < mesh.number_of_boundary_points)
        edges.insert({a, b});
    }
  for (const auto& ends : edges)
    if (edges.count({ends[1], ends[0]}) == 0)
      sides.push_back(ends);
    else if (ends[0] < ends[1])
      chords.push_back({patch, ends});
}

// Puts a point in the middle of a chord.
template <typename Traits>
void split_chord(Domain_mesh_2<Traits>& mesh, const Chord& chord) {
  const std::size_t middle = mesh.points.size(), triangles = mesh.triangles.size();
  mesh.points.push_back(midpoint(mesh.points[chord.ends[0]], mesh.points[chord.ends[1]]));
  mesh.locations.push_back(Domain_mesh_2<Traits>::Location::interior());
  for (std::size_t t = 0; t < triangles; ++t) {
    // Each half of a triangle on the chord has one of the ends replaced.
    std::array<std::size_t, 3> halves[2] = {mesh.triangles[t], mesh.triangles[t]};
    if (std::count(halves[0].begin(), halves[0].end(), chord.ends[0]) == 0 ||
        std::count(halves[0].begin(), halves[0].end(), chord.ends[1]) == 0)
      continue;
    for (std::size_t k = 0; k < 2; ++k) {
      std::replace(halves[k].begin(), halves[k].end(), chord.ends[k], middle);
      if (orientation(mesh.points[halves[k][0]], mesh.points[halves[k][1]],
                      mesh.points[halves[k][2]]) != LEFT_TURN)
        throw Numerical_error("a triangle at the boundary is too flat to be divided");
    }
    mesh.triangles[t] = halves[0];
    mesh.triangles.push_back(halves[1]);
  }
}

// Where patches share more than one side, two of them could have the same chord, and four triangles
// on it; and a chord of one could be an edge on a side of others. Such chords are split, all but
// one. groups[k][v] is the number of the common vertex for vertex v on the boundary of mesh k.
template <typename Traits>
void split_chords(std::vector<Domain_mesh_2<Traits>>& meshes,
                  const std::vector<std::vector<std::size_t>>& groups) {
  const auto common = [&](std::size_t patch, const std::array<std::size_t, 2>& ends) {
    return std::minmax({groups[patch][ends[0]], groups[patch][ends[1]]});
  };
  std::vector<Chord> chords;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> uses;
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    std::vector<std::array<std::size_t, 2>> sides;
    find_chords(meshes[k], k, chords, sides);
    for (const auto& ends : sides)
      ++uses[common(k, ends)];
  }
  for (const Chord& chord : chords)
    ++uses[common(chord.patch, chord.ends)];
  for (const Chord& chord : chords) {
    const auto ends = common(chord.patch, chord.ends);
    if (ends.first != ends.second && uses[ends] == 1)
      continue;
    --uses[ends];
    split_chord(meshes[chord.patch], chord);
  }
}

// The first patch, if any, with a triangle that does not fit: because two of its corners are the
// same common vertex, or another triangle is on the same side of one of its edges.
template <typename Traits>
std::optional<std::size_t> find_torn_patch(const std::vector<Domain_mesh_2<Traits>>& meshes,
                                           const std::vector<std::vector<std::size_t>>& groups) {
  std::set<std::array<std::size_t, 2>> edges;
  std::size_t first_inside = 0; // what vertices inside are called, after all common ones
  for (const auto& group : groups)
    first_inside += group.size();
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    const std::size_t n = meshes[k].number_of_boundary_points;
    const auto name = [&](std::size_t v) { return v < n ? groups[k][v] : first_inside + v - n; };
    for (const auto& t : meshes[k].triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = t[i], b = t[(i + 1) % 3];
        // Edges inside are the patch's own.
        if ((std::min)(a, b) < n &&
            (name(a) == name(b) || !edges.insert({name(a), name(b)}).second))
          return k;
      }
    first_inside += meshes[k].points.size() - n;
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_SPLIT_CHORDS_H
