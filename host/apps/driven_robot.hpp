// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>

#include "host/apps/resumed_run.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "host/session/robot_profile.hpp"
#include "host/session/robot_session.hpp"
#include "host/tracking/camera_follower.hpp"

namespace echomap::apps {

/// A robot, and what is made of what it senses.
struct DrivenRobot {
  session::RobotSession& session;
  pipeline::RobotAtlas& atlas;
  const session::RobotProfile& profile;
  tracking::CameraFollower* camera = nullptr;  ///< Where somebody sees the robot.
  std::optional<ResumedRun> resumed = {};      ///< What the atlas already knows.
};

/// What was there before this run.
inline ResumedRun before_this_run(const DrivenRobot& robot) {
  return robot.resumed.value_or(ResumedRun{});
}

/// Of the robot's time, that of the run that it resumes included.
inline double elapsed_s(const DrivenRobot& robot) {
  const std::chrono::duration<double> session = robot.session.now().time_since_epoch();
  return before_this_run(robot).sim_seconds + session.count();
}

}  // namespace echomap::apps
