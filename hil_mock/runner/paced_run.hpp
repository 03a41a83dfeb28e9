// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hil_mock/runner/byte_endpoint.hpp"
#include "hil_mock/runner/pacer.hpp"
#include "hil_mock/runner/robot_simulation.hpp"

namespace echomap::runner {

/// Runs at the pacer's speed, with whatever host comes and goes, until `end_ns` of simulated time
/// or a stop signal.
void run_paced(RobotSimulation& simulation,
               ByteEndpoint& endpoint,
               Pacer pacer,
               std::int64_t end_ns);

}  // namespace echomap::runner
