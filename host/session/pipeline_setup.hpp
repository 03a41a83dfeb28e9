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

/// Cells of a map that is only felt: sensors of a few centimetres tell a wall's place to some
/// millimetres, a sonar to some centimetres.
inline constexpr double kNearCellM = 0.01;

/// An empty pipeline for what the robot senses. The SLAM method of that name places a robot with a
/// sonar; "none" leaves it to its odometry. One without a sonar has cells of `near_cell_m`.
pipeline::RobotPipeline pipeline_for(const RobotProfile& profile,
                                     const std::string& slam,
                                     double near_cell_m = kNearCellM);

/// An atlas of such pipelines. The profile outlives it.
pipeline::RobotAtlas atlas_for(const RobotProfile& profile,
                               const std::string& slam,
                               const pipeline::RobotAtlasParams& params = {},
                               double near_cell_m = kNearCellM);

}  // namespace echomap::session
