// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "hil_mock/runner/byte_endpoint.hpp"
#include "hil_mock/runner/pacer.hpp"
#include "hil_mock/runner/robot_team.hpp"

namespace echomap::runner {

/// A robot and where its hosts come and go.
struct ServedRobot {
  RobotSimulation* simulation = nullptr;
  ByteEndpoint* endpoint = nullptr;
};

/// Runs a team at the pacer's speed until `end_ns` of simulated time or a stop signal. `robots` are
/// all of its robots.
void run_paced(RobotTeam& team,
               std::span<const ServedRobot> robots,
               Pacer pacer,
               std::int64_t end_ns);

}  // namespace echomap::runner
