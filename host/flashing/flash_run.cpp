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
#include "host/flashing/boot_drive.hpp"

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

void print_command(const console::CommandWords& command) {
  fmt::print("{}\n", console::shell_line(command));
  std::fflush(stdout);
}

/// Throws what a step of a brick says by its exit code.
[[noreturn]] void refuse_step(const BrickPlan& plan, const FlashStep& step, int status) {
  constexpr int kSshItself = 255;
  if (status == step.refusal) {
    throw console::CommandError(console::ExitCode::kNoRobot, step.refused);
  }
  if (status == kSshItself) {
    throw console::CommandError(
        console::ExitCode::kNoRobot,
        fmt::format("{0} cannot reach {1} (above), to {2}\n  next: is the brick on, with ev3dev, "
                    "and connected? try: ssh {1}; name it with --host USER@ADDRESS",
                    step.command.front(),
                    plan.host,
                    step.what));
  }
  throw console::CommandError(
      console::ExitCode::kRuntimeError,
      fmt::format("{} could not {} on {} (exit code {})\n  next: see what it says above; {}",
                  step.command.front(),
                  step.what,
                  plan.host,
                  status,
                  step.advice));
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
    print_command(command);
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

console::ExitCode carry_out(const BrickPlan& plan, bool dry_run) {
  for (const FlashStep& step : plan.steps) {
    print_command(step.command);
    if (dry_run) {
      continue;
    }
    const int status = run_in_terminal(step.command, "openssh-client");
    if (console::interrupted() || status == 128 + SIGINT) {
      return console::ExitCode::kInterrupted;
    }
    if (status != 0) {
      refuse_step(plan, step, status);
    }
  }
  if (!dry_run) {
    console::print("flashed " + plan.host + "\n  next: echomap explore --robot ev3 --port " +
                   plan.address);
  }
  return console::ExitCode::kOk;
}

console::CommandWords uf2_command(const std::filesystem::path& image,
                                  const std::filesystem::path& uf2) {
  return {"echomap", "flash", "--board", "pico", "--image", image.string(), "--uf2", uf2.string()};
}

console::ExitCode carry_out(const DrivePlan& plan, bool dry_run) {
  auto file = plan.image;
  file.replace_extension(".uf2");
  if (file != plan.image) {
    print_command(uf2_command(plan.image, file));
  }
  print_command({"cp", file.string(), plan.drive.string()});
  if (!dry_run) {
    copy_to_boot_drive(plan.uf2, plan.drive, file.filename().string(), ::fsync);
    console::print("flashed the Pico at " + plan.drive.string() +
                   ": it starts its program and shows a serial port\n  next: echomap explore "
                   "--robot pico_2wd --port /dev/ttyACM0");
  }
  return console::ExitCode::kOk;
}

}  // namespace echomap::flashing
