// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a user of the installed package writes: exits with 0 if a patch becomes a mesh.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Multisided_patches.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main(int, char* argv[]) {
  const auto model = MP::IO::read_CGB<Kernel>(argv[1]);
  const MP::Concave_bezier_patch_3<Kernel> patch(model);
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  MP::tessellate(patch, mesh, model.loop.diagonal() / 20);
  return mesh.is_empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
