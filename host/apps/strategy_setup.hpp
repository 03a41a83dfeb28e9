// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "host/apps/robot_profile.hpp"
#include "host/exploration/nxt_farthest.hpp"
#include "host/pipeline/robot_pipeline.hpp"

namespace echomap::apps {

/// What the strategy has to know of a robot.
exploration::NxtFarthestParams strategy_params(const RobotProfile& profile, std::size_t most_stops);

/// An empty pipeline for what the robot senses.
pipeline::RobotPipeline pipeline_for(const RobotProfile& profile);

}  // namespace echomap::apps
