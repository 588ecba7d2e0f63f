// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_OPTION_CHECKS_H
#define MULTIPATCH_OPTION_CHECKS_H

#include <CGAL/Multisided_patches/errors.h>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace multipatch {

// Checks of the arguments of options, which hold or fail whatever the files contain.

// Both limits are allowed.
CLI::Validator whole_number(std::size_t min, std::size_t max);
CLI::Validator number_between(double min, double max);
CLI::Validator number_of_at_least(double min);
// Finite ones, and not more than the limit.
CLI::Validator positive_number();
CLI::Validator positive_number_up_to(double max);
// The limit is not allowed.
CLI::Validator positive_number_below(double limit);

// Whatever a function takes without throwing Input_error; its message is that of the option.
template <typename Function>
CLI::Validator accepted_by(const Function& function) {
  return CLI::Validator(
      [function](std::string& argument) -> std::string {
        try {
          function(argument);
        } catch (const CGAL::Multisided_patches::Input_error& error) {
          return error.what();
        }
        return "";
      },
      "");
}

// The name of a file with one of these extensions, in small letters or capitals.
CLI::Validator name_ending_in(const std::vector<std::string>& extensions);
// The name of a file of a patch, or of a patch or a mesh; that it is no directory is seen when it
// is read.
CLI::Validator patch_name();
CLI::Validator checkable_name();

// What to say of arguments that a command, or the program, does not know: which is the first of
// them, and what may be meant by it.
std::string unexpected_arguments(const CLI::App& app);

// Throws CLI::ValidationError if another option than the named ones is given.
void refuse_other_options(const CLI::App& command, const std::vector<std::string>& names,
                          const std::string& reason);

} // namespace multipatch

#endif // MULTIPATCH_OPTION_CHECKS_H
