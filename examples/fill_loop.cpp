// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

//! [fill_loop]
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Multisided_patches.h>
#include <CGAL/Surface_mesh.h>

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main(int argc, char* argv[]) {
  const auto model = MP::IO::read_CGB<Kernel>(argc > 1 ? argv[1] : "examples/models/l_bracket.cgb");
  const MP::Concave_bezier_patch_3<Kernel> patch(model); // domain and harmonic coordinates inside
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  MP::tessellate(patch, mesh, /* target edge length */ 1.0); // with normals and (u,v)
  return CGAL::IO::write_PLY("filled.ply", mesh) ? 0 : 1;
}
//! [fill_loop]
