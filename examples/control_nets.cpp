// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Fills the ribbons of a five-sided cap with a generalized Bézier patch, elevates its control net,
// moves the central control point so that the surface passes through a given point, and fills the
// same ribbons with an S-patch. Prints how fair the surfaces are, and writes a mesh.

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/analysis/fairness_report.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/patches/Generalized_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/central_control_point.h>
#include <CGAL/Multisided_patches/patches/fill_with_S_patch.h>
#include <CGAL/Multisided_patches/ribbons/elevate_net.h>
#include <CGAL/Multisided_patches/ribbons/make_generalized_bezier_net.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <iostream>
#include <string>

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Patch = MP::Generalized_bezier_patch_3<Kernel>;

template <typename Any_patch>
void print_fairness(const std::string& name, const Any_patch& patch) {
  const auto fairness = MP::fairness_report(patch, /* triangles */ 6000);
  std::cout << name << ": " << patch.basis().size() << " control points, bending energy "
            << fairness.bending_energy << ", 99 % of the area have curvatures up to "
            << fairness.curvature_99 * patch.loop().diagonal() << " / diagonal\n";
}

int main(int argc, char* argv[]) try {
  const std::string file = argc > 1 ? argv[1] : "examples/models/pentagon_cap.cgb";
  const MP::Ribbon_loop_3<Kernel> loop = MP::IO::read_CGB<Kernel>(file).loop;

  //! [control nets]
  const auto net = MP::make_generalized_bezier_net(loop); // of the lowest degree that will do
  print_fairness("degree " + std::to_string(net.degree()), Patch(net));

  const auto elevated = MP::elevate_net(net, net.degree() + 2);
  const Patch patch(elevated); // over a regular polygon
  print_fairness("degree " + std::to_string(elevated.degree()), patch);

  // Lift the middle by a twentieth of the size.
  const auto& domain = patch.domain().vertices();
  const auto middle = CGAL::centroid(domain.begin(), domain.end(), CGAL::Dimension_tag<0>());
  const auto target = patch(middle) + loop.diagonal() / 20 * patch.normal(middle);
  auto points = elevated.control_points();
  points.back() = MP::central_point_for(patch, elevated, middle, target);
  const Patch lifted(elevated.with_control_points(points));
  print_fairness("degree " + std::to_string(elevated.degree()) + ", lifted", lifted);
  //! [control nets]

  const auto s_patch = MP::fill_with_S_patch(loop);
  print_fairness("S-patch of depth " + std::to_string(s_patch.net().depth()), s_patch);

  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  MP::tessellate(lifted, mesh, MP::Mesh_density::triangles(5000));
  std::cout << mesh.number_of_faces() << " triangles of the lifted patch in control_nets.ply\n";
  return CGAL::IO::write_PLY("control_nets.ply", mesh) ? 0 : 1;
} catch (const MP::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
