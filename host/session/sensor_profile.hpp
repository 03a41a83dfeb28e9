// SPDX-License-Identifier: MIT
#pragma once

#include "host/files/toml_reader.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::session {

/// Reads what a profile may have beside wheels, sonar and pan: [wiring], [infrared], [gyro],
/// [battery], [scalar] and [safety], each of them optional. Wants `profile.geometry` and the pan
/// read before. Throws files::ConfigError.
void read_sensors(const files::TomlReader& profile_file, RobotProfile& profile);

}  // namespace echomap::session
