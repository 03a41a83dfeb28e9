// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace echomap::session {

/// The text of a profile with `driver` in its table [drive], in place of the one that it names; the
/// rest is as it was. Throws CommandError 2 where
/// the text has no line with that table alone.
std::string with_driver(const std::string& toml, const std::string& driver);

/// The motor driver that a profile names; empty where it leaves that to the default. Throws
/// files::ConfigError where the text is no TOML.
std::string driver_of(const std::string& toml);

}  // namespace echomap::session
