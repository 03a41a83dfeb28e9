// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "host/files/toml_reader.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::session {

/// The table [scalar]: a sensor that says one number. Wants the pins of [wiring] read before.
/// Throws files::ConfigError.
void read_scalar(const files::TomlReader& table, RobotProfile& profile);

/// Whether the profile wants anything that came with protocol 1.4: a scalar sensor.
bool wants_scalar(const protocol::Configuration& configuration);

/// Why a board with these capabilities (protocol::Capability) refuses the pins of a profile with a
/// scalar sensor, and what to do: the end of a sentence and the line of the next step.
std::string advice_on_refused_scalar(std::uint32_t capabilities);

}  // namespace echomap::session
