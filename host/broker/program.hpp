// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace echomap::broker {

/// A program of the system and the Debian package that it comes in.
struct SystemProgram {
  std::string name;
  std::string package;
};

/// Where a program is: in a folder of `path`, which is like PATH, or in /usr/sbin or
/// /usr/local/sbin, which PATH of a user often lacks. Throws console::CommandError kRuntimeError
/// with the package to install.
std::filesystem::path find_program(const SystemProgram& program, const std::string& path);

/// The same with PATH of this process.
std::filesystem::path find_program(const SystemProgram& program);

/// Runs a program to its end, at most 30 s; what it prints goes to the file `log`. `what` is what
/// it is for. Throws console::CommandError kRuntimeError with its last line where it fails.
void run_program(const std::vector<std::string>& command,
                 const std::string& what,
                 const std::filesystem::path& log);

/// The last line of a file that has letters; empty where there is none.
std::string last_line_of(const std::filesystem::path& file);

}  // namespace echomap::broker
