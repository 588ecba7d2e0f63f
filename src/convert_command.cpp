// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_file.h"
#include "model_output.h"

#include <cstdio>
#include <string>
#include <vector>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

void convert_command(const Convert_options& options) {
  check_model_output(options.output, {options.input});
  const Any_model model = read_model_file(options.input);
  const Any_model result = fitted(model, options.output);
  const std::string lost = joined(losses(result, model_format(options.output)));
  if (!lost.empty() && !options.lossy)
    throw MP::Input_error(options.output + ": a file with this name cannot hold " + lost +
                          "; --lossy leaves that out, a .patch.json file holds it");
  write_model_file(options.output, result);
  if (options.quiet)
    return;
  std::printf("%s: %s, %zu sides\n", options.output.c_str(), type_name(result).c_str(),
              number_of_sides(result));
  if (result.index() != model.index())
    std::printf("  the ribbons are those of the %s; the surface between them differs\n",
                type_name(model).c_str());
  if (!lost.empty())
    std::printf("  left out: %s\n", lost.c_str());
}

} // namespace multipatch
