// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace echomap::console {

/// Prints a line for people on stderr, unless -q was given.
void print(const std::string& line);

}  // namespace echomap::console
