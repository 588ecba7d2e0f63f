// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_file.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/IO/GBP.h>
#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/IO/patch_json.h>
#include <CGAL/Multisided_patches/patches/with_resolved_central_weight.h>
#include <CGAL/Multisided_patches/ribbons/internal/net_quads.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>
#include <variant>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

std::optional<Model_format> format_of(const std::string& file_name) {
  const std::string json = ".patch.json";
  if (file_name.size() > json.size() &&
      std::equal(json.rbegin(), json.rend(), file_name.rbegin(),
                 [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); }))
    return Model_format::json;
  const std::string extension = MP::internal::file_extension(file_name);
  if (extension == ".cgb")
    return Model_format::cgb;
  if (extension == ".gbp")
    return Model_format::gbp;
  return std::nullopt;
}

const char* extension(Model_format format) {
  switch (format) {
  case Model_format::cgb:
    return ".cgb";
  case Model_format::gbp:
    return ".gbp";
  case Model_format::json:
    return ".patch.json";
  }
  return "";
}

// Whether .cgb files have it. The automatic choice is similarity and what follows it.
bool has_generator(MP::Domain_generator generator) {
  const auto& types = MP::IO::internal::domain_types;
  return generator == MP::Domain_generator::automatic ||
         std::find(types.begin(), types.end(), generator) != types.end();
}

std::vector<std::string> cgb_losses(const Concave_model& model) {
  std::vector<std::string> lost;
  if (!model.domain_vertices.empty())
    lost.emplace_back("the vertices of the domain");
  else if (!has_generator(model.domain.generator))
    lost.push_back("the domain generator " + std::string(to_string(model.domain.generator)));
  if (model.coordinates != Coordinates_choice::harmonic)
    lost.push_back(std::string(to_string(model.coordinates)) + " coordinates");
  if (model.reflex_weight != 1)
    lost.emplace_back("the reflex weight");
  return lost;
}

std::vector<std::string> gbp_losses(const Generalized_model& model) {
  std::vector<std::string> lost;
  if (!model.domain_vertices.empty())
    lost.emplace_back("the vertices of the domain");
  else if (model.domain.generator != MP::Domain_generator::regular)
    lost.push_back("the domain generator " + std::string(to_string(model.domain.generator)));
  if (model.coordinates != Coordinates_choice::wachspress)
    lost.push_back(std::string(to_string(model.coordinates)) + " coordinates");
  return lost;
}

Any_model read_any(const std::string& file_name) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file_name, ignored))
    throw MP::Input_error(file_name + ": expected a file, found a directory");
  switch (model_format(file_name)) {
  case Model_format::gbp:
    return Generalized_model(MP::IO::read_GBP<Kernel>(file_name));
  case Model_format::json:
    return MP::IO::read_patch_json<Kernel>(file_name);
  case Model_format::cgb:
    break;
  }
  return Concave_model(MP::IO::read_CGB<Kernel>(file_name));
}

// A .cgb file has no automatic central weight: it gets the one that the patch in the file would
// have, with what the format holds of the options.
MP::Concave_bezier_model_3<Kernel> resolved(const std::string& file_name,
                                            MP::Concave_bezier_model_3<Kernel> model) {
  model.reflex_weight = 1;
  if (!has_generator(model.domain.generator))
    model.domain.generator = MP::Domain_generator::similarity;
  try {
    return MP::with_resolved_central_weight(std::move(model));
  } catch (const MP::Error& error) {
    throw MP::Error(file_name + ": what the automatic central weight stands for cannot be found (" +
                    error.what() + "); a .patch.json file can hold it");
  }
}

// The patch on the ribbons of the net that is most like that of the net.
Concave_model with_ribbons_of(const Generalized_model& model) {
  Concave_model result{MP::Concave_bezier_model_3<Kernel>(model.net.loop())};
  // A central point without influence on the patch must not get any.
  const bool matters = MP::internal::Middle_weights<double>(model.net.size(), model.net.degree())
                           .central_point_matters();
  result.central_weight =
      matters ? MP::Central_weight::weight_deficiency : MP::Central_weight::none;
  result.central_point = model.net.central_point();
  return result;
}

} // namespace

Model_format model_format(const std::string& file_name) {
  const auto format = format_of(file_name);
  if (!format)
    throw MP::Input_error(file_name + ": expected a name that ends in .cgb, .gbp or .patch.json");
  return *format;
}

bool is_patch_file(const std::string& file_name) {
  return format_of(file_name).has_value();
}

Any_model read_model_file(const std::string& file_name) {
  Any_model model = read_any(file_name);
  try {
    loop(model); // some nets have none
  } catch (const MP::Input_error& error) {
    throw MP::Input_error(file_name + ": " + error.what());
  }
  return model;
}

std::vector<std::string> losses(const Any_model& model, Model_format format) {
  if (format == Model_format::cgb && std::holds_alternative<Concave_model>(model))
    return cgb_losses(std::get<Concave_model>(model));
  if (format == Model_format::gbp && std::holds_alternative<Generalized_model>(model))
    return gbp_losses(std::get<Generalized_model>(model));
  return {};
}

Any_model fitted(const Any_model& model, const std::string& file_name) {
  const Model_format format = model_format(file_name);
  const auto* generalized = std::get_if<Generalized_model>(&model);
  const bool fits = format == Model_format::json ||
                    (format == Model_format::gbp && generalized != nullptr) ||
                    (format == Model_format::cgb && std::holds_alternative<Concave_model>(model));
  if (fits)
    return model;
  if (format == Model_format::cgb && generalized != nullptr)
    return with_ribbons_of(*generalized);
  throw MP::Input_error(file_name + ": a " + extension(format) + " file cannot hold this " +
                        type_name(model) + "; a .patch.json file can");
}

void write_model_file(const std::string& file_name, const Any_model& model) {
  switch (model_format(file_name)) {
  case Model_format::cgb:
    return MP::IO::write_CGB<Kernel>(file_name,
                                     resolved(file_name, std::get<Concave_model>(model)));
  case Model_format::gbp:
    return MP::IO::write_GBP<Kernel>(file_name, std::get<Generalized_model>(model).net);
  case Model_format::json:
    return MP::IO::write_patch_json<Kernel>(file_name, model);
  }
}

} // namespace multipatch
