// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_BENCHMARK_FILLING_H
#define MULTISIDED_PATCHES_BENCHMARK_FILLING_H

#include "fixtures.h"

#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/domains/Domain_location.h>

#include <array>

// Ways to fill the hole that a loop of ribbons bounds, and how smoothly each meets the ribbons.
namespace bench {

//! What became of a filling. Angles and gaps are those of `continuity_report()`.
struct Filling_outcome {
  double seconds = 0;         // CPU time
  double triangles = 0;       // 0: a surface was made, and no mesh
  double largest_degrees = 0; // between tangent planes, along the boundary
  double mean_degrees = 0;    // the largest mean of a side
  double largest_gap = 0;     // between points, as a fraction of the loop's diagonal
};

//! A hole with the points at which meshes sample its boundary: in order, with the side and the
//! parameter of each; every side's first point is its corner, where `s` is 0.
struct Hole {
  struct Sample {
    std::size_t side;
    double s;
  };

  Model model;
  double edge_length;
  std::vector<Sample> boundary;
};

//! Triangles that fill a hole: the first points are those of the boundary, in order.
struct Filling_mesh {
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

//! samples the boundary of a model as our mesher does for an edge length (model units)
Hole make_hole(const Model& model, double edge_length);

//! the patch alone
Filling_outcome fill_with_patch(const Hole& hole);
//! the patch, and its mesh; the angles are those of the mesh
Filling_outcome fill_with_patch_mesh(const Hole& hole);
//! CGAL's hole filling, between strips of triangles that follow the ribbons; all sides need at
//! least 2 layers
Filling_outcome fill_with_cgal(const Hole& hole);
//! Open CASCADE's filling (an energy-minimizing plate, approximated by a B-spline surface), with
//! its default parameters or with finer ones
Filling_outcome fill_with_open_cascade(const Hole& hole, bool fine);

// ---------------------------------------------------------------------------------------- measure

//! A surface next to the ribbons of a loop, as `continuity_report()` wants to see it.
//! \tparam Evaluate tells the jets (x, y, z) of the surface at a side and the parameter of a point
//! on it; u and v are any parameters, counterclockwise as seen from where the normal points to
template <typename Evaluate>
class Boundary_surface {
public:
  using FT = double;
  using Location = MP::Domain_location<double>;

  Boundary_surface(const Loop& loop, Evaluate evaluate)
      : loop_(loop), evaluate_(std::move(evaluate)) {}

  const Loop& loop() const { return loop_; }
  const Boundary_surface& domain() const { return *this; }
  Point_2 point_on_side(std::size_t, double) const { return Point_2(0, 0); }
  Location location_on_side(std::size_t i, double s) const { return Location::on_side(i, s); }
  template <int Order>
  auto evaluate(const Point_2&, const Location& at) const {
    static_assert(Order == 2);
    return evaluate_(at.index, at.s);
  }

private:
  const Loop& loop_;
  Evaluate evaluate_;
};

using Surface_jet = std::array<MP::Jet_2<double, 2>, 3>;

//! A flat piece of a surface.
inline Surface_jet plane(const Point_3& p, const Kernel::Vector_3& u, const Kernel::Vector_3& v) {
  Surface_jet jet;
  for (int c = 0; c < 3; ++c) {
    jet[std::size_t(c)][0] = p[c];
    jet[std::size_t(c)][1] = u[c];
    jet[std::size_t(c)][2] = v[c];
  }
  return jet;
}

//! fills in what `continuity_report()` says about a surface
template <typename Surface>
void measure_boundary(const Surface& surface, Filling_outcome& outcome) {
  const MP::Continuity_report report = MP::continuity_report(surface);
  outcome.largest_degrees = report.largest_tangent_plane().value;
  outcome.largest_gap = report.largest_position().value / surface.loop().diagonal();
  for (const MP::Side_continuity& side : report.sides)
    if (side.tangent_plane)
      outcome.mean_degrees = (std::max)(outcome.mean_degrees, side.tangent_plane->mean);
}

//! the same for a mesh: the planes are those of the triangles at the boundary
void measure_boundary(const Filling_mesh& mesh, const Hole& hole, Filling_outcome& outcome);

} // namespace bench

#endif // MULTISIDED_PATCHES_BENCHMARK_FILLING_H
