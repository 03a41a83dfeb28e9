// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/world/part_params.hpp"
#include "hil_mock/world/wiring.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::world {

/// Reads the parts of a robot's file that a robot may go without: [[range]], [[cliff]],
/// [wall_sensor], [virtual_wall_sensor], [gyro], [battery], [stepper]. Throws files::ConfigError.
PartParams read_parts(const files::TomlReader& file);

/// Reads [wiring.BOARD]; only parts that are fitted may be wired, each once. Throws
/// files::ConfigError.
Wiring read_wiring(const files::TomlReader& file, const PartParams& parts);

}  // namespace echomap::world
