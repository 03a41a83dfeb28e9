// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/world/robot_params.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::world {

/// Reads a simulated robot from TOML: sizes are required, errors and strengths have defaults, parts
/// their wiring, sonar and pan drive may be missing. docs/guides/simulated_world.md lists the keys.
/// Throws files::ConfigError, with file, line and column, for a missing or unknown key and for a
/// value out of bounds.
RobotParams read_robot(const files::TomlReader& file);

}  // namespace echomap::world
