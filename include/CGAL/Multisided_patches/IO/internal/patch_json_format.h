// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PATCH_JSON_FORMAT_H
#define CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PATCH_JSON_FORMAT_H

#include <CGAL/Multisided_patches/IO/Any_patch_model.h>
#include <CGAL/Multisided_patches/bases/Central_weight.h>
#include <CGAL/Multisided_patches/domains/Domain_options.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Multisided_patches {
namespace IO {

//! Limits of `.patch.json` files. They are far above what patches need and keep hostile files
//! harmless.
struct Patch_json_limits {
  static constexpr std::size_t max_sides = 1000;
  static constexpr std::size_t max_degree = 100; //!< of S-patches: the depth
  static constexpr std::size_t max_layers = 50;
  static constexpr std::size_t max_control_points = 500000;
  static constexpr std::size_t max_file_size = std::size_t(1) << 26; //!< bytes
};

namespace internal {

// What the writer of the format and the reader share.
inline constexpr const char* patch_json_name = "multisided-patch";
inline constexpr std::size_t patch_json_version = 1;

// The values that a file can name.
inline constexpr std::array all_patch_types{
    Patch_type::concave_bezier, Patch_type::generalized_bezier, Patch_type::s_patch,
    Patch_type::tensor_product, Patch_type::bezier_triangle};
inline constexpr std::array all_coordinates{
    Coordinates_choice::harmonic, Coordinates_choice::mean_value, Coordinates_choice::wachspress};
inline constexpr std::array all_central_weights{
    Central_weight::weight_deficiency, Central_weight::none, Central_weight::adjacent_products,
    Central_weight::full_product, Central_weight::automatic};
inline constexpr std::array all_generators{
    Domain_generator::automatic,        Domain_generator::projected, Domain_generator::similarity,
    Domain_generator::similarity_outer, Domain_generator::curved,    Domain_generator::circular,
    Domain_generator::regular};

} // namespace internal
} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PATCH_JSON_FORMAT_H
