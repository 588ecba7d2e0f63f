// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_patches.h"

#include "patch_coordinates.h"

#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/Generalized_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/S_patch_3.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <exception>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

// The patch of each type of model.
struct Make_patch {
  Any_patch operator()(const Concave_model& model) const {
    return on_coordinates<MP::Concave_bezier_patch_3<Kernel, Patch_coordinates>>(model, model);
  }
  Any_patch operator()(const Generalized_model& model) const {
    return on_coordinates<MP::Generalized_bezier_patch_3<Kernel, Patch_coordinates>>(model,
                                                                                     model.net);
  }
  Any_patch operator()(const S_patch_model& model) const {
    return on_coordinates<MP::S_patch_3<Kernel, Patch_coordinates>>(model, model.net);
  }
  Any_patch operator()(const Tensor_product& patch) const { return as_it_is(patch); }
  Any_patch operator()(const Triangle& patch) const { return as_it_is(patch); }

private:
  // `data` is what the constructor of the patch takes besides coordinates.
  template <typename Patch, typename Description, typename Data>
  static Any_patch on_coordinates(const Description& model, const Data& data) {
    auto [domain, report] = make_domain(Any_model(model));
    const Patch_coordinates coordinates(model.coordinates, domain);
    const Patch patch(data, coordinates);
    Patch_origin origin{std::move(report), model.coordinates, coordinates.error_bound(),
                        std::nullopt};
    if constexpr (std::is_same_v<Description, Concave_model>)
      origin.central_weight = patch.basis().central_weight();
    return {patch, std::move(origin)};
  }
  template <typename Patch>
  static Any_patch as_it_is(const Patch& patch) {
    return {patch,
            {make_domain(Any_model(patch)).report, std::nullopt, std::nullopt, std::nullopt}};
  }
};

} // namespace

Any_patch make_patch(const Any_model& model) {
  return std::visit(Make_patch(), model);
}

std::vector<Any_patch> make_patches(const std::vector<Any_model>& models,
                                    const std::vector<std::string>& inputs) {
  std::vector<std::optional<Any_patch>> made(models.size());
  std::vector<std::exception_ptr> errors(models.size());
  MP::internal::for_each_index<CGAL::Parallel_if_available_tag>(
      models.size(),
      [&](std::size_t k) {
        try {
          made[k].emplace(make_patch(models[k]));
        } catch (const MP::Error& error) {
          errors[k] = std::make_exception_ptr(MP::Error(inputs[k] + ": " + error.what()));
        } catch (...) {
          errors[k] = std::current_exception();
        }
      },
      1);
  std::vector<Any_patch> patches;
  for (std::size_t k = 0; k < made.size(); ++k) {
    if (errors[k])
      std::rethrow_exception(errors[k]);
    patches.push_back(std::move(*made[k]));
  }
  return patches;
}

} // namespace multipatch
