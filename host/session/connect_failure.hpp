// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "host/console/exit_code.hpp"
#include "host/robot_link/robot_link.hpp"
#include "host/time/host_time.hpp"

namespace echomap::session {

/// Of a link that did not become ready: its exit code, and in words why and what to do next.
console::ExitCode connect_failure(const robot_link::RobotLink& link);
std::string reason_of_connect_failure(const robot_link::RobotLink& link, const std::string& port);

/// Of a robot that another session has taken from this one, in state kBusy.
std::string reason_of_take_over(const robot_link::RobotLink& link, const std::string& port);

/// When the robot started, or a multiple of 71.6 minutes later, where its stamps have wrapped; as
/// exact as its clock's rate is known. Empty where the link has no clock or no telemetry yet.
std::optional<time::HostTime> start_of_robot(const robot_link::RobotLink& link);
/// Whether the robot started after `instant` because its reset line was pulled, as DTR does. False
/// where `start_of_robot` is empty.
bool was_reset_since(time::HostTime instant, const robot_link::RobotLink& link);
/// Why a port cannot be joined, for --no-reset.
std::string reset_by_opening(const std::string& port);

}  // namespace echomap::session
