// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace echomap::console {

/// The words of a command, the program first.
using CommandWords = std::vector<std::string>;

/// As one types it at a POSIX shell, with quotes where a word needs them.
std::string shell_line(const CommandWords& command);

}  // namespace echomap::console
