// SPDX-License-Identifier: MIT
#include "host/apps/strategy_setup.hpp"

namespace echomap::apps {

exploration::NxtFarthestParams strategy_params(const RobotProfile& profile,
                                               std::size_t most_stops) {
  exploration::NxtFarthestParams params;
  params.pan_limit_rad = profile.pan_limit_rad;
  params.settle_s = profile.settle_s;
  params.robot_radius_m = profile.body_radius_m;
  params.most_stops = most_stops;
  return params;
}

pipeline::RobotPipeline pipeline_for(const RobotProfile& profile) {
  mapping::SonarMapperParams params;
  params.surfaces.beam_half_angle_rad = profile.beam_half_angle_rad;
  return pipeline::RobotPipeline(profile.geometry, params);
}

}  // namespace echomap::apps
