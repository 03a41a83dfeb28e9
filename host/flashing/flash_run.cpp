// SPDX-License-Identifier: MIT
#include "host/flashing/flash_run.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <spawn.h>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>
#include <sys/wait.h>

#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"

namespace echomap::flashing {
namespace {

/// Runs a program of PATH in this terminal, its stdout on our stderr: ours is for data. The exit
/// status, or 128 + the signal that ended it.
int run_in_terminal(const console::CommandWords& command, const std::string& package) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t pid = -1;
  const int error =
      ::posix_spawnp(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw console::CommandError(console::ExitCode::kRuntimeError,
                                fmt::format("cannot start {}: {}\n  next: apt-get install {}",
                                            command.front(),
                                            std::generic_category().message(error),
                                            package));
  }
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/// What the second try has shown of the board.
constexpr auto kOldBootLoader =
    "this board has the old boot loader, which does not switch the watchdog off: after a hang the\n"
    "firmware starts again by itself, but one that locks interrupts stops the board until its\n"
    "supply is cut\n"
    "  next: nothing, or write the new boot loader with a programmer: docs/guides/flashing.md";

}  // namespace

console::ExitCode carry_out(const FlashPlan& plan, bool dry_run) {
  int status = 0;
  for (const console::CommandWords& command : plan.tries) {
    if (&command != &plan.tries.front()) {
      console::print(dry_run ? "if that fails:"
                             : "that failed; once more, as an old boot loader wants it:");
    }
    fmt::print("{}\n", console::shell_line(command));
    std::fflush(stdout);
    if (dry_run) {
      continue;
    }
    status = run_in_terminal(command, plan.package);
    if (console::interrupted() || status == 128 + SIGINT) {
      return console::ExitCode::kInterrupted;
    }
    if (status == 0) {
      console::print("flashed " + plan.place);
      if (&command != &plan.tries.front()) {
        console::print(kOldBootLoader);
      }
      return console::ExitCode::kOk;
    }
  }
  if (dry_run) {
    return console::ExitCode::kOk;
  }
  throw console::CommandError(console::ExitCode::kRuntimeError,
                              fmt::format("{} could not flash {} (exit code {})\n  next: {}",
                                          plan.tries.front().front(),
                                          plan.place,
                                          status,
                                          plan.advice));
}

}  // namespace echomap::flashing
