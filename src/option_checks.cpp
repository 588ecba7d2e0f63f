// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "option_checks.h"

#include "mesh_file.h"
#include "model_file.h"

#include <CGAL/Multisided_patches/IO/internal/similar_word.h>
#include <CGAL/Multisided_patches/internal/to_text.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <vector>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

template <typename Predicate>
CLI::Validator number_that(const std::string& expected, const Predicate& is_good) {
  return CLI::Validator(
      [=](std::string& argument) -> std::string {
        double x = 0;
        const bool is_number = CLI::detail::lexical_cast(argument, x);
        return is_number && is_good(x) ? "" : "expected " + expected + ", not " + argument;
      },
      "");
}

// "--triangle=10" without its dashes and value.
std::string bare_name(const std::string& option) {
  const std::size_t begin = option.find_first_not_of('-');
  return begin == std::string::npos ? "" : option.substr(begin, option.find('=') - begin);
}

std::string suggestion(const std::string& misspelt, const std::vector<std::string>& names,
                       const std::string& dashes) {
  std::string similar = MP::internal::similar_word(misspelt, names);
  // In a short word, two letters that are swapped are much.
  const auto swapped = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
    return std::is_permutation(name.begin(), name.end(), misspelt.begin(), misspelt.end());
  });
  if (similar.empty() && swapped != names.end())
    similar = *swapped;
  return similar.empty() ? "" : "; did you mean " + dashes + similar + '?';
}

bool is_directory(const std::string& name) {
  std::error_code ignored;
  return std::filesystem::is_directory(name, ignored);
}

bool is_option(const std::string& argument) {
  return argument.size() > 1 && argument.front() == '-';
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({}))
    names.push_back(command->get_name());
  return names;
}

} // namespace

CLI::Validator whole_number(std::size_t min, std::size_t max) {
  return CLI::Validator(
      [=](std::string& argument) -> std::string {
        std::size_t n = 0;
        const char* end = argument.data() + argument.size();
        const auto [rest, error] = std::from_chars(argument.data(), end, n);
        if (error == std::errc() && rest == end && min <= n && n <= max) {
          argument = std::to_string(n); // else a leading zero would make it an octal number
          return "";
        }
        return "expected a whole number from " + std::to_string(min) + " to " +
               std::to_string(max) + ", not " + argument;
      },
      "");
}

CLI::Validator number_between(double min, double max) {
  return number_that("a number from " + MP::internal::to_short_text(min) + " to " +
                         MP::internal::to_short_text(max),
                     [=](double x) { return min <= x && x <= max; });
}

CLI::Validator number_of_at_least(double min) {
  return number_that("a number of at least " + MP::internal::to_short_text(min),
                     [=](double x) { return min <= x; });
}

CLI::Validator positive_number() {
  return number_that("a positive number", [](double x) { return x > 0 && std::isfinite(x); });
}

CLI::Validator positive_number_up_to(double max) {
  return number_that("a positive number, at most " + MP::internal::to_short_text(max),
                     [=](double x) { return x > 0 && x <= max; });
}

CLI::Validator positive_number_below(double limit) {
  return number_that("a positive number below " + MP::internal::to_short_text(limit),
                     [=](double x) { return x > 0 && x < limit; });
}

CLI::Validator name_ending_in(const std::vector<std::string>& extensions) {
  return accepted_by([=](const std::string& name) {
    std::string lower = name, list;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const std::string& extension : extensions) {
      if (lower.size() > extension.size() &&
          lower.compare(lower.size() - extension.size(), extension.size(), extension) == 0)
        return;
      list += (list.empty() ? "" : " or ") + extension;
    }
    throw MP::Input_error(name + ": expected a name that ends in " + list);
  });
}

CLI::Validator patch_name() {
  return accepted_by([](const std::string& name) {
    if (!is_directory(name))
      model_format(name);
  });
}

CLI::Validator checkable_name() {
  return accepted_by([](const std::string& name) {
    if (!is_patch_file(name) && !is_mesh_file(name) && !is_directory(name))
      throw MP::Input_error(name + ": expected a name that ends in .cgb, .gbp or .patch.json, or, "
                                   "of a mesh, in .ply, .obj, .off or .stl");
  });
}

std::string unexpected_arguments(const CLI::App& app) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  const std::vector<std::string> unknown = app.remaining(true);
  if (unknown.empty())
    return "there are arguments that were not expected";
  const CLI::App& command = given.empty() ? app : *given.front();
  const auto option = std::find_if(unknown.begin(), unknown.end(), is_option);
  if (given.empty() && (option == unknown.end() || option != unknown.begin()))
    return "there is no command " + unknown.front() +
           suggestion(unknown.front(), command_names(app), "");
  const std::string of_command = given.empty() ? "" : "the command " + command.get_name() + " has ";
  if (option != unknown.end()) {
    const std::string name = option->substr(0, option->find('='));
    return (given.empty() ? "there is no option " : of_command + "no option ") + name +
           suggestion(bare_name(name), option_names(command), "--");
  }
  return of_command + "no place for the argument " + unknown.front();
}

void refuse_other_options(const CLI::App& command, const std::vector<std::string>& names,
                          const std::string& reason) {
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0 &&
        std::find(names.begin(), names.end(), option->get_name()) == names.end())
      throw CLI::ValidationError(option->get_name(), reason);
}

} // namespace multipatch
