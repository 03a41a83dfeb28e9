// SPDX-License-Identifier: MIT
#pragma once

#include "host/apps/robot_profile.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::apps {

/// Reads what a profile may have beside wheels, sonar and pan: [wiring], [infrared], [gyro],
/// [battery] and [safety], each of them optional. Wants `profile.geometry` and the pan read before.
/// Throws files::ConfigError.
void read_sensors(const files::TomlReader& profile_file, RobotProfile& profile);

}  // namespace echomap::apps
