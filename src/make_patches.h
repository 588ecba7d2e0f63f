// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MAKE_PATCHES_H
#define MULTIPATCH_MAKE_PATCHES_H

#include "commands.h"

#include <CGAL/Multisided_patches/coordinates/Harmonic_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace multipatch {

template <typename Coordinates>
using Patch = CGAL::Multisided_patches::Concave_bezier_patch_3<Kernel, Coordinates>;

// A type as an argument.
template <typename T>
struct Type {
  using type = T;
};

// Returns f(Type<Coordinates>()) for the coordinates that the user has chosen.
template <typename Function>
auto with_coordinates(Coordinates_choice choice, const Function& f) {
  namespace MP = CGAL::Multisided_patches;
  switch (choice) {
  case Coordinates_choice::mean_value:
    return f(Type<MP::Mean_value_coordinates_2<Kernel>>());
  case Coordinates_choice::wachspress:
    return f(Type<MP::Wachspress_coordinates_2<Kernel>>());
  default:
    return f(Type<MP::Harmonic_coordinates_2<Kernel>>());
  }
}

// Only harmonic coordinates have one.
inline std::optional<double>
error_bound(const CGAL::Multisided_patches::Harmonic_coordinates_2<Kernel>& coordinates) {
  return coordinates.error_bound();
}
template <typename Coordinates>
std::optional<double> error_bound(const Coordinates&) {
  return std::nullopt;
}

// Makes the patches, in parallel. Errors begin with the name of the input; of several, that of the
// first input is thrown.
template <typename Coordinates>
std::vector<Patch<Coordinates>> make_patches(const std::vector<Model>& models,
                                             const std::vector<std::string>& inputs) {
  namespace MP = CGAL::Multisided_patches;
  std::vector<std::optional<Patch<Coordinates>>> made(models.size());
  std::vector<std::exception_ptr> errors(models.size());
  MP::internal::for_each_index<CGAL::Parallel_if_available_tag>(
      models.size(),
      [&](std::size_t k) {
        try {
          made[k].emplace(models[k]);
        } catch (const MP::Error& error) {
          errors[k] = std::make_exception_ptr(MP::Error(inputs[k] + ": " + error.what()));
        } catch (...) {
          errors[k] = std::current_exception();
        }
      },
      1);
  std::vector<Patch<Coordinates>> patches;
  for (std::size_t k = 0; k < made.size(); ++k) {
    if (errors[k])
      std::rethrow_exception(errors[k]);
    patches.push_back(std::move(*made[k]));
  }
  return patches;
}

} // namespace multipatch

#endif // MULTIPATCH_MAKE_PATCHES_H
