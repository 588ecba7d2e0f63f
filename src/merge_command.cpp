// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_file.h"
#include "model_output.h"

#include <CGAL/Multisided_patches/ribbons/merge_loops.h>

#include <cstddef>
#include <cstdio>
#include <string>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

using Merged = MP::Merged_loop_3<Kernel>;

std::string source_text(const Merge_options& options, const Merged::Source& source) {
  const std::string& input = source.loop == 0 ? options.input_a : options.input_b;
  std::string text = input + " side " + std::to_string(source.side);
  if (source.begin != 0 || source.end != 1) {
    char part[80];
    std::snprintf(part, sizeof part, " from s = %g to %g", source.begin, source.end);
    text += part;
  }
  return text;
}

void print_summary(const Merge_options& options, const Merged& merged) {
  const Loop& loop = merged.loop;
  std::printf("%s: %zu sides; corners: %zu convex, %zu reflex, %zu straight\n",
              options.output.c_str(), loop.size(), loop.number_of_corners(MP::Corner_type::convex),
              loop.number_of_corners(MP::Corner_type::reflex),
              loop.number_of_corners(MP::Corner_type::straight));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    std::printf("  side %zu: ", i);
    const char* separator = "";
    for (const Merged::Source& source : merged.sources[i]) {
      std::printf("%s%s", separator, source_text(options, source).c_str());
      separator = " and ";
    }
    std::printf("\n");
  }
}

} // namespace

void merge_command(const Merge_options& options) {
  check_model_output(options.output, {options.input_a, options.input_b});
  if (model_format(options.output) == Model_format::gbp)
    throw MP::Input_error(options.output + ": expected a name that ends in .cgb or .patch.json");
  const Loop a = loop(read_model_file(options.input_a));
  const Loop b = loop(read_model_file(options.input_b));
  const Merged merged = MP::merge_loops(a, b);
  write_model_file(options.output, Concave_model(MP::Concave_bezier_model_3<Kernel>(merged.loop)));
  if (!options.quiet)
    print_summary(options, merged);
}

} // namespace multipatch
