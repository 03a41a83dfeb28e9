// SPDX-License-Identifier: MIT
#include "tests/structure/shell.hpp"

#include <array>
#include <cstdio>
#include <stdexcept>

#include <sys/wait.h>

namespace echomap::structure {

std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char character : text) {
    quoted += character == '\'' ? "'\\''" : std::string(1, character);
  }
  return quoted + "'";
}

ShellResult run_shell(const std::string& script, const std::filesystem::path& folder) {
  const std::string command = "cd " + shell_quoted(folder.string()) + " && sh -ec " +
                              shell_quoted(script) + " 2>&1 </dev/null";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) {
    throw std::runtime_error("cannot start a shell");
  }
  ShellResult result;
  std::array<char, 4096> chunk{};
  for (std::size_t size = 0; (size = std::fread(chunk.data(), 1, chunk.size(), pipe)) > 0;) {
    result.output.append(chunk.data(), size);
  }
  const int status = pclose(pipe);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

bool has_program(const std::string& name) {
  return run_shell("command -v " + shell_quoted(name), "/").exit_code == 0;
}

}  // namespace echomap::structure
