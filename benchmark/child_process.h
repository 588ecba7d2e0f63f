// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_BENCHMARK_CHILD_PROCESS_H
#define MULTISIDED_PATCHES_BENCHMARK_CHILD_PROCESS_H

#include <csignal>
#include <cstddef>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bench {

namespace internal {

inline void write_all(int file, const void* data, std::size_t size) {
  const char* begin = static_cast<const char*>(data);
  for (ssize_t n = 0; size > 0 && (n = write(file, begin, size)) > 0; size -= std::size_t(n))
    begin += n;
}

inline std::string read_all(int file) {
  std::string text;
  char buffer[4096];
  for (ssize_t n = 0; (n = read(file, buffer, sizeof buffer)) > 0;)
    text.append(buffer, std::size_t(n));
  return text;
}

// How a process ended, if not by itself.
inline std::string cause_of_death(int status, unsigned seconds) {
  if (!WIFSIGNALED(status))
    return "ended early, with exit code " + std::to_string(WEXITSTATUS(status));
  if (WTERMSIG(status) == SIGALRM)
    return "took longer than " + std::to_string(seconds) + " s";
  return std::string("crashed: ") + strsignal(WTERMSIG(status));
}

} // namespace internal

/*!
 * calls a function in a process of its own, so that it may crash or never end; what it prints is
 * lost.
 *
 * \tparam Function returns a trivially copyable object
 * \param function what to call; this process should have no other threads
 * \param seconds the time limit
 *
 * \throws std::runtime_error with the function's exception, or what became of the process
 */
template <typename Function>
auto run_in_child(const Function& function, unsigned seconds) {
  using Result = std::invoke_result_t<Function>;
  static_assert(std::is_trivially_copyable_v<Result>);
  int pipe_ends[2];
  if (pipe(pipe_ends) != 0)
    throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("no process");
  if (child == 0) {
    close(pipe_ends[0]);
    alarm(seconds); // ends this process
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    // The first byte tells results from messages.
    try {
      const Result result = function();
      internal::write_all(pipe_ends[1], "r", 1);
      internal::write_all(pipe_ends[1], &result, sizeof result);
    } catch (const std::exception& error) {
      internal::write_all(pipe_ends[1], "m", 1);
      internal::write_all(pipe_ends[1], error.what(), std::strlen(error.what()));
    }
    _exit(0);
  }
  close(pipe_ends[1]);
  const std::string answer = internal::read_all(pipe_ends[0]);
  close(pipe_ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  Result result;
  if (answer.size() == 1 + sizeof result && answer[0] == 'r') {
    std::memcpy(&result, answer.data() + 1, sizeof result);
    return result;
  }
  if (!answer.empty() && answer[0] == 'm')
    throw std::runtime_error(answer.substr(1));
  throw std::runtime_error(internal::cause_of_death(status, seconds));
}

} // namespace bench

#endif // MULTISIDED_PATCHES_BENCHMARK_CHILD_PROCESS_H
