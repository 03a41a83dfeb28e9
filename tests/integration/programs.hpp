// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "host/session/child_process.hpp"
#include "tests/support/eventually.hpp"

namespace echomap::test {

/// console::ExitCode::kUnfinished: of a map that is cut short by `--stops`.
constexpr int kUnfinished = 8;

/// How a program ended and what it said on stdout and stderr.
struct Ended {
  int status = -1;
  std::string said;
};

/// A program of the build tree, started with its output in a file.
class Program {
 public:
  Program(const std::string& name,
          std::vector<std::string> arguments,
          const std::filesystem::path& log);
  /// One that cannot write files of more than `max_file_kb`, as where a disk is full.
  Program(const std::string& name,
          const std::vector<std::string>& arguments,
          const std::filesystem::path& log,
          int max_file_kb);

  void send(int signal) { process_.send(signal); }
  /// Waits for its end; the test fails where it does not come.
  Ended wait(std::chrono::seconds limit = std::chrono::seconds(250));

 private:
  std::filesystem::path log_;
  session::ChildProcess process_;
};

/// A UDP port of this machine that nobody has now.
std::string free_port();

using tests::eventually;

}  // namespace echomap::test
