// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes random loops and domains. Every case must end with a valid mesh, or with an exception of
// the package that says why there is none, in 5 seconds.
//
//   fuzz_loops [--count N] [--seed S] [--first K] [--threads T] [--limit SECONDS] [--verbose]
//
// The cases are a matter of the seed and of their index, so that `--first K --count 1` repeats one.
// They run in child processes: one that crashes or does not end is a finding like others.

#include "loop_cases.h"
#include "loop_report.h"

#include <poll.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using namespace fuzz;

namespace {

double processor_time() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// A worker tells its parent about its cases line by line, each in one piece:
//   S <index> <group>\t<text>           the case starts
//   E <index> <seconds> <triangles> <share of target> <verdict>\t<message>
// with the verdict `mesh`, `refused` (an Error of the package) or `finding`.
void tell(int pipe, std::string line) {
  for (char& c : line)
    if (c == '\n')
      c = ' ';
  line += '\n';
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t written = write(pipe, line.data() + done, line.size() - done);
    if (written <= 0)
      _exit(1);
    done += static_cast<std::size_t>(written);
  }
}

constexpr int out_of_time = 124; // exit status of a worker

void limit_time(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (seconds - std::floor(seconds)));
  setitimer(ITIMER_PROF, &timer, nullptr);
}

// Runs a case; tells how it ended, in the words of the lines above.
std::string result_of(const Case& fuzz_case) {
  try {
    const Outcome outcome = fuzz_case.run();
    std::ostringstream line;
    line << outcome.triangles << ' ' << outcome.share_of_target << " mesh\t";
    return line.str();
  } catch (const Finding& finding) {
    return "0 0 finding\t" + finding.text;
  } catch (const MP::Error& error) {
    return *error.what() == '\0' ? "0 0 finding\tan error without a message"
                                 : std::string("0 0 refused\t") + error.what();
  } catch (const std::exception& error) {
    return std::string("0 0 finding\tforeign exception: ") + error.what();
  } catch (...) {
    return "0 0 finding\tforeign exception that is no std::exception";
  }
}

[[noreturn]] void work(const Options& options, std::uint64_t first, int pipe) {
  std::signal(SIGPROF, [](int) { _exit(out_of_time); });
  for (std::uint64_t k = first; k < options.first + options.count; k += options.threads) {
    const Case fuzz_case = make_case(options.seed, k);
    tell(pipe, "S " + std::to_string(k) + ' ' + fuzz_case.group + '\t' + fuzz_case.text);
    limit_time(options.limit);
    const double start = processor_time();
    const std::string result = result_of(fuzz_case);
    const double seconds = processor_time() - start;
    limit_time(0);
    std::ostringstream line;
    line << "E " << k << ' ' << seconds << ' ' << result;
    tell(pipe, line.str());
  }
  _exit(0);
}

// A child process, and the case it is at.
class Worker {
public:
  Worker(const Options& options, std::uint64_t first, Report& report)
      : options_(options), report_(report) {
    launch(first);
  }
  int pipe() const { return pipe_; }
  bool is_done() const { return pipe_ < 0; }

  // Takes what the child has written; a new one takes over if it has ended before its time.
  void read() {
    char buffer[4096];
    const ssize_t size = ::read(pipe_, buffer, sizeof buffer);
    if (size <= 0) {
      bury();
      return;
    }
    text_.append(buffer, static_cast<std::size_t>(size));
    std::size_t end;
    while ((end = text_.find('\n')) != std::string::npos) {
      understand(text_.substr(0, end));
      text_.erase(0, end + 1);
    }
  }

private:
  void launch(std::uint64_t first) {
    int ends[2];
    std::cout.flush();
    if (::pipe(ends) != 0 || (child_ = fork()) < 0) {
      std::perror("fuzz_loops");
      std::exit(2);
    }
    if (child_ == 0) {
      close(ends[0]);
      work(options_, first, ends[1]);
    }
    close(ends[1]);
    pipe_ = ends[0];
    is_busy_ = false;
  }

  void understand(const std::string& line) {
    std::istringstream in(line);
    char type;
    in >> type >> index_;
    if (type == 'S') {
      std::getline(in >> std::ws, group_, '\t');
      std::getline(in, case_);
      report_.start(group_);
      is_busy_ = true;
      return;
    }
    double seconds = 0, share = 0;
    std::size_t triangles = 0;
    std::string verdict, message;
    in >> seconds >> triangles >> share;
    std::getline(in >> std::ws, verdict, '\t');
    std::getline(in, message);
    report_.end(index_, group_, case_, verdict, message, seconds, triangles, share);
    is_busy_ = false;
  }

  void bury() {
    close(pipe_);
    pipe_ = -1;
    int status = 0;
    waitpid(child_, &status, 0);
    if (!is_busy_)
      return;
    const bool is_late = WIFEXITED(status) && WEXITSTATUS(status) == out_of_time;
    const std::string what = is_late ? "out of time" : "crash, status " + std::to_string(status);
    report_.end(index_, group_, case_, "finding", what, is_late ? options_.limit : 0, 0, 0);
    const std::uint64_t next = index_ + options_.threads;
    if (next < options_.first + options_.count)
      launch(next);
  }

  const Options& options_;
  Report& report_;
  pid_t child_ = 0;
  int pipe_ = -1;
  std::string text_, group_, case_;
  std::uint64_t index_ = 0;
  bool is_busy_ = false;
};

bool run(const Options& options) {
  Report report(options);
  std::vector<Worker> workers;
  for (std::uint64_t k = 0; k < (std::min)(options.threads, options.count); ++k)
    workers.emplace_back(options, options.first + k, report);
  for (;;) {
    std::vector<pollfd> waiting;
    std::vector<Worker*> asked;
    for (Worker& w : workers)
      if (!w.is_done()) {
        waiting.push_back({w.pipe(), POLLIN, 0});
        asked.push_back(&w);
      }
    if (waiting.empty())
      return report.print();
    poll(waiting.data(), waiting.size(), -1);
    for (std::size_t k = 0; k < waiting.size(); ++k)
      if (waiting[k].revents != 0)
        asked[k]->read();
  }
}

[[noreturn]] void refuse(const std::string& what) {
  std::cerr << what
            << "\nusage: fuzz_loops [--count N] [--seed S] [--first K] [--threads T] "
               "[--limit SECONDS] [--verbose]\n";
  std::exit(2);
}

Options parsed(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--verbose") {
      options.verbose = true;
      continue;
    }
    if (i + 1 == argc)
      refuse(name + " needs a value");
    char* end = nullptr;
    const char* value = argv[++i];
    if (name == "--limit") {
      options.limit = std::strtod(value, &end);
    } else {
      std::uint64_t* const number = name == "--count"     ? &options.count
                                    : name == "--seed"    ? &options.seed
                                    : name == "--first"   ? &options.first
                                    : name == "--threads" ? &options.threads
                                                          : nullptr;
      if (number == nullptr)
        refuse("unknown option " + name);
      *number = std::strtoull(value, &end, 10);
    }
    if (end == value || *end != '\0')
      refuse(name + " needs a number, not " + value);
  }
  if (options.count < 1 || options.threads < 1 || !(options.limit > 0))
    refuse("--count, --threads and --limit must be positive");
  return options;
}

} // namespace

int main(int argc, char** argv) {
  const Options options = parsed(argc, argv);
  std::cout << "seed " << options.seed << std::endl;
  return run(options) ? 0 : 1;
}
