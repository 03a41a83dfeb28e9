// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "hil_mock/runner/device_options.hpp"
#include "hil_mock/world/robot_world.hpp"

namespace echomap::runner {

/// The room and the robot that a command line names, put together. Throws files::ConfigError for a
/// file that is none and where robot or start do not fit.
std::unique_ptr<world::RobotWorld> load_world(const DeviceOptions& options);

/// Where the robots of a command line start, one for each, in the world. Throws files::ConfigError
/// where the room has no place for them or two stand in one another.
std::vector<geometry::Pose2> device_starts(const DeviceOptions& options);

}  // namespace echomap::runner
