// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace echomap::structure {

/// How a shell command ended; `output` holds stdout and stderr as they came.
struct ShellResult {
  int exit_code = -1;
  std::string output;
};

/// Runs `script` by /bin/sh in `folder`, without standard input; the script ends at its first
/// failing command.
ShellResult run_shell(const std::string& script, const std::filesystem::path& folder);

/// `text` as one word of a shell command.
std::string shell_quoted(const std::string& text);

/// True when the shell finds the program.
bool has_program(const std::string& name);

}  // namespace echomap::structure
