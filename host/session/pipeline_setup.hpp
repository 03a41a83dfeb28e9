// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "host/mapping/sonar_surfaces.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::session {

/// What `--slam` is for a robot that its odometry alone places.
inline constexpr const char* kNoSlam = "none";

/// What `--slam` of a robot that drives may be: the SLAM methods for sonars, and "none".
std::vector<std::string> live_slam_names();

/// How a robot of this profile hears surfaces.
mapping::SonarSurfaceParams surface_params(const RobotProfile& profile);

/// An empty pipeline for what the robot senses. The SLAM method of that name places a robot with a
/// sonar; "none" leaves it to its odometry.
pipeline::RobotPipeline pipeline_for(const RobotProfile& profile, const std::string& slam);

/// An atlas of such pipelines. The profile outlives it.
pipeline::RobotAtlas atlas_for(const RobotProfile& profile,
                               const std::string& slam,
                               const pipeline::RobotAtlasParams& params = {});

}  // namespace echomap::session
