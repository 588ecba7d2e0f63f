// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch_arguments.h"

#include "option_checks.h"

#include <cstddef>

namespace multipatch {

void add_batch_options(CLI::App& command, Batch_options& options, CLI::Option& output) {
  constexpr std::size_t max_threads = 1024;
  constexpr double min_timeout = 2, max_timeout = 1e6; // ranks give signs of life more often
  auto* directory =
      command
          .add_option("--output-directory", options.directory,
                      "make a mesh of each input, in this directory, which is made if need be;\n"
                      "an INPUT may then be a directory, too: all patches directly in it")
          ->type_name("DIR")
          ->excludes(&output);
  const auto add = [&](CLI::Option* option) { return option->needs(directory); };
  add(command.add_option("--format", options.format,
                         "that of meshes in a directory: ply (default), obj, off, stl"))
      ->transform(CLI::IsMember({"ply", "obj", "off", "stl"}, CLI::ignore_case).description(""))
      ->type_name("NAME");
  add(command.add_option("--list", options.list,
                         "a file with more inputs, one a line, or - for standard input; blank\n"
                         "lines and those that start with # do not count"))
      ->type_name("FILE");
  auto* threads =
      add(command.add_option("--threads", options.threads,
                             "how many files are meshed at a time (default: one on each\n"
                             "processor)"))
          ->check(whole_number(1, max_threads))
          ->type_name("N");
  add(command.add_flag("--keep-going", options.keep_going,
                       "after a file that fails, go on with the others"));
  add(command.add_flag(
      "--resume", options.resume,
      "pass over inputs whose mesh an earlier run has made with the same options"));
  auto* mpi = add(command.add_flag("--mpi", options.mpi,
                                   "share the work with the other processes that mpirun started"));
  mpi->excludes(threads);
  command
      .add_option("--rank-timeout", options.rank_timeout,
                  "seconds without a sign of life until such a process counts as lost\n"
                  "(default: 60)")
      ->check(number_between(min_timeout, max_timeout))
      ->type_name("X")
      ->needs(mpi);
}

void require_mesh_arguments(const Mesh_options& options) {
  if (options.inputs.empty() && options.batch.list.empty())
    throw CLI::RequiredError("INPUT");
  if (options.output.empty() && options.batch.directory.empty())
    throw CLI::RequiredError("--output or --output-directory");
  // One whose name is wrong is, in a directory, a file that fails like others.
  if (options.batch.directory.empty())
    for (std::string input : options.inputs) {
      const std::string wrong = patch_name()(input);
      if (!wrong.empty())
        throw CLI::ValidationError("INPUT", wrong);
    }
}

} // namespace multipatch
