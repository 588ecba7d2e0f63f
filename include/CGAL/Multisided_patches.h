// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_H
#define CGAL_MULTISIDED_PATCHES_H

/*!
 * \file
 * The whole package, except for what few programs need and is slow to compile: writing meshes
 * (`CGAL/Multisided_patches/IO/surface_mesh.h`, or CGAL's own functions) and
 * `CGAL/Multisided_patches/analysis/self_intersections.h`.
 */

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/IO/GBP.h>
#include <CGAL/Multisided_patches/IO/polygon_file.h>
#include <CGAL/Multisided_patches/analysis/boundary_deviation.h>
#include <CGAL/Multisided_patches/analysis/check_mesh.h>
#include <CGAL/Multisided_patches/analysis/continuity_report.h>
#include <CGAL/Multisided_patches/analysis/fairness_report.h>
#include <CGAL/Multisided_patches/analysis/mesh_topology.h>
#include <CGAL/Multisided_patches/analysis/rounding_report.h>
#include <CGAL/Multisided_patches/bases/automatic_central_weight.h>
#include <CGAL/Multisided_patches/bases/contact_order.h>
#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/domains/make_regular_domain.h>
#include <CGAL/Multisided_patches/meshing/is_valid_domain_mesh.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>
#include <CGAL/Multisided_patches/meshing/tessellate_complex.h>
#include <CGAL/Multisided_patches/meshing/triangulate_domain.h>
#include <CGAL/Multisided_patches/patches/Bezier_triangle_3.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/Generalized_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/Patch_evaluator.h>
#include <CGAL/Multisided_patches/patches/S_patch_3.h>
#include <CGAL/Multisided_patches/patches/Surface_geometry_3.h>
#include <CGAL/Multisided_patches/patches/Tensor_product_patch_3.h>
#include <CGAL/Multisided_patches/patches/central_control_point.h>
#include <CGAL/Multisided_patches/patches/closest_parameters.h>
#include <CGAL/Multisided_patches/patches/fair_central_point.h>
#include <CGAL/Multisided_patches/patches/fill_with_S_patch.h>
#include <CGAL/Multisided_patches/patches/fit_generalized_bezier_net.h>
#include <CGAL/Multisided_patches/patches/with_resolved_central_weight.h>
#include <CGAL/Multisided_patches/ribbons/Bezier_curve_3.h>
#include <CGAL/Multisided_patches/ribbons/Bspline_curve_3.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>
#include <CGAL/Multisided_patches/ribbons/elevate_net.h>
#include <CGAL/Multisided_patches/ribbons/make_generalized_bezier_net.h>
#include <CGAL/Multisided_patches/ribbons/merge_loops.h>

#endif // CGAL_MULTISIDED_PATCHES_H
