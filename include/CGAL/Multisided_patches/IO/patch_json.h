// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_PATCH_JSON_H
#define CGAL_MULTISIDED_PATCHES_IO_PATCH_JSON_H

#include <CGAL/Multisided_patches/IO/Any_patch_model.h>
#include <CGAL/Multisided_patches/IO/internal/Patch_json_reader.h>
#include <CGAL/Multisided_patches/IO/internal/Patch_json_writer.h>
#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/IO/internal/parse_json.h>
#include <CGAL/Multisided_patches/IO/internal/patch_json_format.h>

#include <istream>
#include <ostream>
#include <string>
#include <variant>

namespace CGAL {
namespace Multisided_patches {

/*!
 * \file
 * The `.patch.json` format, which holds patches of every type with their domains and options; the
 * file `doc/patch.schema.json` is its JSON schema. A file is an object with
 *   - `"format": "multisided-patch"` and `"version": 1`;
 *   - `"type"`, one of the names of `Patch_type`;
 *   - `"coordinates"` and `"domain"`, for types that have a choice: the domain is an object either
 *     with a `"generator"` and a wanted `"clearance"`, or with its `"vertices"`, one for each side;
 *   - what determines a patch of the type: its degrees and `"control_points"` in the order of the
 *     class, or, for a concave generalized Bézier patch, its `"sides"` and options.
 *
 * What a file does not say has its default. Keys that are not known are errors, as they may be
 * misspelt.
 *
 * This header needs nlohmann-json. No other one includes it.
 */
namespace IO {

/*!
 * reads a patch in `.patch.json` format.
 *
 * \tparam Traits a CGAL kernel with exact predicates
 * \param in the stream
 * \param name what error messages call the stream
 *
 * \throws Input_error naming the line and column, or the place in the data as a JSON pointer, and
 * what was expected there
 */
template <typename Traits>
Any_patch_model<Traits> read_patch_json(std::istream& in, const std::string& name) {
  // A point is an array of three numbers; with everything else, that stays below as many again.
  constexpr Multisided_patches::internal::Json_limits limits{
      Patch_json_limits::max_file_size,
      5 * (Patch_json_limits::max_control_points + Patch_json_limits::max_sides), 8};
  const auto json = Multisided_patches::internal::parse_json(in, name, limits);
  return internal::Patch_json_reader<Traits>({json, name}).read();
}

//! reads a patch from a `.patch.json` file. \throws Input_error as above, or if the file cannot be
//! read
template <typename Traits>
Any_patch_model<Traits> read_patch_json(const std::string& file_name) {
  auto in = Multisided_patches::internal::open_for_reading(file_name);
  return read_patch_json<Traits>(in, file_name);
}

/*!
 * writes a patch in `.patch.json` format. Numbers have as many digits as it takes to read the same
 * doubles back.
 *
 * \throws Input_error if the patch exceeds `Patch_json_limits`, or an option is out of range
 */
template <typename Traits>
void write_patch_json(std::ostream& out, const Any_patch_model<Traits>& model) {
  internal::Patch_json_writer writer;
  const std::string text = std::visit([&](const auto& m) { return writer.text(m); }, model);
  out << text << '\n';
}

//! writes a patch to a `.patch.json` file, whole or not at all. \throws Error if it cannot be
//! written
template <typename Traits>
void write_patch_json(const std::string& file_name, const Any_patch_model<Traits>& model) {
  Multisided_patches::internal::Atomic_file file(file_name);
  write_patch_json<Traits>(file.stream(), model);
  file.commit();
}

} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_PATCH_JSON_H
