// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes a patch once, and then moves a control point in small steps, as a user of a modeller would
// with the mouse: the triangles stay the same, and only the vertices move that the control point
// has influence on. Prints how far the mesh moves, and writes it.

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/Patch_evaluator.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Patch = MP::Concave_bezier_patch_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[]) try {
  const std::string file = argc > 1 ? argv[1] : "examples/models/u_vent.cgb";
  const Patch patch(MP::IO::read_CGB<Kernel>(file));
  const auto domain_mesh = MP::mesh_domain(patch, MP::Mesh_density::triangles(20000));
  Mesh mesh;
  MP::tessellate(patch, domain_mesh, mesh); // vertex k of the mesh is point k of the domain

  MP::Patch_evaluator<Patch> evaluator(patch, domain_mesh.points, domain_mesh.locations);
  // A control point in the second row of side 0: the boundary stays where it is.
  const std::size_t c = evaluator.basis().index(0, 1, 1);
  const Kernel::Vector_3 step = 0.01 * patch.loop().diagonal() * patch.normal_on_side(0, 0.5);
  constexpr int steps = 10;
  for (int k = 0; k < steps; ++k)
    evaluator.set_control_point(c, evaluator.control_point(c) + step);

  const auto normals = mesh.property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  double farthest = 0;
  for (const auto v : mesh.vertices()) {
    const Kernel::Point_3 p = evaluator.position(v);
    farthest = (std::max)(farthest, std::sqrt(CGAL::squared_distance(p, mesh.point(v))));
    mesh.point(v) = p;
    normals[v] = evaluator.normal(v);
  }
  std::cout << "The control point has moved by " << steps * std::sqrt(step.squared_length())
            << ", the mesh by up to " << farthest << '\n';
  CGAL::IO::write_PLY("moved.ply", mesh);
} catch (const std::exception& error) {
  std::cerr << "move_control_point: " << error.what() << '\n';
  return 1;
}
