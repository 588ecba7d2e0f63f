// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_ANY_MODEL_H
#define MULTIPATCH_ANY_MODEL_H

#include "commands.h"

#include <CGAL/Multisided_patches/IO/Any_patch_model.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace multipatch {

// What a file says about a patch of any type.
using Any_model = CGAL::Multisided_patches::IO::Any_patch_model<Kernel>;
using Concave_model = CGAL::Multisided_patches::IO::Concave_bezier_description_3<Kernel>;
using Generalized_model = CGAL::Multisided_patches::IO::Generalized_bezier_description_3<Kernel>;
using S_patch_model = CGAL::Multisided_patches::IO::S_patch_description_3<Kernel>;
using Tensor_product = CGAL::Multisided_patches::Tensor_product_patch_3<Kernel>;
using Triangle = CGAL::Multisided_patches::Bezier_triangle_3<Kernel>;
using Loop = CGAL::Multisided_patches::Ribbon_loop_3<Kernel>;

// Whether the name of a file is that of a patch.
bool is_patch_file(const std::string& file_name);

// Reads the input file, and lets the options override what it says. Throws Input_error, too, if an
// option makes no sense for the type of the patch.
Any_model read_model(const Patch_options& options);

// The same for several files, none of which may be given twice; warns of mismatches, if not asked
// to be quiet.
std::vector<Any_model> read_models(Patch_options options, const std::vector<std::string>& inputs,
                                   bool quiet);

// "concave generalized Bezier patch"
std::string type_name(const Any_model& model);

std::size_t number_of_sides(const Any_model& model);

// The ribbons that the patch meets.
Loop loop(const Any_model& model);

// The domain, and how it came about.
CGAL::Multisided_patches::Generated_domain<Kernel> make_domain(const Any_model& model);

// What the parameters of a patch without coordinates are in the terms of such: on squares and
// triangles, Wachspress coordinates are bilinear and linear.
constexpr Coordinates_choice own_coordinates = Coordinates_choice::wachspress;

// The coordinates on it, if the patch has a choice of them.
std::optional<Coordinates_choice> coordinates(const Any_model& model);

// Sentences on where the patch does not have the derivatives that the layers of a ribbon promise.
std::vector<std::string> contact_shortfalls(const Any_model& model);

// What would help against some of them, a sentence, or nothing.
std::string contact_advice(const std::vector<Any_model>& models);

// Warns of them; the prefix of each model begins those on it.
void warn_of_contact_shortfalls(const std::vector<Any_model>& models,
                                const std::vector<std::string>& prefixes);

} // namespace multipatch

#endif // MULTIPATCH_ANY_MODEL_H
