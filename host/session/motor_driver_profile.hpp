// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/files/toml_reader.hpp"
#include "protocol/command_messages.hpp"

namespace echomap::session {

/// `driver` and `stop` of the table [drive], which may both be absent: a phase/enable driver, which
/// decides itself what a duty of 0 does; any other coasts. Sets `bridge` and `bridge_options` of
/// `wiring`. Throws files::ConfigError.
void read_motor_driver(const files::TomlReader& drive, protocol::ConfigureWiring& wiring);

/// What a board lacks that refuses these bridges, and what to do: the end of a sentence and the
/// line of the next step.
std::string advice_on_refused_bridge(const protocol::ConfigureWiring& wiring);

}  // namespace echomap::session
