// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "add_commands.h"
#include "commands.h"
#include "option_checks.h"

#include <CLI/CLI.hpp>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <string>

// What the program returns to the shell; to the last one, the number of the signal is added.
enum Exit_code { success = 0, failure = 1, wrong_usage = 2, signalled = 128 };

namespace {

using namespace multipatch;

int report_error(const std::string& message) {
  std::cerr << "multipatch: " << message << '\n';
  return failure;
}

int report_wrong_usage(const std::string& message) {
  report_error(message);
  std::cerr << "Run with --help for more information.\n";
  return wrong_usage;
}

int run(CLI::App& app, int argc, char* argv[]) {
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty())
      throw CLI::RequiredError("a command");
    return success;
  } catch (const CLI::ExtrasError&) {
    return report_wrong_usage(unexpected_arguments(app));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) // --help and --version are exceptions, too
      return app.exit(error);
    return report_wrong_usage(error.what());
  } catch (const Usage_error& error) {
    return report_wrong_usage(error.what());
  } catch (const Interrupted& interrupted) {
    return signalled + interrupted.signal;
  } catch (const std::bad_alloc&) {
    return report_error("not enough memory");
  } catch (const std::exception& error) {
    return report_error(error.what());
  }
}

// The same status, unless what was printed has not all reached standard output. Who has closed the
// pipe there has seen enough, and is not told.
int after_printing(int status) {
  // If the flush has nothing to do, errno is still that of the print that failed.
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
    return status;
  const int reason = errno;
  if (reason == EPIPE)
    return status == success ? signalled + SIGPIPE : status;
  return report_error("standard output: cannot be written" +
                      (reason == 0 ? "" : std::string(": ") + std::strerror(reason)));
}

} // namespace

int main(int argc, char* argv[]) {
  CLI::App app(
      "Smooth surfaces that fill loops of Bezier ribbons with any number of sides, some of "
      "whose\ncorners may turn inwards.\n");
  app.name("multipatch");
  app.footer("Example:  multipatch mesh bracket.cgb -o bracket.ply --triangles 20000\n"
             "Help on a command:  multipatch mesh --help");
  app.set_version_flag("--version", "multipatch " MULTIPATCH_VERSION);
  // With a minimum of 1, a misspelt command would not be named in the message.
  app.require_subcommand(0, 1);

#ifdef SIGXFSZ
  // Writing beyond the limit of file sizes shall fail, not end the program.
  std::signal(SIGXFSZ, SIG_IGN);
#endif
  Command_options options;
  add_commands(app, options);
  return after_printing(run(app, argc, argv));
}
