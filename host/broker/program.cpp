// SPDX-License-Identifier: MIT
#include "host/broker/program.hpp"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <unistd.h>

#include <fmt/format.h>

#include "host/console/exit_code.hpp"
#include "host/session/child_process.hpp"

namespace echomap::broker {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kProgramPatience{30};

}  // namespace

fs::path find_program(const SystemProgram& program, const std::string& path) {
  std::istringstream folders(path + ":/usr/sbin:/usr/local/sbin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    fs::path file = fs::path(folder) / program.name;
    if (!folder.empty() && ::access(file.c_str(), X_OK) == 0 && fs::is_regular_file(file)) {
      return file;
    }
  }
  throw console::CommandError(
      console::ExitCode::kRuntimeError,
      fmt::format("the program {} is not installed; the fleet's broker needs it\n  next: sudo "
                  "apt-get install {}",
                  program.name,
                  program.package));
}

fs::path find_program(const SystemProgram& program) {
  const char* const path = std::getenv("PATH");
  return find_program(program, path == nullptr ? "" : path);
}

void run_program(const std::vector<std::string>& command,
                 const std::string& what,
                 const fs::path& log) {
  session::ChildProcess process(command, log);
  const std::optional<int> status = process.wait_for(kProgramPatience);
  if (status != 0) {
    const std::string end = status ? fmt::format("exit code {}", *status) : "it does not end";
    throw console::CommandError(
        console::ExitCode::kRuntimeError,
        fmt::format("{} could not {} ({}): {}", command.front(), what, end, last_line_of(log)));
  }
}

std::string last_line_of(const fs::path& file) {
  std::ifstream lines(file);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) {
      last = line;
    }
  }
  return last;
}

}  // namespace echomap::broker
