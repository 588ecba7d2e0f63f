// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes patches that are neighbours of each other to one mesh without gaps:
//
//   mesh_complex OUTPUT.ply A.cgb B.cgb ...

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Multisided_patches.h>
#include <CGAL/Surface_mesh.h>

#include <exception>
#include <iostream>
#include <vector>

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Patch = MP::Concave_bezier_patch_3<Kernel>;

int main(int argc, char* argv[]) {
  if (argc < 3) {
    std::cerr << "usage: mesh_complex OUTPUT.ply PATCH.cgb...\n";
    return 2;
  }
  try {
    std::vector<Patch> patches;
    for (int i = 2; i < argc; ++i)
      patches.emplace_back(MP::IO::read_CGB<Kernel>(argv[i]));
    const MP::Patch_complex<Patch> complex(patches, {argv + 2, argv + argc});
    std::cout << complex.shared_sides().size() << " shared sides, "
              << complex.number_of_free_sides() << " free ones\n";
    for (const std::string& remark : complex.remarks())
      std::cout << remark << '\n';

    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    MP::tessellate(complex, mesh,
                   MP::Mesh_density::edge_length(3) & MP::Mesh_density::normal_deviation(10));
    const MP::Mesh_check check = MP::check_mesh(mesh);
    std::cout << check.triangles << " triangles, "
              << (check.is_closed() ? "closed" : "with a boundary") << ", smallest angle "
              << check.smallest_angle << " degrees\n";
    return CGAL::IO::write_PLY(argv[1], mesh) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "mesh_complex: " << error.what() << '\n';
    return 1;
  }
}
