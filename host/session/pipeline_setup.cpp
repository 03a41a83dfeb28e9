// SPDX-License-Identifier: MIT
#include "host/session/pipeline_setup.hpp"

#include <algorithm>

#include "host/slam/slam_methods.hpp"

namespace echomap::session {
std::vector<std::string> live_slam_names() {
  std::vector<std::string> names{kNoSlam};
  for (const slam::NamedSlam& method : slam::slam_methods()) {
    if (method.takes_cones) {
      names.emplace_back(method.name);
    }
  }
  return names;
}

mapping::SonarSurfaceParams surface_params(const RobotProfile& profile) {
  mapping::SonarSurfaceParams params;
  params.beam_half_angle_rad = profile.beam_half_angle_rad;
  return params;
}

pipeline::RobotPipeline pipeline_for(const RobotProfile& profile,
                                     const std::string& slam,
                                     double near_cell_m) {
  mapping::SonarMapperParams params;
  mapping::ContactMapperParams near;
  if (profile.has_sonar) {
    params.surfaces = surface_params(profile);
    params.floor.max_range_m = profile.range.max_range_m;
    double& faced_m = params.features.completion.faced_range_m;
    faced_m = std::min(faced_m, sure_range_m(profile));
  } else {
    params.grid.resolution_m = near_cell_m;
  }
  near.body_radius_m = profile.body_radius_m;
  if (profile.sensors.infrared_curve) {
    near.infrared_reach_m = profile.sensors.infrared_curve->max_m();
  }
  for (const sensors::InfraredSensor& sensor : profile.sensors.infrared) {
    near.T_robot_infrared.push_back(sensor.T_robot_sensor);
  }
  const bool by_slam = profile.has_sonar && slam != kNoSlam;
  return pipeline::RobotPipeline(
      profile.geometry, params, near, by_slam ? slam::slam_by_name(slam).make() : nullptr);
}

pipeline::RobotAtlas atlas_for(const RobotProfile& profile,
                               const std::string& slam,
                               const pipeline::RobotAtlasParams& params,
                               double near_cell_m) {
  return pipeline::RobotAtlas(
      [&profile, slam, near_cell_m] { return pipeline_for(profile, slam, near_cell_m); }, params);
}

}  // namespace echomap::session
