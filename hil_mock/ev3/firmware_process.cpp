// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/firmware_process.hpp"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>

namespace echomap::ev3 {
namespace {

/// As a shell says that there is no such program.
constexpr int kNoProgram = 127;
constexpr int kSignalBase = 128;
constexpr std::size_t kReadBytes = 4096;

struct Pipe {
  runner::Descriptor out;
  runner::Descriptor in;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  runner::check_call(::pipe2(ends.data(), O_CLOEXEC), "pipe");
  return {runner::Descriptor(ends[0], "pipe"), runner::Descriptor(ends[1], "pipe")};
}

[[noreturn]] void become(std::vector<char*>& arguments, int input, int output) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::dup2(input, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::execvp(arguments.front(), arguments.data());
  ::_exit(kNoProgram);
}

}  // namespace

FirmwareProcess::FirmwareProcess(const std::vector<std::string>& command) {
  Pipe to_program = make_pipe();
  Pipe from_program = make_pipe();
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  pid_ = ::fork();
  runner::check_call(pid_, "fork");
  if (pid_ == 0) {
    become(arguments, to_program.out.number(), from_program.in.number());
  }
  // Both sides say it: whoever comes first.
  ::setpgid(pid_, pid_);
  input_ = std::move(to_program.in);
  output_ = std::move(from_program.out);
  runner::set_non_blocking(input_.number());
  runner::set_non_blocking(output_.number());
}

FirmwareProcess::~FirmwareProcess() {
  ::kill(-pid_, SIGKILL);
  if (!status_) {
    ::waitpid(pid_, nullptr, 0);
  }
}

void FirmwareProcess::write(std::span<const std::uint8_t> bytes) {
  // A pipe whose reader has died would end this program, too.
  static const auto ignored = std::signal(SIGPIPE, SIG_IGN);
  static_cast<void>(ignored);
  static_cast<void>(!::write(input_.number(), bytes.data(), bytes.size()));
}

void FirmwareProcess::read(std::vector<std::uint8_t>& into) {
  std::array<std::uint8_t, kReadBytes> bytes{};
  for (;;) {
    const auto count = ::read(output_.number(), bytes.data(), bytes.size());
    if (count <= 0) {
      return;
    }
    into.insert(into.end(), bytes.begin(), bytes.begin() + count);
  }
}

std::optional<int> FirmwareProcess::exit_status() {
  int status = 0;
  if (!status_ && ::waitpid(pid_, &status, WNOHANG) == pid_) {
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : kSignalBase + WTERMSIG(status);
  }
  return status_;
}

}  // namespace echomap::ev3
