// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace echomap::console {

/// The next line that the user types, without its end. Empty where there is nobody who could, as at
/// the end of stdin, or where the user has had enough (interrupted()).
std::optional<std::string> read_line();

/// Asks on stderr and reads the answer; empty without a terminal, and where read_line() is.
std::optional<std::string> ask(const std::string& question);

}  // namespace echomap::console
